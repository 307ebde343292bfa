// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/flow_scenes.h"
#include "tests/support/meshes.h"

/// What rigid bodies in the flow must do on every device. Instantiate FlowBodiesContract with the struct that
/// FlowContract takes.
namespace spin::contract {

template <class Traits>
class FlowBodiesContract : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string why;
    if (!Traits::available(why)) GTEST_SKIP() << why;
  }
  static RigidBodyConfig body(const TriangleMesh& mesh, double density, Vec3d position) {
    auto shape = makeRigidShape(mesh);
    if (!shape) throw std::runtime_error(shape.error().text());
    RigidBodyConfig b;
    b.shape = *shape;
    b.density = density;
    b.start.position = position;
    return b;
  }
  static std::unique_ptr<FlowSolver> start(const FlowConfig& c, const std::vector<FlowParticle>& particles) {
    auto solver = Traits::make(c);
    if (!solver) throw std::runtime_error(solver.error().text());
    if (const Status added = (*solver)->add(particles); !added)
      throw std::runtime_error(added.error().text());
    return std::move(*solver);
  }
  static void runFor(FlowSolver& solver, double seconds) {
    while (seconds > 1e-9) {
      const auto done = solver.step(seconds);
      if (!done) throw std::runtime_error(done.error().text());
      seconds -= done->seconds;
    }
  }
  /// A lattice without what is within `margin` of a ball or box about the body.
  static std::vector<FlowParticle> around(const std::vector<FlowParticle>& all, Vec3d low, Vec3d high) {
    std::vector<FlowParticle> kept;
    for (const FlowParticle& p : all) {
      const Vec3d x = p.position;
      const bool in =
          x.x > low.x && x.y > low.y && x.z > low.z && x.x < high.x && x.y < high.y && x.z < high.z;
      if (!in) kept.push_back(p);
    }
    return kept;
  }
  static Vec3d momentum(const FlowSolver& solver, const FlowConfig& c) {
    Vec3d sum{};
    for (const FlowSample& s : solver.samples())
      sum += s.particle.velocity * c.particleMass(s.particle.material);
    const auto states = solver.bodies();
    for (std::size_t k = 0; k < states.size(); ++k)
      if (!c.bodies[k].kinematic) sum += states[k].velocity * c.bodies[k].mass();
    return sum;
  }
  /// Snow of 300 kg/m3 that piles up, on a floor.
  static FlowConfig snowBox(int nx, int ny, int nz) {
    FlowConfig c = testing::boxConfig(nx, ny, nz);
    FlowMaterialConfig& m = c.materials[0];
    m.restDensity = 300.0;
    m.rheology.law = RheologyLaw::Yield;
    m.rheology.viscosity = 5.0f;
    m.rheology.frictionTangent = 0.47f;
    m.rheology.most = 200.0f;
    return c;
  }
};
TYPED_TEST_SUITE_P(FlowBodiesContract);

TYPED_TEST_P(FlowBodiesContract, ABoxFloatsAtArchimedesDepth) {
  for (const char* mode : {"summation", "continuity", "implicit"}) {
    const int wide = 16, layers = 10;
    FlowConfig c = testing::boxConfig(wide, wide, 32);
    if (mode == std::string("continuity")) c.density = DensityMode::Continuity;
    if (mode == std::string("implicit")) c.pressure = PressureMode::Implicit;
    c.materials[0].rheology.viscosity = 20.0f;
    const double d = c.spacing, edge = 8 * d, height = 4 * d, ratio = 0.5;
    const TriangleMesh mesh =
        testing::boxMesh({-edge / 2, -edge / 2, -height / 2}, {edge / 2, edge / 2, height / 2});
    const double sink = ratio * height;
    // The box takes the place of the particles that it is put on, and starts half a spacing too high.
    const double middle = 0.5 * wide * d, bottom = layers * d - sink;
    const auto particles =
        this->around(testing::lattice(c, wide, wide, layers), {middle - edge / 2, middle - edge / 2, bottom},
                     {middle + edge / 2, middle + edge / 2, 100});
    c.bodies = {this->body(mesh, ratio * 1000.0, {middle, middle, bottom + height / 2 + 0.5 * d})};
    const auto solver = this->start(c, particles);
    this->runFor(*solver, 1.0);
    double z = 0.0;
    int moments = 0;
    for (; moments < 20; ++moments) {
      this->runFor(*solver, 0.03);
      z += solver->bodies()[0].position.z;
    }
    EXPECT_NEAR(z / moments, bottom + height / 2, 0.5 * d) << mode;
    EXPECT_GT(std::abs(solver->bodies()[0].orientation.w), 0.99);
    EXPECT_EQ(solver->count(), particles.size());
  }
}

