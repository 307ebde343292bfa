// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/math/vec.h"
#include "core/property/value.h"

namespace spin {

/// Without white space at both ends.
std::string_view trimmed(std::string_view text);
/// Decimal integer that fills the whole text; false otherwise or when it overflows. Locale-independent.
bool parseInteger(std::string_view text, std::int64_t& number);
/// Real number with a decimal point that fills the whole text; false otherwise or when it overflows.
bool parseReal(std::string_view text, double& number);
/// Three reals separated by blanks or commas.
bool parseVector(std::string_view text, Vec3d& vector);
/// Points of two reals each (separated by blanks or commas), parted by ';'; no points from an empty text.
bool parsePoints(std::string_view text, PlanPoints& points);

/// Well-formed UTF-8 (RFC 3629) without control characters; tabs and line ends count as such.
bool isCleanText(std::string_view text);
/// The text with everything that could harm a terminal or a message box replaced by '?'.
std::string printable(std::string_view text);

}  // namespace spin
