// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/property/property_table.h"

namespace spin {

/// What the ground is made of; the numbers stand in painted layers and files.
enum class GroundType : std::uint8_t { Quartz, Sand, Soil, Vegetation, Rock, Ice, Asphalt, Water };
inline constexpr int kGroundTypeCount = 8;
/// Value of the cells of a painted layer that nobody painted: there the node's base type holds.
inline constexpr std::uint8_t kUnpaintedGround = 255;
/// Ids and labels, by number.
extern const std::array<Choice, kGroundTypeCount> kGroundTypeChoices;
/// Colour of bare ground for drawing, linear RGB.
Vec3d groundTypeColour(GroundType type);

/// Painted ground types over the terrain (uint8 raster of the terrain's size, see SceneNode::painted; values
/// are GroundType numbers or kUnpaintedGround).
struct GroundTypeLayerNode : NodeData {
  GroundType base = GroundType::Vegetation;  ///< where nothing is painted
  std::string source;                        ///< 8-bit PNG beside the scene; empty = nothing painted
};
extern const NodeType kGroundTypeLayerType;

/// Painted ground temperature over the terrain (float raster in K, NaN = not painted).
struct GroundTemperatureLayerNode : NodeData {
  double base = 273.15;  ///< K, where nothing is painted
  std::string source;    ///< float GeoTIFF beside the scene; empty = nothing painted
};
extern const NodeType kGroundTemperatureLayerType;

}  // namespace spin
