// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bench/flow_bench_scene.h"

namespace spin {

/// How a measured flow is computed: what the plot of error against time goes over.
struct FlowTrial {
  FlowMode mode = kFastMode;
  DensityMode density = DensityMode::Continuity;
  PressureMode pressure = PressureMode::EquationOfState;
  int across = 20;        ///< spacings to the flow's own length: width of a dam's column, depth, channel
  double courant = 0.25;  ///< share of a spacing that sound goes in a step
  WallFriction floor = WallFriction::FreeSlip;  ///< of a dam break
};

/// Mode, density, resolution and step as a row's settings.
void describe(const FlowTrial& trial, BenchRow& row);

/// A column at rest, `across` layers deep: pressure_rms and the rest of the case `hydrostatic`.
Result<BenchRow> hydrostaticTrial(const BenchOptions& options, const FlowTrial& trial);
/// Flow between plates from rest: profile_l2 and the rest of the case `poiseuille`.
Result<BenchRow> poiseuilleTrial(const BenchOptions& options, const FlowTrial& trial);
/// Front of a collapsing column: koshizuka_oka and the rest of the case `dam-break`.
Result<BenchRow> damFrontTrial(const BenchOptions& options, const FlowTrial& trial);

}  // namespace spin
