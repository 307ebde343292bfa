// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/nodes/settings_nodes.h"
#include "core/sim/air_part.h"
#include "editor/render/value_scale.h"

namespace spin {

/// One value per cell of what is shown, in the order of the fields: mass of mist and snow per volume, speed,
/// temperature over that of the air around, divergence. Empty where the part lacks the field, and for
/// Natural.
std::vector<float> airValues(const AirPart& air, AirDisplay shows);
/// "kg/m3", "m/s", "K", "1/s"; empty for Natural.
const char* airUnit(AirDisplay shows);
/// The scale of these values: from the settings, or from the 1st to the 99th percentile of those cells in
/// which something hangs.
ValueScale airScale(const RenderNode& settings, const AirPart& air, const std::vector<float>& values);
/// The legend of a frame; nothing where the colours stand for no values, the settings hide it, or there is
/// nothing to show.
std::optional<ValueLegend> airLegend(const SceneSnapshot& scene, const Frame* frame, double filmTime);

/// How much of a value's colour a cell shows, 0..1: mist and snow per volume over what a hundredth of the
/// cells that hold some have at least.
std::vector<float> airPresence(const AirPart& air);

/// Values on a plane across an axis, at the centres of the cells beside it.
struct AirSliceImage {
  int width = 0, height = 0;  ///< cells along the next axis and the one after (y, z for x)
  int axis = 0;
  Vec3d corner{};             ///< local m, lower corner of cell (0, 0), on the plane
  double cell = 1.0;          ///< m
  std::vector<float> texels;  ///< place on the scale times presence, presence (1 or 0), width fastest

  bool empty() const { return texels.empty(); }
};
/// Between the two layers of cells at `position` (m along the axis 0..2) the mean by distance. Empty where no
/// brick is there, or the plane would take more than `most` cells.
AirSliceImage sliceAir(const AirPart& air, const std::vector<float>& values, const ValueScale& scale,
                       int axis, double position, std::size_t most);

}  // namespace spin
