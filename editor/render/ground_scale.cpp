// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/ground_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/painted_kinds.h"

namespace spin {
namespace {

constexpr Vec3d kUnpainted{0.20, 0.21, 0.23};

GroundScale typeScale() {
  GroundScale scale{paintedKind(kGroundTypeLayerType), {}, kUnpainted, {}};
  for (int type = 0; type < kGroundTypeCount; ++type) {
    scale.stops.push_back({static_cast<double>(type), falseTypeColour(type)});
    scale.names.push_back(kGroundTypeChoices[static_cast<std::size_t>(type)].label);
  }
  return scale;
}

/// Blue below freezing, white at it, red above.
GroundScale temperatureScale() {
  return {paintedKind(kGroundTemperatureLayerType),
          {{celsiusToKelvin(-20.0), {0.02, 0.10, 0.55}},
           {celsiusToKelvin(-10.0), {0.20, 0.42, 0.75}},
           {celsiusToKelvin(0.0), {0.85, 0.85, 0.85}},
           {celsiusToKelvin(10.0), {0.80, 0.36, 0.18}},
           {celsiusToKelvin(20.0), {0.60, 0.03, 0.02}}},
          kUnpainted,
          {}};
}

/// Thin snow matters as much as deep: each stop is about twice the one before.
GroundScale depthScale() {
  return {paintedKind(kSnowDepthLayerType),
          {{0.0, {0.16, 0.09, 0.05}},
           {0.1, {0.42, 0.46, 0.40}},
           {0.25, {0.36, 0.62, 0.55}},
           {0.5, {0.16, 0.52, 0.68}},
           {1.0, {0.06, 0.28, 0.66}},
           {2.0, {0.10, 0.10, 0.52}},
           {5.0, {0.34, 0.06, 0.46}},
           {10.0, {0.80, 0.20, 0.52}}},
          kUnpainted,
          {}};
}

GroundScale clearScale() {
  return {paintedKind(kKeepClearLayerType),
          {{0.0, kUnpainted}, {0.5, {0.62, 0.34, 0.05}}, {1.0, {1.0, 0.72, 0.10}}},
          kUnpainted,
          {}};
}

}  // namespace

Vec3d falseTypeColour(int type) {
  const Vec3d c = groundTypeColour(static_cast<GroundType>(type));
  return {std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z)};
}

Vec3d GroundScale::colour(double value) const {
  if (!(value > stops.front().value)) return stops.front().colour;
  for (std::size_t k = 1; k < stops.size(); ++k) {
    if (value > stops[k].value) continue;
    const double t = (value - stops[k - 1].value) / (stops[k].value - stops[k - 1].value);
    return stops[k - 1].colour * (1.0 - t) + stops[k].colour * t;
  }
  return stops.back().colour;
}

const GroundScale* groundScale(GroundDisplay display) {
  static const std::array<GroundScale, 4> kScales{typeScale(), temperatureScale(), depthScale(),
                                                  clearScale()};
  if (display == GroundDisplay::Natural) return nullptr;
  return &kScales[static_cast<std::size_t>(display) - 1];
}

GroundDisplay displayOf(const PaintedKind& kind) {
  for (const GroundDisplay display : {GroundDisplay::GroundType, GroundDisplay::GroundTemperature,
                                      GroundDisplay::SnowDepth, GroundDisplay::KeepClear})
    if (groundScale(display)->kind == &kind) return display;
  return GroundDisplay::Natural;
}

}  // namespace spin
