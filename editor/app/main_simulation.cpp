// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Holding, stepping and resetting the simulation, as a whole and by process.
#include <QMenu>
#include <QMessageBox>

#include "core/nodes/air_nodes.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/app/scene_tools.h"
#include "editor/models/node_icons.h"
#include "editor/timeline/timeline_panel.h"
#include "editor/timeline/transport_icons.h"

namespace spin {

void MainActions::addHoldActions(QMenu* menu) {
  SimulationController& simulation = m_window->simulation();
  TimelinePanel& timeline = m_window->timeline();
  const QColor ink = m_window->palette().color(QPalette::ButtonText);
  const auto finish = [&](QAction* action, const QIcon& icon, const QString& tip) {
    action->setIcon(icon);
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys));
    timeline.addTool(action);
  };
  QAction* hold = add(menu, "simulatePause", tr("&Pause"), QKeySequence(Qt::Key_P), {});
  hold->setCheckable(true);
  connect(hold, &QAction::triggered, &simulation, &SimulationController::setPaused);
  connect(&simulation, &SimulationController::pausedChanged, hold, &QAction::setChecked);
  finish(hold, transportIcon(TransportIcon::HoldRun, ink),
         tr("Hold the simulation; it goes on where it was"));
  finish(add(menu, "simulateStep", tr("S&ingle step"), QKeySequence(Qt::SHIFT | Qt::Key_Right),
             [&simulation] { simulation.stepFrame(); }),
         transportIcon(TransportIcon::StepRun, ink), tr("Hold the simulation and compute one frame further"));
  const auto process = [&](const char* name, const QString& text, const QKeySequence& keys,
                           const char* property, const NodeType& type, const QString& tip) {
    QAction* action = add(menu, name, text, keys, {});
    action->setCheckable(true);
    connect(action, &QAction::triggered, this,
            [this, property](bool on) { m_window->tools().hold(property, on); });
    finish(action, nodeIcon(type), tip);
    return action;
  };
  m_holdSnow = process("simulatePauseSnow", tr("Pause s&now from here"),
                       QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P), "pause_snow", kSnowfallType,
                       tr("Snowfall and cover stand still from the shown frame on"));
  m_holdFlow = process("simulatePauseFlow", tr("Pause &flow from here"), QKeySequence(Qt::SHIFT | Qt::Key_P),
                       "pause_flow", kAvalancheReleaseType,
                       tr("Avalanches, water and bodies stand still from the shown frame on"));
  m_holdAir = process("simulatePauseAir", tr("Pause &mist and powder from here"),
                      QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P), "pause_air", kAirType,
                      tr("Mist, powder and spray stand still from the shown frame on"));
  mayReset = [this] {
    return QMessageBox::question(
               m_window, tr("Reset the simulation"),
               tr("All simulated frames of this scene are thrown away, in memory and on disk, and "
                  "the simulation starts again at the first frame."),
               QMessageBox::Reset | QMessageBox::Cancel) == QMessageBox::Reset;
  };
  finish(add(menu, "simulateReset", tr("&Reset..."), QKeySequence(Qt::CTRL | Qt::Key_Home),
             [this] {
               if (mayReset()) m_window->simulation().reset();
             }),
         transportIcon(TransportIcon::Reset, ink), tr("Throw away all simulated frames and start again"));
  menu->addSeparator();
  connect(&m_window->document(), &SceneDocument::changed, this, &MainActions::showHeld);
  connect(&m_window->time(), &TimeContext::frameChanged, this, &MainActions::showHeld);
  showHeld();
}

/// The check marks tell what is held at the shown frame.
void MainActions::showHeld() {
  m_holdSnow->setChecked(m_window->tools().isHeld("pause_snow"));
  m_holdFlow->setChecked(m_window->tools().isHeld("pause_flow"));
  m_holdAir->setChecked(m_window->tools().isHeld("pause_air"));
}

}  // namespace spin
