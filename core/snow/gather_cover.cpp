// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/base/random.h"
#include "core/math/sampling.h"
#include "core/snow/cell_samplers.h"
#include "core/snow/exposure_field.h"
#include "core/snow/occlusion_map.h"

namespace spin {
namespace {

constexpr std::size_t kBatch = 64;         ///< rays handed to the caster at once
constexpr std::size_t kCellChunk = 32;     ///< cells a thread takes at once
constexpr std::size_t kCellBlock = 16384;  ///< cells between two reports of progress

/// Lowest and highest point of a grid, the first above the second where it has none.
std::pair<double, double> heightsOf(const CoverGrid& grid) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const float z : grid.base.values) {
    if (std::isnan(z)) continue;
    low = std::min(low, static_cast<double>(z));
    high = std::max(high, static_cast<double>(z));
  }
  return {low, high};
}

struct CellSums {
  double visible = 0.0, visibleFirstHalf = 0.0;
  double held = 0.0, shed = 0.0;
};

/// Sums over the cells of a chunk, m2.
struct ChunkSums {
  double held = 0.0, shed = 0.0;
  double halfSquares = 0.0;
  double cells = 0.0;
};

struct Gather {
  const SnowScene& scene;
  const ExposureSettings& settings;
  std::vector<std::array<std::uint32_t, 4>> points;
  const Occluders* occluders = nullptr;  ///< for maps
};

/// Casts the rays of one cell: two dimensions of the net choose the point, two the direction.
template <class Sampler>
CellSums gatherCell(const Gather& gather, const Sampler& sampler, const UInt4& shift) {
  CellSums sums;
  const std::size_t rays = gather.points.size();
  std::array<Ray, kBatch> batch;
  std::array<std::uint8_t, kBatch> blocked;
  std::array<double, kBatch> arrival, hold;
  std::array<bool, kBatch> early;
  for (std::size_t begin = 0; begin < rays; begin += kBatch) {
    std::size_t count = 0;
    for (std::size_t r = begin; r < std::min(rays, begin + kBatch); ++r) {
      const auto& words = gather.points[r];
      const SurfacePoint p = sampler.at(shifted(words[0], shift.x), shifted(words[1], shift.y));
      const Vec3d w = gather.settings.cone.direction(shifted(words[2], shift.z), shifted(words[3], shift.w));
      const double factor = levelFluxFactor(p.normal, w);
      if (factor <= 0.0) continue;  // the surface turns its back: it shelters itself
      batch[count] = gather.scene.towardsSky(p.position, p.normal, w);
      arrival[count] = factor / p.normal.z;
      hold[count] = gather.settings.hold.share(p.normal.z);
      early[count++] = r < rays / 2;
    }
    gather.scene.rays->occludedMany(batch.data(), count, blocked.data());
    for (std::size_t k = 0; k < count; ++k) {
      if (blocked[k]) continue;
      sums.visible += 1.0;
      sums.visibleFirstHalf += early[k] ? 1.0 : 0.0;
      sums.held += arrival[k] * hold[k];
      sums.shed += arrival[k] * (1.0 - hold[k]);
    }
  }
  return sums;
}

/// Asks the maps of one grid, one for each direction of fall; two dimensions of the net choose the point.
template <class Sampler>
CellSums gatherFromMaps(const Gather& gather, const std::vector<OcclusionMap>& maps, const Sampler& sampler,
                        const UInt4& shift) {
  CellSums sums;
  const std::size_t rays = gather.points.size();
  for (std::size_t r = 0; r < rays; ++r) {
    const auto& words = gather.points[r];
    const SurfacePoint p = sampler.at(shifted(words[0], shift.x), shifted(words[1], shift.y));
    const OcclusionMap& map = maps[r % maps.size()];
    const double factor = levelFluxFactor(p.normal, map.view().frame.n);
    if (factor <= 0.0) continue;
    const double open = map.openness(p.position - gather.scene.centre, p.normal);
    const double hold = gather.settings.hold.share(p.normal.z), arrival = open * factor / p.normal.z;
    sums.visible += open;
    sums.visibleFirstHalf += r < rays / 2 ? open : 0.0;
    sums.held += arrival * hold;
    sums.shed += arrival * (1.0 - hold);
  }
  return sums;
}

/// A grid where it stands, less the snow scene's centre.
struct GridPlace {
  std::size_t grid = 0;
  std::size_t model = 0, patch = 0;  ///< of a model's patch
  Box3d box;
  double cellSize = 1.0;
};

