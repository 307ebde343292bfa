// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace spin {

struct StraightLine {
  double slope = 0.0, offset = 0.0;
};

/// Least squares y = offset + slope x. Needs two different x.
inline StraightLine fitLine(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  double meanX = 0.0, meanY = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    meanX += x[k] / n;
    meanY += y[k] / n;
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - meanX) * (x[k] - meanX);
    xy += (x[k] - meanX) * (y[k] - meanY);
  }
  const double slope = xy / xx;
  return {slope, meanY - slope * meanX};
}

}  // namespace spin
