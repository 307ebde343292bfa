// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigid_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/meshes.h"

namespace spin {
namespace {

constexpr Vec3d kGravity{0, 0, -9.81};

std::shared_ptr<const RigidShape> shapeOf(const TriangleMesh& mesh) {
  auto shape = makeRigidShape(mesh);
  if (!shape) throw std::runtime_error(shape.error().text());
  return *shape;
}
std::shared_ptr<const RigidShape> cube() {
  static const auto shape = shapeOf(testing::cubeMesh(1.0));
  return shape;
}
std::shared_ptr<const RigidShape> ball() {
  static const auto shape = shapeOf(testing::sphereMesh(0.5, 4));
  return shape;
}

RigidBodyConfig body(std::shared_ptr<const RigidShape> shape, Vec3d position) {
  RigidBodyConfig b;
  b.shape = std::move(shape);
  b.restitution = 0.0;
  b.start.position = position;
  return b;
}
RigidStatics floor() {
  RigidStatics s;
  s.addPlane({});
  return s;
}
RigidWorld world(std::vector<RigidBodyConfig> bodies, RigidStatics statics, Vec3d gravity = kGravity,
                 double friction = 0.5) {
  auto made = RigidWorld::make(std::move(bodies), std::move(statics), gravity, friction);
  if (!made) throw std::runtime_error(made.error().text());
  return std::move(*made);
}
void run(RigidWorld& w, double seconds, double step = 1.0 / 240.0) {
  const int steps = static_cast<int>(std::lround(seconds / step));
  for (int k = 0; k < steps; ++k) ASSERT_TRUE(w.step(step, {}).ok());
}
double energyOf(const RigidBodyConfig& b, const RigidState& s) {
  return 0.5 * b.mass() * dot(s.velocity, s.velocity) +
         0.5 * dot(s.angularVelocity, momentumOf(b, s.orientation, s.angularVelocity)) -
         b.mass() * dot(kGravity, s.position);
}

TEST(MassPropertiesTest, OfABoxAndABallAreThoseOfTheFormulas) {
  const auto shells = makeMeshShells(testing::boxMesh({1, 2, 3}, {3, 3, 6}));
  const MassProperties box = massProperties(*shells);
  EXPECT_EQ(box.source, MassSource::Mesh);
  EXPECT_NEAR(box.volume, 6.0, 1e-9);
  EXPECT_LT(length(box.centre - Vec3d{2, 2.5, 4.5}), 1e-9);
  EXPECT_NEAR(box.inertia.xx, 6.0 / 12 * (1 + 9), 1e-9);
  EXPECT_NEAR(box.inertia.zz, 6.0 / 12 * (4 + 1), 1e-9);
  EXPECT_NEAR(box.inertia.xy, 0.0, 1e-9);
  const MassProperties round = massProperties(*makeMeshShells(testing::sphereMesh(2.0, 5, {7, 0, 0})));
  EXPECT_NEAR(round.volume, 4.0 / 3 * M_PI * 8, 0.01 * round.volume);
  EXPECT_NEAR(round.inertia.yy, 0.4 * round.volume * 4, 0.01 * round.inertia.yy);
}

TEST(MassPropertiesTest, AnOpenMeshTakesItsBox) {
  TriangleMesh open = testing::boxMesh({0, 0, 0}, {2, 1, 1});
  open.indices.resize(open.indices.size() - 3);
  const MassProperties p = massProperties(*makeMeshShells(open));
  EXPECT_EQ(p.source, MassSource::Box);
  EXPECT_NEAR(p.volume, 2.0, 1e-6);
  TriangleMesh sheet;
  sheet.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  sheet.indices = {0, 1, 2};
  EXPECT_NEAR(massProperties(*makeMeshShells(sheet)).volume, 2.0 * 1.0 * 0.1, 1e-6);
}

TEST(RigidWorldTest, ABoxRestsBelowTheFrictionAngleAndSlidesAboveIt) {
  // tan 20 degrees = 0.364, tan 35 = 0.700; friction 0.5.
  for (const double degrees : {20.0, 35.0}) {
    const double t = degrees * M_PI / 180.0;
    RigidStatics slope;
    slope.addPlane({{}, {-std::sin(t), 0, std::cos(t)}});
    RigidBodyConfig b = body(cube(), Vec3d{-std::sin(t), 0, std::cos(t)} * 0.5);
    b.start.orientation = turnedBy({}, {0, -t, 0});
    RigidWorld w = world({b}, slope);
    run(w, 0.5);
    const Vec3d early = w.states()[0].position;
    const Vec3d speed = w.states()[0].velocity;
    run(w, 1.0);
    if (degrees < 25) {
      EXPECT_LT(length(w.states()[0].position - b.start.position), 0.01);
      EXPECT_TRUE(w.asleep(0));
    } else {
      const double expected = 9.81 * (std::sin(t) - 0.5 * std::cos(t));
      EXPECT_NEAR((length(w.states()[0].velocity) - length(speed)) / 1.0, expected, 0.05 * expected);
      EXPECT_GT(length(w.states()[0].position - early), 0.3);
    }
  }
}

TEST(RigidWorldTest, AStackOfThreeBoxesStays) {
  RigidWorld w = world(
      {body(cube(), {0, 0, 0.5}), body(cube(), {0.1, 0.05, 1.5}), body(cube(), {-0.1, 0, 2.5})}, floor());
  run(w, 4.0);
  for (std::size_t k = 0; k < 3; ++k) {
    const RigidState& s = w.states()[k];
    EXPECT_LT(length(s.position - w.bodies()[k].start.position), 0.02) << k;
    EXPECT_GT(std::abs(s.orientation.w), 0.9999) << k;
    EXPECT_TRUE(w.asleep(k)) << k;
  }
}

TEST(RigidWorldTest, ABallRollsWithItsOwnAcceleration) {
  // Rolling without slip: a = g sin t / (1 + 2/5).
  const double t = 15.0 * M_PI / 180.0;
  RigidStatics slope;
  slope.addPlane({{}, {-std::sin(t), 0, std::cos(t)}});
  RigidWorld w = world({body(ball(), Vec3d{-std::sin(t), 0, std::cos(t)} * 0.5)}, slope);
  run(w, 2.0);
  const RigidState& s = w.states()[0];
  // Its facets are a tenth of a radius: rolling over their corners takes some.
  const double round = 9.81 * std::sin(t) / 1.4 * 2.0;
  EXPECT_LT(length(s.velocity), round);
  EXPECT_GT(length(s.velocity), 0.75 * round);
  EXPECT_NEAR(length(s.angularVelocity) * 0.5, length(s.velocity), 0.1 * length(s.velocity));
}

TEST(RigidWorldTest, ABounceGivesBackItsShareAndEnergyNeverGrows) {
  for (const double share : {0.0, 0.5, 0.9}) {
    RigidBodyConfig b = body(ball(), {0, 0, 2.5});
    b.restitution = share;
    RigidWorld w = world({b}, floor());
    double top = 0.0, energy = energyOf(b, w.states()[0]);
    bool landed = false;
    for (int k = 0; k < 480; ++k) {
      ASSERT_TRUE(w.step(1.0 / 240, {}).ok());
      const RigidState& s = w.states()[0];
      const double now = energyOf(b, s);
      // The fall by steps of semi-implicit Euler is exact in energy to m g dz per step.
      EXPECT_LT(now, energy + 1e-3 * std::abs(energy)) << k;
      landed = landed || s.position.z < 0.52;
      if (landed) top = std::max(top, s.position.z);
    }
    EXPECT_NEAR(top - 0.5, share * share * 2.0, 0.05 + 0.06 * share * share * 2.0) << share;
  }
}

TEST(RigidWorldTest, CollisionsKeepMomentumAndSpinKeepsEnergy) {
  RigidBodyConfig a = body(cube(), {0, 0, 0}), b = body(ball(), {3, 0.3, 0.2});
  a.start.velocity = {6, 0, 0};
  a.start.angularVelocity = {1, 2, 3};
  b.start.velocity = {-2, 0.5, 0};
  b.density = 900;
  a.restitution = 0.5;
  RigidWorld w = world({a, b}, {}, {});
  const auto momentum = [&] { return w.states()[0].velocity * a.mass() + w.states()[1].velocity * b.mass(); };
  const auto angular = [&] {
    Vec3d sum{};
    for (std::size_t k = 0; k < 2; ++k) {
      const RigidState& s = w.states()[k];
      sum += cross(s.position, s.velocity * w.bodies()[k].mass()) +
             momentumOf(w.bodies()[k], s.orientation, s.angularVelocity);
    }
    return sum;
  };
  const Vec3d before = momentum(), turning = angular();
  run(w, 1.0);
  EXPECT_GT(length(w.states()[1].velocity - b.start.velocity), 1.0) << "they did collide";
  EXPECT_LT(length(momentum() - before), 1e-9 * length(before));
  EXPECT_LT(length(angular() - turning), 0.01 * length(turning));
  EXPECT_LT(length(w.outerImpulse()), 1e-12);

  RigidBodyConfig spun = body(shapeOf(testing::boxMesh({0, 0, 0}, {1, 2, 0.5})), {});
  spun.start.angularVelocity = {3, 0.1, 0.1};
  RigidWorld free = world({spun}, {}, {});
  const double energy = energyOf(spun, free.states()[0]);
  run(free, 20.0);
  EXPECT_NEAR(energyOf(spun, free.states()[0]), energy, 0.005 * energy);
}

TEST(RigidWorldTest, FastBodiesDoNotTunnel) {
  Raster<float> ground(40, 40, -20, -20, 1.0);
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 40; ++i) ground.at(i, j) = static_cast<float>(0.3 * std::sin(i) + 0.2 * j);
  TriangleMesh sheet;
  sheet.positions = {{-20, -20, 0}, {20, -20, 0}, {0, 20, 0}};
  sheet.indices = {0, 1, 2};
  SignedDistanceOptions options;
  options.cell = 0.2;
  options.reach = 0.8;
  options.leastThickness = 0.4;
  for (const double step : {1.0 / 240, 0.02}) {
    RigidStatics terrain;
    terrain.setGround(ground);
    RigidBodyConfig small = body(shapeOf(testing::cubeMesh(0.3)), {0.3, 0, 12});
    small.start.velocity = {3, 2, -40};
    RigidWorld w = world({small}, terrain);
    for (int k = 0; k < static_cast<int>(1.5 / step); ++k) {
      ASSERT_TRUE(w.step(step, {}).ok());
      const Vec3d p = w.states()[0].position;
      // Where nothing of the ground is in reach it must be above it.
      HeightContact<double> c;
      struct View {
        const float* heights;
        std::int32_t width, height;
        double originX, originY, cell;
      } view{ground.values.data(), 40, 40, -20, -20, 1.0};
      ASSERT_TRUE(!nearestGround(view, p.x, p.y, p.z, 1.0, c) || c.distance > 0.1) << k;
    }
    RigidStatics wall;
    wall.addMesh(*SignedDistance::make(sheet, options));
    RigidBodyConfig shot = body(cube(), {0, -5, 10});
    shot.start.velocity = {0, 0, -40};
    RigidWorld w2 = world({shot}, wall);
    run(w2, 2.0, step);
    EXPECT_NEAR(w2.states()[0].position.z, 0.7, 0.1) << "rests on the plate that the sheet is";
  }
}

TEST(RigidWorldTest, KinematicBodiesFollowTheirMotionAndPush) {
  RigidBodyConfig ram = body(cube(), {0, 0, 0.5}), box = body(cube(), {1.5, 0, 0.5});
  ram.kinematic = true;
  ram.start.velocity = {1, 0, 0};
  RigidWorld w = world({ram, box}, floor());
  run(w, 2.0);
  EXPECT_NEAR(w.states()[0].position.x, 2.0, 1e-9);
  EXPECT_NEAR(w.states()[1].position.x, 3.0, 0.03);
  EXPECT_NEAR(w.states()[1].position.z, 0.5, 0.02);
}

TEST(RigidWorldTest, SleepersWakeWhenHitAndWhenPushed) {
  RigidBodyConfig box = body(cube(), {0, 0, 0.5}), shot = body(ball(), {-8, 0, 3.5});
  shot.start.velocity = {9, 0, 0};
  RigidWorld w = world({box, shot}, floor(), kGravity, 0.1);
  run(w, 0.7);
  EXPECT_TRUE(w.asleep(0));
  run(w, 1.8);
  EXPECT_GT(w.states()[0].position.x, 0.05);
  RigidWorld still = world({box}, floor());
  run(still, 1.0);
  ASSERT_TRUE(still.asleep(0));
  const double push = box.mass() * 9.81;
  for (int k = 0; k < 60; ++k) ASSERT_TRUE(still.step(1.0 / 240, {{{push / 240, 0, 0}, {}}}).ok());
  EXPECT_GT(still.states()[0].velocity.x, 0.5);
}

TEST(RigidWorldTest, ARunFromSavedStatesIsTheSameBitForBit) {
  std::vector<RigidBodyConfig> bodies = {body(cube(), {0, 0, 1.2}), body(ball(), {0.2, 0.1, 2.6}),
                                         body(cube(), {0.1, 0.3, 4.0})};
  bodies[0].start.angularVelocity = {1, 0.3, 0.2};
  RigidWorld whole = world(bodies, floor());
  run(whole, 0.7);
  RigidWorld resumed = world(bodies, floor());
  ASSERT_TRUE(resumed.setStates(whole.states()).ok());
  run(whole, 0.8);
  run(resumed, 0.8);
  EXPECT_EQ(whole.states(), resumed.states());
}

TEST(RigidWorldTest, WhatIsNotFiniteIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  RigidBodyConfig bad = body(cube(), {0, nan, 0});
  EXPECT_FALSE(RigidWorld::make({bad}, {}, kGravity, 0.5).ok());
  bad = body(nullptr, {});
  EXPECT_FALSE(RigidWorld::make({bad}, {}, kGravity, 0.5).ok());
  bad = body(cube(), {});
  bad.density = 0.0;
  EXPECT_FALSE(RigidWorld::make({bad}, {}, kGravity, 0.5).ok());
  RigidWorld w = world({body(cube(), {0, 0, 5})}, floor());
  const auto before = w.states();
  EXPECT_FALSE(w.step(0.01, {{{nan, 0, 0}, {}}}).ok());
  EXPECT_FALSE(w.step(nan, {}).ok());
  EXPECT_FALSE(w.step(0.0, {}).ok());
  auto states = before;
  states[0].velocity.x = nan;
  EXPECT_FALSE(w.setStates(states).ok());
  EXPECT_FALSE(w.setStates({}).ok());
  EXPECT_EQ(w.states(), before);
}

}  // namespace
}  // namespace spin
