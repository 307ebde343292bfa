// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/main_actions.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include "core/nodes/node_registry.h"
#include "core/nodes/terrain_node.h"
#include "editor/app/brush_bar.h"
#include "editor/app/file_flow.h"
#include "editor/app/import_flow.h"
#include "editor/app/main_window.h"
#include "editor/app/scene_tools.h"
#include "editor/commands/edits.h"
#include "editor/models/node_icons.h"
#include "editor/timeline/timeline_panel.h"
#include "editor/viewport/viewport.h"

namespace spin {

MainActions::MainActions(MainWindow* window) : QObject(window), m_window(window) {
  addFileMenu();
  addEditMenu();
  addViewMenu();
  addSimulateMenu();
  addTools();
  addHelpMenu();
  addTransport();
  connect(&window->document(), &SceneDocument::selectionChanged, this, &MainActions::followSelection);
  followSelection();
}

QAction* MainActions::add(QMenu* menu, const char* name, const QString& text, const QKeySequence& keys,
                          const Handler& handler) {
  auto* action = new QAction(text, this);
  action->setObjectName(QLatin1String(name));
  action->setShortcut(keys);
  if (menu) menu->addAction(action);
  if (handler) connect(action, &QAction::triggered, this, handler);
  m_all.push_back(action);
  return action;
}

QAction* MainActions::addToggle(QMenu* menu, const char* name, const QString& text, bool on,
                                const QKeySequence& keys, const std::function<void(bool)>& handler) {
  QAction* action = add(menu, name, text, keys, {});
  action->setCheckable(true);
  action->setChecked(on);
  connect(action, &QAction::toggled, this, handler);
  return action;
}

void MainActions::addFileMenu() {
  QMenu* menu = m_window->menuBar()->addMenu(tr("&File"));
  FileFlow& files = m_window->files();
  add(menu, "fileNew", tr("&New"), QKeySequence::New, [&files] { files.newScene(); });
  add(menu, "fileOpen", tr("&Open..."), QKeySequence::Open, [&files] { files.open(); });
  QMenu* recent = menu->addMenu(tr("Open &recent"));
  connect(menu, &QMenu::aboutToShow, recent, [&files, recent] { files.fillRecent(recent); });
  menu->addSeparator();
  add(menu, "fileSave", tr("&Save"), QKeySequence::Save, [&files] { files.save(); });
  add(menu, "fileSaveAs", tr("Save &as..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
      [&files] { files.saveAs(); });
  add(menu, "fileCollect", tr("&Collect files beside the scene"), {}, [this] {
    const Status status = m_window->imports().collect();
    if (!status.ok()) m_window->files().showError(QString::fromStdString(status.error().text()));
  });
  menu->addSeparator();
  add(menu, "fileImport", tr("&Import terrain or model..."), QKeySequence(Qt::CTRL | Qt::Key_I),
      [this] { m_window->imports().choose(); });
  add(menu, "fileExport", tr("&Export..."), QKeySequence(Qt::CTRL | Qt::Key_E),
      [this] { m_window->showExportDialog(); });
  menu->addSeparator();
  add(menu, "fileQuit", tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), [this] { m_window->close(); });
}

void MainActions::addEditMenu() {
  QMenu* menu = m_window->menuBar()->addMenu(tr("&Edit"));
  QUndoStack* undo = m_window->document().undoStack();
  QAction* undoAction = undo->createUndoAction(this, tr("&Undo"));
  undoAction->setObjectName(QStringLiteral("editUndo"));
  undoAction->setShortcut(QKeySequence::Undo);
  QAction* redoAction = undo->createRedoAction(this, tr("&Redo"));
  redoAction->setObjectName(QStringLiteral("editRedo"));
  redoAction->setShortcuts(
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  menu->addActions({undoAction, redoAction});
  m_all.insert(m_all.end(), {undoAction, redoAction});
  menu->addSeparator();
  m_duplicate = add(menu, "editDuplicate", tr("&Duplicate"), QKeySequence(Qt::CTRL | Qt::Key_D), [this] {
    SceneDocument& document = m_window->document();
    const Result<std::string> copy = edit::duplicateNode(document, document.selected());
    if (copy.ok()) document.select(*copy);
  });
  m_delete = add(menu, "editDelete", tr("De&lete"), QKeySequence::Delete, [this] {
    SceneDocument& document = m_window->document();
    const Status status = edit::removeNode(document, document.selected());
    if (!status.ok()) m_window->files().showError(QString::fromStdString(status.error().text()));
  });
  add(menu, "editSetKeys", tr("Set &keys"), QKeySequence(Qt::Key_K), [this] { m_window->tools().setKeys(); });
  menu->addSeparator();
  BrushBar::fillLayerMenu(menu->addMenu(tr("&Painted layer")), &m_window->layers());
  m_nodeMenu = menu->addMenu(tr("&Add node"));
  m_nodeMenu->setObjectName(QStringLiteral("addNodeMenu"));
  connect(m_nodeMenu, &QMenu::aboutToShow, this, &MainActions::fillNodeMenu);
}

void MainActions::fillNodeMenu() {
  m_nodeMenu->clear();
  m_nodeMenu->setToolTipsVisible(true);
  for (const NodeType* type : nodeTypes()) {
    const QString label = QCoreApplication::translate("Properties", type->label);
    const bool file = type == &kTerrainType || type == &kModelType;
    QAction* action = m_nodeMenu->addAction(file ? tr("%1...").arg(label) : label);
    action->setToolTip(QCoreApplication::translate("Properties", type->doc));
    action->setIcon(nodeIcon(*type));
    action->setEnabled(!type->single || !m_window->document().scene().firstOf(*type));
    connect(action, &QAction::triggered, this, [this, type] { addNode(*type); });
  }
}

void MainActions::addNode(const NodeType& type) {
  if (&type == &kTerrainType || &type == &kModelType) return m_window->imports().choose();
  const QString label = QCoreApplication::translate("Properties", type.label);
  const Result<std::string> added = m_window->tools().addNode(type, label);
  if (!added.ok()) m_window->files().showError(QString::fromStdString(added.error().text()));
}

void MainActions::addViewMenu() {
  QMenu* menu = m_window->menuBar()->addMenu(tr("&View"));
  Viewport& view = m_window->viewport();
  add(menu, "viewFrame", tr("&Frame selection"), QKeySequence(Qt::Key_F), [&view] { view.frameSelection(); });
  add(menu, "viewFrameAll", tr("Frame &all"), QKeySequence(Qt::SHIFT | Qt::Key_F),
      [&view] { view.frameAll(); });
  QAction* through = addToggle(menu, "viewLookThrough", tr("&Look through the camera"), false,
                               QKeySequence(Qt::Key_C), [&view](bool on) { view.setLookThrough(on); });
  connect(&view, &Viewport::lookThroughChanged, through, &QAction::setChecked);
  add(menu, "viewSetCamera", tr("&Set the camera from the view"), QKeySequence(Qt::CTRL | Qt::Key_Period),
      [this] { m_window->tools().cameraFromView(); });
  menu->addSeparator();
  addGroundMenu(menu);
  addSnowMenu(menu);
  addFlowMenu(menu);
  addAirMenu(menu);
  addToggle(menu, "viewSnow", tr("S&now cover"), true, {}, [&view](bool on) { view.setShowSnow(on); });
  addToggle(menu, "viewFlakes", tr("Fa&lling flakes"), true, {},
            [&view](bool on) { view.setShowFlakes(on); });
  QAction* reading = addToggle(menu, "viewReading", tr("&Values under the pointer"), true, {},
                               [&view](bool on) { view.setShowReading(on); });
  reading->setToolTip(
      tr("A line at the lower left: depth, mass and temperature of the snow under the pointer, "
         "and the type of the ground."));
  const QSettings settings;
  const bool hints = settings.value("view/hints", true).toBool();
  view.setShowHints(hints);
  addToggle(menu, "viewHints", tr("&Hints of the tools"), hints, {}, [&view](bool on) {
    view.setShowHints(on);
    QSettings().setValue("view/hints", on);
  });
  menu->addSeparator();
  for (QDockWidget* dock : m_window->findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly))
    menu->addAction(dock->toggleViewAction());
  add(menu, "viewReset", tr("&Reset the layout"), {}, [this] { m_window->resetLayout(); });
}

void MainActions::addGroundMenu(QMenu* view) {
  QMenu* menu = view->addMenu(tr("&Ground shows"));
  auto* group = new QActionGroup(this);
  const auto mode = [&](const char* name, const QString& text, GroundDisplay display, bool on) {
    QAction* action = addToggle(menu, name, text, on, {}, [this, display](bool checked) {
      if (checked) m_window->viewport().setGroundDisplay(display);
    });
    group->addAction(action);
  };
  mode("groundNatural", tr("&Natural colours"), GroundDisplay::Natural, true);
  mode("groundTypes", tr("Ground &types"), GroundDisplay::GroundType, false);
  mode("groundTemperature", tr("Ground t&emperature"), GroundDisplay::GroundTemperature, false);
  mode("groundDepth", tr("Painted snow &depth"), GroundDisplay::SnowDepth, false);
  mode("groundClear", tr("What is &kept clear"), GroundDisplay::KeepClear, false);
  menu->addSeparator();
  Viewport& viewport = m_window->viewport();
  addToggle(menu, "groundPainted", tr("The &painted layer while painting"), viewport.showPainted(), {},
            [&viewport](bool on) { viewport.setShowPainted(on); });
}

void MainActions::addSimulateMenu() {
  QMenu* menu = m_window->menuBar()->addMenu(tr("&Simulate"));
  SimulationController& simulation = m_window->simulation();
  add(menu, "simulateStart", tr("&Simulate"), QKeySequence(Qt::Key_F5),
      [&simulation] { simulation.start(); });
  add(menu, "simulateStop", tr("S&top"), QKeySequence(Qt::SHIFT | Qt::Key_F5),
      [&simulation] { simulation.stop(); });
  addHoldActions(menu);
  addToggle(menu, "simulateAutomatic", tr("Simulate &after edits"), simulation.automatic(), {},
            [&simulation](bool on) { simulation.setAutomatic(on); });
  menu->addSeparator();
  add(menu, "simulatePurge", tr("&Delete out-of-date frames from disk"), {},
      [&simulation] { simulation.purgeStale(); });
}

void MainActions::addTransport() {
  TimelinePanel* timeline = &m_window->timeline();
  QAction* play = add(nullptr, "timePlay", tr("Play or pause"), QKeySequence(Qt::Key_Space),
                      [timeline] { timeline->togglePlaying(); });
  m_window->addAction(play);
  const auto step = [&](const char* name, const QString& text, int key, const Handler& handler) {
    // Only in viewport and timeline: trees and fields need these keys themselves.
    QAction* action = add(nullptr, name, text, QKeySequence(key), handler);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    timeline->addAction(action);
    m_window->viewport().addAction(action);
  };
  step("timePrevious", tr("Previous frame"), Qt::Key_Left, [timeline] { timeline->stepBy(-1); });
  step("timeNext", tr("Next frame"), Qt::Key_Right, [timeline] { timeline->stepBy(1); });
  step("timeFirst", tr("First frame"), Qt::Key_Home, [timeline] { timeline->toFirst(); });
  step("timeLast", tr("Last frame"), Qt::Key_End, [timeline] { timeline->toLast(); });
}

void MainActions::followSelection() {
  const bool any = m_window->document().node(m_window->document().selected()) != nullptr;
  m_duplicate->setEnabled(any);
  m_delete->setEnabled(any);
}

std::vector<QAction*> MainActions::withShortcuts() const {
  std::vector<QAction*> found;
  for (QAction* action : m_all)
    if (!action->shortcut().isEmpty()) found.push_back(action);
  return found;
}

}  // namespace spin
