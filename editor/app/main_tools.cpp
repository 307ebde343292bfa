// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The tool bar and the help menu of the main window.
#include <QActionGroup>
#include <QDialog>
#include <QMenuBar>
#include <QMessageBox>
#include <QTextBrowser>
#include <QToolBar>
#include <QVBoxLayout>

#include "editor/app/brush_bar.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/app/scatter_bar.h"
#include "editor/app/tool_icons.h"
#include "editor/viewport/viewport.h"

namespace spin {

void MainActions::addTools() {
  auto* bar = m_window->addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("toolBar"));
  bar->setIconSize(QSize(22, 22));
  bar->setMovable(false);
  auto* group = new QActionGroup(this);
  Viewport& view = m_window->viewport();
  const QColor colour = m_window->palette().color(QPalette::ButtonText);
  const auto tool = [&](const char* name, const QString& text, int key, Viewport::Tool which) {
    QAction* action = addToggle(nullptr, name, text, which == Viewport::Tool::Select, QKeySequence(key),
                                [&view, which](bool on) {
                                  if (on) view.setTool(which);
                                });
    action->setIcon(toolIcon(which, colour));
    action->setToolTip(
        QStringLiteral("%1 (%2)").arg(text, QKeySequence(key).toString(QKeySequence::NativeText)));
    group->addAction(action);
    bar->addAction(action);
    return action;
  };
  tool("toolSelect", tr("Select"), Qt::Key_Q, Viewport::Tool::Select);
  tool("toolMove", tr("Move"), Qt::Key_W, Viewport::Tool::Move);
  tool("toolRotate", tr("Rotate"), Qt::Key_E, Viewport::Tool::Rotate);
  tool("toolScale", tr("Scale"), Qt::Key_R, Viewport::Tool::Scale);
  tool("toolBrush",
       tr("Paint ground types, temperature, snow depth, what is kept clear, or the selected release"),
       Qt::Key_B, Viewport::Tool::Brush);
  tool("toolOutline", tr("Draw the outline of a release"), Qt::Key_O, Viewport::Tool::Outline);
  tool("toolScatter", tr("Scatter copies of a model over the ground"), Qt::Key_S, Viewport::Tool::Scatter);
  bar->addSeparator();
  QAction* local =
      addToggle(nullptr, "toolLocalAxes", tr("Local axes"), false, QKeySequence(Qt::Key_X),
                [&view](bool on) { view.setGizmoAxes(on ? GizmoAxes::Local : GizmoAxes::World); });
  local->setToolTip(tr("Handles along the model's own axes (X)"));
  bar->addAction(local);
  bar->addSeparator();
  addBrushTools(bar);
}

void MainActions::addBrushTools(QToolBar* bar) {
  Viewport* view = &m_window->viewport();
  auto* brush = new BrushBar(bar, view, &m_window->layers(), this);
  const std::vector<QAction*> modes = brush->modes();
  m_all.insert(m_all.end(), modes.begin(), modes.end());
  connect(findChild<QAction*>(QStringLiteral("toolBrush")), &QAction::toggled, brush, &BrushBar::setVisible);
  auto* scatter = new ScatterBar(bar, &m_window->document(), view, this);
  connect(scatter, &ScatterBar::message, m_window, &MainWindow::showMessage);
  connect(findChild<QAction*>(QStringLiteral("toolScatter")), &QAction::toggled, scatter,
          &ScatterBar::setVisible);
  const auto step = [this, view](const char* name, const QString& text, int key, int steps) {
    QAction* action = add(nullptr, name, text, QKeySequence(key), [view, steps] {
      view->setBrushRadius(steppedBrushRadius(view->brush().tip().radius, steps));
    });
    m_window->addAction(action);
  };
  step("brushSmaller", tr("Smaller brush"), Qt::Key_BracketLeft, -1);
  step("brushLarger", tr("Larger brush"), Qt::Key_BracketRight, 1);
}

void MainActions::addHelpMenu() {
  QMenu* menu = m_window->menuBar()->addMenu(tr("&Help"));
  add(menu, "helpShortcuts", tr("&Keys and pointer"), QKeySequence(Qt::Key_F1), [this] { showShortcuts(); });
  add(menu, "helpAbout", tr("&About Spindrift"), {}, [this] { showAbout(); });
}

void MainActions::showShortcuts() {
  QString rows;
  const auto row = [&rows](const QString& keys, const QString& what) {
    rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
  };
  row(tr("Middle button, Alt + left"), tr("Turn the view"));
  row(tr("Shift + middle button"), tr("Shift the view"));
  row(tr("Wheel, Ctrl + middle button"), tr("Nearer and farther"));
  row(tr("Click"), tr("Select"));
  row(tr("Ctrl while dragging a handle"), tr("Whole steps: 1 m, 15 degrees, 0.1"));
  row(tr("Escape while dragging"), tr("Take the drag back"));
  row(tr("Shift while dragging a handle"), tr("Up and down instead of along the ground"));
  row(tr("F, Shift + F with the brush"), tr("Radius and strength by moving the pointer"));
  row(tr("Shift, Ctrl with the brush"), tr("Smooth; pick the value under the pointer"));
  row(tr("Shift with copies"), tr("Take copies away"));
  row(tr("Ctrl + click with copies"), tr("Choose the model that is copied"));
  row(tr("Click with the outline tool"), tr("Add a corner; on a side, put one in"));
  row(tr("Delete over a corner"), tr("Take the corner out"));
  for (QAction* action : withShortcuts())
    row(action->shortcut().toString(QKeySequence::NativeText), action->text().remove(QLatin1Char('&')));
  auto* dialog = new QDialog(m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Keys and pointer"));
  dialog->resize(480, 620);
  auto* column = new QVBoxLayout(dialog);
  auto* text = new QTextBrowser;
  text->setHtml(QStringLiteral("<table cellpadding=3>%1</table>").arg(rows));
  column->addWidget(text);
  dialog->show();
}

void MainActions::showAbout() {
  QMessageBox::about(
      m_window, tr("About Spindrift"),
      tr("<h3>Spindrift %1</h3><p>Editor and simulator of winter scenes.</p><p>Apache License 2.0. "
         "What it builds on is listed in the file NOTICE.</p>")
          .arg(QStringLiteral(SPIN_VERSION)));
}

}  // namespace spin
