// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/cover_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "editor/render/texel_code.h"

namespace spin {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kMostSamples = 200'000;

float at(const std::vector<float>& values, std::size_t cell) {
  return cell < values.size() ? values[cell] : kNone;
}

/// Slope of the bare surface along one axis; one-sided at rims, level where nothing is beside.
double slopeOf(const Raster<float>& base, int i, int j, int di, int dj) {
  const auto height = [&](int a, int b) { return base.contains(a, b) ? base.at(a, b) : kNone; };
  const float here = base.at(i, j), low = height(i - di, j - dj), high = height(i + di, j + dj);
  const bool hasLow = !std::isnan(low), hasHigh = !std::isnan(high);
  const float rise = (hasHigh ? high : here) - (hasLow ? low : here);
  const double run = base.cellSize * (static_cast<int>(hasLow) + static_cast<int>(hasHigh));
  return run > 0.0 ? static_cast<double>(rise) / run : 0.0;
}

/// Every so many cells that account for some area.
std::vector<float> sampleValues(const CoverPart& cover, SnowDisplay shows) {
  std::size_t cells = 0;
  for (const CoverGrid& grid : cover.layout->grids) cells += grid.base.size();
  const std::size_t stride = 1 + cells / kMostSamples;
  std::vector<float> values;
  values.reserve(cells / stride + cover.layout->grids.size());
  for (std::size_t g = 0; g < cover.layout->grids.size(); ++g) {
    const CoverGrid& grid = cover.layout->grids[g];
    for (std::size_t c = 0; c < grid.base.size(); c += stride)
      if (at(grid.area.values, c) > 0.0f) values.push_back(coverValue(cover, g, c, shows));
  }
  return values;
}

/// Differences smaller than these are not worth all colours; in the unit of the legend.
double leastSpan(SnowDisplay shows) {
  switch (shows) {
    case SnowDisplay::Depth:
      return 0.02;
    case SnowDisplay::Density:
      return 20.0;
    default:
      return 1.0;
  }
}

bool isSound(const CoverPart* cover) {
  return cover && cover->layout && cover->values.size() == cover->layout->grids.size();
}

}  // namespace

float coverValue(const CoverPart& cover, std::size_t grid, std::size_t cell, SnowDisplay shows) {
  if (std::isnan(at(cover.layout->grids[grid].base.values, cell))) return kNone;
  const CoverPart::Values& v = cover.values[grid];
  if (shows == SnowDisplay::Temperature)
    return static_cast<float>(static_cast<double>(at(v.temperature, cell)) - kZeroCelsius);
  if (shows == SnowDisplay::Exposure)
    return cover.exposure && grid < cover.exposure->grids.size() ? at(cover.exposure->grids[grid], cell)
                                                                 : kNone;
  const float depth = at(v.depth, cell), swe = at(v.swe, cell);
  if (!(depth >= kThinnestShown)) return kNone;
  switch (shows) {
    case SnowDisplay::Depth:
      return depth;
    case SnowDisplay::Swe:
      return swe;
    case SnowDisplay::Density:
      return swe / depth;
    case SnowDisplay::LiquidWater:
      // Where nothing melts no frame holds it: dry snow.
      return v.liquid.empty() ? 0.0f : at(v.liquid, cell);
    default:
      return kNone;
  }
}

const char* coverUnit(SnowDisplay shows) {
  switch (shows) {
    case SnowDisplay::Depth:
      return "m";
    case SnowDisplay::Swe:
    case SnowDisplay::LiquidWater:
      return "kg/m2";
    case SnowDisplay::Density:
      return "kg/m3";
    case SnowDisplay::Temperature:
      return "\u00b0C";
    case SnowDisplay::Natural:
    case SnowDisplay::Exposure:
      break;
  }
  return "";
}

ValueScale coverScale(const RenderNode& settings, const CoverPart& cover) {
  ValueScale scale;
  scale.low = settings.snowRangeLow;
  scale.high = settings.snowRangeHigh;
  const SnowDisplay shows = settings.snowDisplay;
  if (settings.snowRangeAuto && shows == SnowDisplay::Exposure) {
    scale.low = 0.0;
    scale.high = 1.0;
  } else if (settings.snowRangeAuto) {
    scale.spanBulk(sampleValues(cover, shows));
    if (shows != SnowDisplay::Temperature && shows != SnowDisplay::Density) scale.low = 0.0;
    scale.high = std::max(scale.high, scale.low + leastSpan(shows));
  }
  scale.widen();
  return scale;
}

std::optional<ValueLegend> coverLegend(const SceneSnapshot& scene, const Frame* frame, double filmTime) {
  const auto settings = scene.settings<RenderNode>(filmTime);
  const SnowDisplay shows = settings.snowDisplay;
  if (!frame || !settings.flowLegend || shows == SnowDisplay::Natural) return std::nullopt;
  const auto* cover = frame->part<CoverPart>("cover");
  if (!isSound(cover)) return std::nullopt;
  ValueLegend legend;
  legend.title = kSnowDisplayChoices[static_cast<std::size_t>(shows)].label;
  legend.unit = coverUnit(shows);
  legend.scale = coverScale(settings, *cover);
  legend.ticks = amountTicks(legend.scale);
  return legend;
}

std::vector<CoverTexel> coverColours(const CoverPart& cover, std::size_t grid, SnowDisplay shows,
                                     const ValueScale& scale) {
  // A table: a colour takes three roots, and there may be millions of cells.
  std::array<CoverTexel, 256> table;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const Vec3d c = scaleColour(scale, static_cast<double>(k) / 255.0);
    table[k] = {encodeRoot(c.x), encodeRoot(c.y), encodeRoot(c.z), 255};
  }
  std::vector<CoverTexel> texels(cover.layout->grids[grid].base.size(), CoverTexel{});
  for (std::size_t c = 0; c < texels.size(); ++c) {
    const float value = coverValue(cover, grid, c, shows);
    if (std::isnan(value)) continue;
    texels[c] = table[static_cast<std::size_t>(std::lround(255.0 * scale.place(static_cast<double>(value))))];
  }
  return texels;
}

std::vector<CoverTexel> coverShares(const CoverPart& cover, std::size_t grid, const SlopeHold& hold) {
  const Raster<float>& base = cover.layout->grids[grid].base;
  std::vector<CoverTexel> texels(base.size(), CoverTexel{0, 0, 0, 255});
  for (int j = 0; j < base.height; ++j)
    for (int i = 0; i < base.width; ++i) {
      const std::size_t cell = base.index(i, j);
      if (std::isnan(base.values[cell])) continue;
      const double x = slopeOf(base, i, j, 1, 0), y = slopeOf(base, i, j, 0, 1);
      const float open = coverValue(cover, grid, cell, SnowDisplay::Exposure);
      const double exposure = std::isnan(open) ? 1.0 : std::clamp(static_cast<double>(open), 0.0, 1.0);
      const double share = exposure * hold.share(1.0 / std::sqrt(1.0 + x * x + y * y));
      texels[cell][3] = static_cast<std::uint8_t>(std::lround(255.0 * share));
    }
  return texels;
}

}  // namespace spin
