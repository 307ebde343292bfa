// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/base/random.h"
#include "core/math/sampling.h"
#include "core/snow/cell_mask.h"
#include "core/snow/cell_samplers.h"
#include "core/snow/exposure_field.h"
#include "core/snow/shared_maps.h"

namespace spin {
namespace {

constexpr std::size_t kBatch = 64;         ///< rays handed to the caster at once
constexpr std::size_t kCellChunk = 32;     ///< cells a thread takes at once
constexpr std::size_t kCellBlock = 16384;  ///< cells between two reports of progress

/// Box of a grid's cells in its own axes; empty where it has none.
Box3d gridBox(const CoverGrid& grid) {
  Box3d box;
  const Raster<float>& base = grid.base;
  const double half = 0.5 * base.cellSize;
  for (const float z : base.values)
    if (!std::isnan(z)) box.extend(Vec3d{base.originX, base.originY, static_cast<double>(z)});
  if (box.empty()) return box;
  box.min = {base.originX - half, base.originY - half, box.min.z};
  box.max = {base.x(base.width - 1) + half, base.y(base.height - 1) + half, box.max.z};
  return box;
}

/// Box of what a patch covers, about its model's position.
Box3d patchBox(const ModelGround& model, const ModelPatch& patch, const CoverGrid& grid) {
  Box3d box = gridBox(grid);
  for (const PatchPiece& piece : patch.pieces)
    for (const Vec3f& p : model.triangles[piece.source].corners) {
      box.min.z = std::min(box.min.z, static_cast<double>(p.z));
      box.max.z = std::max(box.max.z, static_cast<double>(p.z));
    }
  return box;
}

/// Over the cells of a grid: m2, and the count.
struct GridSums {
  double held = 0.0, shed = 0.0, halfSquares = 0.0, cells = 0.0;
  static GridSums add(const GridSums& a, const GridSums& b) {
    return {a.held + b.held, a.shed + b.shed, a.halfSquares + b.halfSquares, a.cells + b.cells};
  }
};

struct CellSums {
  double visible = 0.0, visibleFirstHalf = 0.0;
  double held = 0.0, shed = 0.0;
};

struct Gather {
  const SnowScene& scene;
  const ExposureSettings& settings;
  const SkyChange& change;
  const Workshop& workshop;
  std::vector<std::array<std::uint32_t, 4>> points;
  std::optional<Occluders> occluders;  ///< for maps
  std::unique_ptr<MapRaster> raster;   ///< that draws them elsewhere
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

/// Half the difference of the means of the two halves of the rays, which has the spread of the mean of all;
/// with one ray there are no halves.
double halfDifference(const CellSums& sums, std::size_t rays) {
  const std::size_t first = rays / 2;
  if (first == 0) return 0.0;
  const double early = sums.visibleFirstHalf / static_cast<double>(first);
  const double late = (sums.visible - sums.visibleFirstHalf) / static_cast<double>(rays - first);
  return 0.5 * (early - late);
}

/// The cells of one grid that are asked, by maps where there are some. False when cancelled.
template <class Sampler>
bool gatherGrid(const Gather& gather, const std::vector<OcclusionMap>& maps, const Sampler& prototype,
                const CellMask& mask, std::size_t gridIndex, GatheredCover::Cells& values,
                const std::function<void(std::size_t)>& cellsDone) {
  const auto row = static_cast<std::size_t>(mask.width);
  const std::size_t end = static_cast<std::size_t>(mask.toRow) * row;
  values.asked = true;
  const CounterRandom random{gather.settings.seed, static_cast<std::uint32_t>(0x65787000u + gridIndex)};
  const double rays = static_cast<double>(gather.points.size());
  for (std::size_t block = static_cast<std::size_t>(mask.fromRow) * row; block < end; block += kCellBlock) {
    const std::size_t count = std::min(kCellBlock, end - block);
    gather.workshop.backend.forChunks(
        "exposure", count, kCellChunk, [&](std::size_t first, std::size_t last, std::size_t) {
          Sampler sampler = prototype;
          for (std::size_t cell = block + first; cell < block + last; ++cell) {
            if (gather.workshop.cancel.cancelled()) return;
            if (!mask.covers(cell) || !sampler.enter(cell)) continue;
            const CellSums found = maps.empty() ? gatherCell(gather, sampler, random.words(cell))
                                                : gatherFromMaps(gather, maps, sampler, random.words(cell));
            values.exposure[cell] = static_cast<float>(found.visible / rays);
            values.held[cell] = static_cast<float>(found.held / rays);
            values.shed[cell] = static_cast<float>(found.shed / rays);
            values.halves[cell] = static_cast<float>(halfDifference(found, gather.points.size()));
          }
        });
    if (gather.workshop.cancel.cancelled()) return false;
    cellsDone(count);
  }
  return true;
}

/// Grids in a row and what of them is asked, with maps that neighbours share.
struct AskedGrids {
  std::vector<GridPlace> places;
  std::vector<CellMask> masks;
};

/// How far beside a cell its answer looks, m, by place: to where a ray starts off its surface, or as far as
/// the comparison of its plane with a map's texels.
std::vector<double> marginsOf(const Gather& gather, const std::vector<GridPlace>& places) {
  const Vec3d corner = gather.scene.domain.max - gather.scene.centre;
  std::vector<double> margins(places.size(), 4.0 * SnowScene::standOff(corner));
  if (!gather.occluders) return margins;
  const SharedMaps shared(places, gather.settings);
  for (std::size_t first = 0; first < places.size(); first = shared.groupEnd(first))
    for (std::size_t k = first; k < shared.groupEnd(first); ++k)
      margins[k] += OcclusionMap::kReachInTexels * shared.largestTexel(first);
  return margins;
}

/// Calls ask(place, mask, maps) for the grids of which something is asked. False when cancelled.
template <class Ask>
bool askGrids(const Gather& gather, const AskedGrids& grids, const Ask& ask) {
  const SharedMaps shared(grids.places, gather.settings);
  for (std::size_t first = 0; first < grids.places.size(); first = shared.groupEnd(first)) {
    Box3d wanted;
    for (std::size_t k = first; k < shared.groupEnd(first); ++k) wanted.extend(grids.masks[k].reached);
    if (wanted.empty()) continue;
    std::vector<OcclusionMap> maps;
    if (gather.occluders) {
      Box3d local;
      local.extend(wanted.min - gather.scene.centre);
      local.extend(wanted.max - gather.scene.centre);
      maps = shared.draw(first, local, *gather.occluders, gather.raster.get(), gather.workshop);
      if (gather.workshop.cancel.cancelled()) return false;
    }
    for (std::size_t k = first; k < shared.groupEnd(first); ++k)
      if (!grids.masks[k].reached.empty() && !ask(grids.places[k], grids.masks[k], maps)) return false;
  }
  return true;
}

/// Tiles of a grid that a map shows at its finest, the whole grid without maps.
std::vector<BlockTile> tilesOf(const Gather& gather, const LandBlocks& blocks, double cellSize) {
  int side = std::max({blocks.across, blocks.down, 1});
  if (gather.occluders) {
    // The diagonal of a tile's box has to fit; the land's relief takes its part.
    const double most = SharedMaps::largest(cellSize, gather.settings);
    side = std::max(1, static_cast<int>(most / (1.6 * cellSize * LandBlocks::kSide)));
  }
  std::vector<BlockTile> tiles;
  for (int row = 0; row < blocks.down; row += side)
    for (int column = 0; column < blocks.across; column += side)
      tiles.push_back(
          {column, std::min(column + side, blocks.across), row, std::min(row + side, blocks.down)});
  return tiles;
}

AskedGrids terrainGrids(const Gather& gather, const SnowGround& ground, const Raster<float>& heights) {
  AskedGrids grids;
  std::vector<LandBlocks> blocks;
  std::vector<BlockTile> tiles;
  for (std::size_t t = 0; t < ground.terrain.size(); ++t) {
    const TerrainGrid& terrain = ground.terrain[t];
    const CoverGrid& cover = ground.layout->grids[terrain.grid];
    GridPlace place;
    place.grid = terrain.grid;
    place.patch = t;
    place.cellSize = cover.base.cellSize;
    place.move = -gather.scene.centre;
    blocks.emplace_back(heights, terrain, cover);
    for (const BlockTile& tile : tilesOf(gather, blocks.back(), place.cellSize)) {
      place.box = {};
      for (int row = tile.fromRow; row < tile.toRow; ++row)
        for (int column = tile.fromColumn; column < tile.toColumn; ++column)
          place.box.extend(blocks.back().at(column, row));
      grids.places.push_back(place);
      tiles.push_back(tile);
    }
  }
  const std::vector<double> margins = marginsOf(gather, grids.places);
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    const GridPlace& place = grids.places[k];
    grids.masks.push_back(CellMask::onLand(gather.change, margins[k], blocks[place.patch], tiles[k],
                                           ground.layout->grids[place.grid]));
  }
  return grids;
}

AskedGrids patchGrids(const Gather& gather, const SnowGround& ground) {
  AskedGrids grids;
  for (std::size_t m = 0; m < ground.models.size(); ++m)
    for (std::size_t k = 0; k < ground.models[m].patches.size(); ++k) {
      GridPlace place;
      place.grid = ground.models[m].patches[k].grid;
      place.model = m;
      place.patch = k;
      place.cellSize = ground.layout->grids[place.grid].base.cellSize;
      place.move = gather.scene.models[m].placement.translation - gather.scene.centre;
      place.box = patchBox(ground.models[m], ground.models[m].patches[k], ground.layout->grids[place.grid]);
      grids.places.push_back(place);
    }
  if (gather.occluders) sortForMaps(grids.places, gather.settings);
  const std::vector<double> margins = marginsOf(gather, grids.places);
  for (std::size_t k = 0; k < grids.places.size(); ++k) {
    const GridPlace& place = grids.places[k];
    grids.masks.push_back(CellMask::ofPatch(gather.change, margins[k], place.model,
                                            place.moved(gather.scene.centre),
                                            ground.layout->grids[place.grid]));
  }
  return grids;
}

void prepare(const CoverLayout& layout, const SkyChange& change, GatheredCover& cover) {
  cover.grids.resize(layout.grids.size());
  for (std::size_t g = 0; g < layout.grids.size(); ++g) {
    GatheredCover::Cells& cells = cover.grids[g];
    cells.asked = false;
    if (!change.isEverywhere()) continue;
    const std::size_t count = layout.grids[g].base.size();
    cells.exposure.assign(count, 0.0f);
    cells.held.assign(count, 0.0f);
    cells.shed.assign(count, 0.0f);
    cells.halves.assign(count, std::numeric_limits<float>::quiet_NaN());
  }
}

}  // namespace

Status gatherCover(const SceneSnapshot& snapshot, const SnowGround& ground, const SnowScene& scene,
                   const ExposureSettings& settings, const SkyChange& change, const Workshop& workshop,
                   GatheredCover& cover) {
  const CoverLayout& layout = *ground.layout;
  prepare(layout, change, cover);
  if (scene.domain.empty()) return {};
  Gather gather{scene, settings, change, workshop, sobolPoints(static_cast<std::size_t>(settings.rays)),
                {},    {}};
  if (settings.mapDirections > 0) {
    gather.occluders.emplace(snapshot, scene, workshop.cancel);
    if (workshop.makeMapRaster) gather.raster = workshop.makeMapRaster(*gather.occluders);
  }
  AskedGrids patches = patchGrids(gather, ground), land;
  if (!ground.terrain.empty()) land = terrainGrids(gather, ground, snapshot.terrain->heights);
  std::size_t cellCount = 0, cellsSoFar = 0;
  for (AskedGrids* grids : {&patches, &land})
    for (std::size_t k = 0; k < grids->places.size(); ++k)
      if (!grids->masks[k].reached.empty()) cellCount += grids->masks[k].cells();
  const auto cellsDone = [&](std::size_t count) {
    cellsSoFar += count;
    if (workshop.progress)
      workshop.progress(static_cast<double>(cellsSoFar) / static_cast<double>(cellCount));
  };
  if (!ground.terrain.empty()) {
    const TerrainSurface surface(snapshot.terrain->heights);
    const Raster<std::uint8_t> superseded = supersededQuads(surface.heights(), ground);
    const auto ask = [&](const GridPlace& at, const CellMask& mask, const std::vector<OcclusionMap>& maps) {
      const TerrainCellSampler sampler(surface, ground.terrain[at.patch], layout.grids[at.grid], superseded);
      return gatherGrid(gather, maps, sampler, mask, at.grid, cover.grids[at.grid], cellsDone);
    };
    if (!askGrids(gather, land, ask)) return cancelledError();
  }
  const auto ask = [&](const GridPlace& at, const CellMask& mask, const std::vector<OcclusionMap>& maps) {
    const PatchCellSampler sampler(ground.models[at.model], ground.models[at.model].patches[at.patch],
                                   scene.models[at.model].placement.translation);
    return gatherGrid(gather, maps, sampler, mask, at.grid, cover.grids[at.grid], cellsDone);
  };
  if (!askGrids(gather, patches, ask)) return cancelledError();
  return {};
}

void sumGathered(const SnowGround& ground, const GatheredCover& cover, int rays, const Workshop& workshop,
                 ExposureField& field) {
  std::vector<bool> isLand(cover.grids.size(), false);
  for (const TerrainGrid& terrain : ground.terrain) isLand[terrain.grid] = true;
  GridSums onGround, onModels;
  for (std::size_t g = 0; g < cover.grids.size(); ++g) {
    const GatheredCover::Cells& cells = cover.grids[g];
    const std::vector<float>& areas = ground.layout->grids[g].area.values;
    const auto ofCell = [&](std::size_t c) {
      if (std::isnan(cells.halves[c])) return GridSums{};
      const double area = static_cast<double>(areas[c]), halves = static_cast<double>(cells.halves[c]);
      return GridSums{static_cast<double>(cells.held[c]) * area, static_cast<double>(cells.shed[c]) * area,
                      halves * halves, 1.0};
    };
    GridSums& sums = isLand[g] ? onGround : onModels;
    sums = GridSums::add(
        sums, workshop.backend.reduce("exposure", cells.held.size(), GridSums{}, ofCell, GridSums::add));
  }
  field.rates.deposited = onGround.held + onModels.held;
  field.rates.shed = onGround.shed + onModels.shed;
  field.rates.gathered.ground = onGround.held + onGround.shed;
  field.rates.gathered.models = onModels.held + onModels.shed;
  // Half the difference of two halves has the spread of the whole's mean.
  const double cells = onGround.cells + onModels.cells;
  if (cells > 0.0 && rays > 1)
    field.samplingRmse = std::sqrt((onGround.halfSquares + onModels.halfSquares) / cells);
}

}  // namespace spin
