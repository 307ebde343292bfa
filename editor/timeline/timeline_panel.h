// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "editor/timeline/playback_clock.h"
#include "editor/timeline/timeline_bar.h"

class QAction;
class QLabel;
class QSpinBox;
class QToolButton;

namespace spin {

/// Transport buttons, the current frame and the ruler. Knows frames only; what they show is others' business.
class TimelinePanel : public QWidget {
  Q_OBJECT
 public:
  explicit TimelinePanel(QWidget* parent = nullptr);

  TimelineBar* bar() const { return m_bar; }
  int current() const { return m_bar->current(); }
  bool playing() const { return m_playing; }
  double frameRate() const { return m_rate; }
  /// Adds a button for an action of others at the right end of the transport's row.
  void addTool(QAction* action);
  /// Range (inclusive) and film speed, frames per second.
  void setFilm(int first, int last, double frameRate);

 public Q_SLOTS:
  /// Clamped to the range; tells currentChanged() if it is another frame.
  void setCurrent(int frame);
  void setPlaying(bool on);
  /// Frames are being simulated: playing waits at one that is missing instead of running ahead of the
  /// picture.
  void setGrowing(bool on) { m_growing = on; }
  void togglePlaying() { setPlaying(!m_playing); }
  void toFirst() { scrubTo(m_bar->first()); }
  void toLast() { scrubTo(m_bar->last()); }
  void stepBy(int frames) { scrubTo(current() + frames); }

 Q_SIGNALS:
  void currentChanged(int frame);
  void playingChanged(bool on);

 private:
  QToolButton* addButton(const char* name);
  void scrubTo(int frame);
  void playStep();
  int reachable(int due) const;
  void restartClock();
  void showTime();
  void showTexts();

  TimelineBar* m_bar;
  QToolButton* m_toFirst;
  QToolButton* m_previous;
  QToolButton* m_play;
  QToolButton* m_next;
  QToolButton* m_toLast;
  QSpinBox* m_spin;
  QLabel* m_time;
  QTimer m_timer;
  QElapsedTimer m_elapsed;
  PlaybackClock m_clock;
  double m_rate = 24.0;
  bool m_playing = false;
  bool m_growing = false;
};

}  // namespace spin
