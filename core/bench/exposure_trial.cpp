// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/exposure_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/bench/bench_meter.h"
#include "core/bench/reference_surface.h"
#include "core/nodes/terrain_node.h"
#include "core/snow/exposure_process.h"

namespace spin {
namespace {

/// Coarse cells within this distance of a model in plan are near it, m.
constexpr double kNear = 50.0;
constexpr std::array<const char*, 4> kKinds{"coarse_near", "coarse_far", "fine", "model"};

/// A cover cell.
struct Probe {
  std::size_t grid = 0, cell = 0;
  std::size_t kind = 0;  ///< index into kKinds
};

struct Prepared {
  const SceneSnapshot& snapshot;
  SnowGroundPointer ground;
  SnowScene scene;
  ExposureSettings settings;
};

/// Share of plain random rays that see the sky.
double referenceOf(const Prepared& prepared, const Probe& probe, std::uint64_t number, int rays) {
  constexpr std::size_t kBatch = 256;
  constexpr double kStandOff = 2e-3;  // m
  const SnowScene& scene = prepared.scene;
  const ReferenceSurface surface(prepared.snapshot, *prepared.ground, scene, probe.grid, probe.cell);
  const CounterRandom random{0x5eed0fa11ull + number, 77};
  std::vector<ReferencePoint> points;
  std::vector<Ray> batch;
  std::vector<std::uint8_t> blocked(kBatch);
  std::int64_t cast = 0, open = 0;
  const auto flush = [&] {
    scene.rays->occludedMany(batch.data(), batch.size(), blocked.data());
    open += std::count(blocked.begin(), blocked.begin() + static_cast<std::ptrdiff_t>(batch.size()), 0);
    batch.clear();
  };
  // A cell may have surface over a small part of its square only.
  for (std::uint64_t index = 0; cast < rays && index < 1000u * static_cast<std::uint64_t>(rays); ++index) {
    points.clear();
    surface.pointsAt(random, index, points);
    const Vec3d fall = referenceDirection(prepared.settings.cone, random, index);
    for (const ReferencePoint& p : points) {
      ++cast;
      if (dot(p.normal, fall) >= 0.0) continue;
      batch.push_back({(p.position + p.normal * kStandOff - scene.centre).to<float>(), (-fall).to<float>(),
                       0.0f, std::numeric_limits<float>::infinity()});
      if (batch.size() == kBatch) flush();
    }
  }
  flush();
  return cast > 0 ? static_cast<double>(open) / static_cast<double>(cast) : std::nan("");
}

Prepared prepare(const SceneSnapshot& snapshot, const BenchOptions& options) {
  Prepared p{snapshot, makeSnowGround(snapshot), {}, exposureSettings(snapshot, 0.0)};
  std::optional<SnowScene> scene = makeSnowScene(snapshot, *p.ground, 0.0, options.makeRayScene);
  SPIN_CHECK(scene.has_value(), "nobody cancels it");
  p.scene = std::move(*scene);
  return p;
}

bool nearModel(const SceneSnapshot& scene, double x, double y) {
  const auto models = scene.all<ModelNode>();
  return std::any_of(models.begin(), models.end(), [&](const SceneNode* node) {
    const Vec3d place = scene.modelTransform(*node, 0.0).translation;
    return std::hypot(place.x - x, place.y - y) < kNear;
  });
}

/// All cells that account for a surface, by kind.
std::array<std::vector<Probe>, 4> cellsOf(const Prepared& prepared) {
  std::array<std::vector<Probe>, 4> cells;
  const auto& grids = prepared.ground->layout->grids;
  std::vector<int> refinement(grids.size(), -1);
  for (const TerrainGrid& terrain : prepared.ground->terrain) refinement[terrain.grid] = terrain.refinement;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const Raster<float>& area = grids[g].area;
    for (std::size_t c = 0; c < area.values.size(); ++c) {
      if (!(area.values[c] > 0.0f)) continue;
      std::size_t kind = refinement[g] < 0 ? 3 : refinement[g] > 0 ? 2 : 1;
      const int i = static_cast<int>(c) % area.width, j = static_cast<int>(c) / area.width;
      if (kind == 1 && nearModel(prepared.snapshot, area.x(i), area.y(j))) kind = 0;
      cells[kind].push_back({g, c, kind});
    }
  }
  return cells;
}

/// Points drawn with replacement.
std::vector<Probe> drawProbes(const Prepared& prepared, const ExposureTrial& trial) {
  std::vector<std::vector<Probe>> pools;
  for (std::vector<Probe>& cells : cellsOf(prepared)) {
    if (cells.empty()) continue;
    if (trial.byKind || pools.empty())
      pools.push_back(std::move(cells));
    else
      pools[0].insert(pools[0].end(), cells.begin(), cells.end());
  }
  const CounterRandom random{0xb0b5ull, 5};
  std::vector<Probe> probes;
  for (std::uint64_t k = 0; !pools.empty() && probes.size() < trial.points; ++k) {
    const std::vector<Probe>& pool = pools[k % pools.size()];
    probes.push_back(
        pool[static_cast<std::size_t>(random.uniformDouble(k) * static_cast<double>(pool.size()))]);
  }
  return probes;
}

double rootMeanSquare(const std::vector<double>& errors) {
  double squares = 0.0;
  for (const double error : errors) squares += error * error;
  return std::sqrt(squares / static_cast<double>(errors.size()));
}

void addErrors(const std::vector<double>& references, const std::vector<Probe>& probes,
               const ExposureField& field, bool barred, bool byKind, BenchRow& row) {
  std::vector<double> errors;
  std::array<std::vector<double>, 4> ofKind;
  std::array<double, 4> surplus{};
  std::size_t shaded = 0;
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const auto cover = static_cast<double>(field.grids[probes[k].grid].exposure[probes[k].cell]);
    errors.push_back(std::abs(cover - references[k]));
    ofKind[probes[k].kind].push_back(errors.back());
    surplus[probes[k].kind] += cover - references[k];
    shaded += references[k] > 0.02 && references[k] < 0.98 ? 1u : 0u;
  }
  std::sort(errors.begin(), errors.end());
  const double rmse = rootMeanSquare(errors), worst99 = errors[errors.size() * 99 / 100];
  if (barred) {
    row.addError("rmse", rmse, "1", 0.02);
    row.addError("error_99th_percentile", worst99, "1", 0.08);
  } else {
    row.addFigure("rmse", rmse, "1");
    row.addFigure("error_99th_percentile", worst99, "1");
  }
  row.addFigure("points", static_cast<double>(errors.size()), "1");
  row.addFigure("partly_shaded_share", static_cast<double>(shaded) / static_cast<double>(errors.size()), "1");
  for (std::size_t kind = 0; byKind && kind < kKinds.size(); ++kind) {
    if (ofKind[kind].empty()) continue;
    row.addFigure(fmt::format("points_{}", kKinds[kind]), static_cast<double>(ofKind[kind].size()), "1");
    row.addFigure(fmt::format("rmse_{}", kKinds[kind]), rootMeanSquare(ofKind[kind]), "1");
    row.addFigure(fmt::format("bias_{}", kKinds[kind]),
                  surplus[kind] / static_cast<double>(ofKind[kind].size()), "1");
  }
}

}  // namespace

