// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/animation_curve.h"
#include "core/scene/json.h"

namespace spin {

/// Values in scene files: choices by id, vectors as three numbers, paths with '/'.
JsonValue toJson(const PropertyInfo& property, const Value& value);
/// Checks kind, finiteness and range. `where` is for the message; the line is added.
Result<Value> valueFromJson(const PropertyInfo& property, const JsonValue& json, const std::string& where);

/// {"keys": [{"interpolation", "time_s", "value"}, ...]}.
JsonValue toJson(const PropertyInfo& property, const AnimationCurve& curve);
Result<AnimationCurve> curveFromJson(const PropertyInfo& property, const JsonValue& keys,
                                     const std::string& where);

/// "weather.wind_speed_m_s, line 12".
std::string placeOf(const std::string& where, const JsonValue& json);

}  // namespace spin
