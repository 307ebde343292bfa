// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace spin {

/// The passes of the implicit solves and of the stress form (implicit_passes.h, viscous_passes.h).
enum class SolvePass : std::uint8_t { Constraint, Divergence, PressurePush, ViscousProduct, Stress };
inline constexpr std::size_t kSolvePasses = 5;

/// What the implicit pressure keeps of every particle. Null where the pressure follows from the density.
struct PressureSolveView {
  float* pressure = nullptr;  ///< pressure term that the solve has reached, Pa
  float* push = nullptr;      ///< its change that velocities do not have yet, Pa
  float* latest = nullptr;    ///< the iterate before momentum was added, Pa
  float* compliance =
      nullptr;             ///< pressure that takes off one excess, times the step squared, Pa s2; 0 = alone
  float* error = nullptr;  ///< what is wrong with the predicted excess, 1
  float timeStep = 0;      ///< s
  float relaxation = 0;
  float momentum = 0;       ///< share of the last change that is added again
  float level = 0;          ///< excess that is wanted everywhere
  float surplusShare = 0;   ///< of an excess above that level, taken off in this step
  float deficitRoom = 0;    ///< deficit of which no more than that share is filled up in a step; huge
                            ///< where tension is allowed
  float leastPressure = 0;  ///< Pa; far below 0 where tension is allowed
  float deficitShare = 0;   ///< 1 where a density below that at rest counts as an error too
};

/// A particle's direction of search and its viscosity: what a pair of the viscous matrix needs.
struct ViscousRecord {
  float x = 0, y = 0, z = 0;  ///< m/s
  float viscosity = 0;        ///< Pa s
};

/// What the implicit viscosity keeps of every particle; null where it is off.
struct ViscousSolveView {
  ViscousRecord* direction = nullptr;
  float *qx = nullptr, *qy = nullptr, *qz = nullptr;  ///< matrix times direction, kg/m3 m/s
  float *rx = nullptr, *ry = nullptr, *rz = nullptr;  ///< residual, kg/m3 m/s
  float* diagonal = nullptr;                          ///< of the pairs' part, kg/m3
  float* slip = nullptr;                              ///< speed along the wall when the solve began, m/s
  float timeStep = 0;                                 ///< s
  float factor = 0;                                   ///< timeStep times FlowConstants::viscousFactor
};

/// Viscous stress over the square of the relative density, Pa; null where viscosity is pairwise.
struct StressRecord {
  float xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

}  // namespace spin
