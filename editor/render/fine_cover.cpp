// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "editor/render/cover_geometry.h"

namespace spin {
namespace {

/// Width in m over which the fine depth fades into the coarse one.
constexpr double kBlendWidth = 1.5;

/// from, from + stride, ... and `to` itself.
std::vector<int> steps(int from, int to, int stride) {
  std::vector<int> out;
  for (int k = from; k < to; k += stride) out.push_back(k);
  out.push_back(to);
  return out;
}

/// Triangles over the cells i0..i1 x j0..j1, where the surface exists.
std::vector<std::uint32_t> blockIndices(const Raster<float>& base, int i0, int i1, int j0, int j1,
                                        int stride) {
  const auto columns = steps(i0, i1, stride), rows = steps(j0, j1, stride);
  std::vector<std::uint32_t> out;
  for (std::size_t b = 0; b + 1 < rows.size(); ++b)
    for (std::size_t a = 0; a + 1 < columns.size(); ++a) {
      const std::size_t k[4] = {base.index(columns[a], rows[b]), base.index(columns[a + 1], rows[b]),
                                base.index(columns[a], rows[b + 1]), base.index(columns[a + 1], rows[b + 1])};
      const auto hole = [&](std::size_t c) { return std::isnan(base.values[c]); };
      if (std::any_of(std::begin(k), std::end(k), hole)) continue;
      for (const int v : {0, 1, 3, 0, 3, 2}) out.push_back(static_cast<std::uint32_t>(k[v]));
    }
  return out;
}

void addBlocks(const Raster<float>& base, FineCover& fine) {
  for (int j = 0; j < base.height - 1; j += FineCover::kBlock)
    for (int i = 0; i < base.width - 1; i += FineCover::kBlock) {
      const int i1 = std::min(i + FineCover::kBlock, base.width - 1);
      const int j1 = std::min(j + FineCover::kBlock, base.height - 1);
      FineCover::Block block;
      for (int s = 0; s < FineCover::kStrides; ++s)
        block.indices[s] = blockIndices(base, i, i1, j, j1, 1 << s);
      for (const std::uint32_t k : block.indices[0]) block.bounds.extend(fine.positions[k].to<double>());
      if (!block.bounds.empty()) fine.blocks.push_back(std::move(block));
    }
}

/// Sums of `values` along one axis over `reach` cells to both sides; at ends the value there goes on.
void addAlong(std::vector<float>& values, std::size_t first, std::size_t step, int count, int reach,
              std::vector<float>& line) {
  line.resize(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    line[static_cast<std::size_t>(k)] = values[first + static_cast<std::size_t>(k) * step];
  const auto at = [&](int k) {
    return static_cast<double>(line[static_cast<std::size_t>(std::clamp(k, 0, count - 1))]);
  };
  double sum = 0.0;
  for (int k = -reach; k <= reach; ++k) sum += at(k);
  for (int k = 0; k < count; ++k) {
    values[first + static_cast<std::size_t>(k) * step] = static_cast<float>(sum);
    sum += at(k + reach + 1) - at(k - reach);
  }
}

/// What lies lower than the mean of the snow round it sees less of the sky: under clouds nothing else tells a
/// hollow from level snow.
void addHollows(const Raster<float>& base, std::vector<Vec4f>& snow) {
  constexpr double kReach = 1.0;    // m
  constexpr float kShare = 3.0f;    // of the sky, for a hollow as deep as the reach
  constexpr float kDarkest = 0.6f;  // snow lights its own hollows
  std::vector<float> mean(snow.size()), line;
  for (std::size_t k = 0; k < snow.size(); ++k) mean[k] = snow[k].x;
  const int reach = std::max(1, static_cast<int>(std::lround(kReach / base.cellSize)));
  const auto width = static_cast<std::size_t>(base.width);
  for (int j = 0; j < base.height; ++j) addAlong(mean, base.index(0, j), 1, base.width, reach, line);
  for (int i = 0; i < base.width; ++i) addAlong(mean, base.index(i, 0), width, base.height, reach, line);
  const auto side = static_cast<float>(2 * reach + 1);
  const float scale = kShare / (static_cast<float>(reach) * static_cast<float>(base.cellSize));
  for (std::size_t k = 0; k < snow.size(); ++k)
    snow[k].w = std::isnan(base.values[k])
                    ? 0.0f
                    : std::clamp(1.0f - scale * (mean[k] / (side * side) - snow[k].x), kDarkest, 1.0f);
}

}  // namespace

FineCover makeFineCover(const CoverGrid& grid) {
  const Raster<float>& base = grid.base;
  FineCover fine;
  fine.positions.reserve(base.size());
  fine.own.reserve(base.size());
  const double longest = 0.25 * base.cellSize * std::min(base.width, base.height);
  const double width = std::max(base.cellSize, std::min(kBlendWidth, longest));
  for (int j = 0; j < base.height; ++j)
    for (int i = 0; i < base.width; ++i) {
      const float z = base.at(i, j);
      const Vec3d p{base.x(i), base.y(j), std::isnan(z) ? 0.0 : static_cast<double>(z)};
      if (!std::isnan(z)) fine.bounds.extend(p);
      fine.positions.push_back(p.to<float>());
      const int border = std::min({i, j, base.width - 1 - i, base.height - 1 - j});
      const double t = std::min(1.0, border * base.cellSize / width);
      fine.own.push_back(static_cast<float>(t * t * (3.0 - 2.0 * t)));
    }
  addBlocks(base, fine);
  fine.rectangle = {static_cast<float>(base.x(0)), static_cast<float>(base.y(0)),
                    static_cast<float>(base.x(base.width - 1)), static_cast<float>(base.y(base.height - 1))};
  return fine;
}

FineDetail fineDetail(double cellPixels) {
  constexpr double kFinest = 3.0, kMiddle = 1.5;  // pixels from which on the first two levels are drawn
  constexpr double kBegins = 1.45;                // times these the movement begins
  const int level = cellPixels > kFinest ? 0 : cellPixels > kMiddle ? 1 : 2;
  if (level == 2) return {level, 0.0};
  const double ends = level == 0 ? kFinest : kMiddle;
  return {level, std::clamp((kBegins * ends - cellPixels) / ((kBegins - 1.0) * ends), 0.0, 1.0)};
}

std::vector<Vec4f> fineCoverSnow(const FineCover& fine, const CoverGrid& grid,
                                 const std::vector<float>& depth, const Raster<float>& coarseDepth) {
  const Raster<float>& base = grid.base;
  const TerrainSurface coarse(coarseDepth);
  std::vector<Vec4f> snow(base.size());
  for (int j = 0; j < base.height; ++j)
    for (int i = 0; i < base.width; ++i) {
      const std::size_t k = base.index(i, j);
      const float around = static_cast<float>(coarse.heightAt(base.x(i), base.y(j)).value_or(0.0));
      snow[k].x = around + fine.own[k] * (depth[k] - around);
    }
  const float cell = static_cast<float>(base.cellSize);
  for (int j = 0; j < base.height; ++j)
    for (int i = 0; i < base.width; ++i) {
      const int iLow = std::max(i - 1, 0), iHigh = std::min(i + 1, base.width - 1);
      const int jLow = std::max(j - 1, 0), jHigh = std::min(j + 1, base.height - 1);
      Vec4f& s = snow[base.index(i, j)];
      if (iHigh > iLow)
        s.y = (snow[base.index(iHigh, j)].x - snow[base.index(iLow, j)].x) /
              (cell * static_cast<float>(iHigh - iLow));
      if (jHigh > jLow)
        s.z = (snow[base.index(i, jHigh)].x - snow[base.index(i, jLow)].x) /
              (cell * static_cast<float>(jHigh - jLow));
    }
  addHollows(base, snow);
  return snow;
}

}  // namespace spin
