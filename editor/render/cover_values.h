// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/nodes/settings_nodes.h"
#include "core/physics/slope_hold.h"
#include "core/sim/frame.h"
#include "editor/render/value_scale.h"

namespace spin {

/// Snow thinner than this, m, counts as none where its depth, mass or water is shown.
inline constexpr float kThinnestShown = 0.001f;

/// The value of one cell in the unit of the legend (coverUnit()); NaN where there is none: no surface, no
/// snow (depth, mass, density, liquid water), or the frame does not hold it (temperature, exposure). A
/// temperature is that of the surface, snow or bare. NaN for Natural. Requires a grid and cell of the layout.
float coverValue(const CoverPart& cover, std::size_t grid, std::size_t cell, SnowDisplay shows);
/// "m", "kg/m2", "kg/m3", "°C" or nothing.
const char* coverUnit(SnowDisplay shows);

/// The scale of a whole cover: from the settings, or over what lies there (percentiles of at most some
/// 200,000 cells). Amounts begin at 0 and shares end at 1. Not for Natural.
ValueScale coverScale(const RenderNode& settings, const CoverPart& cover);
/// The legend of a frame; nothing where the colours stand for no values, the settings hide it, or there is
/// nothing to show.
std::optional<ValueLegend> coverLegend(const SceneSnapshot& scene, const Frame* frame, double filmTime);

/// What a cell is drawn with beside its depth: root of the value's colour times `a`, and 255 in `a` where the
/// cell has one; or in `a` the share f_p of the published blend.
using CoverTexel = std::array<std::uint8_t, 4>;
std::vector<CoverTexel> coverColours(const CoverPart& cover, std::size_t grid, SnowDisplay shows,
                                     const ValueScale& scale);
/// f_p = f_e f_inc by cell: exposure (1 where it is not known) times what the slope of the bare surface
/// holds.
std::vector<CoverTexel> coverShares(const CoverPart& cover, std::size_t grid, const SlopeHold& hold);

}  // namespace spin