TYPED_TEST_P(FlowBodiesContract, MomentumOfFlowAndBodiesChangesByTheOuterImpulseOnly) {
  for (const auto& [friction, pressure, viscosity] :
       {std::tuple{WallFriction::NoSlip, PressureMode::EquationOfState, ViscosityMode::Pairwise},
        std::tuple{WallFriction::Coulomb, PressureMode::EquationOfState, ViscosityMode::Pairwise},
        std::tuple{WallFriction::NoSlip, PressureMode::EquationOfState, ViscosityMode::Implicit},
        std::tuple{WallFriction::NoSlip, PressureMode::Implicit, ViscosityMode::Pairwise}}) {
    FlowConfig c = testing::boxConfig(24, 24, 32);
    c.pressure = pressure;
    c.viscosity = viscosity;
    c.countImpulse = true;
    c.smoothing = 0.2;
    c.materials[0].rheology.viscosity = 5.0f;
    c.walls.surfaces = {{friction, 0.4f}, {friction, 0.3f}};
    const double d = c.spacing;
    auto particles = testing::lattice(c, 16, 16, 8, 0.2, {4 * d, 4 * d, 0.05 * d});
    RigidBodyConfig ball = this->body(testing::sphereMesh(4 * d, 2), 400.0, {13 * d, 11 * d, 15 * d});
    ball.start.velocity = {1, 0.5, -4};
    ball.start.angularVelocity = {3, 8, 1};
    ball.surface = 1;
    c.bodies = {ball};
    const auto solver = this->start(c, particles);
    const Vec3d before = this->momentum(*solver, c);
    this->runFor(*solver, 0.15);
    const Vec3d change = this->momentum(*solver, c) - before;
    const double exchanged = ball.mass() * length(solver->bodies()[0].velocity - ball.start.velocity);
    ASSERT_GT(exchanged, 0.3 * ball.mass());
    EXPECT_LT(length(change - solver->outerImpulse()), 1e-5 * length(solver->outerImpulse()));
    EXPECT_LT(length(change - solver->outerImpulse()), 1e-5 * exchanged);
    EXPECT_EQ(solver->count(), particles.size());
  }
}

TYPED_TEST_P(FlowBodiesContract, TheLightestBodiesStayWhereTheyFloat) {
  for (const double density : {50.0, 5.0, 1.0}) {
    FlowConfig c = testing::boxConfig(16, 16, 40);
    c.pressure = PressureMode::Implicit;
    const double d = c.spacing;
    c.bodies = {this->body(testing::cubeMesh(4 * d), density, {8 * d, 8 * d, 11 * d})};
    const auto solver = this->start(c, testing::lattice(c, 16, 16, 8));
    for (int k = 0; k < 10; ++k) {
      this->runFor(*solver, 0.05);
      const RigidState& s = solver->bodies()[0];
      // It falls by a spacing on to water that is eight deep; what is as light as air bounces.
      ASSERT_GT(s.position.z, 8 * d) << density;
      ASSERT_LT(s.position.z, density < 5.0 ? 20 * d : 14 * d) << density;
    }
    EXPECT_EQ(solver->count(), 16u * 16u * 8u);
  }
}

