// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/sim/frame.h"
#include "core/sph/flow_solver.h"

namespace spin {

/// Classes of particles in the attribute "class" (after Mukai et al.).
enum class FlowClass : std::uint8_t {
  Main,      ///< in the flow
  Isolated,  ///< nearly alone: a candidate for spray
  Surface,   ///< at the surface of the flow
};

/// Class of a particle; Main unless its latest step was sampled.
FlowClass flowClassOf(const FlowConfig& config, const FlowSample& sample);

/// Particles that entered together.
struct FlowBirth {
  std::uint32_t firstId = 0;
  double film = 0.0;  ///< s
};

/// Steps of one frame.
struct FlowStepCount {
  std::uint32_t steps = 0;
  std::array<std::uint32_t, 5> limits{};  ///< by StepLimit
  double seconds = 0.0;
  std::uint64_t pressureIterations = 0, viscosityIterations = 0;  ///< of implicit solves
  std::uint32_t viscositySolves = 0;                              ///< steps that solved for the viscosity
};

/// Particles that entered since the beginning, by material.
struct FlowAccount {
  std::array<std::uint64_t, kMostMaterials> released{};
  std::array<std::uint64_t, kMostMaterials> inflow{};
};

/// What a frame is told of the flow.
struct FlowReport {
  const FlowSolver& solver;
  const FlowConfig& config;
  const std::vector<FlowBirth>& births;
  const FlowAccount& account;
  const FlowStepCount& steps;
  int layers = 0;  ///< per slab depth, of the thinnest slab; 0 = no slab
};

/// Puts the parts "flow" (particles) and, where there are bodies, "flow_boundary" (their boundary particles,
/// without attributes), the terms of the mass budget and figures into the frame.
void publishFlow(const FlowReport& report, Frame& frame);
/// Bytes of one particle in a frame.
double flowFrameBytes();

}  // namespace spin
