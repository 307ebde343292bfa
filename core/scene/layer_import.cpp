// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/layer_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace spin {
namespace {

constexpr const char* kWhat = "The file cannot be laid over the terrain";
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Where the centre of terrain cell (i, j) lies in the raster, in cells from the centre of its first.
struct Mapping {
  double x0 = 0.0, y0 = 0.0;             ///< of terrain cell (0, 0)
  double perColumn = 1.0, perRow = 1.0;  ///< raster cells per terrain cell
  bool oneToOne() const { return x0 == 0.0 && y0 == 0.0 && perColumn == 1.0 && perRow == 1.0; }
};

Result<Mapping> mappingOf(const RasterImport& raster, const TerrainData& terrain, const std::string& path) {
  const Raster<float>& r = raster.values;
  const Raster<float>& t = terrain.heights;
  Mapping map;
  const bool placed = terrain.geo.epsg != 0 || !terrain.geo.wkt.empty() || terrain.geo.origin.x != 0.0 ||
                      terrain.geo.origin.y != 0.0;
  if (!raster.georeferenced || !placed) {
    map.perColumn = static_cast<double>(r.width) / t.width;
    map.perRow = static_cast<double>(r.height) / t.height;
    map.x0 = 0.5 * map.perColumn - 0.5;
    map.y0 = 0.5 * map.perRow - 0.5;
    return map;
  }
  if (raster.geo.epsg != 0 && terrain.geo.epsg != 0 && raster.geo.epsg != terrain.geo.epsg)
    return badInput(kWhat, path,
                    fmt::format("its coordinates are EPSG:{}, the terrain's are EPSG:{}", raster.geo.epsg,
                                terrain.geo.epsg),
                    fmt::format("Reproject it: gdalwarp -t_srs EPSG:{} IN OUT", terrain.geo.epsg));
  map.perColumn = map.perRow = t.cellSize / r.cellSize;
  map.x0 = (terrain.geo.origin.x + t.originX - raster.geo.origin.x - r.originX) / r.cellSize;
  map.y0 = (terrain.geo.origin.y + t.originY - raster.geo.origin.y - r.originY) / r.cellSize;
  // Georeferences carry rounded numbers: a thousandth of a cell is none.
  const auto settle = [](double& v, double whole) {
    if (std::abs(v - whole) < 1e-3) v = whole;
  };
  settle(map.x0, std::round(map.x0));
  settle(map.y0, std::round(map.y0));
  settle(map.perColumn, 1.0);
  settle(map.perRow, 1.0);
  const double east = map.x0 + map.perColumn * (t.width - 1), north = map.y0 + map.perRow * (t.height - 1);
  if (east < -0.5 || north < -0.5 || map.x0 > r.width - 0.5 || map.y0 > r.height - 0.5)
    return badInput(kWhat, path, "by its georeference it lies beside the terrain",
                    "Check that both have the same coordinate system");
  return map;
}

double cellAt(const Raster<float>& r, int i, int j) {
  return r.contains(i, j) ? static_cast<double>(r.at(i, j)) : kNan;
}

double nearest(const Raster<float>& r, double x, double y) {
  return cellAt(r, static_cast<int>(std::floor(x + 0.5)), static_cast<int>(std::floor(y + 0.5)));
}

/// Mean of what has data, weighted by how much of a cell lies in the box round (x, y), whose sides are a
/// terrain cell's or at least a raster cell's: for a coarse raster this is interpolation.
double measured(const Raster<float>& r, double x, double y, double width, double height) {
  if (std::isnan(nearest(r, x, y))) return kNan;
  const double halfX = 0.5 * std::max(1.0, width), halfY = 0.5 * std::max(1.0, height);
  const auto share = [](double cell, double middle, double half) {
    return std::max(0.0, std::min(cell + 0.5, middle + half) - std::max(cell - 0.5, middle - half));
  };
  double sum = 0.0, weight = 0.0;
  for (int j = static_cast<int>(std::floor(y - halfY + 0.5));
       j <= static_cast<int>(std::ceil(y + halfY - 0.5)); ++j)
    for (int i = static_cast<int>(std::floor(x - halfX + 0.5));
         i <= static_cast<int>(std::ceil(x + halfX - 0.5)); ++i) {
      const double value = cellAt(r, i, j);
      const double w = share(i, x, halfX) * share(j, y, halfY);
      if (std::isnan(value) || !(w > 0.0)) continue;
      sum += w * value;
      weight += w;
    }
  return weight > 0.0 ? sum / weight : kNan;
}

/// Temperatures on Earth in degrees Celsius and in kelvin do not overlap.
bool looksLikeCelsius(const Raster<float>& r) {
  bool any = false;
  for (const float v : r.values) {
    if (std::isnan(v)) continue;
    if (v < -90.0f || v > 90.0f) return false;
    any = true;
  }
  return any;
}

template <class T, class Value>
TiledRaster<T> layerFrom(const Raster<float>& t, T blank, const Value& value) {
  TiledRaster<T> layer(t.width, t.height, blank);
  for (int j = 0; j < t.height; ++j)
    for (int i = 0; i < t.width; ++i)
      if (const double v = value(i, j); !std::isnan(v)) layer.set(i, j, static_cast<T>(v));
  return layer;
}

Result<PaintedLayer> namesFrom(const Raster<float>& r, const Raster<float>& t, const Mapping& map,
                               const PaintedKind& kind, const std::string& path) {
  double bad = kNan;
  const auto value = [&](int i, int j) {
    const double v = nearest(r, map.x0 + map.perColumn * i, map.y0 + map.perRow * j);
    if (std::isnan(v) || v == static_cast<double>(kind.blank)) return kNan;
    if (kind.holds(v) && v == std::floor(v)) return v;
    bad = v;
    return kNan;
  };
  TiledRaster<std::uint8_t> layer = layerFrom(t, static_cast<std::uint8_t>(kind.blank), value);
  if (std::isnan(bad)) return PaintedLayer(std::move(layer));
  return badInput(kWhat, path, fmt::format("{} is the number of no {}", bad, kind.name),
                  fmt::format("It may hold {} to {}, and {} where nothing is painted", kind.least, kind.most,
                              static_cast<int>(kind.blank)));
}

PaintedLayer measuresFrom(const Raster<float>& r, const Raster<float>& t, const Mapping& map,
                          const PaintedKind& kind, double scale, double offset, std::size_t& clipped) {
  const auto value = [&](int i, int j) {
    const double v =
        measured(r, map.x0 + map.perColumn * i, map.y0 + map.perRow * j, map.perColumn, map.perRow);
    if (std::isnan(v)) return kNan;
    const double si = v * scale + offset;
    if (!kind.holds(si)) ++clipped;
    return std::clamp(si, kind.least, kind.most);
  };
  return layerFrom(t, kind.blank, value);
}

}  // namespace

