// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/fields/ray_scene.h"

namespace spin {

/// Two ray scenes asked as one, so that what stands still need not be built again when something moves. The
/// lower one is committed already and keeps its numbers; triangles are added above it, numbered from
/// `lowerCount` on.
std::unique_ptr<RayScene> makeLayeredRayScene(std::shared_ptr<const RayScene> lower, std::uint32_t lowerCount,
                                              std::unique_ptr<RayScene> upper);

}  // namespace spin
