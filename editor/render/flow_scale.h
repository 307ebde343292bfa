// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/nodes/settings_nodes.h"
#include "core/sim/frame.h"
#include "editor/render/value_scale.h"

namespace spin {

/// How values of particles become colours.
struct FlowScale : ValueScale {
  FlowDisplay shows = FlowDisplay::Material;
};

/// One value per particle of what is shown: speed is the length of "velocity". Empty where the set lacks the
/// attribute, and for Material.
std::vector<float> flowValues(const ParticleSet& set, FlowDisplay shows);
/// That of one particle; nothing under the same conditions.
std::optional<float> flowValue(const ParticleSet& set, FlowDisplay shows, std::size_t particle);
/// "m/s" and so on; empty where there is none.
const char* flowUnit(FlowDisplay shows);
/// The scale for these values: from the settings, or from the 1st to the 99th percentile of the values.
FlowScale flowScale(const RenderNode& settings, std::vector<float> values);
/// The legend of a frame; nothing where the colours stand for no values, the settings hide it, or nothing
/// flows.
std::optional<ValueLegend> flowLegend(const SceneSnapshot& scene, const Frame* frame, double filmTime);

}  // namespace spin
