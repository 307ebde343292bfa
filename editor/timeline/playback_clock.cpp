// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/timeline/playback_clock.h"

#include <algorithm>
#include <cmath>

namespace spin {

void PlaybackClock::start(int frame, int first, int last, double frameRate, double now) {
  m_first = first;
  m_count = std::max(1, last - first + 1);
  m_start = std::clamp(frame, first, first + m_count - 1);
  m_rate = std::max(1e-3, frameRate);
  m_began = now;
}

int PlaybackClock::frameAt(double now) const {
  const double passed = std::floor(std::max(0.0, now - m_began) * m_rate + 1e-9);
  return m_first + static_cast<int>(std::fmod(passed + (m_start - m_first), m_count));
}

double PlaybackClock::untilNext(double now) const {
  const double position = std::max(0.0, now - m_began) * m_rate;
  return (std::floor(position + 1e-9) + 1.0 - position) / m_rate;
}

}  // namespace spin
