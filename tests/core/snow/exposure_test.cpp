// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/core/snow/snow_test_scene.h"
#include "tests/support/time_limit.h"

namespace spin {
namespace {

using test::TestScene;

ExposureField fieldOf(const SceneSnapshot& scene, const ExposureSettings& settings) {
  const SnowGroundPointer ground = makeSnowGround(scene);
  const SnowScene standing = *makeSnowScene(scene, *ground, 0.0, makeBvhRayScene);
  CpuBackend backend(2);
  const CancelToken cancel;
  auto field = makeExposureField(scene, *ground, standing, settings, {backend, cancel, {}});
  EXPECT_TRUE(field.ok());
  return std::move(field.value());
}

TEST(FallCone, PointsAlongFallAndDrift) {
  const FallCone cone = fallCone({3, 4, 0}, 1.0, 0.1);
  EXPECT_NEAR(cone.frame.n.x / -cone.frame.n.z, 3.0, 1e-3);
  EXPECT_NEAR(cone.frame.n.y / -cone.frame.n.z, 4.0, 1e-3);
  EXPECT_NEAR(cone.halfAngle, 0.1, 1e-12);
  EXPECT_EQ(fallCone({}, 1.0, 0.0).frame.n, (Vec3d{0, 0, -1}));
}

TEST(FallCone, AllDirectionsComeDownInAnyWind) {
  for (const double wind : {0.0, 5.0, 20.0, 80.0}) {
    const FallCone cone = fallCone({wind, 0, 0}, 1.0, degreesToRadians(60));
    for (int k = 0; k < 400; ++k) {
      const Vec3d w = cone.direction((k % 20 + 0.5) / 20, (k / 20 + 0.5) / 20);
      EXPECT_LT(w.z, 0.0);
      EXPECT_NEAR(length(w), 1.0, 1e-12);
    }
  }
}

TEST(FallCone, SmallChangesOfWindGiveTheSameCone) {
  EXPECT_EQ(fallCone({2.0, 0, 0}, 1.0, 0.1).frame.n, fallCone({2.0004, 0, 0}, 1.0, 0.1).frame.n);
  EXPECT_NE(fallCone({2.0, 0, 0}, 1.0, 0.1).frame.n, fallCone({2.01, 0, 0}, 1.0, 0.1).frame.n);
}

/// Terrain cells beside a high wall, snow slanting over it: the shadow is as long as height x drift.
TEST(Exposure, ShadowOfAWallIsHeightTimesDrift) {
  TestScene test;
  ModelNode placed;
  placed.position = {30, 20, 0};
  const double drift = 1.5, height = 6.0;
  const SceneSnapshot scene =
      test.land(41, 41, 1.0, [](double, double) { return 0.0; })
          .model("wall", test::modelOf(test::boxMesh({-0.5f, -19, 0}, {0, 19, float(height)})), placed)
          .build();
  ExposureSettings settings;
  settings.cone = fallCone({-drift, 0, 0}, 1.0, 0.0);
  const ExposureField field = fieldOf(scene, settings);
  const SnowGroundPointer ground = makeSnowGround(scene);
  const CoverGrid* fine = nullptr;
  std::size_t grid = 0;
  for (std::size_t g = 0; g < ground->layout->grids.size(); ++g)
    if (ground->layout->grids[g].id == "terrain/fine0") fine = &ground->layout->grids[grid = g];
  ASSERT_NE(fine, nullptr);
  const double edge = 29.5 - height * drift;
  int sheltered = 0;
  for (int i = 0; i < fine->base.width; ++i) {
    const double x = fine->base.x(i);
    if (x > 29.4 || std::abs(x - edge) < fine->base.cellSize)
      continue;  // under the wall; the texel at the edge
    const float e = field.grids[grid].exposure[fine->base.index(i, fine->base.row(20.0))];
    EXPECT_EQ(e, x < edge ? 1.0f : 0.0f) << x;
    sheltered += e == 0.0f ? 1 : 0;
  }
  EXPECT_GT(sheltered, 20);
}

/// Ground under an opening in a roof: share of the cone that passes the opening.
TEST(Exposure, ConeThroughASquareOpeningInARoof) {
  // A roof with a square opening 2 x 2 m at 3 m, cone of 30 degrees half angle: reference by midpoint sums.
  Mesh roof;
  const auto add = [&](float x0, float y0, float x1, float y1) {
    const Mesh part = test::sheetMesh({x0, y0, 3}, {x1, y0, 3}, {x0, y1, 3});
    const auto first = static_cast<std::uint32_t>(roof.positions.size());
    roof.positions.insert(roof.positions.end(), part.positions.begin(), part.positions.end());
    for (const std::uint32_t i : part.indices) roof.indices.push_back(first + i);
  };
  add(-9, -9, 9, -1), add(-9, 1, 9, 9), add(-9, -1, -1, 1), add(1, -1, 9, 1);
  TestScene test;
  ModelNode placed;
  placed.position = {20, 20, 0};
  placed.catchesSnow = false;
  test.terrain.coverDetailMargin = 0.0;
  const SceneSnapshot scene = test.land(41, 41, 1.0, [](double, double) { return 0.0; })
                                  .model("roof", test::modelOf(roof), placed)
                                  .build();
  ExposureSettings settings;
  settings.cone = fallCone({}, 1.0, degreesToRadians(30));
  settings.rays = 512;
  const ExposureField field = fieldOf(scene, settings);
  const SnowGroundPointer ground = makeSnowGround(scene);
  const std::size_t g = ground->terrain[1].grid;
  const Raster<float>& base = ground->layout->grids[g].base;
  for (const double x : {20.125, 20.875, 21.625, 22.375}) {
    double open = 0.0;
    const int n = 400;
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b) {
        const Vec3d w = settings.cone.direction((a + 0.5) / n, (b + 0.5) / n);
        const double hx = x - 20 - 3 * w.x / w.z, hy = 0.125 - 3 * w.y / w.z;
        open += (std::abs(hx) < 1 && std::abs(hy) < 1) ? 1.0 / (n * n) : 0.0;
      }
    const float e = field.grids[g].exposure[base.index(base.column(x), base.row(20.125))];
    EXPECT_NEAR(e, open, 0.015) << x;
  }
}

TEST(Exposure, SelfShelteringSlopeTurnsItsBack) {
  // A slope of 45 degrees under snow that slants by 60 degrees from behind it sees none of it.
  TestScene test;
  const SceneSnapshot scene = test.land(20, 20, 1.0, [](double x, double) { return -x; }).build();
  ExposureSettings settings;
  settings.cone = fallCone({std::tan(degreesToRadians(60)), 0, 0}, 1.0, 0.0);
  const ExposureField field = fieldOf(scene, settings);
  for (const float e : field.grids[0].exposure) EXPECT_EQ(e, 0.0f);
  EXPECT_EQ(field.rates.deposited, 0.0);
  EXPECT_EQ(field.rates.lost, 0.0);
  // Facing the snow it catches more per horizontal area than level ground: 1 + tan 45 tan 60.
  settings.cone = fallCone({-std::tan(degreesToRadians(60)), 0, 0}, 1.0, 0.0);
  settings.hold = {degreesToRadians(80), degreesToRadians(85)};
  const ExposureField facing = fieldOf(scene, settings);
  for (const float held : facing.grids[0].held) EXPECT_NEAR(held, 1.0 + std::tan(degreesToRadians(60)), 2e-3);
}

TEST(Exposure, ForwardAndGatheredFlowsAgreeSinkBySink) {
  TestScene test;
  ModelNode placed;
  placed.position = {30, 28, 0};
  const SceneSnapshot scene =
      test.land(40, 40, 1.5,
                [](double x, double y) {
                  if (x > 40 && y > 40 && x < 50 && y < 52) return double(test::kHole);
                  return 4.0 * std::sin(0.2 * x) + 3.0 * std::cos(0.17 * y);
                })
          .model("box", test::modelOf(test::boxMesh({-6, -8, -5}, {6, 8, 12})), placed)
          .build();
  ExposureSettings settings;
  settings.cone = fallCone({-1.1, 0.6, 0}, 1.0, degreesToRadians(15));
  const ExposureField field = fieldOf(scene, settings);
  const SnowRates& r = field.rates;
  EXPECT_EQ(r.lost, 0.0);
  EXPECT_NEAR(r.forward.total() / r.emitted, 1.0, 1e-9);
  EXPECT_NEAR(r.forward.ground / r.gathered.ground, 1.0, 3e-3);
  EXPECT_NEAR(r.forward.models / r.gathered.models, 1.0, 1e-2);
  EXPECT_NEAR(r.forward.left / r.gathered.left, 1.0, 3e-3);
  EXPECT_GT(r.gathered.models, 0.05 * r.emitted);
  EXPECT_GT(r.gathered.left, 0.05 * r.emitted);
}

/// A shared terrain and model for the checks of sameness.
SceneSnapshot richScene() {
  TestScene test;
  test.weather.windSpeed = 2.0;
  test.snowfall.fallSpreadDegrees = 15.0;
  test.snowfall.flakeCount = 3000;
  test.simulation.exposureNoise = 0.1;
  test.terrain.coverDetailMargin = 1.0;
  ModelNode placed;
  placed.position = {12, 12, 0};
  SceneSnapshot scene =
      test.land(20, 20, 1.5, [](double x, double y) { return 0.5 * std::sin(x) * std::cos(y); })
          .model("box", test::modelOf(test::boxMesh({-2, -2, 0}, {2, 2, 3})), placed)
          .build();
  for (SceneNode& n : scene.nodes)
    if (n.id == "weather") {
      n.curves["wind_speed_m_s"].setKey({0.0, 2.0, Interpolation::Step});
      n.curves["wind_speed_m_s"].setKey({2.0 / 24, 3.0, Interpolation::Step});
    }
  return scene;
}

std::vector<char> bytesOf(const Frame& frame) {
  ByteWriter out;
  for (const auto& [name, part] : frame.parts) part->save(out);
  for (const BudgetTerm& term : frame.info.budget.terms) out.put(term.kilograms);
  return out.take();
}

TEST(SnowProcesses, ThreadsDoNotChangeABit) {
  const SceneSnapshot scene = richScene();
  std::vector<char> first;
  for (const int threads : {1, 2, 4}) {
    SnowRun run(scene, makeBvhRayScene, threads);
    ASSERT_TRUE(run.run(3).ok());
    const std::vector<char> bytes = bytesOf(run.frame());
    if (first.empty()) first = bytes;
    EXPECT_TRUE(bytes == first) << threads << " threads";
  }
}

TEST(SnowProcesses, ResumedRunEqualsAnUninterruptedOne) {
  const SceneSnapshot scene = richScene();
  SnowRun whole(scene, makeBvhRayScene, 2), before(scene, makeBvhRayScene, 2),
      after(scene, makeBvhRayScene, 2);
  ASSERT_TRUE(whole.run(5).ok());
  ASSERT_TRUE(before.run(2).ok());
  ASSERT_TRUE(after.load(2, before.save()).ok());
  for (int f = 0; f < 3; ++f) ASSERT_TRUE(after.step().ok());
  EXPECT_TRUE(bytesOf(whole.frame()) == bytesOf(after.frame()));
  EXPECT_TRUE(whole.save() == after.save());
}

TEST(SnowProcesses, DamagedCheckpointIsAnError) {
  const SceneSnapshot scene = richScene();
  SnowRun run(scene, makeBvhRayScene, 2);
  ASSERT_TRUE(run.run(1).ok());
  std::vector<char> state = run.save();
  ASSERT_GT(state.size(), 9u);
  state.erase(state.end() - 9, state.end());
  SnowRun other(scene, makeBvhRayScene, 2);
  EXPECT_EQ(other.load(1, state).error().kind, ErrorKind::BadInput);
  EXPECT_FALSE(other.load(1, {}).ok());
}

TEST(SnowProcesses, CancelEndsALongExposureSoon) {
  TestScene test;
  test.simulation.exposureRays = 4096;
  test.snowfall.fallSpreadDegrees = 15.0;
  const SceneSnapshot scene =
      test.land(100, 100, 5.0, [](double x, double y) { return 30 * std::sin(0.01 * x * y); }).build();
  SnowRun run(scene, makeBvhRayScene, 2);
  using Clock = std::chrono::steady_clock;
  std::atomic<Clock::time_point::rep> asked{0};
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
    asked = Clock::now().time_since_epoch().count();
    run.cancel().cancel();
  });
  const Status status = run.begin();
  const auto ended = Clock::now().time_since_epoch().count();
  stopper.join();
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::Cancelled);
  EXPECT_LT(static_cast<double>(ended - asked) * 1e-9, 0.5 * test::patience());
}

