// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numeric>

#include "core/base/random.h"
#include "core/math/sampling.h"
#include "core/snow/cell_samplers.h"
#include "core/snow/exposure_field.h"

namespace spin {
namespace {

constexpr std::size_t kBatch = 64;         ///< rays handed to the caster at once
constexpr std::size_t kCellChunk = 32;     ///< cells a thread takes at once
constexpr std::size_t kCellBlock = 16384;  ///< cells between two reports of progress

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

/// Half the difference of the means of the two halves of the rays, which has the spread of the mean of all;
/// with one ray there are no halves.
double halfDifference(const CellSums& sums, std::size_t rays) {
  const std::size_t first = rays / 2;
  if (first == 0) return 0.0;
  const double early = sums.visibleFirstHalf / static_cast<double>(first);
  const double late = (sums.visible - sums.visibleFirstHalf) / static_cast<double>(rays - first);
  return 0.5 * (early - late);
}

/// All cells of one grid. False when cancelled.
template <class Sampler>
bool gatherGrid(const Gather& gather, const Sampler& prototype, const CoverGrid& grid, std::size_t gridIndex,
                const Workshop& workshop, ExposureField::Values& values, ChunkSums& total,
                const std::function<void(std::size_t)>& cellsDone) {
  const std::size_t cells = grid.base.size();
  values.exposure.assign(cells, 0.0f);
  values.held.assign(cells, 0.0f);
  const CounterRandom random{gather.settings.seed, static_cast<std::uint32_t>(0x65787000u + gridIndex)};
  const double rays = static_cast<double>(gather.points.size());
  for (std::size_t block = 0; block < cells; block += kCellBlock) {
    const std::size_t count = std::min(kCellBlock, cells - block);
    std::vector<ChunkSums> partial((count + kCellChunk - 1) / kCellChunk);
    workshop.backend.forChunks("exposure", count, kCellChunk,
                               [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                                 Sampler sampler = prototype;
                                 ChunkSums sums;
                                 for (std::size_t cell = block + begin; cell < block + end; ++cell) {
                                   if (workshop.cancel.cancelled()) return;
                                   if (!sampler.enter(cell)) continue;
                                   const CellSums found = gatherCell(gather, sampler, random.words(cell));
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
  const Gather gather{scene, settings, sobolPoints(static_cast<std::size_t>(settings.rays))};
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
    for (const TerrainGrid& terrain : ground.terrain) {
      const CoverGrid& cover = layout.grids[terrain.grid];
      const TerrainCellSampler sampler(surface, terrain, cover, superseded);
      if (!gatherGrid(gather, sampler, cover, terrain.grid, workshop, field.grids[terrain.grid], onGround,
                      cellsDone))
        return cancelledError();
    }
  }
  for (std::size_t m = 0; m < ground.models.size(); ++m)
    for (const ModelPatch& patch : ground.models[m].patches) {
      const PatchCellSampler sampler(ground.models[m], patch, scene.models[m].placement.translation);
      if (!gatherGrid(gather, sampler, layout.grids[patch.grid], patch.grid, workshop,
                      field.grids[patch.grid], onModels, cellsDone))
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
