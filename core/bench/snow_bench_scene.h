// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/sim/snapshot.h"

namespace spin {

/// A house of width x length (m) with eaves that stick out and a gable roof; closed, z up, floor at 0.
std::shared_ptr<const ModelData> benchHouse(double width, double length, double wall, double ridge);

struct SnowBenchScene {
  int cells = 128;        ///< of the terrain along each side
  double cellSize = 5.0;  ///< m
  int houses = 3;
  bool holes = true;  ///< a lake without data and a cut corner
  SimulationNode simulation;
  WeatherNode weather;
  SnowfallNode snowfall;
};
/// A valley between two slopes with gullies, houses on its floor, weather and snowfall.
SceneSnapshot snowBenchSnapshot(const SnowBenchScene& options);

}  // namespace spin
