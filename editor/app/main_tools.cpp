// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The tool bar and the help menu of the main window.
#include <QActionGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QToolBar>
#include <QVBoxLayout>

#include "core/nodes/flow_nodes.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/app/tool_icons.h"
#include "editor/panels/field_keys.h"
#include "editor/viewport/picture_view.h"
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
  tool("toolBrush", tr("Paint ground types, or the area of the selected release"), Qt::Key_B,
       Viewport::Tool::Brush);
  tool("toolOutline", tr("Draw the outline of a release"), Qt::Key_O, Viewport::Tool::Outline);
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
  auto* type = new QComboBox;
  type->setObjectName(QStringLiteral("brushType"));
  type->setToolTip(tr("Ground type that the brush paints"));
  for (int k = 0; k < kGroundTypeCount; ++k)
    type->addItem(
        QCoreApplication::translate("Properties", kGroundTypeChoices[static_cast<std::size_t>(k)].label), k);
  type->addItem(tr("Rub out"), static_cast<int>(kUnpaintedGround));
  type->setCurrentIndex(type->findData(static_cast<int>(view->brush().value())));
  connect(type, &QComboBox::currentIndexChanged, view,
          [view, type] { view->brush().setValue(static_cast<std::uint8_t>(type->currentData().toInt())); });
  auto* area = new QComboBox;
  area->setObjectName(QStringLiteral("brushArea"));
  area->setToolTip(tr("What the brush does to the area of the selected release"));
  area->addItem(tr("Release here"), false);
  area->addItem(tr("Rub out"), true);
  connect(area, &QComboBox::currentIndexChanged, view,
          [view, area] { view->brush().setRubsOut(area->currentData().toBool()); });
  auto* radius = new QDoubleSpinBox;
  radius->setObjectName(QStringLiteral("brushRadius"));
  radius->setRange(0.5, 500.0);
  radius->setDecimals(1);
  radius->setSuffix(tr(" m"));
  radius->setValue(view->brush().radius());
  radius->setToolTip(tr("Radius of the brush ([ and ], or Ctrl + wheel)"));
  connect(radius, &QDoubleSpinBox::valueChanged, view, &Viewport::setBrushRadius);
  connect(view, &Viewport::brushRadiusChanged, radius, [radius](double metres) {
    const QSignalBlocker quiet(radius);
    radius->setValue(metres);
  });
  connect(new FieldKeys(radius), &FieldKeys::entered, view, [view] { view->surface()->setFocus(); });
  QAction* brush = findChild<QAction*>(QStringLiteral("toolBrush"));
  QAction* typeShown = bar->addWidget(type);
  QAction* areaShown = bar->addWidget(area);
  QAction* radiusShown = bar->addWidget(radius);
  const auto show = [=, this] {
    const SceneNode* node = m_window->document().node(m_window->document().selected());
    const bool release = node && node->as<AvalancheReleaseNode>();
    typeShown->setVisible(brush->isChecked() && !release);
    areaShown->setVisible(brush->isChecked() && release);
    radiusShown->setVisible(brush->isChecked());
  };
  connect(brush, &QAction::toggled, this, show);
  connect(&m_window->document(), &SceneDocument::selectionChanged, this, show);
  show();
  const auto step = [this, view](const char* name, const QString& text, int key, int steps) {
    QAction* action = add(nullptr, name, text, QKeySequence(key), [view, steps] {
      view->setBrushRadius(steppedBrushRadius(view->brush().radius(), steps));
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
  row(tr("Shift while dragging a handle of flow"), tr("Up and down instead of along the ground"));
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
