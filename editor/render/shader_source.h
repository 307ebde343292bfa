// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace spin {

/// Text of a file in resources/shaders, built into the program; empty if there is none.
std::string_view shaderSource(std::string_view name);

}  // namespace spin
