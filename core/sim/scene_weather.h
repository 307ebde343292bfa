// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sim/snapshot.h"

namespace spin {

/// Air and precipitation where the weather is measured, by keyframes or by the scene's station record.
struct AirNow {
  double temperature = 0.0;       ///< K
  double relativeHumidity = 0.0;  ///< over water, share
  double snowfall = 0.0;          ///< kg/(m2 s), the snowfall's rate factor included; 0 without a snowfall
  double rainfall = 0.0;          ///< kg/(m2 s), likewise
};
AirNow airAt(const SceneSnapshot& scene, double filmTime);

}  // namespace spin
