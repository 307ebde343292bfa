// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMouseEvent>
#include <optional>
#include <utility>

#include "editor/viewport/orbit_camera.h"

namespace spin {

/// Turns the pointer's moves into camera moves: middle button or Alt + left orbits, with Shift it pans, with
/// Ctrl it zooms; the wheel zooms to the pointer. Also flies to places. None of it takes the eye below the
/// floor.
class ViewNavigator {
 public:
  static constexpr double kFlightSeconds = 0.35;

  const OrbitCamera& camera() const { return m_camera; }
  void setCamera(const OrbitCamera& camera);
  /// Null = there is none.
  void setFloor(EyeFloor floor) { m_floor = std::move(floor); }

  /// True if the press begins a camera move.
  bool press(const QMouseEvent& event);
  /// True while a camera move goes on.
  bool move(const QMouseEvent& event, double viewHeightPixels);
  bool release(const QMouseEvent& event);
  bool dragging() const { return m_drag != Drag::None; }
  void wheel(double steps, Vec3d anchor);

  /// Begins a flight at `now`, s of a steady clock.
  void flyTo(const OrbitCamera& goal, double now);
  /// Moves along; false once it has arrived or where none goes on.
  bool fly(double now);
  bool flying() const { return m_flight.has_value(); }

 private:
  enum class Drag { None, Orbit, Pan, Zoom };
  struct Flight {
    OrbitCamera from, to;
    double began;
  };

  OrbitCamera m_camera;
  EyeFloor m_floor;
  Drag m_drag = Drag::None;
  QPointF m_last;
  std::optional<Flight> m_flight;
};

}  // namespace spin
