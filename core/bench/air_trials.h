// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/bench/air_bench_scene.h"

namespace spin {

/// How a measured flow of air is computed: what the plot of error against time goes over.
struct AirTrial {
  AirAdvection advection = AirAdvection::MacCormack;
  bool reflection = true;
  AirPressure pressure = AirPressure::Multigrid;
  int across = 64;       ///< cells along the box
  double courant = 1.0;  ///< cells that the fastest air goes in a step
};

/// "MacCormack, reflected, multigrid".
std::string nameOf(const AirTrial& trial);
/// Scheme, resolution and step as a row's settings.
void describe(const AirTrial& trial, BenchRow& row);

/// Vortices of Taylor and Green that decay for a second: velocity_l2, kept_energy and the rest of the case
/// `taylor-green`.
Result<BenchRow> taylorGreenTrial(const BenchOptions& options, const AirTrial& trial);

}  // namespace spin
