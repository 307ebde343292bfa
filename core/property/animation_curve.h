// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/property/property_table.h"

namespace spin {

enum class Interpolation : std::uint8_t { Step, Linear, Smooth };

/// Value at a film time; `interpolation` rules the span from this key to the next.
struct Key {
  double time = 0.0;  ///< film seconds
  Value value;
  Interpolation interpolation = Interpolation::Linear;
  friend bool operator==(const Key&, const Key&) = default;
};

/// Keys in ascending, distinct times. Before the first and after the last key the value is held.
/// Reals and vectors interpolate (Smooth: monotone cubic of Fritsch and Carlson 1980 with the slopes of
/// Fritsch and Butland 1984, level at both ends, never past its keys); all other kinds step.
class AnimationCurve {
 public:
  const std::vector<Key>& keys() const { return m_keys; }
  bool empty() const { return m_keys.empty(); }
  /// Inserts, or replaces a key within 1e-6 s of the same time.
  void setKey(Key key);
  /// Removes the key within 1e-6 s of the time; false if there is none.
  bool removeKey(double time);
  /// The key within 1e-6 s of the time; nullptr if there is none.
  const Key* keyAt(double time) const;
  /// Requires at least one key.
  Value at(double time) const;
  friend bool operator==(const AnimationCurve&, const AnimationCurve&) = default;

 private:
  std::vector<Key> m_keys;
};

}  // namespace spin
