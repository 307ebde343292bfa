// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/rigid/rigid_contacts.h"

namespace spin {

/// What else pushed a body during a step: impulse and angular impulse about its centre of mass, world axes.
struct RigidImpulse {
  Vec3d linear{};   ///< N s
  Vec3d angular{};  ///< N m s
};

/// Bodies that fall, rest, slide, roll and collide: sequential impulses (Catto 2005) with Coulomb's friction
/// and restitution, contacts seen before they happen, overlap pushed out without giving speed, sleep. A step
/// depends on nothing but states and arguments, and not on threads: a run goes on from saved states bit for
/// bit.
class RigidWorld {
 public:
  RigidWorld() = default;
  /// Friction of what does not move is `staticFriction`. Fails where a value is out of range.
  static Result<RigidWorld> make(std::vector<RigidBodyConfig> bodies, RigidStatics statics, Vec3d gravity,
                                 double staticFriction);

  /// `impulses`: one per body, or none. Fails, and changes nothing, where one is not finite.
  Status step(double seconds, const std::vector<RigidImpulse>& impulses);
  const std::vector<RigidBodyConfig>& bodies() const { return m_bodies; }
  const std::vector<RigidState>& states() const { return m_states; }
  /// Fails, and changes nothing, where the number is another or a value is not finite.
  Status setStates(std::vector<RigidState> states);
  bool asleep(std::size_t body) const { return m_states[body].calmSeconds >= kSleepAfter; }
  /// Bodies that nothing but gravity and `impulses` would move in a step: awake, not kinematic, and nothing
  /// within their way.
  std::vector<bool> freeBodies(double seconds) const;
  /// Impulse that gravity and what does not move, kinematic and sleeping bodies among it, gave in the last
  /// step, N s: the change of the moving bodies' momentum is this and `impulses` on all bodies.
  Vec3d outerImpulse() const { return m_outer; }

 private:
  bool moves(std::size_t body) const { return !m_bodies[body].kinematic && !asleep(body); }
  int substeps(double seconds) const;
  void substep(double seconds, const std::vector<RigidImpulse>& impulses, double share);
  void kick(double seconds, const std::vector<RigidImpulse>& impulses, double share);
  void drift(double seconds);
  void settle(double seconds, const std::vector<RigidImpulse>& impulses, double share,
              const std::vector<RigidContact>& contacts);

  std::vector<RigidBodyConfig> m_bodies;
  RigidStatics m_statics;
  Vec3d m_gravity{};
  double m_staticFriction = 0.5;
  std::vector<RigidState> m_states;
  Vec3d m_outer{};
};

}  // namespace spin
