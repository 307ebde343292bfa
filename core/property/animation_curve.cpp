// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/property/animation_curve.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace spin {
namespace {

/// Keys nearer than this are the same key, s.
constexpr double kSameTime = 1e-6;

using Keys = std::vector<Key>;

double component(const Value& value, int axis) {
  const Vec3d* vector = std::get_if<Vec3d>(&value);
  return vector ? (*vector)[axis] : std::get<double>(value);
}

double secant(const Keys& keys, std::size_t i, int axis) {
  return (component(keys[i + 1].value, axis) - component(keys[i].value, axis)) /
         (keys[i + 1].time - keys[i].time);
}

/// Slope at a key: weighted harmonic mean of the neighbouring secants (Fritsch and Butland 1984), which
/// stays in the monotone region of Fritsch and Carlson 1980 (at most 3 times the smaller secant). Zero at a
/// turning point and at both ends, where the curve is held.
double slope(const Keys& keys, std::size_t i, int axis) {
  if (i == 0 || i + 1 == keys.size()) return 0.0;
  const double before = secant(keys, i - 1, axis), after = secant(keys, i, axis);
  if (before * after <= 0.0) return 0.0;
  const double h0 = keys[i].time - keys[i - 1].time, h1 = keys[i + 1].time - keys[i].time;
  const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / before + w1 / after);
}

/// Cubic Hermite span between keys i and i + 1 at u in 0..1.
double smooth(const Keys& keys, std::size_t i, double u, int axis) {
  const double h = keys[i + 1].time - keys[i].time;
  const double a = component(keys[i].value, axis), b = component(keys[i + 1].value, axis);
  const double m0 = h * slope(keys, i, axis), m1 = h * slope(keys, i + 1, axis);
  const double u2 = u * u, u3 = u2 * u;
  return a + (b - a) * (3.0 * u2 - 2.0 * u3) + m0 * (u3 - 2.0 * u2 + u) + m1 * (u3 - u2);
}

double interpolated(const Keys& keys, std::size_t i, double u, int axis) {
  const double a = component(keys[i].value, axis), b = component(keys[i + 1].value, axis);
  const double value =
      keys[i].interpolation == Interpolation::Smooth ? smooth(keys, i, u, axis) : a * (1.0 - u) + b * u;
  // Rounding must not carry a value past its key: the property's range holds for keys only.
  return std::clamp(value, std::min(a, b), std::max(a, b));
}

bool isNumeric(const Value& value) {
  return std::holds_alternative<double>(value) || std::holds_alternative<Vec3d>(value);
}

auto atOrAfter(auto& keys, double time) {
  return std::lower_bound(keys.begin(), keys.end(), time,
                          [](const Key& key, double t) { return key.time < t; });
}

}  // namespace

void AnimationCurve::setKey(Key key) {
  SPIN_CHECK(std::isfinite(key.time), "time of a key");
  const auto found = atOrAfter(m_keys, key.time - kSameTime);
  if (found != m_keys.end() && found->time <= key.time + kSameTime) {
    key.time = found->time;
    *found = std::move(key);
  } else {
    m_keys.insert(found, std::move(key));
  }
}

bool AnimationCurve::removeKey(double time) {
  const auto found = atOrAfter(m_keys, time - kSameTime);
  if (found == m_keys.end() || found->time > time + kSameTime) return false;
  m_keys.erase(found);
  return true;
}

const Key* AnimationCurve::keyAt(double time) const {
  const auto found = atOrAfter(m_keys, time - kSameTime);
  return found != m_keys.end() && found->time <= time + kSameTime ? &*found : nullptr;
}

Value AnimationCurve::at(double time) const {
  SPIN_CHECK(!m_keys.empty(), "value of a curve without keys");
  if (!(time > m_keys.front().time)) return m_keys.front().value;
  if (time >= m_keys.back().time) return m_keys.back().value;
  const auto next = std::upper_bound(m_keys.begin(), m_keys.end(), time,
                                     [](double t, const Key& key) { return t < key.time; });
  const std::size_t i = static_cast<std::size_t>(next - m_keys.begin()) - 1;
  const Key& from = m_keys[i];
  if (from.interpolation == Interpolation::Step || !isNumeric(from.value) ||
      from.value.index() != next->value.index())
    return from.value;
  const double u = (time - from.time) / (next->time - from.time);
  if (std::holds_alternative<double>(from.value)) return interpolated(m_keys, i, u, 0);
  return Vec3d{interpolated(m_keys, i, u, 0), interpolated(m_keys, i, u, 1), interpolated(m_keys, i, u, 2)};
}

}  // namespace spin
