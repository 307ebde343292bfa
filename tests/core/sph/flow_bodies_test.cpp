// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/flow_bodies_contract.h"

#include "core/sph/body_boundary.h"

namespace spin {
namespace {

/// Bodies act in stages that all instruction sets share; one is enough.
struct BestIsaBodies {
  static Result<std::unique_ptr<FlowSolver>> make(const FlowConfig& config) {
    return makeFlowSolverCpu(config, 2, bestIsa());
  }
  static bool available(std::string&) { return true; }
};

}  // namespace

namespace contract {
INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, FlowBodiesContract, BestIsaBodies);
}

namespace {

TEST(FlowBodiesTest, ThreadCountDoesNotChangeABit) {
  FlowConfig c = testing::boxConfig(24, 24, 40);
  c.materials[0].rheology.viscosity = 2.0f;
  const double d = c.spacing;
  for (int k = 0; k < 3; ++k) {
    RigidBodyConfig b;
    b.shape = *makeRigidShape(k == 1 ? testing::sphereMesh(3 * d, 2) : testing::cubeMesh(5 * d));
    b.density = 300.0 + 400.0 * k;
    b.start.position = {(6 + 6 * k) * d, (8 + 4 * k) * d, (11 + 3 * k) * d};
    b.start.angularVelocity = {1.0 * k, 2, 3};
    c.bodies.push_back(b);
  }
  const auto particles = testing::lattice(c, 24, 24, 7, 0.2, {0, 0, 0.3 * d});
  auto wrapped = particles;
  testing::wrap(c, wrapped);
  std::vector<RigidState> first;
  std::vector<FlowSample> samples;
  for (const int threads : {1, 2, 4}) {
    auto solver = makeFlowSolverCpu(c, threads, bestIsa());
    ASSERT_TRUE(solver.ok() && (*solver)->add(wrapped).ok());
    for (int k = 0; k < 250; ++k) ASSERT_TRUE((*solver)->step(1.0).ok());
    const auto now = (*solver)->samples();
    if (threads == 1) first = (*solver)->bodies(), samples = now;
    ASSERT_EQ((*solver)->bodies(), first) << threads;
    for (std::size_t i = 0; i < now.size(); ++i)
      ASSERT_EQ(now[i].particle.position, samples[i].particle.position) << threads;
  }
}

TEST(FlowBodiesTest, BoundaryParticlesLieHalfASpacingInsideAndOneToASquare) {
  const double spacing = 0.1;
  const auto ball = *makeRigidShape(testing::sphereMesh(1.0, 4));
  const BodyBoundary b = sampleBody(*ball, spacing, 2 * spacing);
  for (const Vec3d& p : b.positions) ASSERT_NEAR(length(p), 1.0 - 0.5 * spacing, 0.02 * spacing + 0.005);
  const double squares = 4 * M_PI * 0.95 * 0.95 / (spacing * spacing);
  EXPECT_NEAR(static_cast<double>(b.positions.size()), squares, 0.25 * squares);
  // A sheet has its particles on itself, a body thinner than a spacing in its middle, and a grain has one.
  TriangleMesh sheet;
  sheet.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  sheet.indices = {0, 1, 2};
  const auto sheetShape = *makeRigidShape(sheet);
  for (const Vec3d& p : sampleBody(*sheetShape, spacing, 0.2).positions)
    ASSERT_NEAR(p.z + sheetShape->mass.centre.z, 0.0, 1e-6);
  const auto plate = *makeRigidShape(testing::boxMesh({0, 0, 0}, {1, 1, 0.04}));
  const BodyBoundary thin = sampleBody(*plate, spacing, 0.2);
  ASSERT_GT(thin.positions.size(), 50u);
  for (const Vec3d& p : thin.positions) ASSERT_NEAR(p.z, 0.0, 0.1 * spacing);
  EXPECT_GE(sampleBody(**makeRigidShape(testing::cubeMesh(0.5 * spacing)), spacing, 0.2).positions.size(),
            1u);
}

}  // namespace
}  // namespace spin
