// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/terrain_light.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace spin {
namespace {

constexpr float kNoShadow = -1e9f;

/// Derivative along one axis from the neighbours that have data.
float slope(float before, float here, float after, float cell) {
  const bool hasBefore = !std::isnan(before), hasAfter = !std::isnan(after);
  if (hasBefore && hasAfter) return (after - before) / (2.0f * cell);
  if (hasAfter) return (after - here) / cell;
  if (hasBefore) return (here - before) / cell;
  return 0.0f;
}

float heightOrHole(const Raster<float>& h, int i, int j) {
  return h.contains(i, j) ? h.at(i, j) : std::numeric_limits<float>::quiet_NaN();
}

float skyShare(const Raster<float>& h, int i, int j) {
  static constexpr int kDirections[8][2] = {{1, 0},  {1, 1},   {0, 1},  {-1, 1},
                                            {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  const float here = h.at(i, j);
  float sum = 0.0f;
  for (const auto& d : kDirections) {
    const float unit =
        static_cast<float>(h.cellSize) * std::hypot(static_cast<float>(d[0]), static_cast<float>(d[1]));
    float horizon = 0.0f;  // tangent of the horizon angle
    for (int step = 1; step <= 64; step *= 2) {
      const float z = heightOrHole(h, i + d[0] * step, j + d[1] * step);
      if (!std::isnan(z)) horizon = std::max(horizon, (z - here) / (unit * static_cast<float>(step)));
    }
    sum += 1.0f / (1.0f + horizon * horizon);
  }
  return sum / 8.0f;
}

Vec4f lightOf(const Raster<float>& h, int i, int j) {
  const float here = h.at(i, j), cell = static_cast<float>(h.cellSize);
  if (std::isnan(here)) return {0.0f, 0.0f, 1.0f, 0.0f};
  const float dx = slope(heightOrHole(h, i - 1, j), here, heightOrHole(h, i + 1, j), cell);
  const float dy = slope(heightOrHole(h, i, j - 1), here, heightOrHole(h, i, j + 1), cell);
  const float inverse = 1.0f / std::sqrt(1.0f + dx * dx + dy * dy);
  return {-dx * inverse, -dy * inverse, skyShare(h, i, j), 1.0f};
}

}  // namespace

std::vector<Vec4f> terrainNormalsAndSky(const Raster<float>& heights) {
  std::vector<Vec4f> out(heights.size());
  CpuBackend backend;
  backend.forEach(
      "terrain light", static_cast<std::size_t>(heights.height),
      [&](std::size_t row) {
        const int j = static_cast<int>(row);
        for (int i = 0; i < heights.width; ++i) out[heights.index(i, j)] = lightOf(heights, i, j);
      },
      16);
  return out;
}

std::vector<float> terrainShadowHeights(const Raster<float>& heights, Vec3d toSun) {
  std::vector<float> shadow(heights.size(), kNoShadow);
  const double horizontal = std::hypot(toSun.x, toSun.y);
  if (horizontal < 1e-6 || toSun.z <= 0.0) return shadow;
  // One step towards the sun is one cell along the dominant axis and a fraction along the other.
  const bool alongX = std::abs(toSun.x) >= std::abs(toSun.y);
  const double major = alongX ? toSun.x : toSun.y, minor = alongX ? toSun.y : toSun.x;
  const int direction = major > 0.0 ? 1 : -1;
  const double across = minor / std::abs(major);
  const float drop = static_cast<float>(heights.cellSize * toSun.z / std::abs(major));
  const int lines = alongX ? heights.width : heights.height, cells = alongX ? heights.height : heights.width;
  const auto top = [&](int line, int cell) {
    if (cell < 0 || cell >= cells) return kNoShadow;
    const std::size_t k = alongX ? heights.index(line, cell) : heights.index(cell, line);
    const float z = heights.values[k];
    return std::isnan(z) ? shadow[k] : std::max(z, shadow[k]);
  };
  for (int n = 1; n < lines; ++n) {
    const int line = direction > 0 ? lines - 1 - n : n;
    for (int c = 0; c < cells; ++c) {
      const double place = c + across;
      const int low = static_cast<int>(std::floor(place));
      const float f = static_cast<float>(place - low);
      const float a = top(line + direction, low), b = top(line + direction, low + 1);
      const float z = (a <= kNoShadow || b <= kNoShadow ? std::max(a, b) : a + f * (b - a)) - drop;
      const std::size_t k = alongX ? heights.index(line, c) : heights.index(c, line);
      shadow[k] = std::max(kNoShadow, z);
    }
  }
  return shadow;
}

std::vector<std::uint8_t> packTerrainLight(const Raster<float>& heights,
                                           const std::vector<Vec4f>& normalsAndSky,
                                           const std::vector<float>& shadowHeights, float edge) {
  const auto toByte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f)));
  };
  std::vector<std::uint8_t> bytes;
  bytes.reserve(heights.size() * 4);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const Vec4f& n = normalsAndSky[k];
    const float above = std::isnan(heights.values[k]) ? edge : heights.values[k] - shadowHeights[k];
    const float t = std::clamp(above / edge, 0.0f, 1.0f);
    for (const float v :
         {128.0f + 127.0f * n.x, 128.0f + 127.0f * n.y, 255.0f * n.z, 255.0f * t * t * (3.0f - 2.0f * t)})
      bytes.push_back(toByte(v));
  }
  return bytes;
}

}  // namespace spin
