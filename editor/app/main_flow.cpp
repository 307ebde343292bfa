// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What the window's menus say about flow: how it is shown. They change the scene's picture settings, so that
// exports show the same.
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

#include "core/nodes/settings_nodes.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/app/scene_tools.h"

namespace spin {

void MainActions::addFlowMenu(QMenu* view) {
  QMenu* menu = view->addMenu(tr("Flo&w shows"));
  auto* group = new QActionGroup(this);
  for (std::size_t k = 0; k < kFlowDisplayChoices.size(); ++k) {
    const Choice& choice = kFlowDisplayChoices[k];
    const QByteArray name = QByteArray("flow_") + choice.id;
    QAction* action =
        add(menu, name.constData(), QCoreApplication::translate("Properties", choice.label), {},
            [this, k] { m_window->tools().setPicture("flow_display", static_cast<std::int64_t>(k)); });
    action->setCheckable(true);
    group->addAction(action);
    m_flowDisplays.push_back(action);
  }
  menu->addSeparator();
  m_flowBoundary = add(menu, "flowBoundary", tr("&Boundary particles"), {}, {});
  m_flowBoundary->setCheckable(true);
  m_flowBoundary->setToolTip(
      tr("The particles on the surface of rigid bodies that the flow pushes against; terrain has none"));
  menu->setToolTipsVisible(true);
  connect(m_flowBoundary, &QAction::triggered, this,
          [this](bool on) { m_window->tools().setPicture("show_flow_boundary", on); });
  connect(&m_window->document(), &SceneDocument::changed, this, &MainActions::showFlowSettings);
  showFlowSettings();
}

void MainActions::showFlowSettings() {
  const SceneNode* node = m_window->document().scene().firstOf(kRenderType);
  const RenderNode* settings = node ? node->as<RenderNode>() : nullptr;
  const FlowDisplay shown = settings ? settings->flowDisplay : FlowDisplay::Material;
  m_flowDisplays[static_cast<std::size_t>(shown)]->setChecked(true);
  m_flowBoundary->setChecked(settings && settings->showFlowBoundary);
}

}  // namespace spin
