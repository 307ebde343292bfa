// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigid_world.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/rigid/contact_solver.h"

namespace spin {
namespace {

constexpr const char* kWhat = "The rigid bodies cannot be computed";
constexpr double kLongestSubstep = 1.0 / 240.0;  // s
/// A substep brings no point farther than this share of what its body's field reaches.
constexpr double kReachShare = 0.4;
constexpr double kMostSubsteps = 1e5;
/// A body hardly moves below this speed of its surface, m/s, and is not pushed below this share of its
/// weight.
constexpr double kCalmSpeed = 0.03, kCalmPush = 0.01;

Status checkBody(const RigidBodyConfig& b, std::size_t number) {
  const std::string where = "body " + std::to_string(number);
  const auto bad = [&](const char* why) { return badInput(kWhat, where, why); };
  if (!b.shape) return bad("it has no shape");
  if (!(b.density > 0.0 && b.density <= 1e5)) return bad("its density is not within 0 to 100000 kg/m3");
  if (!(b.friction >= 0.0 && b.friction <= 100.0)) return bad("its friction is not within 0 to 100");
  if (!(b.restitution >= 0.0 && b.restitution <= 1.0)) return bad("its restitution is not within 0 to 1");
  if (!isFinite(b.start)) return bad("its state is not finite");
  return {};
}

}  // namespace

Result<RigidWorld> RigidWorld::make(std::vector<RigidBodyConfig> bodies, RigidStatics statics, Vec3d gravity,
                                    double staticFriction) {
  if (!isFinite(gravity) || !(staticFriction >= 0.0 && staticFriction <= 100.0))
    return badInput(kWhat, {}, "gravity or friction is out of range");
  RigidWorld world;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (Status ok = checkBody(bodies[k], k); !ok) return ok.error();
    world.m_states.push_back(bodies[k].start);
    world.m_states.back().orientation = normalized(bodies[k].start.orientation);
  }
  world.m_bodies = std::move(bodies);
  world.m_statics = std::move(statics);
  world.m_gravity = gravity;
  world.m_staticFriction = staticFriction;
  return world;
}

Status RigidWorld::setStates(std::vector<RigidState> states) {
  if (states.size() != m_states.size())
    return badInput(kWhat, {}, "there are more or fewer states than bodies");
  for (std::size_t k = 0; k < states.size(); ++k)
    if (!isFinite(states[k])) return badInput(kWhat, "body " + std::to_string(k), "its state is not finite");
  m_states = std::move(states);
  return {};
}

std::vector<bool> RigidWorld::freeBodies(double seconds) const {
  std::vector<bool> free(m_bodies.size());
  for (std::size_t k = 0; k < free.size(); ++k) free[k] = moves(k);
  for (const RigidContact& c : findContacts(m_bodies, m_states, m_statics, m_staticFriction, seconds)) {
    free[static_cast<std::size_t>(c.a)] = false;
    if (c.b >= 0) free[static_cast<std::size_t>(c.b)] = false;
  }
  return free;
}

int RigidWorld::substeps(double seconds) const {
  double count = seconds / kLongestSubstep;
  for (std::size_t k = 0; k < m_bodies.size(); ++k) {
    if (asleep(k) && !m_bodies[k].kinematic) continue;
    const RigidState& s = m_states[k];
    const double way = (length(s.velocity) + m_bodies[k].shape->radius * length(s.angularVelocity)) * seconds;
    count = std::max(count, way / (kReachShare * m_bodies[k].shape->field->reach()));
  }
  return static_cast<int>(std::ceil(std::min(count, kMostSubsteps) - 1e-9));
}

Status RigidWorld::step(double seconds, const std::vector<RigidImpulse>& impulses) {
  if (!(seconds > 0.0) || !std::isfinite(seconds)) return badInput(kWhat, "time step", "it is not above 0");
  if (!impulses.empty() && impulses.size() != m_bodies.size())
    return badInput(kWhat, {}, "there are more or fewer impulses than bodies");
  for (std::size_t k = 0; k < impulses.size(); ++k)
    if (!isFinite(impulses[k].linear) || !isFinite(impulses[k].angular))
      return badInput(kWhat, "body " + std::to_string(k), "what pushes it is not finite");
  m_outer = {};
  const std::vector<RigidState> before = m_states;
  const int count = std::max(substeps(seconds), 1);
  for (int k = 0; k < count; ++k) substep(seconds / count, impulses, 1.0 / count);
  for (std::size_t k = 0; k < m_states.size(); ++k)
    if (!isFinite(m_states[k])) {
      m_states = before;
      return Error{ErrorKind::Failed, kWhat, "body " + std::to_string(k), "its state is not finite any more",
                   "Use a smaller step; the last good state is kept"};
    }
  return {};
}

