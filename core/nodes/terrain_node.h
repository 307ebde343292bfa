// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nodes/ground_nodes.h"

namespace spin {

/// Elevation model. Its raster defines the local frame: x east, y north, z up, metres; origin at the
/// south-west corner cell's centre and the lowest height.
struct TerrainNode : NodeData {
  std::string source;              ///< raster file
  int epsg = 0;                    ///< overrides the file's coordinate system; 0 = take the file's
  double cellSize = 0.0;           ///< m, for files without georeference; 0 = the file's, or 1 m
  double heightUnit = 1.0;         ///< m per unit of height, for files that name none (16-bit PNG)
  bool hasNoData = false;          ///< noData marks cells without height, for files that cannot say so
  double noData = 0.0;             ///< in units of the file
  double verticalScale = 1.0;      ///< factor on heights above the lowest
  double coverDetailCell = 0.25;   ///< m, cover cells near models
  double coverDetailMargin = 6.0;  ///< m, how far round a model the fine cover reaches
  std::string credit;              ///< shown on the caption
};
extern const NodeType kTerrainType;

/// Which way is up in a model file.
enum class ModelUpAxis : std::uint8_t { File, Y, Z };

/// An imported model standing in the scene.
struct ModelNode : NodeData {
  std::string source;  ///< model file
  ModelUpAxis upAxis = ModelUpAxis::File;
  double unitScale = 0.0;  ///< m per unit of the file; 0 = as the format says
  Vec3d position{};        ///< m, local; z above the ground where onGround is set
  bool onGround = true;
  Vec3d rotationDegrees{};  ///< about x, y, z
  Vec3d scale{1, 1, 1};
  double coverCell = 0.15;  ///< m, cells of the cover on this model
  bool catchesSnow = true;
  GroundType surface = GroundType::Rock;  ///< what the snow lies on
  double heat = 0.0;                      ///< W/m2 that comes up through the surface: a heated house
  double dusting = 0.0;                   ///< 0..1, snow in the picture on what carries no cover
  bool fineCover = true;                  ///< the ground round it has fine cover cells
  PlanPoints copies;                      ///< m, local: places of further copies
  double copyTurnDegrees = 360.0;         ///< range of their random turn about z
  double copyScale = 0.15;                ///< random share by which they are larger or smaller
  int copySeed = 1;
};
extern const NodeType kModelType;

}  // namespace spin
