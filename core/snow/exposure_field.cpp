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

/// Multiplies the deposit of the grids by 1 + noise, scaled so that what lies on them together stays the
/// same. The noise is a function of the place, so grids that meet agree.
void makeUneven(const std::vector<std::size_t>& gridIndices, const CoverLayout& layout, double wavelength,
                const ExposureSettings& settings, const Workshop& workshop, ExposureField& field) {
  NoiseSums sums;
  for (const std::size_t g : gridIndices) {
    const CoverGrid& grid = layout.grids[g];
    std::vector<float>& held = field.grids[g].held;
    const auto area = [&](std::size_t c) { return static_cast<double>(grid.area.values[c]); };
    const auto mass = [&](std::size_t c) { return static_cast<double>(held[c]) * area(c); };
    const auto add = [](double a, double b) { return a + b; };
    sums.plain += workshop.backend.reduce("cover noise", held.size(), 0.0, mass, add);
    workshop.backend.forEach("cover noise", held.size(), [&](std::size_t c) {
      if (held[c] > 0.0f)
        held[c] = static_cast<float>(static_cast<double>(held[c]) *
                                     unevenness(grid, c, wavelength, settings.noise, settings.seed));
    });
    sums.uneven += workshop.backend.reduce("cover noise", held.size(), 0.0, mass, add);
  }
  if (!(sums.uneven > 0.0)) return;
  const double scale = sums.plain / sums.uneven;
  for (const std::size_t g : gridIndices)
    for (float& held : field.grids[g].held) held = static_cast<float>(static_cast<double>(held) * scale);
}

void addNoise(const SnowGround& ground, const ExposureSettings& settings, const Workshop& workshop,
              ExposureField& field) {
  if (settings.noise <= 0.0) return;
  std::vector<std::size_t> terrain;
  for (const TerrainGrid& grid : ground.terrain) terrain.push_back(grid.grid);
  makeUneven(terrain, *ground.layout, kNoiseWavelength, settings, workshop, field);
  for (const ModelGround& model : ground.models)
    for (const ModelPatch& patch : model.patches)
      makeUneven({patch.grid}, *ground.layout, kPatchWavelength, settings, workshop, field);
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
                                        const Workshop& workshop) {
  ExposureField field;
  field.cone = settings.cone;
  field.airVolume = scene.airVolume;
  if (const Status status = gatherCover(snapshot, ground, scene, settings, workshop, field); !status)
    return status.error();
  if (const Status status = estimateRates(snapshot, ground, scene, settings, workshop, field.rates); !status)
    return status.error();
  smoothFacets(snapshot, ground, settings, workshop, field);
  addNoise(ground, settings, workshop, field);
  field.rates.deposited = heldTotal(*ground.layout, field);
  return field;
}

}  // namespace spin
