// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What lies under the pointer of the viewport. Finding it costs a ray through the scene, so it follows the
// pointer a few times a second and not with every event.
#include "editor/viewport/cover_reading.h"
#include "editor/viewport/flow_reading.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"

namespace spin {

void Viewport::setShowReading(bool on) {
  m_showReading = on;
  scheduleReading();
}

void Viewport::scheduleReading() {
  if (!m_readTimer.isActive()) m_readTimer.start();
}

void Viewport::updateReading() {
  QString text;
  if (m_showReading && m_pointerInside && m_scene && !editing()) {
    const ViewportContext seen = context();
    const auto below = readCover(*m_scene, m_frame.get(), m_filmTime, seen.view.ray(m_pointer));
    const auto flow = readFlow(*m_scene, m_frame.get(), m_filmTime, seen.view, m_pointer);
    // Flow lies on the ground, so that a little behind it is still before it.
    const bool hidden =
        flow && below && seen.view.depth(flow->point) > 1.02 * seen.view.depth(below->point) + 1.0;
    if (flow && !hidden)
      text = readingText(*flow);
    else if (below)
      text = readingText(*below);
  }
  if (text == m_reading) return;
  m_reading = text;
  updateOverlay();
}

}  // namespace spin
