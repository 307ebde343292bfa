// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/ui_watchdog.h"

#include <algorithm>

namespace spin {

UiWatchdog::UiWatchdog(QObject* parent) : QObject(parent) {
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.setInterval(kTickMilliseconds);
  connect(&m_timer, &QTimer::timeout, this, &UiWatchdog::tick);
  restart();
}

void UiWatchdog::restart() {
  m_longest = 0.0;
  m_since.start();
  m_timer.start();
}

void UiWatchdog::tick() {
  const double gap = static_cast<double>(m_since.nsecsElapsed()) * 1e-9;
  m_longest = std::max(m_longest, gap - kTickMilliseconds * 1e-3);
  m_since.restart();
}

}  // namespace spin
