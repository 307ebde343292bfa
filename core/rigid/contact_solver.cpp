// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/contact_solver.h"

#include <algorithm>

namespace spin {
namespace {

constexpr int kRounds = 30;
constexpr int kBounceRounds = 10;
constexpr int kSeparateRounds = 4;
/// Slower than this bodies do not bounce, m/s.
constexpr double kBounceFrom = 0.2;
/// Overlap that is left, as a share of the body's radius, so that contacts last.
constexpr double kSlop = 1e-3;
/// Share of the overlap that a step takes away, and the most of it, in radii.
constexpr double kSeparateShare = 0.2, kSeparateMost = 0.05;

}  // namespace

ContactSolver::ContactSolver(const std::vector<RigidBodyConfig>& bodies, std::vector<RigidState>& states,
                             const std::vector<bool>& moves, std::vector<RigidContact>& contacts)
    : m_bodies(bodies), m_states(states), m_moves(moves), m_contacts(contacts) {
  for (RigidContact& c : contacts) {
    c.armA = c.point - states[static_cast<std::size_t>(c.a)].position;
    if (c.b >= 0) c.armB = c.point - states[static_cast<std::size_t>(c.b)].position;
    c.approach = dot(relativeVelocity(c), c.normal);
  }
}

Vec3d ContactSolver::relativeVelocity(const RigidContact& c) const {
  const RigidState& a = m_states[static_cast<std::size_t>(c.a)];
  Vec3d v = a.velocity + cross(a.angularVelocity, c.armA);
  if (c.b >= 0) {
    const RigidState& b = m_states[static_cast<std::size_t>(c.b)];
    v = v - (b.velocity + cross(b.angularVelocity, c.armB));
  }
  return v;
}

double ContactSolver::inverseMass(std::size_t body) const {
  return m_moves[body] ? 1.0 / m_bodies[body].mass() : 0.0;
}

double ContactSolver::response(const RigidContact& c, Vec3d n) const {
  const auto of = [&](int number, Vec3d arm) {
    if (number < 0 || !m_moves[static_cast<std::size_t>(number)]) return 0.0;
    const auto k = static_cast<std::size_t>(number);
    const Vec3d turn = cross(arm, n);
    return inverseMass(k) + dot(turn, spinOf(m_bodies[k], m_states[k].orientation, turn));
  };
  return of(c.a, c.armA) + of(c.b, c.armB);
}

void ContactSolver::apply(const RigidContact& c, Vec3d impulse) {
  const auto to = [&](int number, Vec3d arm, Vec3d p) {
    if (number < 0 || !m_moves[static_cast<std::size_t>(number)]) return;
    const auto k = static_cast<std::size_t>(number);
    m_states[k].velocity += p * inverseMass(k);
    m_states[k].angularVelocity += spinOf(m_bodies[k], m_states[k].orientation, cross(arm, p));
  };
  to(c.a, c.armA, impulse);
  to(c.b, c.armB, -impulse);
}

void ContactSolver::pushOne(RigidContact& c, double target) {
  const double k = response(c, c.normal);
  if (!(k > 0.0)) return;
  const double before = c.push;
  c.push = std::max(before + (target - dot(relativeVelocity(c), c.normal)) / k, 0.0);
  apply(c, c.normal * (c.push - before));
}

void ContactSolver::rubOne(RigidContact& c) {
  const Vec3d v = relativeVelocity(c), slide = v - c.normal * dot(v, c.normal);
  const double speed = length(slide);
  if (!(speed > 1e-12)) return;
  const Vec3d along = slide / speed;
  const double k = response(c, along);
  if (!(k > 0.0)) return;
  const Vec3d before = c.rub;
  Vec3d wanted = before - along * (speed / k);
  const double most = c.friction * c.push, size = length(wanted);
  if (size > most) wanted = wanted * (most / size);
  c.rub = wanted;
  apply(c, wanted - before);
}

void ContactSolver::solve(double seconds) {
  for (int round = 0; round < kRounds; ++round)
    for (RigidContact& c : m_contacts) {
      rubOne(c);
      pushOne(c, std::min(-c.separation / seconds, 0.0));
    }
}

void ContactSolver::bounce() {
  for (int round = 0; round < kBounceRounds; ++round)
    for (RigidContact& c : m_contacts)
      if (c.push > 0.0 && c.approach < -kBounceFrom) pushOne(c, -c.restitution * c.approach);
}

void ContactSolver::shift(const RigidContact& c, Vec3d impulse) {
  const auto to = [&](int number, Vec3d arm, Vec3d p) {
    if (number < 0 || !m_moves[static_cast<std::size_t>(number)]) return;
    const auto k = static_cast<std::size_t>(number);
    RigidState& s = m_states[k];
    s.position += p * inverseMass(k);
    s.orientation = turnedBy(s.orientation, spinOf(m_bodies[k], s.orientation, cross(arm, p)));
  };
  to(c.a, c.armA, impulse);
  to(c.b, c.armB, -impulse);
}

void ContactSolver::separate(const std::vector<RigidState>& before) {
  for (int round = 0; round < kSeparateRounds; ++round)
    for (const RigidContact& c : m_contacts) {
      const auto moved = [&](int number) {
        if (number < 0) return Vec3d{};
        const auto k = static_cast<std::size_t>(number);
        return m_states[k].toWorld(before[k].toBody(c.point)) - c.point;
      };
      const double now = c.separation + dot(c.normal, moved(c.a) - moved(c.b));
      const double radius = m_bodies[static_cast<std::size_t>(c.a)].shape->radius;
      const double way = std::min(-kSeparateShare * (now + kSlop * radius), kSeparateMost * radius);
      const double k = response(c, c.normal);
      if (way > 0.0 && k > 0.0) shift(c, c.normal * (way / k));
    }
}

Vec3d ContactSolver::staticImpulse() const {
  Vec3d sum{};
  for (const RigidContact& c : m_contacts) {
    const bool outer = c.b < 0 || !m_moves[static_cast<std::size_t>(c.b)];
    const bool own = m_moves[static_cast<std::size_t>(c.a)];
    if (outer && own) sum += c.normal * c.push + c.rub;
    if (!outer && !own) sum += -(c.normal * c.push + c.rub);
  }
  return sum;
}

}  // namespace spin
