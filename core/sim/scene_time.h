// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/nodes/weather_nodes.h"
#include "core/physics/sunlight.h"
#include "core/sim/snapshot.h"

namespace spin {

/// Reads "2005-10-01 00:00" (also with T between, with seconds, or the day alone) as s from 1970-01-01 00:00
/// UTC.
Result<std::int64_t> parseDateTime(std::string_view text);
/// "2005-10-01 00:00"
std::string dateTimeText(std::int64_t utc);

/// UTC of a weather time (s since film time 0), s from 1970: by the weather's start, else by its record. None
/// if the scene has no date, or one that cannot be read.
std::optional<double> utcAt(const SceneSnapshot& scene, double weatherSeconds);

/// The sun that melts snow: by the weather's choice; below the horizon for none, and without a date.
Sun meltingSun(const SceneSnapshot& scene, const WeatherNode& weather, double weatherSeconds);
/// Unit vector towards the sun that lights pictures.
Vec3d picturedSun(const SceneSnapshot& scene, double filmTime);

}  // namespace spin