Result<LaidRaster> laidOver(const RasterImport& raster, const TerrainData& terrain, const PaintedKind& kind,
                            const LayerImportOptions& options, const std::string& path) {
  const Raster<float>& r = raster.values;
  const Raster<float>& t = terrain.heights;
  const Result<Mapping> map = mappingOf(raster, terrain, path);
  if (!map) return map.error();
  LaidRaster laid;
  if (r.width != t.width || r.height != t.height || !map->oneToOne())
    laid.remarks.push_back(fmt::format("Its {} x {} cells were resampled to the terrain's {} x {}.", r.width,
                                       r.height, t.width, t.height));
  if (kind.numbers) {
    Result<PaintedLayer> layer = namesFrom(r, t, *map, kind, path);
    if (!layer) return layer.error();
    laid.layer = std::move(*layer);
    return laid;
  }
  double scale = 1.0, offset = 0.0;
  if (raster.bits != 0) {
    scale = (options.white - options.black) / ((1 << raster.bits) - 1);
    offset = options.black;
  } else if (kind.unit == Unit::Kelvin && looksLikeCelsius(r)) {
    offset = kZeroCelsius;
    laid.remarks.push_back("Its temperatures were taken as degrees Celsius.");
  }
  std::size_t clipped = 0;
  laid.layer = measuresFrom(r, t, *map, kind, scale, offset, clipped);
  if (clipped > 0)
    laid.remarks.push_back(fmt::format(
        "{} cells held more or less than a {} can be; they have its limits now.", clipped, kind.name));
  return laid;
}

}  // namespace spin
