// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "core/fields/tiled_raster.h"

namespace spin {

/// A smoothed copy of a painted layer, made tile by tile where it is asked for. Measures become the mean of
/// what is painted round them (two box filters, so near and far count like a tent); names the commonest of
/// their neighbours. Unpainted (NaN) cells stay so.
template <class T>
class LayerSmoother {
 public:
  /// `reach`: half side of the box in cells, >= 1.
  LayerSmoother(TiledRaster<T> layer, int reach) : m_layer(std::move(layer)), m_reach(reach) {}
  T at(int i, int j);

 private:
  using Tile = typename TiledRaster<T>::Tile;
  std::unique_ptr<Tile> smoothedTile(int tileX, int tileY) const;

  TiledRaster<T> m_layer;
  int m_reach;
  std::map<std::size_t, std::unique_ptr<Tile>> m_tiles;
};

extern template class LayerSmoother<std::uint8_t>;
extern template class LayerSmoother<float>;

}  // namespace spin
