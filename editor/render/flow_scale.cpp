// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/flow_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

constexpr double kLowShare = 0.01, kHighShare = 0.99;  // what lies beyond does not stretch the scale
/// A logarithmic scale spans this much at most below its end.
constexpr double kMostDecades = 6.0;

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

Vec3d fromCode(unsigned code) {
  const auto linear = [](unsigned byte) {
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);  // IEC 61966-2-1
  };
  return {linear(code >> 16 & 0xff), linear(code >> 8 & 0xff), linear(code & 0xff)};
}

ScaleColours fromCodes(const std::array<unsigned, kScaleStops>& codes) {
  ScaleColours colours;
  std::transform(codes.begin(), codes.end(), colours.begin(), fromCode);
  return colours;
}

/// Two finite values that bound the bulk of the values; low < high.
void spread(std::vector<float> values, bool positive, double& low, double& high) {
  std::erase_if(values, [positive](float v) { return !std::isfinite(v) || (positive && v <= 0.0f); });
  low = positive ? 1.0 : 0.0;
  high = low + 1.0;
  if (values.empty()) return;
  const auto at = [&values](double share) {
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(k)]);
  };
  low = at(kLowShare);
  high = at(kHighShare);
}

/// 1, 2 or 5 times a power of ten.
double roundStep(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  const double factor = step / power;
  return power * (factor < 1.5 ? 1.0 : factor < 3.5 ? 2.0 : factor < 7.5 ? 5.0 : 10.0);
}

std::vector<FlowLegend::Tick> amountTicks(const FlowScale& scale) {
  std::vector<FlowLegend::Tick> ticks;
  const auto add = [&](double value) { ticks.push_back({scale.place(value), fmt::format("{:.6g}", value)}); };
  if (scale.logarithmic) {
    const int first = static_cast<int>(std::ceil(std::log10(scale.low) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(scale.high) + 1e-9));
    for (int decade = first; decade <= last; ++decade) add(std::pow(10.0, decade));
    if (ticks.size() >= 2) return ticks;
    ticks.clear();
    add(scale.low);
    add(scale.high);
    return ticks;
  }
  const double step = roundStep((scale.high - scale.low) / 5.0);
  const double first = std::ceil(scale.low / step - 1e-9);
  for (double k = first; k * step <= scale.high + 1e-9 * step; k += 1.0) add(k * step + 0.0);
  return ticks;
}

}  // namespace

double FlowScale::place(double value) const {
  if (logarithmic) value = value > 0.0 ? value : low;
  const double t = logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.0;
}

std::vector<float> flowValues(const ParticleSet& set, FlowDisplay shows) {
  const ParticleAttribute* a = set.find(shownOf(shows).attribute);
  if (!a || a->components < 1 || a->values.size() != set.size() * static_cast<std::size_t>(a->components))
    return {};
  if (a->components == 1) return a->values;
  std::vector<float> values(set.size());
  const auto width = static_cast<std::size_t>(a->components);
  for (std::size_t k = 0; k < values.size(); ++k) {
    float square = 0.0f;
    for (std::size_t c = 0; c < width; ++c) square += a->values[k * width + c] * a->values[k * width + c];
    values[k] = std::sqrt(square);
  }
  return values;
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
  if (settings.flowRangeAuto) spread(std::move(values), scale.logarithmic, scale.low, scale.high);
  if (scale.logarithmic) {
    if (!(scale.high > 0.0)) scale.high = 1.0;
    scale.low = std::max(scale.low, scale.high * std::pow(10.0, -kMostDecades));
    if (!(scale.high > scale.low * 1.001)) scale.high = scale.low * 10.0;
  } else if (!(scale.high - scale.low > 1e-6 * std::max(std::abs(scale.low), std::abs(scale.high)))) {
    scale.high = scale.low + std::max(1.0, 1e-3 * std::abs(scale.low));
  }
  return scale;
}

const ScaleColours& scaleColours(const FlowScale& scale) {
  static const ScaleColours kViridis =
      fromCodes({0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725});
  // Told apart also by most who see fewer colours (M. Okabe, K. Ito 2008).
  static const ScaleColours kClasses =
      fromCodes({0x56b4e9, 0x999999, 0xe69f00, 0xcc79a7, 0x009e73, 0xf0e442, 0x0072b2, 0xd55e00, 0xffffff});
  return scale.classes ? kClasses : kViridis;
}

Vec3d scaleColour(const FlowScale& scale, double place) {
  const ScaleColours& colours = scaleColours(scale);
  const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(kScaleStops - 1);
  const auto k = std::min(static_cast<std::size_t>(at), kScaleStops - 2);
  const double t = at - static_cast<double>(k);
  return colours[k] * (1.0 - t) + colours[k + 1] * t;
}

std::optional<FlowLegend> flowLegend(const SceneSnapshot& scene, const Frame* frame, double filmTime) {
  const auto settings = scene.settings<RenderNode>(filmTime);
  if (!frame || !settings.flowLegend || settings.flowDisplay == FlowDisplay::Material) return std::nullopt;
  const auto* flow = frame->part<ParticlePart>("flow");
  if (!flow) return std::nullopt;
  std::vector<float> values = flowValues(flow->particles, settings.flowDisplay);
  if (values.empty()) return std::nullopt;
  FlowLegend legend;
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
