// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/exposure_field.h"

#include "core/math/noise.h"

namespace spin {
namespace {

constexpr double kNoiseWavelength = 24.0;  ///< m, of the coarsest unevenness on the terrain
constexpr double kPatchWavelength = 3.0;   ///< m, on models

/// Sums of a set of grids before and after the noise: their ratio keeps the mass.
struct NoiseSums {
  double plain = 0.0, uneven = 0.0;
};

double unevenness(const CoverGrid& grid, std::size_t cell, double wavelength, double amplitude,
                  std::uint64_t seed) {
  const auto width = static_cast<std::size_t>(grid.base.width);
  const Vec3d p{grid.base.x(static_cast<int>(cell % width)), grid.base.y(static_cast<int>(cell / width)),
                0.37};
  return 1.0 + amplitude * octaveNoise(p, wavelength, 2.0 * grid.base.cellSize, seed);
}

/// 1 + noise of all cells of a grid: a function of the place, so grids that meet agree.
std::vector<float> unevenGrid(const CoverGrid& grid, double wavelength, const ExposureSettings& settings,
                              const Workshop& workshop) {
  std::vector<float> uneven(grid.base.size(), 1.0f);
  workshop.backend.forEach("cover noise", uneven.size(), [&](std::size_t c) {
    uneven[c] = static_cast<float>(unevenness(grid, c, wavelength, settings.noise, settings.seed));
  });
  return uneven;
}

/// Multiplies the deposit of the grids by 1 + noise, scaled so that what lies on them together stays the
/// same.
void makeUneven(const std::vector<std::size_t>& gridIndices, const CoverLayout& layout,
                const ExposureMemory& memory, const Workshop& workshop, ExposureField& field) {
  NoiseSums sums;
  for (const std::size_t g : gridIndices) {
    const std::vector<float>& area = layout.grids[g].area.values;
    const std::vector<float>& uneven = memory.uneven[g];
    std::vector<float>& held = field.grids[g].held;
    const auto add = [](NoiseSums a, NoiseSums b) {
      return NoiseSums{a.plain + b.plain, a.uneven + b.uneven};
    };
    const auto makeCell = [&](std::size_t c) {
      NoiseSums mass;
      mass.plain = static_cast<double>(held[c]) * static_cast<double>(area[c]);
      held[c] *= uneven[c];
      mass.uneven = static_cast<double>(held[c]) * static_cast<double>(area[c]);
      return mass;
    };
    sums = add(sums, workshop.backend.reduce("cover noise", held.size(), NoiseSums{}, makeCell, add));
  }
  if (!(sums.uneven > 0.0)) return;
  const double scale = sums.plain / sums.uneven;
  for (const std::size_t g : gridIndices)
    for (float& held : field.grids[g].held) held = static_cast<float>(static_cast<double>(held) * scale);
}

void addNoise(const SnowGround& ground, const ExposureSettings& settings, const Workshop& workshop,
              ExposureMemory& memory, ExposureField& field) {
  if (settings.noise <= 0.0) return;
  const CoverLayout& layout = *ground.layout;
  const bool first = memory.uneven.empty();
  memory.uneven.resize(layout.grids.size());
  std::vector<std::size_t> terrain;
  for (const TerrainGrid& grid : ground.terrain) {
    terrain.push_back(grid.grid);
    if (first)
      memory.uneven[grid.grid] = unevenGrid(layout.grids[grid.grid], kNoiseWavelength, settings, workshop);
  }
  makeUneven(terrain, layout, memory, workshop, field);
  for (const ModelGround& model : ground.models)
    for (const ModelPatch& patch : model.patches) {
      if (first)
        memory.uneven[patch.grid] =
            unevenGrid(layout.grids[patch.grid], kPatchWavelength, settings, workshop);
      makeUneven({patch.grid}, layout, memory, workshop, field);
    }
}

/// What changed since the memory's standing.
SkyChange changeSince(const ExposureMemory& memory, const SnowScene& scene,
                      const ExposureSettings& settings) {
  if (!memory.standing || !(memory.standing->settings == settings) ||
      !(memory.standing->domain == scene.domain) || memory.standing->models.size() != scene.models.size())
    return SkyChange::everywhere();
  return SkyChange(settings.cone, memory.standing->models, scene.models);
}

/// What the cells hold to the last bit, after rounding and noise.
double heldTotal(const CoverLayout& layout, const ExposureField& field) {
  double sum = 0.0;
  for (std::size_t g = 0; g < layout.grids.size(); ++g)
    for (std::size_t c = 0; c < field.grids[g].held.size(); ++c)
      sum +=
          static_cast<double>(field.grids[g].held[c]) * static_cast<double>(layout.grids[g].area.values[c]);
  return sum;
}

}  // namespace

Error cancelledError() {
  return {ErrorKind::Cancelled, "The simulation stopped", "exposure", "it was cancelled", ""};
}

Result<ExposureField> makeExposureField(const SceneSnapshot& snapshot, const SnowGround& ground,
                                        const SnowScene& scene, const ExposureSettings& settings,
                                        const Workshop& workshop, ExposureMemory* memory) {
  ExposureMemory own;
  ExposureMemory& kept = memory ? *memory : own;
  const SkyChange change = changeSince(kept, scene, settings);
  if (kept.standing && !(kept.standing->settings == settings)) kept.uneven.clear();
  kept.standing.reset();  // nothing is kept of what is cancelled halfway
  ExposureField field;
  field.cone = settings.cone;
  field.airVolume = scene.airVolume;
  if (const Status status = gatherCover(snapshot, ground, scene, settings, change, workshop, kept.gathered);
      !status)
    return status.error();
  sumGathered(ground, kept.gathered, settings.rays, workshop, field);
  if (const Status status = estimateRates(snapshot, ground, scene, settings, workshop, field.rates); !status)
    return status.error();
  smoothFacets(snapshot, ground, settings, workshop, kept);
  for (std::size_t g = 0; g < kept.gathered.grids.size(); ++g) {
    const GatheredCover::Cells& cells = kept.gathered.grids[g];
    field.grids.push_back({cells.exposure, kept.smooth[g].empty() ? cells.held : kept.smooth[g]});
  }
  addNoise(ground, settings, workshop, kept, field);
  field.rates.deposited = heldTotal(*ground.layout, field);
  kept.standing = {settings, scene.domain, scene.models};
  return field;
}

}  // namespace spin