TYPED_TEST_P(FlowBodiesContract, ABodyAHundredTimesDenserThanSnowSinksAndStaysStable) {
  FlowConfig c = this->snowBox(16, 16, 40);
  const double d = c.spacing;
  c.bodies = {this->body(testing::cubeMesh(5 * d), 30000.0, {8 * d, 8 * d, 12 * d})};
  const auto solver = this->start(c, testing::lattice(c, 16, 16, 8));
  double fastest = 0.0;
  for (int k = 0; k < 20; ++k) {
    this->runFor(*solver, 0.05);
    for (const FlowSample& s : solver->samples()) fastest = std::max(fastest, length(s.particle.velocity));
  }
  const RigidState& s = solver->bodies()[0];
  EXPECT_NEAR(s.position.z, 2.5 * d, 0.2 * d) << "it lies on the ground";
  EXPECT_LT(length(s.velocity), 0.1);
  EXPECT_LT(fastest, 8.0) << "a fall of 0.4 m gives 2.7 m/s";
  EXPECT_EQ(solver->count(), 16u * 16u * 8u);
}

TYPED_TEST_P(FlowBodiesContract, ABodyLighterThanSnowStaysOnTop) {
  FlowConfig c = this->snowBox(16, 16, 40);
  const double d = c.spacing;
  c.bodies = {this->body(testing::sphereMesh(3 * d, 2), 60.0, {8 * d, 8 * d, 12 * d})};
  const auto solver = this->start(c, testing::lattice(c, 16, 16, 8));
  this->runFor(*solver, 1.0);
  const RigidState& s = solver->bodies()[0];
  // A fifth of the density: a fifth of its volume at most is below the surface.
  EXPECT_GT(s.position.z, 8 * d);
  EXPECT_LT(s.position.z, 12 * d);
  EXPECT_LT(length(s.velocity), 0.2);
}

TYPED_TEST_P(FlowBodiesContract, ADamBreakCarriesABodyAway) {
  FlowConfig c = testing::boxConfig(60, 8, 30);
  c.periodic[0] = false;
  c.walls.planes.push_back({{0, 0, 0}, {1, 0, 0}, {}, 0});
  c.domainMin.x = -4 * c.spacing;
  c.domainMax.x = c.domainMin.x + 66 * c.spacing;
  const double d = c.spacing;
  RigidBodyConfig box = this->body(testing::cubeMesh(4 * d), 600.0, {24 * d, 4 * d, 2 * d});
  box.friction = 0.3;
  c.bodies = {box};
  const auto solver = this->start(c, testing::lattice(c, 12, 8, 16));
  this->runFor(*solver, 0.8);
  EXPECT_GT(solver->bodies()[0].position.x, 28 * d);
  EXPECT_GT(solver->bodies()[0].velocity.x, 0.3);
}

TYPED_TEST_P(FlowBodiesContract, APaddleFollowsItsMotionAndPushesTheFlow) {
  FlowConfig c = testing::boxConfig(80, 8, 24);
  c.countImpulse = true;
  const double d = c.spacing;
  // Across the whole channel, so that nothing gets past.
  RigidBodyConfig paddle =
      this->body(testing::boxMesh({-d, -6 * d, -8 * d}, {d, 6 * d, 8 * d}), 500.0, {4 * d, 4 * d, 8.2 * d});
  paddle.kinematic = true;
  paddle.start.velocity = {0.8, 0, 0};
  c.bodies = {paddle};
  const auto solver = this->start(c, testing::lattice(c, 24, 8, 6, 0.0, {6 * d, 0, 0}));
  this->runFor(*solver, 0.4);
  const double x = solver->bodies()[0].position.x;
  EXPECT_NEAR(x, 4 * d + 0.8 * 0.4, 1e-9);
  EXPECT_EQ(solver->bodies()[0].velocity, paddle.start.velocity);
  int behind = 0;
  for (const FlowSample& s : solver->samples())
    behind += s.particle.position.x < x && s.particle.position.x > 0.2 * d;
  EXPECT_EQ(behind, 0);
  EXPECT_GT(this->momentum(*solver, c).x, 0.2 * 0.8 * 24 * 8 * 6 * c.particleMass(0));
  EXPECT_LT(length(this->momentum(*solver, c) - solver->outerImpulse()),
            1e-5 * length(solver->outerImpulse()) + 1e-5);
}

