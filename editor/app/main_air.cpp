// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What the window's menus say about mist and powder in the air: how they are shown. They change the scene's
// picture settings, so that exports show the same.
#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <QUndoStack>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/nodes/settings_nodes.h"
#include "core/sim/air_part.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/app/scene_tools.h"
#include "editor/app/simulation_controller.h"

namespace spin {
namespace {

/// Middle of what hangs in the air of a frame along an axis, m.
std::optional<double> middleOf(const FramePointer& frame, std::size_t axis) {
  const AirPart* air = frame ? frame->part<AirPart>("air") : nullptr;
  if (!air || air->bricks.empty()) return std::nullopt;
  constexpr std::array<int, 3> kBrick{kBrickX, kBrickY, kBrickZ};
  std::int32_t low = air->bricks.front()[axis], high = low;
  for (const auto& brick : air->bricks) {
    low = std::min(low, brick[axis]);
    high = std::max(high, brick[axis]);
  }
  return air->origin[static_cast<int>(axis)] + 0.5 * air->cell * kBrick[axis] * (low + high + 1.0);
}

}  // namespace

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
              [this, property, k] { showAir(property, k); });
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

/// A slice begins in the middle of the cloud: at 0 m there is often nothing.
void MainActions::showAir(const char* property, std::size_t choice) {
  const auto first = static_cast<std::size_t>(AirSlice::AcrossX);
  std::optional<double> middle;
  if (std::string_view(property) == "air_slice" && choice >= first)
    middle = middleOf(m_window->simulation().shownFrame(), choice - first);
  QUndoStack* undo = m_window->document().undoStack();
  if (middle) undo->beginMacro(tr("Show a slice of the air"));
  m_window->tools().setPicture(property, static_cast<std::int64_t>(choice));
  if (!middle) return;
  m_window->tools().setPicture("air_slice_position_m", std::round(*middle * 10.0) / 10.0);
  undo->endMacro();
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
