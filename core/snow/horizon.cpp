// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/horizon.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/physics/sunlight.h"

namespace spin {
namespace {

/// Height at a local offset from a cell, nearest cell; NaN outside and without data.
float heightAt(const Raster<float>& heights, int i, int j) {
  return heights.contains(i, j) ? heights.at(i, j) : std::nanf("");
}

/// Slope along one axis from the neighbours that have data.
double gradient(float before, float here, float after, double cell) {
  const bool low = !std::isnan(before), high = !std::isnan(after);
  const double from = static_cast<double>(low ? before : here), to = static_cast<double>(high ? after : here);
  return (to - from) / (cell * std::max(int{low} + int{high}, 1));
}

Vec3d normalAt(const Raster<float>& h, int i, int j) {
  const float here = h.at(i, j);
  if (std::isnan(here)) return {0, 0, 1};
  const double gx = gradient(heightAt(h, i - 1, j), here, heightAt(h, i + 1, j), h.cellSize);
  const double gy = gradient(heightAt(h, i, j - 1), here, heightAt(h, i, j + 1), h.cellSize);
  return normalized(Vec3d{-gx, -gy, 1.0});
}

double horizonOf(const Raster<float>& h, int i, int j, double azimuth, double reach) {
  const double east = std::sin(azimuth), north = std::cos(azimuth);
  const double here = static_cast<double>(h.at(i, j));
  double tangent = 0.0;
  for (double away = h.cellSize; away <= reach; away += std::max(h.cellSize, 0.1 * away)) {
    const int x = i + static_cast<int>(std::lround(east * away / h.cellSize));
    const int y = j + static_cast<int>(std::lround(north * away / h.cellSize));
    if (!h.contains(x, y)) break;
    const float there = h.at(x, y);
    const double distance = h.cellSize * std::hypot(x - i, y - j);
    if (std::isnan(there) || distance == 0.0) continue;
    tangent = std::max(tangent, (static_cast<double>(there) - here) / distance);
  }
  return tangent;
}

constexpr double kSectorWidth = 2.0 * kPi / HorizonMap::kSectors;

}  // namespace

HorizonMap HorizonMap::make(const Raster<float>& heights, double reach, CpuBackend& backend) {
  HorizonMap map;
  map.m_normals.resize(heights.size());
  map.m_tangents.assign(heights.size() * kSectors, 0.0f);
  backend.forEach("horizon", heights.size(), [&](std::size_t cell) {
    const int i = static_cast<int>(cell % static_cast<std::size_t>(heights.width));
    const int j = static_cast<int>(cell / static_cast<std::size_t>(heights.width));
    map.m_normals[cell] = normalAt(heights, i, j).to<float>();
    if (std::isnan(heights.values[cell])) return;
    for (int s = 0; s < kSectors; ++s)
      map.m_tangents[cell * kSectors + static_cast<std::size_t>(s)] =
          static_cast<float>(horizonOf(heights, i, j, s * kSectorWidth, reach));
  });
  return map;
}

double HorizonMap::horizonTangent(std::size_t cell, double azimuth) const {
  const double turns = azimuth / (2.0 * kPi);
  const double sector = (turns - std::floor(turns)) * kSectors;
  const auto first = static_cast<std::size_t>(sector);
  const double share = sector - static_cast<double>(first);
  const float* tangents = m_tangents.data() + cell * kSectors;
  const double a = static_cast<double>(tangents[first % kSectors]);
  const double b = static_cast<double>(tangents[(first + 1) % kSectors]);
  return a + (b - a) * share;
}

double HorizonMap::beamFactor(std::size_t cell, Vec3d towardsSun) const {
  if (towardsSun.z <= 0.0) return 0.0;
  const double level = std::hypot(towardsSun.x, towardsSun.y);
  if (level > 0.0 && towardsSun.z < level * horizonTangent(cell, std::atan2(towardsSun.x, towardsSun.y)))
    return 0.0;
  return slopeBeamFactor(normal(cell), towardsSun);
}

double HorizonMap::skyView(std::size_t cell) const {
  const Vec3d n = normal(cell);
  const double cosine = n.z, sine = std::hypot(n.x, n.y);
  const double aspect = std::atan2(n.x, n.y);
  double sum = 0.0;
  for (int s = 0; s < kSectors; ++s) {
    const double turn = std::cos(s * kSectorWidth - aspect);
    // The slope itself hides the sky below its plane.
    const double own = -turn * sine / std::max(cosine, 1e-6);
    const double tangent =
        std::max(own, static_cast<double>(m_tangents[cell * kSectors + static_cast<std::size_t>(s)]));
    const double zenith = 0.5 * kPi - std::atan(tangent);
    const double open = std::sin(zenith);
    sum += cosine * open * open + sine * turn * (zenith - open * std::cos(zenith));
  }
  return std::clamp(sum / kSectors, 0.0, 1.0);
}

}  // namespace spin
