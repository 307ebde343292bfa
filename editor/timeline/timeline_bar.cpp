// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/timeline/timeline_bar.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace spin {
namespace {

constexpr double kMargin = 14.0;
constexpr int kRulerBottom = 20;
constexpr int kKeysCentre = 27;
constexpr int kStatesTop = 36;
constexpr int kStatesHeight = 6;

QColor colourOf(FrameState state) {
  switch (state) {
    case FrameState::Ready:
      return QColor(86, 160, 211);
    case FrameState::Stale:
      return QColor(170, 126, 62);
    case FrameState::Missing:
      break;
  }
  return QColor(58, 62, 68);
}

}  // namespace

int rulerStep(double pixelsPerFrame, double minPixels) {
  int decade = 1;
  while (true) {
    for (const int factor : {1, 2, 5})
      if (decade * factor * pixelsPerFrame >= minPixels || decade >= 100000000) return decade * factor;
    decade *= 10;
  }
}

TimelineBar::TimelineBar(QWidget* parent) : QWidget(parent) {
  setObjectName("timelineBar");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFocusPolicy(Qt::ClickFocus);
}

void TimelineBar::setRange(int first, int last) {
  m_first = first;
  m_last = std::max(first, last);
  setCurrent(m_current);
  update();
}

void TimelineBar::setCurrent(int frame) {
  m_current = std::clamp(frame, m_first, m_last);
  update();
}

void TimelineBar::setStates(std::vector<FrameState> states) {
  if (states == m_states) return;
  m_states = std::move(states);
  update();
}

void TimelineBar::setKeyFrames(std::vector<double> frames) {
  if (m_dragKey >= 0 || frames == m_keys) return;
  m_keys = std::move(frames);
  update();
}

double TimelineBar::xOf(double frame) const {
  const double span = std::max(1, m_last - m_first);
  return kMargin + (frame - m_first) / span * (width() - 2.0 * kMargin);
}

int TimelineBar::frameAt(double x) const {
  const double span = std::max(1, m_last - m_first);
  const double frame = m_first + (x - kMargin) / std::max(1.0, width() - 2.0 * kMargin) * span;
  return std::clamp(static_cast<int>(std::lround(frame)), m_first, m_last);
}

void TimelineBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  paintStates(painter);
  paintRuler(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  paintKeys(painter);
  const double x = xOf(m_current);
  painter.setPen(QPen(QColor(235, 240, 245), 1.5));
  painter.drawLine(QPointF(x, 2), QPointF(x, height() - 2));
  painter.setBrush(QColor(235, 240, 245));
  painter.drawPolygon(QPolygonF({{x - 5, 1}, {x + 5, 1}, {x, 8}}));
}

void TimelineBar::paintRuler(QPainter& painter) const {
  const double perFrame = (width() - 2.0 * kMargin) / std::max(1, m_last - m_first);
  const int step = rulerStep(perFrame, 56.0);
  const int minor = rulerStep(perFrame, 8.0);
  const QColor text = palette().color(QPalette::PlaceholderText);
  painter.setPen(text);
  const auto firstMultiple = [this](int by) { return (m_first + by - 1) / by * by; };
  for (int frame = firstMultiple(minor); frame <= m_last; frame += minor)
    painter.drawLine(QPointF(xOf(frame), kRulerBottom - 3), QPointF(xOf(frame), kRulerBottom));
  for (int frame = firstMultiple(step); frame <= m_last; frame += step) {
    const double x = xOf(frame);
    painter.drawLine(QPointF(x, kRulerBottom - 6), QPointF(x, kRulerBottom));
    painter.drawText(QRectF(x - 40, 0, 80, kRulerBottom - 5), Qt::AlignHCenter | Qt::AlignVCenter,
                     QString::number(frame));
  }
}

FrameState TimelineBar::stateOf(int frame) const {
  const auto index = static_cast<std::size_t>(std::max(frame, 0));
  return index < m_states.size() ? m_states[index] : FrameState::Missing;
}

void TimelineBar::paintStates(QPainter& painter) const {
  // Runs of equal state are one rectangle, so that long films stay cheap to paint.
  int begin = m_first;
  while (begin <= m_last) {
    int end = begin;
    while (end < m_last && stateOf(end + 1) == stateOf(begin)) ++end;
    const double left = std::max(kMargin, xOf(begin - 0.5));
    const double right = std::min(width() - kMargin, xOf(end + 0.5));
    painter.fillRect(QRectF(left, kStatesTop, right - left, kStatesHeight), colourOf(stateOf(begin)));
    begin = end + 1;
  }
}

void TimelineBar::paintKeys(QPainter& painter) const {
  painter.setPen(QPen(QColor(30, 30, 30), 1));
  for (std::size_t k = 0; k < m_keys.size(); ++k) {
    const bool dragged = static_cast<int>(k) == m_dragKey;
    const double x = xOf(dragged ? m_dragTo : m_keys[k]);
    painter.setBrush(dragged ? QColor(255, 235, 150) : QColor(240, 196, 74));
    painter.drawPolygon(QPolygonF(
        {{x, kKeysCentre - 5.0}, {x + 5, kKeysCentre}, {x, kKeysCentre + 5.0}, {x - 5, kKeysCentre}}));
  }
}

int TimelineBar::keyNear(const QPointF& position) const {
  if (std::abs(position.y() - kKeysCentre) > 7) return -1;
  int best = -1;
  double bestDistance = 7.0;
  for (std::size_t k = 0; k < m_keys.size(); ++k) {
    const double distance = std::abs(xOf(m_keys[k]) - position.x());
    if (distance < bestDistance) {
      best = static_cast<int>(k);
      bestDistance = distance;
    }
  }
  return best;
}

void TimelineBar::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  m_dragKey = keyNear(event->position());
  if (m_dragKey >= 0) {
    m_dragTo = frameAt(event->position().x());
    update();
    return;
  }
  Q_EMIT frameRequested(frameAt(event->position().x()));
}

void TimelineBar::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  const int frame = frameAt(event->position().x());
  if (m_dragKey >= 0) {
    m_dragTo = frame;
    update();
  } else if (frame != m_current) {
    Q_EMIT frameRequested(frame);
  }
}

void TimelineBar::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || m_dragKey < 0) return;
  const double from = m_keys[static_cast<std::size_t>(m_dragKey)];
  const int to = m_dragTo;
  m_dragKey = -1;
  update();
  if (std::abs(from - to) > 1e-6) Q_EMIT keyMoved(from, to);
}

bool TimelineBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), toolTipAt(help->pos().x()), this);
  return true;
}

QString TimelineBar::toolTipAt(double x) const {
  const int frame = frameAt(x);
  switch (stateOf(frame)) {
    case FrameState::Ready:
      return tr("Frame %1: simulated").arg(frame);
    case FrameState::Stale:
      return tr("Frame %1: from before the last change").arg(frame);
    case FrameState::Missing:
      break;
  }
  return tr("Frame %1: not simulated yet").arg(frame);
}

}  // namespace spin
