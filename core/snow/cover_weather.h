// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/sunlight.h"
#include "core/sim/snapshot.h"
#include "core/snow/snow_cells_view.h"

namespace spin {

/// A stretch of a step; film and weather time run evenly within it.
struct TimeSpan {
  FrameTime from, to;

  double seconds() const { return to.weather - from.weather; }
  double middleFilm() const { return 0.5 * (from.film + to.film); }
  double middleWeather() const { return 0.5 * (from.weather + to.weather); }
  /// Its part from the share a to the share b.
  TimeSpan part(double a, double b) const;
};

/// Weather of a stretch of an hour or less as cells take it, and the sun in its middle. snowfall and rainfall
/// are those of level ground at the weather's altitude.
struct CoverWeather {
  SnowStepWeather step;
  double precipitation = 0.0;  ///< kg/(m2 s), step.snowfall and step.rainfall with all digits
  Sun sun;
};
CoverWeather coverWeather(const SceneSnapshot& scene, const TimeSpan& span);

/// Height above the local origin at which the weather was measured, m.
double weatherLevel(const SceneSnapshot& scene);

}  // namespace spin
