// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace spin {

inline constexpr std::size_t kScaleStops = 9;
using ScaleColours = std::array<Vec3d, kScaleStops>;  ///< linear RGB, evenly spaced from low to high

/// How values become colours.
struct ValueScale {
  double low = 0.0, high = 1.0;  ///< high > low; for classes the numbers of the first and the last colour
  bool logarithmic = false;
  bool classes = false;  ///< colours stand for kinds, not for amounts

  /// Place of a value on the scale, clamped to 0..1; 0 for values that are not finite.
  double place(double value) const;
  /// Takes the range from the 1st to the 99th percentile of the values; those that are not finite, and for
  /// logarithms those not above 0, do not count. 0..1 (1..2) where none does.
  void spanBulk(std::vector<float> values);
  /// Makes high > low, and keeps logarithms within six decades.
  void widen();
};

/// Stops of the colour map: viridis (S. van der Walt, N. Smith 2015, CC0), perceptually even; distinct
/// colours for classes.
const ScaleColours& scaleColours(const ValueScale& scale);
Vec3d scaleColour(const ValueScale& scale, double place);

/// What is printed beside a picture whose colours stand for values.
struct ValueLegend {
  struct Tick {
    double place;      ///< 0..1
    std::string text;  ///< a number; of classes a name, context "Properties"
  };
  const char* title = "";  ///< context "Properties"
  std::string unit;
  ValueScale scale;
  std::vector<Tick> ticks;
};

/// Round numbers on a scale of amounts, at their places.
std::vector<ValueLegend::Tick> amountTicks(const ValueScale& scale);

}  // namespace spin
