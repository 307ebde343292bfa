// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/property_table.h"

namespace spin {

/// Elevation model. Its raster defines the local frame: x east, y north, z up, metres; origin at the
/// south-west corner cell's centre and the lowest height.
struct TerrainNode : NodeData {
  std::string source;              ///< raster file
  int epsg = 0;                    ///< overrides the file's coordinate system; 0 = take the file's
  double verticalScale = 1.0;      ///< factor on heights above the lowest
  double coverDetailCell = 0.25;   ///< m, cover cells near models
  double coverDetailMargin = 6.0;  ///< m, how far round a model the fine cover reaches
  std::string credit;              ///< shown on the caption
};
extern const NodeType kTerrainType;

/// An imported model standing in the scene.
struct ModelNode : NodeData {
  std::string source;  ///< model file
  Vec3d position{};    ///< m, local; z above the ground where onGround is set
  bool onGround = true;
  Vec3d rotationDegrees{};  ///< about x, y, z
  Vec3d scale{1, 1, 1};
  double coverCell = 0.15;  ///< m, cells of the cover on this model
  bool catchesSnow = true;
};
extern const NodeType kModelType;

}  // namespace spin
