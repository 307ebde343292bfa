// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/property/value.h"

#include <fmt/format.h>

#include "core/base/check.h"
#include "core/base/units.h"

namespace spin {

UnitInfo unitInfo(Unit unit) {
  switch (unit) {
    case Unit::None:
    case Unit::Factor:
      return {"", 1.0, 0.0};
    case Unit::Metre:
      return {"m", 1.0, 0.0};
    case Unit::Millimetre:
      return {"mm", 1e3, 0.0};
    case Unit::MetrePerSecond:
      return {"m/s", 1.0, 0.0};
    case Unit::Degree:
      return {"\u00b0", 1.0, 0.0};
    case Unit::Kelvin:
      return {"\u00b0C", 1.0, -kZeroCelsius};
    case Unit::PrecipitationRate:
      return {"mm/h", 3600.0, 0.0};
    case Unit::KilogramPerCubicMetre:
      return {"kg/m\u00b3", 1.0, 0.0};
    case Unit::Second:
      return {"s", 1.0, 0.0};
    case Unit::PerSecond:
      return {"1/s", 1.0, 0.0};
    case Unit::Pixel:
      return {"px", 1.0, 0.0};
    case Unit::Byte:
      return {"MiB", 1.0 / (1024.0 * 1024.0), 0.0};
    case Unit::SquareMetrePerSecond:
      return {"m\u00b2/s", 1.0, 0.0};
    case Unit::CubicMetrePerSecond:
      return {"m\u00b3/s", 1.0, 0.0};
    case Unit::PascalSecond:
      return {"Pa s", 1.0, 0.0};
    case Unit::Pascal:
      return {"Pa", 1.0, 0.0};
    case Unit::PerMetre:
      return {"1/m", 1.0, 0.0};
    case Unit::KelvinPerMetre:
      return {"K/km", 1000.0, 0.0};
    case Unit::PercentPerHundredMetres:
      return {"%/100 m", 1e4, 0.0};
    case Unit::WattPerSquareMetre:
      return {"W/m\u00b2", 1.0, 0.0};
    case Unit::KilogramPerSquareMetreDayKelvin:
      return {"mm/(d K)", 86400.0, 0.0};
  }
  SPIN_CHECK(false, "unit without a row");
}

namespace {

struct TextOf {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  /// fmt prints the shortest text that reads back as the same number, whatever the locale.
  std::string operator()(double value) const { return fmt::format("{}", value); }
  std::string operator()(const Vec3d& value) const {
    return fmt::format("{} {} {}", value.x, value.y, value.z);
  }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const PlanPoints& value) const {
    std::string text;
    for (const Vec2d& p : value) text += fmt::format("{}{} {}", text.empty() ? "" : "; ", p.x, p.y);
    return text;
  }
};

}  // namespace

std::string toText(const Value& value) {
  return std::visit(TextOf{}, value);
}

}  // namespace spin
