// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/math/vec.h"
#include "editor/viewport/brush_tip.h"

namespace spin {

/// Changing the brush by moving the pointer: F takes the radius, Shift+F the strength. The key may be held
/// while the pointer moves, or tapped and the change confirmed by a click.
class BrushAdjust {
 public:
  enum class What { Radius, Strength };

  BrushAdjust(What what, const BrushTip& tip, Vec2d pixel) : m_what(what), m_start(tip), m_pixel(pixel) {}

  What what() const { return m_what; }
  /// The tip before the change.
  const BrushTip& start() const { return m_start; }
  /// The tip for the pointer: to the right is more. 100 pixels double the radius; 200 go through the whole
  /// strength.
  BrushTip at(Vec2d pixel) {
    const double travel = pixel.x - m_pixel.x;
    m_moved = m_moved || std::abs(travel) >= kMoved;
    BrushTip tip = m_start;
    if (m_what == What::Radius)
      tip.radius = std::clamp(tip.radius * std::exp2(travel / 100.0), kLeastBrushRadius, kMostBrushRadius);
    else
      tip.strength = std::clamp(tip.strength + travel / 200.0, 0.01, 1.0);
    return tip;
  }
  /// Whether the pointer moved while the key was down, so that letting it go ends the change.
  bool moved() const { return m_moved; }

 private:
  static constexpr double kMoved = 3.0;  // pixels

  What m_what;
  BrushTip m_start;
  Vec2d m_pixel;
  bool m_moved = false;
};

}  // namespace spin
