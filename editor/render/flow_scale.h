// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/nodes/settings_nodes.h"
#include "core/sim/frame.h"

namespace spin {

inline constexpr std::size_t kScaleStops = 9;
using ScaleColours = std::array<Vec3d, kScaleStops>;  ///< linear RGB, evenly spaced from low to high

/// How values of particles become colours.
struct FlowScale {
  FlowDisplay shows = FlowDisplay::Material;
  double low = 0.0, high = 1.0;  ///< SI; high > low; for classes the numbers of the first and the last colour
  bool logarithmic = false;
  bool classes = false;  ///< colours stand for kinds, not for amounts

  /// Place of a value on the scale, clamped to 0..1; 0 for values that are not finite.
  double place(double value) const;
};

/// One value per particle of what is shown: speed is the length of "velocity". Empty where the set lacks the
/// attribute, and for Material.
std::vector<float> flowValues(const ParticleSet& set, FlowDisplay shows);
/// The scale for these values: from the settings, or from the 1st to the 99th percentile of the values.
FlowScale flowScale(const RenderNode& settings, std::vector<float> values);
/// Stops of the colour map: viridis (S. van der Walt, N. Smith 2015, CC0), perceptually even; distinct
/// colours for classes.
const ScaleColours& scaleColours(const FlowScale& scale);
Vec3d scaleColour(const FlowScale& scale, double place);

/// What is printed beside a picture whose colours stand for values.
struct FlowLegend {
  struct Tick {
    double place;      ///< 0..1
    std::string text;  ///< a number; of classes a name, context "Properties"
  };
  const char* title = "";  ///< context "Properties"
  std::string unit;
  FlowScale scale;
  std::vector<Tick> ticks;
};

/// The legend of a frame; nothing where the colours stand for no values, the settings hide it, or nothing
/// flows.
std::optional<FlowLegend> flowLegend(const SceneSnapshot& scene, const Frame* frame, double filmTime);

}  // namespace spin
