// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/reference_surface.h"
#include "core/bench/snow_bench_scene.h"
#include "core/bench/snow_run.h"
#include "core/bench/worst.h"
#include "core/snow/exposure_process.h"

namespace spin {
namespace {

/// Flow of snow onto a model per precipitation rate, m2, by packets aimed at its bounding sphere: a disc
/// across each direction, and whatever a packet meets first. Shares no sampler with the gathered flow that it
/// checks.
double aimedFlow(const SnowScene& scene, const FallCone& cone, const StandingModel& model) {
  constexpr std::uint64_t kPackets = 1u << 18;
  Box3d box;
  for (const PlacedTriangle& triangle : model.triangles)
    for (const Vec3f& p : triangle.corners) box.extend(p.to<double>() + model.placement.translation);
  const double radius = 0.5 * length(box.size()), far = 2.0 * length(scene.domain.size());
  const CounterRandom random{0xa1b2c3ull, 9};
  double sum = 0.0;
  for (std::uint64_t k = 0; k < kPackets; ++k) {
    const Vec3d w = referenceDirection(cone, random, k);
    const Vec3d across = normalized(cross(w, std::abs(w.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    const UInt4 words = random.words(k, 0);
    const double r = radius * std::sqrt(toUnitDouble(words.x, words.y)),
                 turn = 2.0 * kPi * toUnitDouble(words.z, words.w);
    const Vec3d from =
        box.centre() + (across * std::cos(turn) + cross(w, across) * std::sin(turn)) * r - w * far;
    const auto hit = scene.rays->closest({(from - scene.centre).to<float>(), w.to<float>()});
    if (hit && hit->geometry == model.geometry) sum += 1.0 / std::abs(w.z);
  }
  return kPi * radius * radius * sum / static_cast<double>(kPackets);
}

/// How far the flow gathered on the model is from the aimed one, as a share of it, or of a tenth of what
/// falls on it in the open where it lies sheltered.
Result<double> modelFlowError(const SceneSnapshot& scene, const BenchOptions& options) {
  CpuBackend backend(options.threads);
  const CancelToken cancel;
  const SnowGroundPointer ground = makeSnowGround(scene);
  const std::optional<SnowScene> standing = makeSnowScene(scene, *ground, 0.0, options.makeRayScene);
  SPIN_CHECK(standing && standing->models.size() == 1, "the scene has one model and nobody cancels");
  const ExposureSettings settings = exposureSettings(scene, 0.0);
  const auto field = makeExposureField(scene, *ground, *standing, settings, {backend, cancel, {}});
  if (!field) return field.error();
  const double aimed = aimedFlow(*standing, settings.cone, standing->models[0]);
  double plan = 0.0;
  for (const PlacedTriangle& triangle : standing->models[0].triangles)
    plan += 0.25 * std::abs(triangle.normal().z);  // half of them face down
  return std::abs(field->rates.gathered.models - aimed) / std::max(aimed, 0.1 * plan);
}

Result<BenchRow> measure(const BenchOptions& options, double wind, int rays, int frames) {
  BenchRow row;
  row.caseId = "mass";
  row.settings = {{"wind_m_s", fmt::format("{:g}", wind)}, {"rays", std::to_string(rays)}};
  const BenchMeter meter;
  SnowBenchScene build;
  build.cells = 96;
  build.houses = 1;
  build.weather.windSpeed = wind;
  build.simulation.exposureRays = rays;
  build.simulation.timeScale = 2880.0;
  build.snowfall.flakeCount = 1000;
  const SceneSnapshot scene = snowBenchSnapshot(build);
  SnowRun run(scene, options.makeRayScene, options.threads);
  double imbalance = 0.0, residual = 0.0;
  Status status = run.begin();
  for (int f = 0; f < frames && status; ++f) {
    status = run.step();
    if (!status) break;
    const MassBudget budget = run.frame().info.budget;
    imbalance = worse(imbalance, std::abs(budget.relativeImbalance()));
    residual = worse(residual, std::abs(budget.get("sampling_residual")) / budget.get("emitted"));
  }
  if (!status) return status.error();
  const Frame last = run.frame();
  row.addError("imbalance", imbalance, "1", 1e-6);
  row.addError("sampling_residual_share", residual, "1", 0.005);
  const Result<double> onModel = modelFlowError(scene, options);
  if (!onModel) return onModel.error();
  row.addError("model_flow_error", *onModel, "1", 0.02);
  for (const BudgetTerm& term : last.info.budget.terms) row.addFigure(term.name, term.kilograms, "kg");
  for (const auto& [name, value] : last.info.figures)
    if (name.rfind("residual_", 0) == 0 || name == "lost_share") row.addFigure(name, value, "1");
  meter.finish(row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  const std::vector<int> rayCounts = options.quick ? std::vector<int>{64} : std::vector<int>{16, 64, 256};
  for (const int rays : rayCounts)
    for (const double wind : {0.0, 2.0, 10.0}) {
      auto row = measure(options, wind, rays, 6);
      if (!row) return row.error();
      rows.push_back(std::move(row.value()));
    }
  return rows;
}

}  // namespace

BenchCase massCase() {
  return {"mass", "closure of the mass budget over a valley with houses, a lake without data and wind",
          "emitted = deposited + shed + aloft + left + sampling residual", run};
}

}  // namespace spin
