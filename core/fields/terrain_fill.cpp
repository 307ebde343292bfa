// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/terrain_fill.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/base/units.h"

namespace spin {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kLeastWeight = 1.0f / 512.0f;
/// Flatter ground faces nowhere.
constexpr double kLevelDegrees = 0.05;

/// 1 at no distance from the range, 0 at `soft` and beyond.
double falloff(double distance, double soft) {
  if (distance <= 0.0) return 1.0;
  if (distance >= soft) return 0.0;
  const double t = 1.0 - distance / soft;
  return t * t * (3.0 - 2.0 * t);
}

/// Rise per metre from two neighbours, or from one and the point itself; 0 between holes.
double rise(float before, float here, float after, double cell) {
  const bool a = !std::isnan(before), b = !std::isnan(after);
  const auto difference = [](float from, float to) {
    return static_cast<double>(to) - static_cast<double>(from);
  };
  if (a && b) return difference(before, after) / (2.0 * cell);
  if (a) return difference(before, here) / cell;
  return b ? difference(here, after) / cell : 0.0;
}

template <class T, class Change>
void forWeighted(TiledRaster<T>& layer, const Raster<float>& weights, const Change& change) {
  SPIN_CHECK(layer.width() == weights.width && layer.height() == weights.height,
             "weights of another size than the layer");
  for (int j = 0; j < weights.height; ++j)
    for (int i = 0; i < weights.width; ++i)
      if (const float w = weights.at(i, j); w >= kLeastWeight) change(i, j, w);
}

}  // namespace

double SoftRange::weight(double value) const {
  if (!on) return 1.0;
  if (std::isnan(value)) return 0.0;
  return falloff(std::max(low - value, value - high), soft);
}

double SoftRange::weightOfDirection(double degrees) const {
  if (!on) return 1.0;
  if (std::isnan(degrees)) return 0.0;
  const auto turn = [](double d) { return d - 360.0 * std::floor(d / 360.0); };
  const double width = high - low >= 360.0 ? 360.0 : turn(high - low);
  const double past = turn(degrees - low);  // clockwise from the beginning
  if (past <= width) return 1.0;
  return falloff(std::min(past - width, 360.0 - past), soft);
}

TerrainShape terrainShape(const Raster<float>& heights, CpuBackend& backend) {
  TerrainShape shape{heights.sameShape<float>(kNan), heights.sameShape<float>(kNan)};
  const auto at = [&](int i, int j) { return heights.contains(i, j) ? heights.at(i, j) : kNan; };
  backend.forEach(
      "terrain shape", static_cast<std::size_t>(heights.height),
      [&](std::size_t row) {
        const int j = static_cast<int>(row);
        for (int i = 0; i < heights.width; ++i) {
          const float here = heights.at(i, j);
          if (std::isnan(here)) continue;
          const double east = rise(at(i - 1, j), here, at(i + 1, j), heights.cellSize);
          const double north = rise(at(i, j - 1), here, at(i, j + 1), heights.cellSize);
          const double slope = radiansToDegrees(std::atan(std::hypot(east, north)));
          shape.slope.at(i, j) = static_cast<float>(slope);
          if (slope < kLevelDegrees) continue;
          const double faces = radiansToDegrees(std::atan2(-east, -north));
          shape.aspect.at(i, j) = static_cast<float>(faces < 0.0 ? faces + 360.0 : faces);
        }
      },
      8);
  return shape;
}

Raster<float> fillWeights(const Raster<float>& heights, const TerrainShape& shape, const FillRule& rule,
                          double seaLevel, CpuBackend& backend) {
  SPIN_CHECK(shape.slope.hasShapeOf(heights) && shape.aspect.hasShapeOf(heights), "shape of another terrain");
  Raster<float> weights = heights.sameShape<float>(0.0f);
  backend.forEach("fill weights", heights.size(), [&](std::size_t k) {
    if (std::isnan(heights.values[k])) return;
    const double w = rule.altitude.weight(static_cast<double>(heights.values[k]) + seaLevel) *
                     rule.slope.weight(static_cast<double>(shape.slope.values[k])) *
                     rule.aspect.weightOfDirection(static_cast<double>(shape.aspect.values[k]));
    weights.values[k] = static_cast<float>(w);
  });
  return weights;
}

TiledRaster<float> filled(TiledRaster<float> layer, const Raster<float>& weights, const LayerFill& fill) {
  forWeighted(layer, weights, [&](int i, int j, float weight) {
    const float old = layer.at(i, j);
    const double before = std::isnan(old) ? fill.base : static_cast<double>(old);
    const double w = static_cast<double>(weight);
    double after = before + w * (fill.value - before);
    if (fill.combine == FillCombine::Add) after = before + w * fill.value;
    if (fill.combine == FillCombine::Max) after = std::max(before, after);
    layer.set(i, j, static_cast<float>(std::clamp(after, fill.least, fill.most)));
  });
  return layer;
}

TiledRaster<std::uint8_t> filled(TiledRaster<std::uint8_t> layer, const Raster<float>& weights,
                                 std::uint8_t value) {
  const CounterRandom dice{1};
  forWeighted(layer, weights, [&](int i, int j, float weight) {
    const auto point = (static_cast<std::uint64_t>(j) << 32) | static_cast<std::uint64_t>(i);
    if (weight >= 1.0f || dice.uniform(point) < weight) layer.set(i, j, value);
  });
  return layer;
}

}  // namespace spin
