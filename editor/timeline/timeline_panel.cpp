// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/timeline/timeline_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "editor/timeline/transport_icons.h"

namespace spin {

TimelinePanel::TimelinePanel(QWidget* parent) : QWidget(parent), m_bar(new TimelineBar(this)) {
  setObjectName("timelinePanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 4);
  column->setSpacing(2);
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  column->addLayout(row);
  column->addWidget(m_bar);

  m_toFirst = addButton("toFirst");
  m_previous = addButton("previousFrame");
  m_play = addButton("play");
  m_next = addButton("nextFrame");
  m_toLast = addButton("toLast");
  const QColor ink = palette().color(QPalette::ButtonText);
  m_toFirst->setIcon(transportIcon(TransportIcon::First, ink));
  m_previous->setIcon(transportIcon(TransportIcon::Previous, ink));
  m_play->setIcon(transportIcon(TransportIcon::Play, ink));
  m_next->setIcon(transportIcon(TransportIcon::Next, ink));
  m_toLast->setIcon(transportIcon(TransportIcon::Last, ink));
  m_spin = new QSpinBox(this);
  m_spin->setObjectName("currentFrame");
  m_spin->setKeyboardTracking(false);
  m_spin->setFocusPolicy(Qt::ClickFocus);
  m_time = new QLabel(this);
  m_time->setObjectName("currentTime");
  row->addWidget(m_spin);
  row->addWidget(m_time);
  row->addStretch();

  connect(m_toFirst, &QToolButton::clicked, this, &TimelinePanel::toFirst);
  connect(m_toLast, &QToolButton::clicked, this, &TimelinePanel::toLast);
  connect(m_previous, &QToolButton::clicked, this, [this] { stepBy(-1); });
  connect(m_next, &QToolButton::clicked, this, [this] { stepBy(1); });
  connect(m_play, &QToolButton::clicked, this, &TimelinePanel::togglePlaying);
  connect(m_spin, &QSpinBox::valueChanged, this, &TimelinePanel::scrubTo);
  connect(m_bar, &TimelineBar::frameRequested, this, &TimelinePanel::scrubTo);
  m_timer.setSingleShot(true);
  m_timer.setTimerType(Qt::PreciseTimer);
  connect(&m_timer, &QTimer::timeout, this, &TimelinePanel::playStep);
  m_elapsed.start();
  setFilm(0, 119, 24.0);
  showTexts();
}

QToolButton* TimelinePanel::addButton(const char* name) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);
  static_cast<QHBoxLayout*>(layout()->itemAt(0)->layout())->addWidget(button);
  return button;
}

void TimelinePanel::addTool(QAction* action) {
  auto* button = new QToolButton(this);
  button->setObjectName(action->objectName());
  button->setDefaultAction(action);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);
  static_cast<QHBoxLayout*>(layout()->itemAt(0)->layout())->addWidget(button);
}

void TimelinePanel::setFilm(int first, int last, double frameRate) {
  const int before = current();
  m_rate = frameRate;
  m_bar->setRange(first, last);
  {
    const QSignalBlocker quiet(m_spin);
    m_spin->setRange(first, std::max(first, last));
    m_spin->setValue(current());
  }
  showTime();
  if (m_playing) restartClock();
  if (current() != before) Q_EMIT currentChanged(current());
}

void TimelinePanel::setCurrent(int frame) {
  const int before = current();
  m_bar->setCurrent(frame);
  const QSignalBlocker quiet(m_spin);
  m_spin->setValue(current());
  showTime();
  if (current() != before) Q_EMIT currentChanged(current());
}

void TimelinePanel::scrubTo(int frame) {
  setCurrent(frame);
  if (m_playing) restartClock();
}

void TimelinePanel::setPlaying(bool on) {
  if (on == m_playing) return;
  m_playing = on;
  m_play->setIcon(
      transportIcon(on ? TransportIcon::Pause : TransportIcon::Play, palette().color(QPalette::ButtonText)));
  showTexts();
  if (on)
    restartClock();
  else
    m_timer.stop();
  Q_EMIT playingChanged(on);
}

void TimelinePanel::restartClock() {
  const double now = static_cast<double>(m_elapsed.nsecsElapsed()) * 1e-9;
  m_clock.start(current(), m_bar->first(), m_bar->last(), m_rate, now);
  m_timer.start(static_cast<int>(std::ceil(m_clock.untilNext(now) * 1000.0)));
}

void TimelinePanel::playStep() {
  const double now = static_cast<double>(m_elapsed.nsecsElapsed()) * 1e-9;
  const int due = m_clock.frameAt(now), frame = reachable(due);
  setCurrent(frame);
  if (m_playing && frame != due) return restartClock();
  if (m_playing) m_timer.start(std::max(1, static_cast<int>(std::ceil(m_clock.untilNext(now) * 1000.0))));
}

/// The last frame on the way to the one that is due before one that is still missing.
int TimelinePanel::reachable(int due) const {
  if (!m_growing) return due;
  int frame = current();
  // Nothing is to be seen from a frame on that is missing itself.
  if (m_bar->stateOf(frame) == FrameState::Missing) return m_bar->first();
  while (frame != due) {
    const int next = frame < m_bar->last() ? frame + 1 : m_bar->first();
    if (m_bar->stateOf(next) == FrameState::Missing) break;
    frame = next;
  }
  return frame;
}

void TimelinePanel::showTime() {
  m_time->setText(tr("%1 s").arg(locale().toString(current() / std::max(1e-3, m_rate), 'f', 2)));
}

void TimelinePanel::showTexts() {
  m_toFirst->setToolTip(tr("First frame (Home)"));
  m_previous->setToolTip(tr("Previous frame (Left)"));
  m_play->setToolTip(m_playing ? tr("Pause (Space)") : tr("Play (Space)"));
  m_next->setToolTip(tr("Next frame (Right)"));
  m_toLast->setToolTip(tr("Last frame (End)"));
  m_spin->setToolTip(tr("Current frame"));
  showTime();
}

}  // namespace spin
