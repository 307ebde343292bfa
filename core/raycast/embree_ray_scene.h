// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/fields/ray_scene.h"

namespace spin {

/// Ray casting by Embree 3 (robust mode, so that rays do not slip through shared edges).
std::unique_ptr<RayScene> makeEmbreeRayScene();

}  // namespace spin
