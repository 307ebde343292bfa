// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>

#include "core/nodes/settings_nodes.h"
#include "core/sim/frame.h"
#include "core/sim/snapshot.h"
#include "editor/viewport/view_frame.h"

namespace spin {

/// The particle of a flow that lies under the pointer.
struct FlowReading {
  Vec3d point{};               ///< its centre, local m
  double speed = 0.0;          ///< m/s
  double density = 0.0;        ///< kg/m3
  std::optional<double> high;  ///< m above the bare ground
  FlowDisplay shows = FlowDisplay::Material;
  double value = 0.0;  ///< what `shows` is drawn by; 0 for Material
};

/// The particle nearest to the eye that a ray meets; far away, where particles are smaller than the pointer
/// can tell, within two pixels of it. Nothing where the frame has no flow there.
std::optional<FlowReading> readFlow(const SceneSnapshot& scene, const Frame* frame, double filmTime,
                                    const ViewFrame& view, Vec2d pixel);

/// The reading in one line.
QString readingText(const FlowReading& reading);

}  // namespace spin
