// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "core/sim/frame_store.h"

namespace spin {

/// The ruler of the timeline: frame numbers, the bar of cached frames, key marks of the selected node and the
/// current frame. Dragging scrubs; dragging a key mark moves the keys.
class TimelineBar : public QWidget {
  Q_OBJECT
 public:
  explicit TimelineBar(QWidget* parent = nullptr);

  int first() const { return m_first; }
  int last() const { return m_last; }
  int current() const { return m_current; }
  /// Inclusive; the current frame is moved into it.
  void setRange(int first, int last);
  void setCurrent(int frame);
  /// States of frames 0 .. n-1.
  void setStates(std::vector<FrameState> states);
  /// Missing where nothing was told.
  FrameState stateOf(int frame) const;
  /// Frames at which the selected node has keys; fractions are keys between frames.
  void setKeyFrames(std::vector<double> frames);
  const std::vector<double>& keyFrames() const { return m_keys; }

  int frameAt(double x) const;
  double xOf(double frame) const;
  QSize sizeHint() const override { return {600, 46}; }
  QSize minimumSizeHint() const override { return {160, 46}; }

 Q_SIGNALS:
  /// The user scrubs to a frame.
  void frameRequested(int frame);
  /// The user dragged the key mark at `from` to a whole frame.
  void keyMoved(double from, int to);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void paintRuler(QPainter& painter) const;
  void paintStates(QPainter& painter) const;
  void paintKeys(QPainter& painter) const;
  int keyNear(const QPointF& position) const;
  QString toolTipAt(double x) const;

  int m_first = 0;
  int m_last = 119;
  int m_current = 0;
  std::vector<FrameState> m_states;
  std::vector<double> m_keys;
  int m_dragKey = -1;
  int m_dragTo = 0;
};

/// Distance of ruler labels in frames: 1, 2, 5 times a power of ten, at least minPixels apart.
int rulerStep(double pixelsPerFrame, double minPixels);

}  // namespace spin
