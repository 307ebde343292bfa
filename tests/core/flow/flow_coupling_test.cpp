// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/flow/flow_coupling.h"
#include "core/sph/flow_setup.h"
#include "tests/core/flow/flow_test_scene.h"

namespace spin {
namespace {

using test::FlowTestScene;

/// Steps the flow of a scene with something coupled.
struct CoupledFlow {
  SceneSnapshot scene;
  Pipeline pipeline;
  CpuBackend backend{1};
  RaySceneFactory rays = makeBvhRayScene;
  CancelToken cancel;
  ProcessContext context{backend, rays, cancel, pipeline.exchange(), {}};
  FlowCoupling& coupling;

  explicit CoupledFlow(SceneSnapshot made)
      : scene(std::move(made)),
        pipeline(Pipeline::compile(scene, {flowProcessType()})),
        coupling(pipeline.exchange().emplace<FlowCoupling>()) {
    SPIN_CHECK(flow().begin(scene, context).ok(), "the flow does not begin");
  }
  Process& flow() { return *pipeline.processes()[0]; }
  Status step(int frame) {
    return flow().step({scene, scene.timeOf(frame), scene.timeOf(frame + 1)}, context);
  }
  MassBudget budget(int frame) {
    Frame published;
    published.info.time = scene.timeOf(frame);
    flow().publish(scene, published.info.time, published);
    return published.info.budget;
  }
};

SceneSnapshot slab() {
  FlowTestScene scene;
  test::slopeScene(scene);
  scene.settings.spacing = 0.2;
  return scene.add(kAvalancheReleaseType, "slab", test::squareRelease(2.0, 4.0, 0.6)).build();
}

TEST(FlowCoupling, IsCalledAfterEveryPartOfAFrameWithSampledParticles) {
  CoupledFlow run(slab());
  run.coupling.longest = 0.03;
  std::vector<double> ends{0.0};
  run.coupling.after = [&](const FlowPart& part) -> Status {
    EXPECT_EQ(part.from, ends.back());
    ends.push_back(part.to);
    for (const FlowSample& s : part.solver.samples()) EXPECT_GE(s.neighbours, 0);
    return {};
  };
  ASSERT_TRUE(run.step(0));
  ASSERT_EQ(ends.size(), 5u) << "a tenth of a second in four parts";
  EXPECT_NEAR(ends[1], 0.025, 1e-12);
  EXPECT_EQ(ends.back(), run.scene.timeOf(1).film);
  run.coupling.after = [](const FlowPart&) { return badInput("It broke", "test", "on purpose"); };
  const Status failed = run.step(1);
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().what, "It broke");
}

TEST(FlowCoupling, WhatIsGivenIsMissingInTheBudgetAndWhatComesBackIsThere) {
  CoupledFlow run(slab());
  double given = 0.0, mass = 0.0;
  run.coupling.longest = 1.0;
  run.coupling.after = [&](const FlowPart& part) {
    mass = part.config.particleMass(0);
    std::vector<FlowExchange> changes;
    for (const FlowSample& s : part.solver.samples()) {
      changes.push_back({s.particle.id, s.particle.velocity, 0.25, s.particle.id % 10 == 0});
      given += mass * (changes.back().taken ? 1.0 : 0.25);
    }
    return part.solver.exchange(changes);
  };
  ASSERT_TRUE(run.step(0));
  const double released = run.budget(1).get("flow_released");
  EXPECT_NEAR(run.budget(1).get("flow_present") + given, released, 1e-9 * released);

  FlowParticle free, inGround;
  free.position = {12, 6, 1.0}, free.given = 0.5;
  inGround.position = {12, 8, -0.3}, inGround.given = 0.25;
  run.coupling.rejoining = {inGround, free};
  run.coupling.after = [](const FlowPart&) { return Status(); };
  const double before = run.budget(1).get("flow_present");
  ASSERT_TRUE(run.step(1));
  EXPECT_TRUE(run.coupling.rejoining.empty());
  ASSERT_EQ(run.coupling.refused.size(), 1u);
  EXPECT_EQ(run.coupling.refused[0].given, 0.25);
  EXPECT_NEAR(run.budget(2).get("flow_present") - before, 0.5 * mass, 1e-6 * mass);
}

}  // namespace
}  // namespace spin
