// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/property_table.h"

namespace spin {

/// The camera that pictures are rendered from.
struct CameraNode : NodeData {
  Vec3d position{0, -50, 20};  ///< m, local
  Vec3d target{};              ///< m, point looked at
  double fovDegrees = 45.0;    ///< vertical
};
extern const NodeType kCameraType;

}  // namespace spin
