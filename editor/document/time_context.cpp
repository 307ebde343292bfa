// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/time_context.h"

#include <algorithm>

#include "core/nodes/settings_nodes.h"
#include "editor/document/scene_document.h"

namespace spin {

TimeContext::TimeContext(SceneDocument* document, QObject* parent) : QObject(parent), m_document(document) {}

double TimeContext::frameRate() const {
  const SceneNode* node = m_document->scene().firstOf(kSimulationType);
  const auto* settings = node ? node->as<SimulationNode>() : nullptr;
  return settings ? settings->frameRate : SimulationNode{}.frameRate;
}

double TimeContext::filmTime() const {
  return m_frame / frameRate();
}

void TimeContext::setFrame(int frame) {
  const int known = std::max(0, frame);
  if (known == m_frame) return;
  m_frame = known;
  Q_EMIT frameChanged(m_frame);
}

}  // namespace spin