ExposureTrial exposureTrial(SnapshotPointer snapshot, const BenchOptions& options) {
  ExposureTrial trial;
  trial.snapshot = std::move(snapshot);
  trial.points = options.quick ? 1000 : 2000;
  trial.referenceRays = options.quick ? 4096 : 65536;
  if (!options.quick) trial.rays = {64, 16, 256};
  if (!options.quick) trial.maps = {{16, 1024}, {4, 1024}, {64, 1024}, {16, 512}, {16, 2048}};
  return trial;
}

Result<std::vector<BenchRow>> compareExposure(const ExposureTrial& trial, const BenchOptions& options) {
  Prepared prepared = prepare(*trial.snapshot, options);
  const std::vector<Probe> probes = drawProbes(prepared, trial);
  if (probes.empty())
    return badInput("The exposure cannot be compared", "scene", "it has no surface that snow can lie on");
  CpuBackend backend(options.threads);
  const CancelToken cancel;
  std::vector<double> references(probes.size());
  backend.forEach(
      "reference", probes.size(),
      [&](std::size_t k) { references[k] = referenceOf(prepared, probes[k], k, trial.referenceRays); }, 4);
  std::vector<BenchRow> rows;
  const auto add = [&](const ExposureSettings& settings, bool barred) -> Status {
    BenchRow row;
    row.caseId = "exposure-raytraced";
    row.settings = trial.settings;
    row.settings["rays"] = std::to_string(settings.rays);
    row.settings["reference_rays"] = std::to_string(trial.referenceRays);
    row.settings["caster"] = prepared.scene.rays->name();
    if (settings.mapDirections > 0) {
      row.settings["caster"] = "maps";
      row.settings["directions"] = std::to_string(settings.mapDirections);
      row.settings["map_size"] = std::to_string(settings.mapSize);
    }
    const BenchMeter meter;
    backend.timings().clear();
    const auto field = makeExposureField(prepared.snapshot, *prepared.ground, prepared.scene, settings,
                                         {backend, cancel, {}});
    if (!field) return field.error();
    meter.finish(row);
    addErrors(references, probes, *field, barred, trial.byKind, row);
    if (field->samplingRmse) row.addFigure("estimated_rmse", *field->samplingRmse, "1");
    double cells = 0.0;
    for (const auto& grid : field->grids) cells += static_cast<double>(grid.exposure.size());
    const double seconds = backend.timings().seconds("exposure");
    row.addTime(settings.mapDirections > 0 ? "lookups_per_second" : "rays_per_second",
                cells * settings.rays / seconds, "1/s");
    if (settings.mapDirections > 0)
      row.addTime("drawing_maps", backend.timings().seconds("occlusion map"), "s");
    rows.push_back(std::move(row));
    return {};
  };
  // The default setting has the bar; fewer rays show how the error grows, and maps what they cost and save.
  for (const int rays : trial.rays) {
    prepared.settings.rays = rays;
    if (const Status status = add(prepared.settings, rays >= 64); !status) return status.error();
  }
  prepared.settings.rays = 64;
  for (const auto& [directions, size] : trial.maps) {
    prepared.settings.mapDirections = directions;
    prepared.settings.mapSize = size;
    if (const Status status = add(prepared.settings, false); !status) return status.error();
  }
  return rows;
}

}  // namespace spin
