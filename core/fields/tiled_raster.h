// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/check.h"

namespace spin {

/// Painted raster in tiles of 64 x 64, copy-on-write: copying the raster copies only pointers, so a snapshot
/// is cheap and an undo step keeps only the tiles a stroke touched. Same orientation as Raster (row 0 =
/// south).
template <class T>
class TiledRaster {
 public:
  static constexpr int kTile = 64;
  using Tile = std::array<T, kTile * kTile>;
  using TilePointer = std::shared_ptr<const Tile>;

  TiledRaster() = default;
  TiledRaster(int width, int height, T fill)
      : m_width(width), m_height(height), m_tilesX((width + kTile - 1) / kTile), m_fill(fill) {
    SPIN_CHECK(width >= 0 && height >= 0, "raster size");
    auto tile = std::make_shared<Tile>();
    tile->fill(fill);
    m_tiles.assign(
        static_cast<std::size_t>(m_tilesX) * static_cast<std::size_t>((height + kTile - 1) / kTile), tile);
  }

  int width() const { return m_width; }
  int height() const { return m_height; }
  bool empty() const { return m_tiles.empty(); }
  T fill() const { return m_fill; }
  std::size_t tileCount() const { return m_tiles.size(); }
  const TilePointer& tile(std::size_t index) const { return m_tiles[index]; }
  void setTile(std::size_t index, TilePointer tile) { m_tiles[index] = std::move(tile); }
  std::size_t tileIndex(int i, int j) const {
    return static_cast<std::size_t>(j / kTile) * static_cast<std::size_t>(m_tilesX) +
           static_cast<std::size_t>(i / kTile);
  }
  T at(int i, int j) const {
    SPIN_DCHECK(i >= 0 && j >= 0 && i < m_width && j < m_height, "tiled raster index out of range");
    return (*m_tiles[tileIndex(i, j)])[inTile(i, j)];
  }
  /// Writes one value; a tile that somebody else holds is copied first.
  void set(int i, int j, T value) {
    SPIN_DCHECK(i >= 0 && j >= 0 && i < m_width && j < m_height, "tiled raster index out of range");
    TilePointer& tile = m_tiles[tileIndex(i, j)];
    if (same((*tile)[inTile(i, j)], value)) return;
    if (tile.use_count() > 1) tile = std::make_shared<Tile>(*tile);
    // The last other holder may have been another thread, which has finished reading by now.
    std::atomic_thread_fence(std::memory_order_acquire);
    const_cast<Tile&>(*tile)[inTile(i, j)] = value;
  }
  friend bool operator==(const TiledRaster& a, const TiledRaster& b) {
    if (a.m_width != b.m_width || a.m_height != b.m_height) return false;
    for (std::size_t t = 0; t < a.m_tiles.size(); ++t)
      if (a.m_tiles[t] != b.m_tiles[t] &&
          !std::equal(a.m_tiles[t]->begin(), a.m_tiles[t]->end(), b.m_tiles[t]->begin(), same))
        return false;
    return true;
  }

 private:
  /// NaN marks what is not painted, so one NaN is as good as another.
  static bool same(T a, T b) { return a == b || (a != a && b != b); }
  static std::size_t inTile(int i, int j) {
    return static_cast<std::size_t>((j % kTile) * kTile + i % kTile);
  }
  int m_width = 0;
  int m_height = 0;
  int m_tilesX = 0;
  T m_fill{};
  std::vector<TilePointer> m_tiles;
};

}  // namespace spin
