// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "plugins/host/import_checks.h"
#include "plugins/host/import_codec.h"

namespace spin {
namespace {

enum class LayerKind : std::uint8_t { None, Bytes, Floats };

/// Tiles go one by one; a tile of one value is a single number, so that a sparsely painted layer is small.
template <class T>
void encodeTiles(ByteWriter& out, const TiledRaster<T>& raster) {
  out.put(raster.width());
  out.put(raster.height());
  out.put(raster.fill());
  for (std::size_t t = 0; t < raster.tileCount(); ++t) {
    const auto& tile = *raster.tile(t);
    const bool uniform = std::all_of(tile.begin(), tile.end(), [&](T v) { return v == tile[0]; });
    out.put(static_cast<std::uint8_t>(uniform));
    if (uniform)
      out.put(tile[0]);
    else
      out.put(tile);
  }
}

template <class T>
Result<PaintedLayer> decodeTiles(ByteReader& in, const std::string& path) {
  const auto bad = [&](const char* why) { return badInput("The painted layer is unusable", path, why); };
  const auto width = in.get<int>();
  const auto height = in.get<int>();
  const auto fill = in.get<T>();
  if (!in.ok() || width < 1 || height < 1 || width > kMaxRasterEdge || height > kMaxRasterEdge)
    return bad("its size is out of range");
  TiledRaster<T> raster(width, height, fill);
  for (std::size_t t = 0; t < raster.tileCount() && in.ok(); ++t) {
    auto tile = std::make_shared<typename TiledRaster<T>::Tile>();
    const bool uniform = in.get<std::uint8_t>() != 0;
    if (uniform)
      tile->fill(in.get<T>());
    else
      *tile = in.get<typename TiledRaster<T>::Tile>();
    const bool plain = uniform && (*tile)[0] == fill;
    if (!plain) raster.setTile(t, std::move(tile));
  }
  if (!in.ok()) return bad("it is damaged");
  return PaintedLayer(std::move(raster));
}

}  // namespace

void encode(ByteWriter& out, const PaintedLayer& layer) {
  if (const auto* bytes = std::get_if<TiledRaster<std::uint8_t>>(&layer)) {
    out.put(LayerKind::Bytes);
    encodeTiles(out, *bytes);
  } else if (const auto* floats = std::get_if<TiledRaster<float>>(&layer)) {
    out.put(LayerKind::Floats);
    encodeTiles(out, *floats);
  } else {
    out.put(LayerKind::None);
  }
}

Result<PaintedLayer> decodeLayer(ByteReader& in, const std::string& path) {
  switch (in.get<LayerKind>()) {
    case LayerKind::None:
      return PaintedLayer();
    case LayerKind::Bytes:
      return decodeTiles<std::uint8_t>(in, path);
    case LayerKind::Floats:
      return decodeTiles<float>(in, path);
  }
  return badInput("The painted layer is unusable", path, "it is of an unknown kind");
}

}  // namespace spin
