// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/snow/exposure_field.h"

namespace spin {

/// What the exposure process hands to later processes, beside the SnowGroundPointer.
using ExposureFieldPointer = std::shared_ptr<const ExposureField>;

/// Settings that the scene asks for at a film time.
ExposureSettings exposureSettings(const SceneSnapshot& scene, double filmTime);

}  // namespace spin
