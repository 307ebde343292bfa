// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/ground_nodes.h"

namespace spin {

constinit const std::array<Choice, kGroundTypeCount> kGroundTypeChoices{{
    {"quartz", SPIN_TR("Quartz")},
    {"sand", SPIN_TR("Sand")},
    {"soil", SPIN_TR("Soil")},
    {"vegetation", SPIN_TR("Vegetation")},
    {"rock", SPIN_TR("Rock")},
    {"ice", SPIN_TR("Ice")},
    {"asphalt", SPIN_TR("Asphalt")},
    {"water", SPIN_TR("Water")},
}};

Vec3d groundTypeColour(GroundType type) {
  static constexpr std::array<Vec3d, kGroundTypeCount> kColours{{
      {0.42, 0.40, 0.37},
      {0.45, 0.33, 0.19},
      {0.11, 0.07, 0.045},
      {0.075, 0.095, 0.035},
      {0.17, 0.16, 0.15},
      {0.52, 0.62, 0.70},
      {0.035, 0.035, 0.038},
      {0.02, 0.05, 0.07},
  }};
  return kColours[static_cast<std::size_t>(type)];
}

namespace {

constexpr PropertyRow kTypeRows[] = {
    property<&GroundTypeLayerNode::base>("base", SPIN_TR("Base type"),
                                         SPIN_TR("Ground where nothing is painted."))
        .oneOf(kGroundTypeChoices),
    property<&GroundTypeLayerNode::source>("source", SPIN_TR("Painted file"),
                                           SPIN_TR("8-bit PNG of the terrain's size with one ground type per "
                                                   "pixel; written when the scene is saved."))
        .path(),
};
constexpr PropertyRow kTemperatureRows[] = {
    property<&GroundTemperatureLayerNode::base>("base_k", SPIN_TR("Base temperature"),
                                                SPIN_TR("Ground temperature where nothing is painted."))
        .in(Unit::Kelvin)
        .range(213.15, 333.15, 1)
        .animated(),
    property<&GroundTemperatureLayerNode::source>(
        "source", SPIN_TR("Painted file"),
        SPIN_TR("GeoTIFF of the terrain's size with temperatures in K; written when the scene is saved."))
        .path(),
};
constexpr Choice kDepthUses[] = {
    {"replace", SPIN_TR("Replaces old snow")},
    {"add", SPIN_TR("Lies on old snow")},
};
constexpr PropertyRow kDepthRows[] = {
    property<&SnowDepthLayerNode::use>(
        "use", SPIN_TR("Where painted"),
        SPIN_TR("Whether painted snow replaces the old snow of the snowfall or lies on top of it."))
        .oneOf(kDepthUses),
    property<&SnowDepthLayerNode::density>("density_kg_m3", SPIN_TR("Density"),
                                           SPIN_TR("Density of the painted snow when the film begins."))
        .in(Unit::KilogramPerCubicMetre)
        .range(10, 917, 10),
    property<&SnowDepthLayerNode::source>(
        "source", SPIN_TR("Painted file"),
        SPIN_TR("GeoTIFF of the terrain's size with depths in m; written when the scene is saved."))
        .path(),
};
constexpr PropertyRow kClearRows[] = {
    property<&KeepClearLayerNode::strength>(
        "strength", SPIN_TR("Strength"),
        SPIN_TR("Factor on the painted share of the falling snow that is taken away."))
        .in(Unit::Factor)
        .range(0, 1, 0.05)
        .animated(),
    property<&KeepClearLayerNode::start>("start_s", SPIN_TR("Start"),
                                         SPIN_TR("Film time at which clearing begins."))
        .in(Unit::Second)
        .range(0, 1e6, 1),
    property<&KeepClearLayerNode::stop>("stop_s", SPIN_TR("Stop"),
                                        SPIN_TR("Film time at which clearing ends."))
        .in(Unit::Second)
        .range(0, 1e6, 1),
    property<&KeepClearLayerNode::source>(
        "source", SPIN_TR("Painted file"),
        SPIN_TR("GeoTIFF of the terrain's size with shares from 0 to 1; written when the scene is saved."))
        .path(),
};

}  // namespace

constinit const NodeType kGroundTypeLayerType = nodeType<GroundTypeLayerNode>(
    "ground_type", SPIN_TR("Ground types"), SPIN_TR("Painted materials of the ground."), true, kTypeRows);
constinit const NodeType kGroundTemperatureLayerType = nodeType<GroundTemperatureLayerNode>(
    "ground_temperature", SPIN_TR("Ground temperature"), SPIN_TR("Painted temperature of the ground."), true,
    kTemperatureRows);
constinit const NodeType kSnowDepthLayerType =
    nodeType<SnowDepthLayerNode>("snow_depth", SPIN_TR("Snow depth"),
                                 SPIN_TR("Painted snow that lies when the film begins."), true, kDepthRows);
constinit const NodeType kKeepClearLayerType = nodeType<KeepClearLayerNode>(
    "keep_clear", SPIN_TR("Keep clear"),
    SPIN_TR("Painted ground where falling snow is taken away: ploughed roads, heated yards."), false,
    kClearRows);

}  // namespace spin
