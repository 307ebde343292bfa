// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/math/vec.h"

namespace spin {

/// Cuts the full picture of a resting view into bands, each drawn in one turn of the event loop, so that a
/// slow driver shows full detail without holding up the window. Learns the height of a band from the last
/// one's time.
class BandPlan {
 public:
  static constexpr double kBandSeconds = 0.050;
  static constexpr double kLeastShare = 1.0 / 32.0;

  void restart() { m_from = 0.0; }
  bool done() const { return m_from >= 1.0; }
  /// The next band as shares of the height, from the bottom.
  Vec2d next() const {
    // A rest too thin to be worth a turn of its own goes with the last band.
    const double to = m_from + m_share;
    return {m_from, to > 1.0 - 0.5 * kLeastShare ? 1.0 : to};
  }
  /// Tells how long next() took and moves on.
  void report(double seconds) {
    m_from = next().y;
    const double factor = std::clamp(0.9 * kBandSeconds / std::max(seconds, 1e-6), 0.4, 1.5);
    m_share = std::clamp(m_share * factor, kLeastShare, 1.0);
  }

 private:
  double m_from = 0.0;
  double m_share = 1.0 / 12.0;
};

}  // namespace spin
