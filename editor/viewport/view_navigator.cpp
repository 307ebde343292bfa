// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/view_navigator.h"

namespace spin {
namespace {

constexpr double kZoomStepsPerPixel = 0.02;

}  // namespace

void ViewNavigator::setCamera(const OrbitCamera& camera) {
  m_camera = camera;
  m_flight.reset();
}

bool ViewNavigator::press(const QMouseEvent& event) {
  const Qt::KeyboardModifiers keys = event.modifiers();
  const bool left = event.button() == Qt::LeftButton && keys.testFlag(Qt::AltModifier);
  if (!left && event.button() != Qt::MiddleButton) return false;
  m_drag = keys.testFlag(Qt::ShiftModifier)     ? Drag::Pan
           : keys.testFlag(Qt::ControlModifier) ? Drag::Zoom
                                                : Drag::Orbit;
  m_last = event.position();
  m_flight.reset();
  return true;
}

bool ViewNavigator::move(const QMouseEvent& event, double viewHeightPixels) {
  if (m_drag == Drag::None) return false;
  const QPointF delta = event.position() - m_last;
  m_last = event.position();
  if (m_drag == Drag::Orbit) m_camera.orbit(delta.x(), delta.y());
  if (m_drag == Drag::Pan) m_camera.pan(delta.x(), delta.y(), viewHeightPixels);
  if (m_drag == Drag::Zoom) m_camera.zoom(-delta.y() * kZoomStepsPerPixel, m_camera.pivot());
  // A turn keeps what is looked at, the others the direction.
  if (m_floor && m_drag == Drag::Orbit)
    m_camera.turnAbove(m_floor);
  else if (m_floor)
    m_camera.liftAbove(m_floor);
  return true;
}

bool ViewNavigator::release(const QMouseEvent& event) {
  if (m_drag == Drag::None || (event.button() != Qt::LeftButton && event.button() != Qt::MiddleButton))
    return false;
  m_drag = Drag::None;
  return true;
}

void ViewNavigator::wheel(double steps, Vec3d anchor) {
  m_flight.reset();
  m_camera.zoom(steps, anchor);
  if (m_floor) m_camera.liftAbove(m_floor);
}

void ViewNavigator::flyTo(const OrbitCamera& goal, double now) {
  m_flight = Flight{m_camera, goal, now};
  if (m_floor) m_flight->to.turnAbove(m_floor);
}

bool ViewNavigator::fly(double now) {
  if (!m_flight) return false;
  const double t = (now - m_flight->began) / kFlightSeconds;
  m_camera = OrbitCamera::between(m_flight->from, m_flight->to, t);
  if (m_floor) m_camera.liftAbove(m_floor);
  if (t < 1.0) return true;
  m_flight.reset();
  return false;
}

}  // namespace spin
