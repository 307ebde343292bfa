// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace spin {

/// Measures how long the event loop of the GUI thread stands still: the longest time by which a tick came
/// late.
class UiWatchdog : public QObject {
  Q_OBJECT
 public:
  static constexpr int kTickMilliseconds = 5;

  explicit UiWatchdog(QObject* parent = nullptr);
  /// Forgets what was measured.
  void restart();
  double longestBlockSeconds() const { return m_longest; }

 private:
  void tick();

  QTimer m_timer;
  QElapsedTimer m_since;
  double m_longest = 0.0;
};

}  // namespace spin
