// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigid_contacts.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

/// Way that a point of a body can go in a time, and a little more: what is that near may be touched.
double wayOf(const RigidBodyConfig& body, const RigidState& s, double seconds) {
  return seconds * (length(s.velocity) + body.shape->radius * length(s.angularVelocity));
}

/// Of many contacts of one pair those that carry it: the deepest first, then again and again the one farthest
/// from all that are chosen, by place and by direction.
void choose(std::vector<RigidContact>& from, double radius, std::vector<RigidContact>& to) {
  if (from.size() <= static_cast<std::size_t>(kContactsPerPair)) {
    to.insert(to.end(), from.begin(), from.end());
    return;
  }
  std::vector<double> apart(from.size(), 1e300);
  std::size_t next = 0;
  for (std::size_t i = 1; i < from.size(); ++i)
    if (from[i].separation < from[next].separation) next = i;
  for (int k = 0; k < kContactsPerPair; ++k) {
    const RigidContact chosen = from[next];
    to.push_back(chosen);
    double farthest = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Vec3d turn = from[i].normal - chosen.normal;
      const double d = length(from[i].point - chosen.point) + 2.0 * radius * length(turn);
      apart[i] = std::min(apart[i], d);
      if (apart[i] > farthest) farthest = apart[i], next = i;
    }
    if (!(farthest > 0.02 * radius)) return;
  }
}

class Finder {
 public:
  Finder(const std::vector<RigidBodyConfig>& bodies, const std::vector<RigidState>& states, double seconds)
      : m_bodies(bodies), m_states(states), m_seconds(seconds) {}

  void againstStatics(std::size_t a, const RigidStatics& statics, double friction) {
    const RigidBodyConfig& body = m_bodies[a];
    const double margin = marginOf(a);
    if (body.kinematic || !statics.mayTouch(m_states[a].position, body.shape->radius + margin)) return;
    std::vector<RigidContact> found;
    for (const Vec3d& p : body.shape->points) {
      const Vec3d at = m_states[a].toWorld(p);
      statics.near(at, margin, [&](int part, const StaticContact& c) {
        RigidContact contact = make(a, at, c.normal, c.distance);
        contact.part = part;
        contact.friction = std::sqrt(body.friction * friction);
        contact.restitution = body.restitution;
        found.push_back(contact);
      });
    }
    choose(found, body.shape->radius, contacts);
  }

  void between(std::size_t a, std::size_t b) {
    if (m_bodies[a].kinematic && m_bodies[b].kinematic) return;
    const double margin = marginOf(a) + marginOf(b);
    const double reach = m_bodies[a].shape->radius + m_bodies[b].shape->radius + margin;
    if (length(m_states[a].position - m_states[b].position) > reach) return;
    std::vector<RigidContact> found;
    pointsAgainst(a, b, margin, found);
    const std::size_t own = found.size();
    pointsAgainst(b, a, margin, found);
    for (std::size_t k = own; k < found.size(); ++k) {
      std::swap(found[k].a, found[k].b);
      found[k].normal = -found[k].normal;
    }
    choose(found, std::min(m_bodies[a].shape->radius, m_bodies[b].shape->radius), contacts);
  }

  std::vector<RigidContact> contacts;

 private:
  double marginOf(std::size_t a) const {
    return 1.5 * wayOf(m_bodies[a], m_states[a], m_seconds) + 5e-3 * m_bodies[a].shape->radius;
  }
  static RigidContact make(std::size_t a, Vec3d point, Vec3d normal, double separation) {
    RigidContact c;
    c.a = static_cast<int>(a);
    c.point = point;
    c.normal = normal;
    c.separation = separation;
    return c;
  }

  /// Points of a in the field of b.
  void pointsAgainst(std::size_t a, std::size_t b, double margin, std::vector<RigidContact>& found) const {
    const SignedDistanceView field = m_bodies[b].shape->field->view({});
    const Quaternion toB = m_states[b].orientation.conjugate() * m_states[a].orientation;
    const Vec3d offset = m_states[b].toBody(m_states[a].position);
    for (const Vec3d& p : m_bodies[a].shape->points) {
      const Vec3f q = (offset + toB.rotate(p)).to<float>();
      SignedDistanceView::Value value;
      if (!field.sample(q.x, q.y, q.z, value) || !(static_cast<double>(value.distance) < margin)) continue;
      const Vec3d g = Vec3f{value.x, value.y, value.z}.to<double>();
      if (length(g) < 1e-3) continue;  // deep inside, where the field has no direction
      RigidContact c = make(a, m_states[a].toWorld(p), m_states[b].orientation.rotate(normalized(g)),
                            static_cast<double>(value.distance));
      c.b = static_cast<int>(b);
      c.friction = std::sqrt(m_bodies[a].friction * m_bodies[b].friction);
      c.restitution = std::max(m_bodies[a].restitution, m_bodies[b].restitution);
      found.push_back(c);
    }
  }

  const std::vector<RigidBodyConfig>& m_bodies;
  const std::vector<RigidState>& m_states;
  double m_seconds;
};

}  // namespace

std::vector<RigidContact> findContacts(const std::vector<RigidBodyConfig>& bodies,
                                       const std::vector<RigidState>& states, const RigidStatics& statics,
                                       double staticFriction, double seconds) {
  Finder finder(bodies, states, seconds);
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    finder.againstStatics(a, statics, staticFriction);
    for (std::size_t b = a + 1; b < bodies.size(); ++b) finder.between(a, b);
  }
  return std::move(finder.contacts);
}

}  // namespace spin
