// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/bench/bench_case.h"
#include "core/sph/flow_solver.h"

namespace spin {

/// A named setting of the solver that cases are run at.
struct FlowMode {
  const char* id;  ///< "fast", "accurate"
  double supportSpacings;
};
inline constexpr FlowMode kFastMode{"fast", 2.0};
inline constexpr FlowMode kAccurateMode{"accurate", 3.0};

/// Particles on a lattice from `corner` on, moved by up to `jitter` spacings at random and wrapped along
/// periodic axes.
std::vector<FlowParticle> flowLattice(const FlowConfig& config, int nx, int ny, int nz, Vec3d corner,
                                      double jitter);
/// Width of a slab that stands for two dimensions, in spacings: a whole number of supports, three or more.
int slabWidth(double supportSpacings);

/// On the device and with the instruction set that the options ask for, with the particles in it.
Result<std::unique_ptr<FlowSolver>> startFlow(const FlowConfig& config,
                                              const std::vector<FlowParticle>& particles,
                                              const BenchOptions& options);
/// Steps until `seconds` have gone; gives the number of steps.
Result<int> runFlow(FlowSolver& solver, double seconds);
/// Device, instruction set and threads of the row.
void nameDevice(const FlowSolver& solver, const BenchOptions& options, BenchRow& row);

}  // namespace spin
