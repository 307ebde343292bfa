// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/dark_look.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace spin {
namespace {

QPalette darkPalette() {
  const QColor window(43, 46, 51), base(31, 33, 37), text(218, 222, 227), dim(150, 157, 165);
  const QColor faint(108, 114, 121), button(55, 59, 65), accent(64, 132, 184);
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(36, 39, 43));
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::PlaceholderText, dim);
  palette.setColor(QPalette::Button, button);
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, QColor(255, 120, 110));
  palette.setColor(QPalette::ToolTipBase, QColor(60, 64, 70));
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor(110, 175, 225));
  palette.setColor(QPalette::LinkVisited, QColor(160, 150, 215));
  palette.setColor(QPalette::Light, QColor(74, 79, 86));
  palette.setColor(QPalette::Midlight, QColor(62, 66, 72));
  palette.setColor(QPalette::Mid, QColor(36, 39, 43));
  palette.setColor(QPalette::Dark, QColor(26, 28, 31));
  palette.setColor(QPalette::Shadow, QColor(14, 15, 17));
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, faint);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(70, 74, 80));
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, dim);
  return palette;
}

}  // namespace

void applyDarkLook(QApplication& application) {
  QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
  QApplication::setPalette(darkPalette());
  application.setStyleSheet(QStringLiteral(
      "QToolTip { color: #dadee3; background: #3c4046; border: 1px solid #55595f; padding: 3px; }"
      "QDockWidget::title { background: #24272b; padding: 5px 8px; }"
      "QMainWindow::separator { background: #1c1e21; width: 4px; height: 4px; }"
      "QMainWindow::separator:hover { background: #4084b8; }"
      "QStatusBar::item { border: none; }"
      "QToolBar { border: none; spacing: 3px; padding: 3px; }"));
}

}  // namespace spin