TYPED_TEST_P(FlowBodiesContract, SprayAndJetsDoNotEnterBodies) {
  FlowConfig c;
  c.spacing = 0.05;
  c.gravity = {};
  c.countImpulse = true;
  c.materials[0].soundSpeed = 100.0;
  c.domainMin = {-5, -5, -5};
  c.domainMax = {5, 5, 5};
  const double d = c.spacing;
  c.bodies = {this->body(testing::cubeMesh(8 * d), 400.0, {})};
  c.bodies[0].start.orientation = turnedBy({}, {0.3, 0.5, 0.7});
  auto particles = testing::lattice(c, 6, 6, 8, 0.1, {-3 * d, -3 * d, 8 * d});
  const CounterRandom random{31, 5};
  for (std::uint64_t k = 0; k < 200; ++k) {
    FlowParticle p;
    const auto u = [&](std::uint32_t n) { return 0.5 * (2.0 * random.uniformDouble(k, n) - 1.0); };
    p.position = {u(0), u(1), 1.0 + u(2)};
    particles.push_back(p);
  }
  // One that begins within the body is left out.
  particles.emplace_back();
  for (FlowParticle& p : particles) p.velocity = {0, 0, -10};
  const auto solver = this->start(c, particles);
  EXPECT_EQ(solver->count(), particles.size() - 1);
  const auto momentum = this->momentum(*solver, c);
  float deepest = 0.0f;
  for (int k = 0; k < 40; ++k) {
    this->runFor(*solver, 0.004);
    const RigidState s = solver->bodies()[0];
    for (const FlowSample& p : solver->samples()) {
      const Vec3f q = s.toBody(p.particle.position).to<float>();
      SignedDistanceView::Value value;
      if (c.bodies[0].shape->field->view({}).sample(q.x, q.y, q.z, value))
        deepest = std::min(deepest, value.distance);
    }
  }
  EXPECT_EQ(solver->count(), particles.size() - 1) << "none has left the domain";
  EXPECT_GT(static_cast<double>(deepest), -0.35 * d);
  EXPECT_LT(solver->bodies()[0].velocity.z, -2.0);
  EXPECT_LT(length(this->momentum(*solver, c) - momentum - solver->outerImpulse()), 1e-5 * length(momentum));
}

TYPED_TEST_P(FlowBodiesContract, StatesAreGivenBackAndSet) {
  FlowConfig c = testing::boxConfig(16, 16, 32);
  const double d = c.spacing;
  c.bodies = {this->body(testing::cubeMesh(4 * d), 300.0, {8 * d, 8 * d, 12 * d})};
  const auto solver = this->start(c, testing::lattice(c, 16, 16, 4));
  this->runFor(*solver, 0.05);
  auto states = solver->bodies();
  ASSERT_EQ(states.size(), 1u);
  EXPECT_LT(states[0].velocity.z, -0.3);
  states[0].position = {8 * d, 8 * d, 20 * d};
  states[0].velocity = {};
  ASSERT_TRUE(solver->setBodies(states).ok());
  EXPECT_EQ(solver->bodies(), states);
  // Boundary particles are half a spacing below the faces and move along.
  ASSERT_GT(solver->bodyBoundary().size(), 40u);
  for (const Vec3d& p : solver->bodyBoundary()) {
    const Vec3d q = p - states[0].position;
    ASSERT_NEAR(std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)}), 1.5 * d, 0.11 * d);
  }
  states[0].position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solver->setBodies(states).ok());
  EXPECT_FALSE(solver->setBodies({}).ok());
  c.bodies[0].density = -1.0;
  EXPECT_FALSE(TypeParam::make(c).ok());
  c.bodies[0].density = 300.0;
  c.bodies[0].surface = 9;
  EXPECT_FALSE(TypeParam::make(c).ok());
}

REGISTER_TYPED_TEST_SUITE_P(FlowBodiesContract, ABoxFloatsAtArchimedesDepth,
                            MomentumOfFlowAndBodiesChangesByTheOuterImpulseOnly,
                            TheLightestBodiesStayWhereTheyFloat,
                            ABodyAHundredTimesDenserThanSnowSinksAndStaysStable,
                            ABodyLighterThanSnowStaysOnTop, ADamBreakCarriesABodyAway,
                            APaddleFollowsItsMotionAndPushesTheFlow, SprayAndJetsDoNotEnterBodies,
                            StatesAreGivenBackAndSet);

}  // namespace spin::contract
