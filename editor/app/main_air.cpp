// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What the window's menus say about mist and powder in the air: how they are shown. They change the scene's
// picture settings, so that exports show the same.
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

#include "core/nodes/settings_nodes.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/app/scene_tools.h"

namespace spin {

void MainActions::addAirMenu(QMenu* view) {
  QMenu* menu = view->addMenu(tr("&Air shows"));
  menu->setToolTipsVisible(true);
  const auto addChoices = [&](const auto& choices, const char* property, const QString& tip,
                              std::vector<QAction*>& actions) {
    auto* group = new QActionGroup(this);
    for (std::size_t k = 0; k < choices.size(); ++k) {
      const QByteArray name = QByteArray("air_") + choices[k].id;
      QAction* action =
          add(menu, name.constData(), QCoreApplication::translate("Properties", choices[k].label), {},
              [this, property, k] { m_window->tools().setPicture(property, static_cast<std::int64_t>(k)); });
      action->setCheckable(true);
      action->setToolTip(tip);
      group->addAction(action);
      actions.push_back(action);
    }
  };
  addChoices(
      kAirDisplayChoices, "air_display",
      tr("Colours mist and powder in the air by this value, here and in exported pictures; the range of "
         "colours is set at the picture settings."),
      m_airDisplays);
  menu->addSection(tr("Slice"));
  addChoices(kAirSliceChoices, "air_slice",
             tr("Shows the value on a plane across this axis instead of in the whole cloud; where the plane "
                "stands is set at the picture settings."),
             m_airSlices);
  connect(&m_window->document(), &SceneDocument::changed, this, &MainActions::showAirSettings);
  showAirSettings();
}

void MainActions::showAirSettings() {
  const SceneNode* node = m_window->document().scene().firstOf(kRenderType);
  const RenderNode* settings = node ? node->as<RenderNode>() : nullptr;
  const AirDisplay shown = settings ? settings->airDisplay : AirDisplay::Natural;
  const AirSlice slice = settings ? settings->airSlice : AirSlice::Off;
  m_airDisplays[static_cast<std::size_t>(shown)]->setChecked(true);
  m_airSlices[static_cast<std::size_t>(slice)]->setChecked(true);
}

}  // namespace spin
