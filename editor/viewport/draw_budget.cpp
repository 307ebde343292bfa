// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/draw_budget.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

// Share of the full work, from which detail and resolution follow.
constexpr double kFloor = 0.05;
// Detail goes down to this first; only then the resolution.
constexpr double kLeastQuality = 0.25;
constexpr double kLeastScale = 0.35;

}  // namespace

DrawBudget::Effort DrawBudget::effort(bool moving) const {
  const double level = moving ? m_moving : m_still;
  if (level >= 1.0) return {};
  const double quality = std::clamp(level * 1.5, kLeastQuality, 1.0);
  const double rest = level >= 0.5 ? 1.0 : level / 0.5;
  // Steps of an eighth: the picture does not change its size with every frame.
  const double scale = std::clamp(std::round(std::sqrt(rest) * 8.0) / 8.0, kLeastScale, 1.0);
  return {quality, scale};
}

void DrawBudget::report(bool moving, double seconds) {
  double& level = moving ? m_moving : m_still;
  const double budget = moving ? kMovingSeconds : kStillSeconds;
  if (seconds > budget)
    level *= std::max(0.3, 0.9 * budget / seconds);
  else if (seconds < 0.6 * budget)
    level *= std::clamp(0.8 * budget / std::max(seconds, 1e-6), 1.1, 1.6);
  level = std::clamp(level, kFloor, 1.0);
}

}  // namespace spin
