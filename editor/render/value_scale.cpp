// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/value_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

constexpr double kLowShare = 0.01, kHighShare = 0.99;  // what lies beyond does not stretch the scale
/// A logarithmic scale spans this much at most below its end.
constexpr double kMostDecades = 6.0;

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

/// 1, 2 or 5 times a power of ten.
double roundStep(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  const double factor = step / power;
  return power * (factor < 1.5 ? 1.0 : factor < 3.5 ? 2.0 : factor < 7.5 ? 5.0 : 10.0);
}

}  // namespace

double ValueScale::place(double value) const {
  if (logarithmic) value = value > 0.0 ? value : low;
  const double t = logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.0;
}

void ValueScale::spanBulk(std::vector<float> values) {
  const bool positive = logarithmic;
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

void ValueScale::widen() {
  if (logarithmic) {
    if (!(high > 0.0)) high = 1.0;
    low = std::max(low, high * std::pow(10.0, -kMostDecades));
    if (!(high > low * 1.001)) high = low * 10.0;
  } else if (!(high - low > 1e-6 * std::max(std::abs(low), std::abs(high)))) {
    high = low + std::max(1.0, 1e-3 * std::abs(low));
  }
}

const ScaleColours& scaleColours(const ValueScale& scale) {
  static const ScaleColours kViridis =
      fromCodes({0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725});
  // Told apart also by most who see fewer colours (M. Okabe, K. Ito 2008).
  static const ScaleColours kClasses =
      fromCodes({0x56b4e9, 0x999999, 0xe69f00, 0xcc79a7, 0x009e73, 0xf0e442, 0x0072b2, 0xd55e00, 0xffffff});
  return scale.classes ? kClasses : kViridis;
}

Vec3d scaleColour(const ValueScale& scale, double place) {
  const ScaleColours& colours = scaleColours(scale);
  const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(kScaleStops - 1);
  const auto k = std::min(static_cast<std::size_t>(at), kScaleStops - 2);
  const double t = at - static_cast<double>(k);
  return colours[k] * (1.0 - t) + colours[k + 1] * t;
}

std::vector<ValueLegend::Tick> amountTicks(const ValueScale& scale) {
  std::vector<ValueLegend::Tick> ticks;
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

}  // namespace spin
