// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/rigid/rigid_body.h"
#include "core/rigid/rigid_statics.h"

namespace spin {

/// A point where body a touches body b or, with b below 0, something that does not move.
struct RigidContact {
  int a = 0, b = -1;
  int part = 0;             ///< of the statics
  Vec3d point{};            ///< world m
  Vec3d normal{0, 0, 1};    ///< from b to a
  double separation = 0.0;  ///< m, below 0 where they overlap
  double friction = 0.0, restitution = 0.0;
  // The solver's:
  Vec3d armA{}, armB{};
  double approach = 0.0;  ///< normal speed before, below 0 when they come together, m/s
  double push = 0.0;      ///< normal impulse so far, N s
  Vec3d rub{};            ///< friction's impulse so far
};

/// All places where surface points of a body are nearer to another solid than they can come within `seconds`,
/// and at most kContactsPerPair of each pair: the deepest, and what lies farthest from those chosen.
std::vector<RigidContact> findContacts(const std::vector<RigidBodyConfig>& bodies,
                                       const std::vector<RigidState>& states, const RigidStatics& statics,
                                       double staticFriction, double seconds);
inline constexpr int kContactsPerPair = 8;

}  // namespace spin
