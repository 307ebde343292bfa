// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/air_window.h"

#include <algorithm>

#include "core/sim/air_part.h"

namespace spin {
namespace {

constexpr BrickKey kBrick{kBrickX, kBrickY, kBrickZ};
/// Corners lie so that cells which begin at multiples of these bricks begin at multiples of ever larger cells
/// on all coarser levels (CoarseMap shifts cells by as much as half of kBefore): what a level joins stays
/// together when the window moves, and boxes of round sizes stay whole.
constexpr BrickKey kAlign{2, 8, 8}, kBefore{2, 2, 2};
constexpr double kMostCells = 1.5e9;

std::int32_t floorTo(std::int32_t value, std::int32_t step) {
  const std::int32_t rest = value % step;
  return value - (rest < 0 ? rest + step : rest);
}

}  // namespace

bool brickBefore(const BrickKey& a, const BrickKey& b) {
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

void sortBricks(std::vector<BrickKey>& keys) {
  std::sort(keys.begin(), keys.end(), brickBefore);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

std::size_t AirWindow::slot(const BrickKey& key) const {
  std::size_t at = 0;
  for (std::size_t a = 3; a-- > 0;) {
    const std::int32_t k = key[a] - m_low[a];
    if (k < 0 || k >= m_count[a]) return m_nearPlaces.size();
    at = at * static_cast<std::size_t>(m_count[a]) + static_cast<std::size_t>(k);
  }
  return at;
}

std::int32_t AirWindow::nearPlace(const BrickKey& key) const {
  const std::size_t at = slot(key);
  return at < m_nearPlaces.size() ? m_nearPlaces[at] : -1;
}

std::int32_t AirWindow::activePlace(const BrickKey& key) const {
  const std::size_t at = slot(key);
  return at < m_activePlaces.size() ? m_activePlaces[at] : -1;
}

AirBrick AirWindow::brickOf(const BrickKey& key) const {
  AirBrick brick{0, (key[0] - m_low[0]) * kBrickX, (key[1] - m_low[1]) * kBrickY,
                 (key[2] - m_low[2]) * kBrickZ};
  brick.first = brick.z * strides().z + brick.y * strides().y + brick.x;
  return brick;
}

Result<AirWindow> AirWindow::make(std::vector<BrickKey> active) {
  AirWindow w;
  w.m_active = std::move(active);
  BrickKey high{1, 1, 1};
  if (!w.m_active.empty()) {
    w.m_low = high = w.m_active.front();
    for (const BrickKey& key : w.m_active)
      for (std::size_t a = 0; a < 3; ++a) {
        w.m_low[a] = std::min(w.m_low[a], key[a]);
        high[a] = std::max(high[a], key[a] + 1);
      }
  }
  double cells = 1.0;
  for (std::size_t a = 0; a < 3; ++a) {
    w.m_low[a] = floorTo(w.m_low[a] - 1 + kBefore[a], kAlign[a]) - kBefore[a];
    w.m_count[a] = high[a] + 1 - w.m_low[a];
    cells *= static_cast<double>(w.m_count[a]) * kBrick[a];
  }
  if (cells > kMostCells)
    return Error{ErrorKind::OutOfResources, "The air could not be computed", "air",
                 "the box round it has more than 1.5e9 cells", "Make cells larger or the domain smaller"};
  w.m_dims = {w.m_count[0] * kBrickX, w.m_count[1] * kBrickY, w.m_count[2] * kBrickZ};

  const auto slots = static_cast<std::size_t>(w.m_count[0]) * static_cast<std::size_t>(w.m_count[1]) *
                     static_cast<std::size_t>(w.m_count[2]);
  w.m_nearPlaces.assign(slots, -1);
  w.m_activePlaces.assign(slots, -1);
  std::vector<std::uint8_t> isFace(slots, 0);
  for (std::size_t k = 0; k < w.m_active.size(); ++k) {
    const BrickKey& key = w.m_active[k];
    w.m_activePlaces[w.slot(key)] = static_cast<std::int32_t>(k);
    w.m_activeBricks.push_back(w.brickOf(key));
    for (std::int32_t z = -1; z <= 1; ++z)
      for (std::int32_t y = -1; y <= 1; ++y)
        for (std::int32_t x = -1; x <= 1; ++x)
          w.m_nearPlaces[w.slot({key[0] + x, key[1] + y, key[2] + z})] = 0;
    isFace[w.slot(key)] = 1;
    for (std::size_t a = 0; a < 3; ++a) {
      BrickKey above = key;
      ++above[a];
      isFace[w.slot(above)] = 1;
    }
  }
  for (std::size_t at = 0; at < slots; ++at) {
    if (w.m_nearPlaces[at] < 0) continue;
    const auto x = static_cast<std::size_t>(w.m_count[0]), y = static_cast<std::size_t>(w.m_count[1]);
    const BrickKey key{w.m_low[0] + static_cast<std::int32_t>(at % x),
                       w.m_low[1] + static_cast<std::int32_t>(at / x % y),
                       w.m_low[2] + static_cast<std::int32_t>(at / x / y)};
    w.m_nearPlaces[at] = static_cast<std::int32_t>(w.m_nearKeys.size());
    w.m_nearKeys.push_back(key);
    w.m_near.push_back(w.brickOf(key));
    if (isFace[at]) w.m_faces.push_back(w.m_near.back());
  }
  return w;
}

CoarseBricks coarserBricks(const AirDims& dims, const std::vector<AirBrick>& active) {
  const std::int32_t fine[3] = {dims.x / kBrickX, dims.y / kBrickY, dims.z / kBrickZ};
  std::int32_t count[3];
  for (int a = 0; a < 3; ++a) count[a] = (fine[a] + 1) / 2 + 2;
  CoarseBricks coarse;
  coarse.dims = {count[0] * kBrickX, count[1] * kBrickY, count[2] * kBrickZ};
  std::vector<std::uint8_t> kind(static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
                                     static_cast<std::size_t>(count[2]),
                                 0);
  const auto slot = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    return static_cast<std::size_t>((z * count[1] + y) * count[0] + x);
  };
  for (const AirBrick& brick : active) {
    const std::int32_t x = brick.x / kBrickX / 2 + 1, y = brick.y / kBrickY / 2 + 1,
                       z = brick.z / kBrickZ / 2 + 1;
    kind[slot(x, y, z)] |= 3;
    kind[slot(x + 1, y, z)] |= 1;
    kind[slot(x, y + 1, z)] |= 1;
    kind[slot(x, y, z + 1)] |= 1;
  }
  for (std::int32_t z = 0; z < count[2]; ++z)
    for (std::int32_t y = 0; y < count[1]; ++y)
      for (std::int32_t x = 0; x < count[0]; ++x) {
        const std::uint8_t is = kind[slot(x, y, z)];
        AirBrick brick{0, x * kBrickX, y * kBrickY, z * kBrickZ};
        brick.first = brick.z * coarse.strides().z + brick.y * coarse.strides().y + brick.x;
        if (is & 1) coarse.faces.push_back(brick);
        if (is & 2) coarse.active.push_back(brick);
      }
  return coarse;
}

}  // namespace spin