GridPlace placeOf(const Gather& gather, const CoverGrid& grid, std::size_t index, Vec3d place) {
  GridPlace at;
  at.grid = index;
  at.cellSize = grid.base.cellSize;
  const auto [low, high] = heightsOf(grid);
  if (!(low <= high)) return at;
  const Raster<float>& base = grid.base;
  const double half = 0.5 * base.cellSize;
  const Vec3d move = place - gather.scene.centre;
  at.box.extend(move + Vec3d{base.originX - half, base.originY - half, low});
  at.box.extend(move + Vec3d{base.x(base.width - 1) + half, base.y(base.height - 1) + half, high});
  return at;
}

/// Maps for grids in a row, one for each of the directions that are evenly spread over the cone. Texels of
/// half a cell, or what the largest map allows; neighbours that fit into one map share it.
class SharedMaps {
 public:
  SharedMaps(const Gather& gather, const Workshop& workshop) : m_gather(gather), m_workshop(workshop) {}

  /// Maps that show places[index]; called with ascending indices of the same places. Empty without maps.
  const std::vector<OcclusionMap>& at(const std::vector<GridPlace>& places, std::size_t index) {
    if (!m_gather.occluders || index < m_end || places[index].box.empty()) return m_maps;
    Box3d box = places[index].box;
    const double half = 0.5 * places[index].cellSize, most = 0.9 * half * m_gather.settings.mapSize;
    for (m_end = index + 1; m_end < places.size(); ++m_end) {
      Box3d joined = box;
      if (!places[m_end].box.empty()) joined.extend(places[m_end].box);
      if (places[m_end].cellSize != places[index].cellSize || length(joined.size()) > most) break;
      box = joined;
    }
    draw(box, half);
    return m_maps;
  }

 private:
  void draw(const Box3d& box, double texel) {
    std::vector<Vec3d> corners;
    for (int k = 0; k < 8; ++k)
      corners.push_back(
          {k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z});
    m_maps.clear();
    for (const auto& words : sobolPoints(static_cast<std::size_t>(m_gather.settings.mapDirections))) {
      if (m_workshop.cancel.cancelled()) return;
      const Vec3d fall = m_gather.settings.cone.direction(shifted(words[2], 0), shifted(words[3], 0));
      m_maps.emplace_back(*m_gather.occluders,
                          MapView::round(corners, fall, texel, m_gather.settings.mapSize), m_workshop.backend,
                          m_workshop.cancel);
    }
  }

  const Gather& m_gather;
  const Workshop& m_workshop;
  std::vector<OcclusionMap> m_maps;
  std::size_t m_end = 0;  ///< of the places that the maps show
};

/// The patches of all models, neighbours one after the other.
std::vector<GridPlace> patchPlaces(const Gather& gather, const SnowGround& ground) {
  std::vector<GridPlace> places;
  for (std::size_t m = 0; m < ground.models.size(); ++m)
    for (std::size_t k = 0; k < ground.models[m].patches.size(); ++k) {
      const std::size_t grid = ground.models[m].patches[k].grid;
      places.push_back(
          placeOf(gather, ground.layout->grids[grid], grid, gather.scene.models[m].placement.translation));
      places.back().model = m;
      places.back().patch = k;
    }
  const auto tileOf = [&](const GridPlace& p) {
    const double tile = 0.25 * p.cellSize * gather.settings.mapSize;
    const Vec3d centre = p.box.empty() ? Vec3d{} : p.box.centre();
    return std::tuple(p.cellSize, std::floor(centre.x / tile), std::floor(centre.y / tile));
  };
  if (gather.occluders)
    std::stable_sort(places.begin(), places.end(),
                     [&](const GridPlace& a, const GridPlace& b) { return tileOf(a) < tileOf(b); });
  return places;
}

/// Half the difference of the means of the two halves of the rays, which has the spread of the mean of all;
/// with one ray there are no halves.
double halfDifference(const CellSums& sums, std::size_t rays) {
  const std::size_t first = rays / 2;
  if (first == 0) return 0.0;
  const double early = sums.visibleFirstHalf / static_cast<double>(first);
  const double late = (sums.visible - sums.visibleFirstHalf) / static_cast<double>(rays - first);
  return 0.5 * (early - late);
}

