// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "core/sim/frame.h"

class QLabel;
class QTableWidget;
class QToolButton;

namespace spin {

/// Where the time of the shown frame went, stage by stage, and what the frame tells of itself: particles,
/// steps, what limited them, iterations, errors. Can be copied as text.
class StagePanel : public QWidget {
  Q_OBJECT
 public:
  explicit StagePanel(QWidget* parent = nullptr);

  /// Null = nothing is shown.
  void setFrame(const FramePointer& frame);
  /// Both tables, tab-separated with a line of headings each.
  QString text() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fill();
  void fillStages();
  void fillFigures();
  void showTexts();

  FramePointer m_frame;
  QLabel* m_title;
  QTableWidget* m_stages;
  QTableWidget* m_figures;
  QToolButton* m_copy;
};

}  // namespace spin