void RigidWorld::kick(double seconds, const std::vector<RigidImpulse>& impulses, double share) {
  for (std::size_t k = 0; k < m_bodies.size(); ++k) {
    RigidState& s = m_states[k];
    if (m_bodies[k].kinematic) {
      if (!impulses.empty()) m_outer += impulses[k].linear * -share;
      continue;
    }
    const double mass = m_bodies[k].mass();
    if (!impulses.empty()) {
      // What holds a body up against its weight does not wake it; what moves it does.
      if (asleep(k) && length(impulses[k].linear) * share > kCalmPush * mass * length(m_gravity) * seconds)
        s.calmSeconds = 0.0;
    }
    if (asleep(k)) {
      if (!impulses.empty()) m_outer += impulses[k].linear * -share;
      continue;
    }
    m_outer += m_gravity * (mass * seconds);
    s.velocity += m_gravity * seconds;
    if (impulses.empty()) continue;
    s.velocity += impulses[k].linear * (share / mass);
    s.angularVelocity += spinOf(m_bodies[k], s.orientation, impulses[k].angular * share);
  }
}

void RigidWorld::drift(double seconds) {
  for (std::size_t k = 0; k < m_bodies.size(); ++k) {
    RigidState& s = m_states[k];
    if (asleep(k) && !m_bodies[k].kinematic) continue;
    s.position += s.velocity * seconds;
    if (m_bodies[k].kinematic) {
      s.orientation = turnedBy(s.orientation, s.angularVelocity * seconds);
      continue;
    }
    // Angular momentum is kept, the midpoint's spin turns the body.
    const Vec3d momentum = momentumOf(m_bodies[k], s.orientation, s.angularVelocity);
    const Quaternion half = turnedBy(s.orientation, s.angularVelocity * (0.5 * seconds));
    s.orientation = turnedBy(s.orientation, spinOf(m_bodies[k], half, momentum) * seconds);
    s.angularVelocity = spinOf(m_bodies[k], s.orientation, momentum);
  }
}

void RigidWorld::substep(double seconds, const std::vector<RigidImpulse>& impulses, double share) {
  kick(seconds, impulses, share);
  std::vector<RigidContact> contacts = findContacts(m_bodies, m_states, m_statics, m_staticFriction, seconds);
  // A sleeping body that something moving touches wakes first.
  for (const RigidContact& c : contacts) {
    if (c.b < 0) continue;
    const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
    const Vec3d v = m_states[a].velocityAt(c.point) - m_states[b].velocityAt(c.point);
    if (c.separation + dot(v, c.normal) * seconds > 0.0) continue;
    if (length(v) < 2.0 * kCalmSpeed + length(m_gravity) * seconds) continue;
    m_states[a].calmSeconds = m_states[b].calmSeconds = 0.0;
  }
  std::vector<bool> free(m_bodies.size());
  for (std::size_t k = 0; k < m_bodies.size(); ++k) free[k] = moves(k);
  ContactSolver solver(m_bodies, m_states, free, contacts);
  solver.solve(seconds);
  solver.bounce();
  const std::vector<RigidState> before = m_states;
  drift(seconds);
  solver.separate(before);
  m_outer += solver.staticImpulse();
  settle(seconds, impulses, share, contacts);
}

void RigidWorld::settle(double seconds, const std::vector<RigidImpulse>& impulses, double share,
                        const std::vector<RigidContact>& contacts) {
  std::vector<bool> held(m_bodies.size(), false);
  for (const RigidContact& c : contacts) {
    if (!(c.push > 0.0)) continue;
    held[static_cast<std::size_t>(c.a)] = true;
    if (c.b >= 0) held[static_cast<std::size_t>(c.b)] = true;
  }
  for (std::size_t k = 0; k < m_bodies.size(); ++k) {
    RigidState& s = m_states[k];
    if (m_bodies[k].kinematic || asleep(k)) continue;
    const double speed = length(s.velocity) + m_bodies[k].shape->radius * length(s.angularVelocity);
    const double weight = m_bodies[k].mass() * length(m_gravity) * seconds;
    const bool pushed = !impulses.empty() && length(impulses[k].linear) * share > kCalmPush * weight;
    s.calmSeconds = held[k] && speed < kCalmSpeed && !pushed ? s.calmSeconds + seconds : 0.0;
    if (s.calmSeconds < kSleepAfter) continue;
    m_outer += s.velocity * -m_bodies[k].mass();
    s.velocity = s.angularVelocity = {};
  }
}

}  // namespace spin
