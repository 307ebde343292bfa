// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/flow_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

struct Shown {
  const char* attribute;
  const char* unit;
};

Shown shownOf(FlowDisplay shows) {
  switch (shows) {
    case FlowDisplay::Speed:
      return {"velocity", "m/s"};
    case FlowDisplay::Density:
      return {"density", "kg/m3"};
    case FlowDisplay::Pressure:
      return {"pressure", "Pa"};
    case FlowDisplay::Acceleration:
      return {"acceleration", "m/s2"};
    case FlowDisplay::ShearRate:
      return {"shear_rate", "1/s"};
    case FlowDisplay::Viscosity:
      return {"viscosity", "Pa s"};
    case FlowDisplay::ParticleClass:
      return {"class", ""};
    case FlowDisplay::Age:
      return {"age", "s"};
    case FlowDisplay::Neighbours:
      return {"neighbours", ""};
    case FlowDisplay::Material:
      break;
  }
  return {"", ""};
}

const ParticleAttribute* attributeOf(const ParticleSet& set, FlowDisplay shows) {
  const ParticleAttribute* a = set.find(shownOf(shows).attribute);
  const bool whole =
      a && a->components > 0 && a->values.size() == set.size() * static_cast<std::size_t>(a->components);
  return whole ? a : nullptr;
}

/// Its size where it is a vector.
float valueAt(const ParticleAttribute& a, std::size_t particle) {
  const auto width = static_cast<std::size_t>(a.components);
  const float* at = a.values.data() + particle * width;
  if (width == 1) return *at;
  float square = 0.0f;
  for (std::size_t c = 0; c < width; ++c) square += at[c] * at[c];
  return std::sqrt(square);
}

}  // namespace

std::vector<float> flowValues(const ParticleSet& set, FlowDisplay shows) {
  const ParticleAttribute* a = attributeOf(set, shows);
  if (!a) return {};
  if (a->components == 1) return a->values;
  std::vector<float> values(set.size());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = valueAt(*a, k);
  return values;
}

std::optional<float> flowValue(const ParticleSet& set, FlowDisplay shows, std::size_t particle) {
  const ParticleAttribute* a = attributeOf(set, shows);
  if (!a || particle >= set.size()) return std::nullopt;
  return valueAt(*a, particle);
}

const char* flowUnit(FlowDisplay shows) {
  return shownOf(shows).unit;
}

FlowScale flowScale(const RenderNode& settings, std::vector<float> values) {
  FlowScale scale;
  scale.shows = settings.flowDisplay;
  if (settings.flowDisplay == FlowDisplay::ParticleClass) {
    scale.classes = true;
    scale.high = static_cast<double>(kScaleStops - 1);
    return scale;
  }
  scale.logarithmic = settings.flowLogarithmic;
  scale.low = settings.flowRangeLow;
  scale.high = settings.flowRangeHigh;
  if (settings.flowRangeAuto) scale.spanBulk(std::move(values));
  scale.widen();
  return scale;
}

std::optional<ValueLegend> flowLegend(const SceneSnapshot& scene, const Frame* frame, double filmTime) {
  const auto settings = scene.settings<RenderNode>(filmTime);
  if (!frame || !settings.flowLegend || settings.flowDisplay == FlowDisplay::Material) return std::nullopt;
  const auto* flow = frame->part<ParticlePart>("flow");
  if (!flow) return std::nullopt;
  std::vector<float> values = flowValues(flow->particles, settings.flowDisplay);
  if (values.empty()) return std::nullopt;
  ValueLegend legend;
  legend.title = kFlowDisplayChoices[static_cast<std::size_t>(settings.flowDisplay)].label;
  legend.unit = shownOf(settings.flowDisplay).unit;
  std::vector<float> present = values;
  legend.scale = flowScale(settings, std::move(values));
  if (!legend.scale.classes) {
    legend.ticks = amountTicks(legend.scale);
    return legend;
  }
  std::sort(present.begin(), present.end());
  present.erase(std::unique(present.begin(), present.end()), present.end());
  for (const float number : present) {
    const auto kind = static_cast<std::size_t>(std::max(number, 0.0f));
    const std::string text = kind < kFlowClassLabels.size()
                                 ? kFlowClassLabels[kind]
                                 : fmt::format("{:.6g}", static_cast<double>(number));
    legend.ticks.push_back({legend.scale.place(static_cast<double>(number)), text});
  }
  return legend;
}

}  // namespace spin
