// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spin {

/// Which frame to show while the film plays: film speed is kept and frames are dropped where drawing is
/// slower. Plays round and round in its range.
class PlaybackClock {
 public:
  /// Starts at `frame` (moved into the range first..last) at `now`, s of any steady clock.
  void start(int frame, int first, int last, double frameRate, double now);
  int frameAt(double now) const;
  /// Seconds until the next frame is due.
  double untilNext(double now) const;

 private:
  int m_start = 0;
  int m_first = 0;
  int m_count = 1;
  double m_rate = 24.0;
  double m_began = 0.0;
};

}  // namespace spin
