// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/random.h"
#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_bench_scene.h"
#include "core/snow/cell_samplers.h"
#include "core/snow/exposure_process.h"

namespace spin {
namespace {

/// A cover cell and what the cover says about it.
struct Probe {
  std::size_t grid = 0, cell = 0;
  double cover = 0.0;
};

/// Direction uniform in the cone by rejection from a ball's slice: nothing in common with the cover's map.
Vec3d referenceDirection(const FallCone& cone, const CounterRandom& random, std::uint64_t index) {
  const UInt4 w = random.words(index, 1);
  const double cosine = 1.0 - cone.oneMinusCos * toUnitDouble(w.x, w.y);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const double turn = 2.0 * kPi * toUnitDouble(w.z, w.w);
  return cone.frame.s * (sine * std::cos(turn)) + cone.frame.t * (sine * std::sin(turn)) +
         cone.frame.n * cosine;
}

/// Share of plain random rays that see the sky.
template <class Sampler>
double reference(const SnowScene& scene, const FallCone& cone, const Sampler& sampler, std::uint64_t probe,
                 int rays) {
  constexpr int kBatch = 256;
  const CounterRandom random{0x5eed0fa11ull + probe, 77};
  std::vector<Ray> batch;
  std::vector<std::uint8_t> blocked(kBatch);
  std::int64_t open = 0;
  for (int r = 0; r < rays; ++r) {
    const auto index = static_cast<std::uint64_t>(r);
    const UInt4 w = random.words(index, 0);
    const SurfacePoint p = sampler.at(toUnitDouble(w.x, w.y), toUnitDouble(w.z, w.w));
    const Vec3d fall = referenceDirection(cone, random, index);
    if (dot(p.normal, fall) < 0.0) batch.push_back(scene.towardsSky(p.position, p.normal, fall));
    if (batch.size() == kBatch || r + 1 == rays) {
      scene.rays->occludedMany(batch.data(), batch.size(), blocked.data());
      open += std::count(blocked.begin(), blocked.begin() + static_cast<std::ptrdiff_t>(batch.size()), 0);
      batch.clear();
    }
  }
  return static_cast<double>(open) / rays;
}

/// Cells with a surface, drawn evenly over all grids' cells.
std::vector<Probe> drawProbes(const SnowGround& ground, const ExposureField& field, std::size_t count) {
  std::vector<std::size_t> start{0};
  for (const CoverGrid& grid : ground.layout->grids) start.push_back(start.back() + grid.base.size());
  const CounterRandom random{0xb0b5ull, 5};
  std::vector<Probe> probes;
  for (std::uint64_t k = 0; probes.size() < count && k < 1000 * count; ++k) {
    const auto at = static_cast<std::size_t>(random.uniformDouble(k) * static_cast<double>(start.back()));
    const auto grid =
        static_cast<std::size_t>(std::upper_bound(start.begin(), start.end(), at) - start.begin()) - 1;
    const std::size_t cell = at - start[grid];
    if (!(ground.layout->grids[grid].area.values[cell] > 0.0f)) continue;
    probes.push_back({grid, cell, static_cast<double>(field.grids[grid].exposure[cell])});
  }
  return probes;
}

struct Prepared {
  SceneSnapshot snapshot;
  SnowGroundPointer ground;
  SnowScene scene;
  ExposureSettings settings;
};

double referenceOf(const Prepared& prepared, const Raster<std::uint8_t>& superseded, const Probe& probe,
                   std::uint64_t number, int rays) {
  const SnowGround& ground = *prepared.ground;
  const FallCone& cone = prepared.settings.cone;
  const TerrainSurface surface(prepared.snapshot.terrain->heights);
  for (const TerrainGrid& terrain : ground.terrain) {
    if (terrain.grid != probe.grid) continue;
    TerrainCellSampler sampler(surface, terrain, ground.layout->grids[probe.grid], superseded);
    sampler.enter(probe.cell);
    return reference(prepared.scene, cone, sampler, number, rays);
  }
  for (std::size_t m = 0; m < ground.models.size(); ++m)
    for (const ModelPatch& patch : ground.models[m].patches) {
      if (patch.grid != probe.grid) continue;
      PatchCellSampler sampler(ground.models[m], patch, prepared.scene.models[m].placement.translation);
      sampler.enter(probe.cell);
      return reference(prepared.scene, cone, sampler, number, rays);
    }
  return 0.0;
}

Prepared prepare(const BenchOptions& options, double wind) {
  SnowBenchScene build;
  build.weather.windSpeed = wind;
  Prepared prepared;
  prepared.snapshot = snowBenchSnapshot(build);
  prepared.ground = makeSnowGround(prepared.snapshot);
  prepared.scene = *makeSnowScene(prepared.snapshot, *prepared.ground, 0.0, options.makeRayScene);
  prepared.settings = exposureSettings(prepared.snapshot, 0.0);
  return prepared;
}

void addErrors(const std::vector<double>& references, const std::vector<Probe>& probes, bool barred,
               BenchRow& row) {
  std::vector<double> errors;
  double squares = 0.0;
  std::size_t shaded = 0;
  for (std::size_t k = 0; k < probes.size(); ++k) {
    errors.push_back(std::abs(probes[k].cover - references[k]));
    squares += errors.back() * errors.back();
    shaded += references[k] > 0.02 && references[k] < 0.98 ? 1u : 0u;
  }
  std::sort(errors.begin(), errors.end());
  const double rmse = std::sqrt(squares / static_cast<double>(errors.size()));
  const double worst99 = errors[errors.size() * 99 / 100];
  if (barred) {
    row.addError("rmse", rmse, "1", 0.02);
    row.addError("error_99th_percentile", worst99, "1", 0.08);
  } else {
    row.addFigure("rmse", rmse, "1");
    row.addFigure("error_99th_percentile", worst99, "1");
  }
  row.addFigure("points", static_cast<double>(errors.size()), "1");
  row.addFigure("partly_shaded_share", static_cast<double>(shaded) / static_cast<double>(errors.size()), "1");
}

Result<std::vector<BenchRow>> measure(const BenchOptions& options, double wind) {
  const std::size_t points = options.quick ? 1000 : 2000;
  const int referenceRays = options.quick ? 4096 : 65536;
  Prepared prepared = prepare(options, wind);
  CpuBackend backend(options.threads);
  const CancelToken cancel;
  std::vector<double> references;
  std::vector<BenchRow> rows;
  const Raster<std::uint8_t> superseded =
      supersededQuads(prepared.snapshot.terrain->heights, *prepared.ground);
  for (const int rays : {64, 16, 256}) {
    if (options.quick && rays != 64) continue;
    BenchRow row;
    row.caseId = "exposure-raytraced";
    row.settings = {{"rays", std::to_string(rays)},
                    {"wind_m_s", fmt::format("{:g}", wind)},
                    {"reference_rays", std::to_string(referenceRays)},
                    {"caster", prepared.scene.rays->name()}};
    const BenchMeter meter;
    prepared.settings.rays = rays;
    auto field = makeExposureField(prepared.snapshot, *prepared.ground, prepared.scene, prepared.settings,
                                   {backend, cancel, {}});
    if (!field) return field.error();
    meter.finish(row);
    const std::vector<Probe> probes = drawProbes(*prepared.ground, *field, points);
    if (references.empty()) {
      references.resize(probes.size());
      backend.forEach(
          "reference", probes.size(),
          [&](std::size_t k) {
            references[k] = referenceOf(prepared, superseded, probes[k], k, referenceRays);
          },
          4);
    }
    // The default setting has the bar; the others show how the error falls with the rays.
    addErrors(references, probes, rays >= 64, row);
    row.addFigure("estimated_rmse", field->samplingRmse, "1");
    double cells = 0.0;
    for (const auto& grid : field->grids) cells += static_cast<double>(grid.exposure.size());
    row.addTime("rays_per_second", cells * rays / backend.timings().seconds("exposure"), "1/s");
    backend.timings().clear();
    rows.push_back(std::move(row));
  }
  return rows;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const double wind : {2.0, 0.0}) {
    if (options.quick && wind == 0.0) continue;
    auto measured = measure(options, wind);
    if (!measured) return measured.error();
    for (BenchRow& row : measured.value()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

BenchCase exposureRaytracedCase() {
  return {"exposure-raytraced", "exposure of the cover's cells in a valley with houses",
          "plain random rays over the same cells, 65,536 a cell (4,096 with --quick)", run};
}

}  // namespace spin
