// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/camera_node.h"

namespace spin {
namespace {

constexpr PropertyRow kCameraRows[] = {
    property<&CameraNode::position>("position_m", SPIN_TR("Position"),
                                    SPIN_TR("Place of the eye in local metres."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 1)
        .animated()
        .affecting(Affects::Picture),
    property<&CameraNode::target>("target_m", SPIN_TR("Target"), SPIN_TR("Point the camera looks at."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 1)
        .animated()
        .affecting(Affects::Picture),
    property<&CameraNode::fovDegrees>("fov_deg", SPIN_TR("Field of view"), SPIN_TR("Vertical angle of view."))
        .in(Unit::Degree)
        .range(1, 160, 1)
        .animated()
        .affecting(Affects::Picture),
};

}  // namespace

constinit const NodeType kCameraType = nodeType<CameraNode>(
    "camera", SPIN_TR("Camera"), SPIN_TR("The view that pictures are rendered from."), true, kCameraRows);

}  // namespace spin
