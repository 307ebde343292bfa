// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/air_values.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

constexpr std::array<std::int64_t, 3> kBrick{kBrickX, kBrickY, kBrickZ};
constexpr std::size_t kSample = 200'000;

const AirField* wholeField(const AirPart& air, const char* name, int components) {
  const AirField* field = air.find(name);
  const bool whole = field && field->components == components &&
                     field->halves.size() == air.cells() * static_cast<std::size_t>(components);
  return whole ? field : nullptr;
}

std::vector<float> scalar(const AirPart& air, const char* name) {
  const AirField* field = wholeField(air, name, 1);
  if (!field) return {};
  std::vector<float> values(air.cells());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = field->scale * floatFromHalf(field->halves[k]);
  return values;
}

std::vector<float> speeds(const AirPart& air) {
  const AirField* field = wholeField(air, "velocity", 3);
  if (!field) return {};
  std::vector<float> values(air.cells());
  for (std::size_t brick = 0; brick < air.bricks.size(); ++brick)
    for (std::size_t cell = 0; cell < kBrickCells; ++cell) {
      const Vec3f v{field->at(brick, 0, cell), field->at(brick, 1, cell), field->at(brick, 2, cell)};
      values[brick * kBrickCells + cell] = length(v);
    }
  return values;
}

std::vector<float> load(const AirPart& air) {
  std::vector<float> mist = scalar(air, "mist");
  const std::vector<float> snow = scalar(air, "snow");
  if (mist.empty()) return snow;
  for (std::size_t k = 0; k < snow.size(); ++k) mist[k] += snow[k];
  return mist;
}

/// Sums of values and weights on the plane's cells.
struct SliceSums {
  std::array<std::int64_t, 2> low{}, high{};  // cells, the high ones beyond
  std::vector<float> value, weight;
};

/// Adds the layer `k` of the brick along the axis.
void addLayer(const AirPart& air, const std::vector<float>& values, const ValueScale& scale,
              std::size_t brick, std::size_t axis, std::int64_t k, float share, SliceSums& sums) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  constexpr std::array<std::int64_t, 3> kStride{1, kBrickX, kBrickX * kBrickY};
  const std::int64_t u0 = air.bricks[brick][u] * kBrick[u] - sums.low[0],
                     v0 = air.bricks[brick][v] * kBrick[v] - sums.low[1];
  const std::int64_t width = sums.high[0] - sums.low[0];
  for (std::int64_t j = 0; j < kBrick[v]; ++j)
    for (std::int64_t i = 0; i < kBrick[u]; ++i) {
      const auto cell = static_cast<std::size_t>(k * kStride[axis] + i * kStride[u] + j * kStride[v]);
      const auto to = static_cast<std::size_t>((v0 + j) * width + u0 + i);
      sums.value[to] +=
          share * static_cast<float>(scale.place(static_cast<double>(values[brick * kBrickCells + cell])));
      sums.weight[to] += share;
    }
}

}  // namespace

std::vector<float> airValues(const AirPart& air, AirDisplay shows) {
  switch (shows) {
    case AirDisplay::Density:
      return load(air);
    case AirDisplay::Velocity:
      return speeds(air);
    case AirDisplay::Temperature:
      return scalar(air, "temperature");
    case AirDisplay::Divergence:
      return scalar(air, "divergence");
    case AirDisplay::Natural:
      break;
  }
  return {};
}

const char* airUnit(AirDisplay shows) {
  constexpr std::array<const char*, 5> kUnits{"", "kg/m3", "m/s", "K", "1/s"};
  return kUnits[static_cast<std::size_t>(shows)];
}

ValueScale airScale(const RenderNode& settings, const AirPart& air, const std::vector<float>& values) {
  ValueScale scale;
  scale.low = settings.airRangeLow;
  scale.high = settings.airRangeHigh;
  if (settings.airRangeAuto) {
    const std::vector<float> present = airPresence(air);
    const std::size_t stride = std::max<std::size_t>(1, values.size() / kSample);
    std::vector<float> seen;
    for (std::size_t k = 0; k < values.size(); k += stride)
      if (present[k] > 0.01f) seen.push_back(values[k]);
    scale.spanBulk(std::move(seen));
    if (settings.airDisplay == AirDisplay::Density) scale.low = 0.0;
  }
  scale.widen();
  return scale;
}

