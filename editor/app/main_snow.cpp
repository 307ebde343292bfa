// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What the window's menus say about the snow cover: what it shows and how it is lit. They change the scene's
// picture settings, so that exports show the same.
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>

#include "core/nodes/settings_nodes.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/app/scene_tools.h"

namespace spin {

void MainActions::addSnowMenu(QMenu* view) {
  QMenu* menu = view->addMenu(tr("Snow s&hows"));
  menu->setToolTipsVisible(true);
  auto* group = new QActionGroup(this);
  for (std::size_t k = 0; k < kSnowDisplayChoices.size(); ++k) {
    const Choice& choice = kSnowDisplayChoices[k];
    const QByteArray name = QByteArray("snow_") + choice.id;
    QAction* action =
        add(menu, name.constData(), QCoreApplication::translate("Properties", choice.label), {},
            [this, k] { m_window->tools().setPicture("snow_display", static_cast<std::int64_t>(k)); });
    action->setCheckable(true);
    action->setToolTip(
        tr("Colours the snow cover by this value, here and in exported pictures; the range of "
           "colours is set at the picture settings."));
    group->addAction(action);
    m_snowDisplays.push_back(action);
  }
  menu->addSeparator();
  m_publishedSnow = add(menu, "snowPublished", tr("&Published shading (Blinn-Phong)"), {}, {});
  m_publishedSnow->setToolTip(
      tr("Lights the snow by ambient, diffuse and mirrored light as published, instead "
         "of the physically based way."));
  m_publishedSnow->setCheckable(true);
  connect(m_publishedSnow, &QAction::triggered, this, [this](bool on) {
    const SnowShading shading = on ? SnowShading::BlinnPhong : SnowShading::Physical;
    m_window->tools().setPicture("snow_shading", static_cast<std::int64_t>(shading));
  });
  connect(&m_window->document(), &SceneDocument::changed, this, &MainActions::showSnowSettings);
  showSnowSettings();
}

void MainActions::showSnowSettings() {
  const SceneNode* node = m_window->document().scene().firstOf(kRenderType);
  const RenderNode* settings = node ? node->as<RenderNode>() : nullptr;
  const SnowDisplay shown = settings ? settings->snowDisplay : SnowDisplay::Natural;
  m_snowDisplays[static_cast<std::size_t>(shown)]->setChecked(true);
  m_publishedSnow->setChecked(settings && settings->snowShading == SnowShading::BlinnPhong);
}

}  // namespace spin
