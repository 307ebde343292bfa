// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sim/process.h"

namespace spin {

/// Flakes in one wrap-round box; needed where a snowfall node is enabled. Publishes the part "flakes".
ProcessType fallProcessType();
/// How open every cover cell lies to the falling snow; needed where snow falls on a terrain or a model.
/// Hands a SnowGround and an ExposureField (core/snow/exposure_field.h) to the processes after it.
ProcessType exposureProcessType();
/// Snow cover of terrain and models and the mass budget; needed where the exposure is. Publishes the part
/// "cover", the budget and figures.
ProcessType coverProcessType();

}  // namespace spin
