// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace spin {

inline constexpr int kNoiseSize = 256;

/// A tile that repeats without a seam, kNoiseSize^2 RGBA: layered gradient noise (0.5 = mean), its slope
/// along u and v (0.5 = level), and white noise. The same bytes on every machine.
std::vector<std::uint8_t> makeNoiseTile();

}  // namespace spin
