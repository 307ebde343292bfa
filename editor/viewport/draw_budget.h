// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spin {

/// Keeps drawing quick: learns from the time of the last picture how much detail the next one may have, first
/// by drawing less, then by drawing at a lower resolution. Pictures drawn while the view moves have less time
/// than still ones.
class DrawBudget {
 public:
  static constexpr double kMovingSeconds = 0.030;
  static constexpr double kStillSeconds = 0.060;

  struct Effort {
    double quality = 1.0;  ///< RenderOptions::quality
    double scale = 1.0;    ///< pixels drawn per pixel shown, along each axis
    friend bool operator==(const Effort&, const Effort&) = default;
  };
  /// Begins with little detail: for slow drivers, or after a change of scene, until the first times are
  /// known.
  void startLow() { m_moving = m_still = 0.3; }
  Effort effort(bool moving) const;
  /// Tells how long a picture took that was drawn with effort(moving).
  void report(bool moving, double seconds);

 private:
  double m_moving = 1.0;  ///< share of the full work, 1 = all
  double m_still = 1.0;
};

}  // namespace spin