/// All cells of one grid, by maps where there are some. False when cancelled.
template <class Sampler>
bool gatherGrid(const Gather& gather, const std::vector<OcclusionMap>& maps, const Sampler& prototype,
                const CoverGrid& grid, std::size_t gridIndex, const Workshop& workshop,
                ExposureField::Values& values, ChunkSums& total,
                const std::function<void(std::size_t)>& cellsDone) {
  const std::size_t cells = grid.base.size();
  values.exposure.assign(cells, 0.0f);
  values.held.assign(cells, 0.0f);
  const CounterRandom random{gather.settings.seed, static_cast<std::uint32_t>(0x65787000u + gridIndex)};
  const double rays = static_cast<double>(gather.points.size());
  for (std::size_t block = 0; block < cells; block += kCellBlock) {
    const std::size_t count = std::min(kCellBlock, cells - block);
    std::vector<ChunkSums> partial((count + kCellChunk - 1) / kCellChunk);
    workshop.backend.forChunks(
        "exposure", count, kCellChunk, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
          Sampler sampler = prototype;
          ChunkSums sums;
          for (std::size_t cell = block + begin; cell < block + end; ++cell) {
            if (workshop.cancel.cancelled()) return;
            if (!sampler.enter(cell)) continue;
            const CellSums found = maps.empty() ? gatherCell(gather, sampler, random.words(cell))
                                                : gatherFromMaps(gather, maps, sampler, random.words(cell));
            const double area = static_cast<double>(grid.area.values[cell]);
            values.exposure[cell] = static_cast<float>(found.visible / rays);
            values.held[cell] = static_cast<float>(found.held / rays);
            sums.held += static_cast<double>(values.held[cell]) * area;
            sums.shed += found.shed / rays * area;
            const double halves = halfDifference(found, gather.points.size());
            sums.halfSquares += halves * halves;
            sums.cells += 1.0;
          }
          partial[chunk] = sums;
        });
    if (workshop.cancel.cancelled()) return false;
    for (const ChunkSums& sums : partial) {
      total.held += sums.held;
      total.shed += sums.shed;
      total.halfSquares += sums.halfSquares;
      total.cells += sums.cells;
    }
    cellsDone(count);
  }
  return true;
}

}  // namespace

Status gatherCover(const SceneSnapshot& snapshot, const SnowGround& ground, const SnowScene& scene,
                   const ExposureSettings& settings, const Workshop& workshop, ExposureField& field) {
  const CoverLayout& layout = *ground.layout;
  field.grids.assign(layout.grids.size(), {});
  for (std::size_t g = 0; g < layout.grids.size(); ++g) {
    field.grids[g].exposure.assign(layout.grids[g].base.size(), 0.0f);
    field.grids[g].held.assign(layout.grids[g].base.size(), 0.0f);
  }
  if (scene.domain.empty()) return {};
  std::optional<Occluders> occluders;
  if (settings.mapDirections > 0) occluders.emplace(snapshot, scene, workshop.cancel);
  const Gather gather{scene, settings, sobolPoints(static_cast<std::size_t>(settings.rays)),
                      occluders ? &*occluders : nullptr};
  std::size_t cellCount = 0, cellsSoFar = 0;
  for (const CoverGrid& grid : layout.grids) cellCount += grid.base.size();
  const auto cellsDone = [&](std::size_t count) {
    cellsSoFar += count;
    if (workshop.progress)
      workshop.progress(static_cast<double>(cellsSoFar) / static_cast<double>(cellCount));
  };
  ChunkSums onGround, onModels;
  if (!ground.terrain.empty()) {
    const TerrainSurface surface(snapshot.terrain->heights);
    const Raster<std::uint8_t> superseded = supersededQuads(surface.heights(), ground);
    std::vector<GridPlace> places;
    for (const TerrainGrid& terrain : ground.terrain)
      places.push_back(placeOf(gather, layout.grids[terrain.grid], terrain.grid, {}));
    SharedMaps maps(gather, workshop);
    for (std::size_t t = 0; t < places.size(); ++t) {
      const CoverGrid& cover = layout.grids[places[t].grid];
      const TerrainCellSampler sampler(surface, ground.terrain[t], cover, superseded);
      if (!gatherGrid(gather, maps.at(places, t), sampler, cover, places[t].grid, workshop,
                      field.grids[places[t].grid], onGround, cellsDone))
        return cancelledError();
    }
  }
  const std::vector<GridPlace> patches = patchPlaces(gather, ground);
  SharedMaps maps(gather, workshop);
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const GridPlace& at = patches[k];
    const PatchCellSampler sampler(ground.models[at.model], ground.models[at.model].patches[at.patch],
                                   scene.models[at.model].placement.translation);
    if (!gatherGrid(gather, maps.at(patches, k), sampler, layout.grids[at.grid], at.grid, workshop,
                    field.grids[at.grid], onModels, cellsDone))
      return cancelledError();
  }
  field.rates.deposited = onGround.held + onModels.held;
  field.rates.shed = onGround.shed + onModels.shed;
  field.rates.gathered.ground = onGround.held + onGround.shed;
  field.rates.gathered.models = onModels.held + onModels.shed;
  // Half the difference of two halves has the spread of the whole's mean.
  const double cells = onGround.cells + onModels.cells;
  if (cells > 0.0 && settings.rays > 1)
    field.samplingRmse = std::sqrt((onGround.halfSquares + onModels.halfSquares) / cells);
  return {};
}

}  // namespace spin
