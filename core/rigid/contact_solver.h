// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/rigid/rigid_contacts.h"

namespace spin {

/// Solves for the impulses at contacts, one after the other, over and over (Catto 2005).
class ContactSolver {
 public:
  /// `moves` says which bodies an impulse changes.
  ContactSolver(const std::vector<RigidBodyConfig>& bodies, std::vector<RigidState>& states,
                const std::vector<bool>& moves, std::vector<RigidContact>& contacts);

  /// Changes velocities so that nothing comes nearer than it may within `seconds`, and rubs.
  void solve(double seconds);
  /// Gives back a share of the speed that bodies came together with.
  void bounce();
  /// Turns and moves bodies apart that overlap, a part of it, without touching their speeds. `before` is
  /// where contacts were found.
  void separate(const std::vector<RigidState>& before);
  /// Impulse that what does not move gave, N s.
  Vec3d staticImpulse() const;

 private:
  Vec3d relativeVelocity(const RigidContact& c) const;
  double inverseMass(std::size_t body) const;
  /// Change of the relative velocity along a direction per impulse, 1/kg.
  double response(const RigidContact& c, Vec3d direction) const;
  void apply(const RigidContact& c, Vec3d impulse);
  void pushOne(RigidContact& c, double target);
  void rubOne(RigidContact& c);
  void shift(const RigidContact& c, Vec3d impulse);

  const std::vector<RigidBodyConfig>& m_bodies;
  std::vector<RigidState>& m_states;
  const std::vector<bool>& m_moves;
  std::vector<RigidContact>& m_contacts;
};

}  // namespace spin