TEST(SnowProcesses, UnchangedWeatherCastsNoRaysAgain) {
  TestScene test;
  const SceneSnapshot scene = test.land(8, 8, 2.0, [](double, double) { return 0.0; }).build();
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.begin().ok());
  const ExposureFieldPointer first = test::fieldIn(run.exchange());
  ASSERT_TRUE(run.step().ok());
  EXPECT_EQ(first, test::fieldIn(run.exchange()));
}

TEST(SnowProcesses, HashFollowsWhatAStepUses) {
  const SceneSnapshot scene = richScene();
  const auto hashAt = [](const SceneSnapshot& s, int frame) {
    Hasher hasher;
    const Pipeline pipeline = Pipeline::compile(s);
    for (const auto& process : pipeline.processes())
      process->hashInputs({s, s.timeOf(frame), s.timeOf(frame + 1)}, hasher);
    return hasher.digest();
  };
  SceneSnapshot edited = scene;
  for (SceneNode& n : edited.nodes)
    if (n.id == "weather") n.curves["wind_speed_m_s"].setKey({3.0 / 24, 5.0, Interpolation::Step});
  EXPECT_EQ(hashAt(scene, 0), hashAt(edited, 0)) << "an edit of a later key keeps the frames before it";
  EXPECT_NE(hashAt(scene, 3), hashAt(edited, 3));
}

}  // namespace
}  // namespace spin
