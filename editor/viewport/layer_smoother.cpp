// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/layer_smoother.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

/// A rectangle of cells cut out of a layer, row by row.
struct Window {
  int i0, j0, width, height;

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j - j0) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(i - i0);
  }
};

Window windowRound(int tileX, int tileY, int margin, int width, int height, int tile) {
  const int i0 = std::max(0, tileX * tile - margin), j0 = std::max(0, tileY * tile - margin);
  return {i0, j0, std::min(width, (tileX + 1) * tile + margin) - i0,
          std::min(height, (tileY + 1) * tile + margin) - j0};
}

/// Sum of the values within `reach` along each row; what lies beyond the ends counts as 0.
void sumRows(const std::vector<float>& from, std::vector<float>& to, const Window& w, int reach) {
  for (int j = 0; j < w.height; ++j) {
    const float* in = &from[static_cast<std::size_t>(j) * static_cast<std::size_t>(w.width)];
    float* out = &to[static_cast<std::size_t>(j) * static_cast<std::size_t>(w.width)];
    // In double: a running sum of floats would not come back to 0.
    double sum = 0.0;
    for (int k = 0; k < std::min(reach, w.width); ++k) sum += static_cast<double>(in[k]);
    for (int k = 0; k < w.width; ++k) {
      if (k + reach < w.width) sum += static_cast<double>(in[k + reach]);
      out[k] = static_cast<float>(sum);
      if (k - reach >= 0) sum -= static_cast<double>(in[k - reach]);
    }
  }
}

/// The same along each column, all columns at a time.
void sumColumns(const std::vector<float>& from, std::vector<float>& to, const Window& w, int reach) {
  const auto width = static_cast<std::size_t>(w.width);
  std::vector<double> sums(width, 0.0);
  const auto add = [&](int j, double sign) {
    if (j < 0 || j >= w.height) return;
    const float* row = &from[static_cast<std::size_t>(j) * width];
    for (std::size_t i = 0; i < width; ++i) sums[i] += sign * static_cast<double>(row[i]);
  };
  for (int j = 0; j < reach; ++j) add(j, 1.0);
  for (int j = 0; j < w.height; ++j) {
    add(j + reach, 1.0);
    float* row = &to[static_cast<std::size_t>(j) * width];
    for (std::size_t i = 0; i < width; ++i) row[i] = static_cast<float>(sums[i]);
    add(j - reach, -1.0);
  }
}

void boxSum(std::vector<float>& values, const Window& w, int reach) {
  std::vector<float> between(values.size());
  sumRows(values, between, w, reach);
  sumColumns(between, values, w, reach);
}

template <class Visit>
void forTile(int tileX, int tileY, int width, int height, int tile, const Visit& visit) {
  for (int j = tileY * tile; j < std::min(height, (tileY + 1) * tile); ++j)
    for (int i = tileX * tile; i < std::min(width, (tileX + 1) * tile); ++i)
      visit(i, j, static_cast<std::size_t>((j % tile) * tile + i % tile));
}

void smoothInto(const TiledRaster<float>& layer, int tileX, int tileY, int reach,
                TiledRaster<float>::Tile& tile) {
  constexpr int kTile = TiledRaster<float>::kTile;
  const Window w = windowRound(tileX, tileY, 2 * reach, layer.width(), layer.height(), kTile);
  std::vector<float> sums(w.size()), counts(w.size());
  for (int j = w.j0; j < w.j0 + w.height; ++j)
    for (int i = w.i0; i < w.i0 + w.width; ++i) {
      const float v = layer.at(i, j);
      counts[w.index(i, j)] = std::isnan(v) ? 0.0f : 1.0f;
      sums[w.index(i, j)] = std::isnan(v) ? 0.0f : v;
    }
  for (int pass = 0; pass < 2; ++pass) {
    boxSum(sums, w, reach);
    boxSum(counts, w, reach);
  }
  forTile(tileX, tileY, layer.width(), layer.height(), kTile, [&](int i, int j, std::size_t cell) {
    const float old = layer.at(i, j);
    const std::size_t at = w.index(i, j);
    tile[cell] = std::isnan(old) ? old : sums[at] / counts[at];
  });
}

void smoothInto(const TiledRaster<std::uint8_t>& layer, int tileX, int tileY, int reach,
                TiledRaster<std::uint8_t>::Tile& tile) {
  constexpr int kTile = TiledRaster<std::uint8_t>::kTile;
  const Window w = windowRound(tileX, tileY, reach, layer.width(), layer.height(), kTile);
  std::vector<bool> there(256, false);
  for (int j = w.j0; j < w.j0 + w.height; ++j)
    for (int i = w.i0; i < w.i0 + w.width; ++i) there[layer.at(i, j)] = true;
  std::vector<float> most(kTile * kTile, 0.0f), votes(w.size());
  forTile(tileX, tileY, layer.width(), layer.height(), kTile,
          [&](int i, int j, std::size_t cell) { tile[cell] = layer.at(i, j); });
  for (int name = 0; name < 256; ++name) {
    if (!there[static_cast<std::size_t>(name)]) continue;
    for (int j = w.j0; j < w.j0 + w.height; ++j)
      for (int i = w.i0; i < w.i0 + w.width; ++i) votes[w.index(i, j)] = layer.at(i, j) == name ? 1.0f : 0.0f;
    boxSum(votes, w, reach);
    forTile(tileX, tileY, layer.width(), layer.height(), kTile, [&](int i, int j, std::size_t cell) {
      // At a draw a cell keeps its name.
      const float own = layer.at(i, j) == name ? 0.5f : 0.0f;
      const float got = votes[w.index(i, j)] + own;
      if (got <= most[cell]) return;
      most[cell] = got;
      tile[cell] = static_cast<std::uint8_t>(name);
    });
  }
}

}  // namespace

template <class T>
std::unique_ptr<typename LayerSmoother<T>::Tile> LayerSmoother<T>::smoothedTile(int tileX, int tileY) const {
  auto tile = std::make_unique<Tile>();
  tile->fill(m_layer.fill());
  smoothInto(m_layer, tileX, tileY, m_reach, *tile);
  return tile;
}

template <class T>
T LayerSmoother<T>::at(int i, int j) {
  constexpr int kTile = TiledRaster<T>::kTile;
  std::unique_ptr<Tile>& tile = m_tiles[m_layer.tileIndex(i, j)];
  if (!tile) tile = smoothedTile(i / kTile, j / kTile);
  return (*tile)[static_cast<std::size_t>((j % kTile) * kTile + i % kTile)];
}

template class LayerSmoother<std::uint8_t>;
template class LayerSmoother<float>;

}  // namespace spin
