// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sim/process.h"

namespace spin {

/// Snow is falling on something: an enabled snowfall, and a terrain or an enabled model with data.
bool snowHasGround(const SceneSnapshot& scene);
/// Film time at which a step takes its weather and places.
inline double middleFilm(const StepInput& input) {
  return 0.5 * (input.from.film + input.to.film);
}
/// Adds weather, snowfall and simulation settings at the beginning, middle and end of the step.
void hashSnowWeather(const StepInput& input, Hasher& hasher);
/// Whether a model turns or changes size at any time of the film: it keeps no snow then.
bool modelTurns(const SceneNode& model);
/// Adds what rules the lying snow: its settings, layers of the ground, sources of heat.
void hashSnowCover(const StepInput& input, Hasher& hasher);
/// Adds terrain and models where they stand in the middle of the step.
void hashSnowGround(const StepInput& input, Hasher& hasher);

}  // namespace spin