std::optional<ValueLegend> airLegend(const SceneSnapshot& scene, const Frame* frame, double filmTime) {
  const auto settings = scene.settings<RenderNode>(filmTime);
  if (!frame || !settings.flowLegend || settings.airDisplay == AirDisplay::Natural) return std::nullopt;
  const auto* air = frame->part<AirPart>("air");
  if (!air) return std::nullopt;
  const std::vector<float> values = airValues(*air, settings.airDisplay);
  if (values.empty()) return std::nullopt;
  ValueLegend legend;
  legend.title = kAirDisplayChoices[static_cast<std::size_t>(settings.airDisplay)].label;
  legend.unit = airUnit(settings.airDisplay);
  legend.scale = airScale(settings, *air, values);
  legend.ticks = amountTicks(legend.scale);
  return legend;
}

std::vector<float> airPresence(const AirPart& air) {
  std::vector<float> shares = load(air);
  if (shares.empty()) return std::vector<float>(air.cells(), 1.0f);
  const std::size_t stride = std::max<std::size_t>(1, shares.size() / kSample);
  std::vector<float> some;
  for (std::size_t k = 0; k < shares.size(); k += stride)
    if (shares[k] > 0.0f) some.push_back(shares[k]);
  float most = 1.0f;
  if (!some.empty()) {
    const auto at = some.begin() + static_cast<std::ptrdiff_t>(some.size() - 1 - some.size() / 100);
    std::nth_element(some.begin(), at, some.end());
    most = *at;
  }
  for (float& share : shares) share = std::isfinite(share) ? std::clamp(share / most, 0.0f, 1.0f) : 0.0f;
  return shares;
}

AirSliceImage sliceAir(const AirPart& air, const std::vector<float>& values, const ValueScale& scale,
                       int axis, double position, std::size_t most) {
  AirSliceImage image;
  const auto a = static_cast<std::size_t>(axis);
  const std::size_t u = (a + 1) % 3, v = (a + 2) % 3;
  const double centre = (position - air.origin[axis]) / air.cell - 0.5;
  if (values.size() != air.cells() || !(std::abs(centre) < 1e9)) return image;
  const auto below = static_cast<std::int64_t>(std::floor(centre));
  const auto shareAbove = static_cast<float>(centre - std::floor(centre));
  const auto each = [&](const auto& visit) {
    for (std::size_t brick = 0; brick < air.bricks.size(); ++brick)
      for (std::int64_t k = below; k <= below + 1; ++k) {
        const std::int64_t within = k - air.bricks[brick][a] * kBrick[a];
        const float share = k == below ? 1.0f - shareAbove : shareAbove;
        if (within >= 0 && within < kBrick[a] && share > 0.0f) visit(brick, within, share);
      }
  };
  SliceSums sums;
  bool any = false;
  each([&](std::size_t brick, std::int64_t, float) {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t along = side == 0 ? u : v;
      const std::int64_t low = air.bricks[brick][along] * kBrick[along], high = low + kBrick[along];
      sums.low[side] = any ? std::min(sums.low[side], low) : low;
      sums.high[side] = any ? std::max(sums.high[side], high) : high;
    }
    any = true;
  });
  const double width = static_cast<double>(sums.high[0] - sums.low[0]),
               height = static_cast<double>(sums.high[1] - sums.low[1]);
  if (!any || width * height > static_cast<double>(most)) return image;
  sums.value.assign(static_cast<std::size_t>(width * height), 0.0f);
  sums.weight = sums.value;
  each([&](std::size_t brick, std::int64_t k, float share) {
    addLayer(air, values, scale, brick, a, k, share, sums);
  });
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.axis = axis;
  image.cell = air.cell;
  const double alongU = air.origin[static_cast<int>(u)] + static_cast<double>(sums.low[0]) * air.cell,
               alongV = air.origin[static_cast<int>(v)] + static_cast<double>(sums.low[1]) * air.cell;
  image.corner = axis == 0   ? Vec3d{position, alongU, alongV}
                 : axis == 1 ? Vec3d{alongV, position, alongU}
                             : Vec3d{alongU, alongV, position};
  image.texels.resize(2 * sums.value.size());
  for (std::size_t k = 0; k < sums.value.size(); ++k) {
    const bool there = sums.weight[k] > 0.49f;
    image.texels[2 * k] = there ? sums.value[k] / sums.weight[k] : 0.0f;
    image.texels[2 * k + 1] = there ? 1.0f : 0.0f;
  }
  return image;
}

}  // namespace spin
