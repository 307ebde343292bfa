// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/bench/dam_break_reference.h"
#include "core/bench/flow_trials.h"

namespace spin {

struct DamFront {
  std::vector<FrontPoint> front;  ///< s, m; column 1 m wide and 2 m high
  double energy = 0.0;            ///< at the end, kinetic and potential, over that at the start
  double seconds = 0.0;           ///< of computing a simulated second
  std::string device;
};

/// The column of Koshizuka and Oka 1996 until 0.8 s. By summation it first settles behind the gate: particles
/// on a lattice beside a wall have 3 to 4 % too much density, which would blow the column apart.
Result<DamFront> runDamFront(const BenchOptions& options, const FlowTrial& setting);

/// Relative RMS error of a front against points that are measured `shift` seconds later.
double frontError(const std::vector<FrontPoint>& front, const std::vector<FrontPoint>& measured,
                  double shift);
/// The least error over shifts within 0.1 s.
double shiftedFrontError(const std::vector<FrontPoint>& front, const std::vector<FrontPoint>& measured,
                         double& shift);
std::vector<FrontPoint> koshizukaOkaFront();
/// Martin and Moyce's points in metres and seconds of a column 1 m wide, up to x = 4 m.
std::vector<FrontPoint> martinMoyceFront(bool narrow);

/// Particles at rest behind a gate: each with the place and density that it settles to within `seconds`.
Result<std::vector<FlowParticle>> settled(FlowConfig config, std::vector<FlowParticle> particles,
                                          double depth, double seconds, const BenchOptions& options);

}  // namespace spin
