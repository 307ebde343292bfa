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

/// What painted snow depth does to the old snow of the snowfall node where it is painted.
enum class SnowDepthUse : std::uint8_t { Replace, Add };

/// Snow that lies when the film begins, painted over the terrain (float raster, m of depth, vertical; NaN =
/// not painted).
struct SnowDepthLayerNode : NodeData {
  SnowDepthUse use = SnowDepthUse::Replace;
  double density = 250.0;  ///< kg/m3, of the painted snow
  std::string source;      ///< float GeoTIFF beside the scene; empty = nothing painted
};
extern const NodeType kSnowDepthLayerType;

/// Ground that is kept clear (ploughed roads, heated yards): painted share 0..1 of what falls that is taken
/// away (float raster; 0 = not painted).
struct KeepClearLayerNode : NodeData {
  double strength = 1.0;  ///< factor on the painted share
  double start = 0.0;     ///< s of film
  double stop = 1e6;      ///< s of film
  std::string source;     ///< float GeoTIFF beside the scene; empty = nothing painted
};
extern const NodeType kKeepClearLayerType;

}  // namespace spin
