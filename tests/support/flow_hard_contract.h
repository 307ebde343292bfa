// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/support/flow_runs.h"
#include "tests/support/flow_scenes.h"

/// What would break a weaker solver. Short by default; with SPIN_LONG_TESTS set each case runs its full
/// length and prints its figures. Instantiate FlowHard with a struct as FlowRuns wants it.
namespace spin::contract {

inline bool fullLength() {
  return std::getenv("SPIN_LONG_TESTS") != nullptr;
}

template <class Traits>
class FlowHard : public FlowRuns<Traits> {
 protected:
  template <class... Values>
  static void figure(const char* format, Values... values) {
    if (fullLength()) std::printf(format, values...);
  }
};
TYPED_TEST_SUITE_P(FlowHard);

constexpr double kInstant = 1e-9;  // s, a step that moves nothing

/// Gravity that makes a floor at z = 0 a slope, falling towards +x.
inline Vec3d slopeGravity(double degrees) {
  const double t = degrees * M_PI / 180.0;
  return {9.80665 * std::sin(t), 0, -9.80665 * std::cos(t)};
}

inline double fastestOf(const std::vector<FlowSample>& samples) {
  double fastest = 0.0;
  for (const FlowSample& s : samples) fastest = std::max(fastest, length(s.particle.velocity));
  return fastest;
}
inline double lowestOf(const std::vector<FlowSample>& samples) {
  double low = INFINITY;
  for (const FlowSample& s : samples) low = std::min(low, s.particle.position.z);
  return low;
}

/// Energy per mass, J/kg: kinetic, potential, and elastic, of the linear state equation: the integral of p /
/// rho^2 over the density.
inline double energyOf(const FlowConfig& c, const std::vector<FlowSample>& samples) {
  double sum = 0.0;
  for (const FlowSample& s : samples) {
    const double sound = c.materials[s.particle.material].soundSpeed;
    const double e = std::max(s.density / c.materials[s.particle.material].restDensity - 1.0, 0.0);
    sum += 0.5 * dot(s.particle.velocity, s.particle.velocity) - dot(c.gravity, s.particle.position) +
           sound * sound * (std::log1p(e) - e / (1.0 + e));
  }
  return sum / static_cast<double>(samples.size());
}

/// How far the deepest particle lies below the height field, m.
inline double depthBelow(const FlowConfig& c, const std::vector<FlowSample>& samples) {
  WallView view;
  const Raster<float>& g = c.walls.ground;
  view.ground = {g.values.data(),
                 nullptr,
                 g.width,
                 g.height,
                 static_cast<float>(g.originX),
                 static_cast<float>(g.originY),
                 static_cast<float>(g.cellSize)};
  double deepest = 0.0;
  for (const FlowSample& s : samples) {
    const Vec3f p = s.particle.position.template to<float>();
    view.near(p.x, p.y, p.z, static_cast<float>(c.spacing), [&](const WallContact& wall) {
      deepest = std::max(deepest, -static_cast<double>(wall.distance));
    });
  }
  return deepest;
}

TYPED_TEST_P(FlowHard, CrossFluidsRunDownASteepSlope) {
  // The published avalanche fluid (thinning, flow curve not monotone) and one a thousand times stiffer.
  double speed[2] = {};
  for (const int stiff : {0, 1}) {
    FlowConfig c = testing::boxConfig(8, 8, 24);
    c.spacing = 0.1;
    c.domainMin = {0, 0, -0.4};
    c.domainMax = {0.8, 0.8, 2.4};
    c.gravity = slopeGravity(45);
    FlowMaterialConfig& m = c.materials[0];
    m.soundSpeed = 60.0;
    m.restDensity = 400.0;
    m.rheology.law = RheologyLaw::Cross;
    m.rheology.viscosity = stiff ? 1e5f : 100.0f;
    m.rheology.viscosityAtSpeed = stiff ? 1e3f : 1.0f;
    m.rheology.crossFactor = 3000.0f;
    m.rheology.exponent = 2.0f;
    const Solver solver = this->start(c, testing::lattice(c, 8, 8, 5, 0.1));
    const double seconds = stiff ? (fullLength() ? 0.2 : 0.02) : (fullLength() ? 1.0 : 0.3);
    this->runFor(*solver, seconds);
    const auto samples = solver->samples();
    ASSERT_EQ(samples.size(), 8u * 8u * 5u);
    EXPECT_GT(lowestOf(samples), -0.01 * c.spacing) << stiff;
    for (const FlowSample& s : samples) speed[stiff] += s.particle.velocity.x / 320.0 / seconds;
    // Never faster than without friction.
    EXPECT_LE(speed[stiff], c.gravity.x * 1.01);
    EXPECT_LT(fastestOf(samples), 1.5 * c.gravity.x * seconds + 0.05 * c.materials[0].soundSpeed) << stiff;
    this->figure("cross fluid %s: %.3f s, mean acceleration %.3f m/s2, fastest %.2f m/s\n",
                 stiff ? "x 1000" : "x 1", seconds, speed[stiff], fastestOf(samples));
  }
  EXPECT_GT(speed[0], 0.0);
}

TYPED_TEST_P(FlowHard, BinghamBelowItsYieldStressStays) {
  // Bed stress 0.43 of the yield stress. What is left is the creep of the regularised law, tau h / (2 mu).
  FlowConfig c = testing::boxConfig(8, 8, 16);
  c.gravity = slopeGravity(10);
  Rheology& r = c.materials[0].rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = 10.0f;
  r.cohesion = 1200.0f;
  c.density = DensityMode::Continuity;
  const int layers = 6;
  const double depth = layers * c.spacing;
  auto particles = testing::lattice(c, 8, 8, layers);
  // Begins at rest: a layer that first sinks into its pressure flows while it does.
  for (FlowParticle& p : particles)
    p.excess = -c.gravity.z * (depth - p.position.z) / std::pow(c.materials[0].soundSpeed, 2);
  const Solver solver = this->start(c, particles);
  const double seconds = this->run(*solver, 1.0, fullLength() ? 10000 : 4000);
  const auto samples = solver->samples();
  double creep = 0.0;
  for (const FlowSample& s : samples) creep += s.particle.velocity.x / static_cast<double>(samples.size());
  // Profile of a layer of one viscosity: mean speed tau h / (3 mu).
  const double expected = 1000.0 * c.gravity.x * depth * depth / (3.0 * 1200.0 * 100.0);
  // The short run still has some of the beginning in it.
  EXPECT_LT(creep, (fullLength() ? 1.6 : 4.0) * expected);
  EXPECT_LT(creep, 0.02 * c.gravity.x * std::max(seconds, 0.05));
  this->figure("Bingham at rest: %.4f s, creep %.3g m/s (regularised law: %.3g), %.3g spacings\n", seconds,
               creep, expected, creep * seconds / c.spacing);
}

TYPED_TEST_P(FlowHard, AHundredMetresOfWaterRest) {
  FlowConfig c = testing::boxConfig(8, 8, 160);
  c.spacing = 1.0;
  c.domainMin = {0, 0, -4};
  c.domainMax = {8, 8, 150};
  c.density = DensityMode::Continuity;
  const double depth = 100.0, weight = 9806.65;
  c.materials[0].soundSpeed = 10.0 * std::sqrt(9.80665 * depth);
  c.materials[0].rheology.viscosity = static_cast<float>(0.1 * 1000.0 * c.materials[0].soundSpeed);
  auto particles = testing::lattice(c, 8, 8, 100);
  for (FlowParticle& p : particles)
    p.excess = 9.80665 * (depth - p.position.z) / std::pow(c.materials[0].soundSpeed, 2);
  const Solver solver = this->start(c, particles);
  this->run(*solver, 1.0, fullLength() ? 30000 : 1500);
  double squares = 0.0;
  const auto samples = solver->samples();
  for (const FlowSample& s : samples) {
    const double exact = weight * std::max(depth - s.particle.position.z, 0.0);
    squares += (s.pressure - exact) * (s.pressure - exact);
  }
  const double rms = std::sqrt(squares / static_cast<double>(samples.size())) / (weight * depth);
  EXPECT_EQ(samples.size(), 6400u);
  EXPECT_LT(rms, 0.03);
  EXPECT_GT(lowestOf(samples), 0.0);
  EXPECT_LT(fastestOf(samples), 0.05 * std::sqrt(9.80665 * depth));
  this->figure("100 m of water: pressure rms %.4f rho g H, fastest %.3f m/s\n", rms, fastestOf(samples));
}

TYPED_TEST_P(FlowHard, WaterFallsEightyMetresOntoAStep) {
  FlowConfig c = testing::boxConfig(8, 8, 8);
  c.spacing = 0.5;
  c.periodic[0] = c.periodic[1] = false;
  c.domainMin = {-60, -60, -10};
  c.domainMax = {60, 60, 110};
  c.walls.planes.clear();
  c.walls.ground = Raster<float>(240, 240, -60, -60, 0.5);
  for (int j = 0; j < 240; ++j)
    for (int i = 0; i < 240; ++i) c.walls.ground.at(i, j) = c.walls.ground.x(i) < 0 ? 5.0f : 0.0f;
  // Two and a half times the speed it arrives with: far below what would be asked for.
  c.materials[0].soundSpeed = 100.0;
  const Solver solver =
      this->start(c, testing::lattice(c, 8, 8, 8, 0.1, {-2, -2, fullLength() ? 85.0 : 20.0}));
  this->run(*solver, kInstant, 1);
  const double before = energyOf(c, solver->samples());
  double deepest = 0.0, fastest = 0.0;
  for (int k = 0; k < (fullLength() ? 50 : 26); ++k) {
    this->runFor(*solver, 0.1);
    const auto samples = solver->samples();
    deepest = std::max(deepest, depthBelow(c, samples));
    fastest = std::max(fastest, fastestOf(samples));
    ASSERT_LT(energyOf(c, samples), 1.001 * before);
  }
  EXPECT_EQ(solver->count(), 512u);
  EXPECT_LT(deepest, 0.1 * c.spacing);
  this->figure("fall on to a step: fastest %.1f m/s, deepest %.4f spacings\n", fastest, deepest / c.spacing);
}

TYPED_TEST_P(FlowHard, AFilmOneParticleThickSlides) {
  for (const DensityMode density : {DensityMode::Summation, DensityMode::Continuity}) {
    FlowConfig c = testing::boxConfig(20, 20, 20);
    c.gravity = slopeGravity(30);
    c.density = density;
    c.walls.surfaces[0] = {WallFriction::Coulomb, 0.3f};
    const Solver solver = this->start(c, testing::lattice(c, 20, 20, 1, 0.1));
    const double seconds = 0.5;
    this->runFor(*solver, seconds);
    const auto samples = solver->samples();
    ASSERT_EQ(samples.size(), 400u);
    double speed = 0.0, high = 0.0;
    for (const FlowSample& s : samples)
      speed += s.particle.velocity.x / 400.0, high += s.particle.position.z / 400.0;
    EXPECT_GT(lowestOf(samples), -0.01 * c.spacing);
    EXPECT_LT(high, 1.0 * c.spacing);
    EXPECT_NEAR(speed / seconds, c.gravity.x + 0.3 * c.gravity.z, 0.1 * c.gravity.x);
    this->figure("film: acceleration %.3f m/s2 of %.3f, lowest %.2f, mean height %.2f spacings\n",
                 speed / seconds, c.gravity.x + 0.3 * c.gravity.z, lowestOf(samples) / c.spacing,
                 high / c.spacing);
  }
}

TYPED_TEST_P(FlowHard, WhatFliesAloneForgetsItsPressureAndComesToRest) {
  // Crumbs that a collision threw out while they were compressed: with that for ever, they would be springs.
  FlowConfig c = testing::boxConfig(64, 64, 120);
  c.density = DensityMode::Continuity;
  std::vector<FlowParticle> crumbs(9);
  for (std::size_t k = 0; k < crumbs.size(); ++k) {
    crumbs[k].position = {0.5 + 1.0 * static_cast<double>(k % 3), 0.5 + 1.0 * static_cast<double>(k / 3),
                          0.5};
    crumbs[k].velocity = {0.0, 0.0, -1.0};
    crumbs[k].excess = 0.5;
  }
  const Solver solver = this->start(c, crumbs);
  double high = 0.0;
  for (int k = 0; k < 50; ++k) {
    this->runFor(*solver, 0.05);
    for (const FlowSample& s : solver->samples()) high = std::max(high, s.particle.position.z);
  }
  EXPECT_EQ(solver->count(), crumbs.size());
  EXPECT_LT(high, 0.5);
  EXPECT_LT(fastestOf(solver->samples()), 0.02);
  for (const FlowSample& s : solver->samples()) {
    EXPECT_LT(s.particle.position.z, c.spacing);
    EXPECT_NEAR(s.density, 1000.0, 10.0);
  }
}

TYPED_TEST_P(FlowHard, ParticlesAtTheSamePlaceStayFinite) {
  FlowConfig c = testing::boxConfig(12, 12, 24);
  c.materials[0].rheology.viscosity = 1.0f;
  c.smoothing = 0.1;
  for (const DensityMode density : {DensityMode::Summation, DensityMode::Continuity}) {
    c.density = density;
    auto particles = testing::lattice(c, 12, 12, 8);
    particles.push_back(particles[500]);
    particles.push_back(particles[500]);
    particles.push_back(particles[3]);
    const Solver solver = this->start(c, particles);
    this->runFor(*solver, fullLength() ? 2.0 : 0.3);
    const auto samples = solver->samples();
    EXPECT_EQ(samples.size(), particles.size());
    EXPECT_LT(fastestOf(samples), 0.25 * c.materials[0].soundSpeed);
    EXPECT_GT(lowestOf(samples), -0.01 * c.spacing);
  }
}

TYPED_TEST_P(FlowHard, WhatIsFilledIntoTheGroundIsNotThere) {
  FlowConfig c = testing::boxConfig(8, 8, 8);
  c.periodic[0] = c.periodic[1] = false;
  c.domainMin = {0, 0, -1};
  c.domainMax = {9, 9, 6};
  c.walls.planes.clear();
  c.walls.ground = testing::rampGround(9, 9, 0.25, 0.5);
  for (const DensityMode density : {DensityMode::Summation, DensityMode::Continuity}) {
    c.density = density;
    // A level disc on a slope: one side hangs in the air, the other lies four spacings in the ground.
    const auto particles = testing::lattice(c, 20, 20, 6, 0.1, {4.5, 4.0, 2.5});
    const Solver solver = this->start(c, particles);
    std::size_t above = 0;
    for (const FlowParticle& p : particles) above += p.position.z > 0.5 * p.position.x ? 1 : 0;
    EXPECT_GE(solver->count(), above);
    EXPECT_LT(solver->count(), particles.size() - 200);
    EXPECT_LT(depthBelow(c, solver->samples()), 0.26 * c.spacing);
    const std::size_t count = solver->count();
    double fastest = 0.0;
    for (int k = 0; k < 6; ++k) {
      this->runFor(*solver, 0.05);
      fastest = std::max(fastest, fastestOf(solver->samples()));
    }
    EXPECT_EQ(solver->samples().size(), count);
    // It falls by 0.25 m, runs down the slope and spreads: 2 + 2 + 3 m/s. What would be shot out of the
    // ground comes at the sound speed, 20 m/s.
    EXPECT_LT(fastest, 9.0);
    EXPECT_LT(depthBelow(c, solver->samples()), 0.1 * c.spacing);
    this->figure("filled into the ground: %zu of %zu are there, fastest %.2f m/s, deepest %.3f spacings\n",
                 count, particles.size(), fastest, depthBelow(c, solver->samples()) / c.spacing);
  }
}

TYPED_TEST_P(FlowHard, AStepTenTimesTooLargeShrinks) {
  FlowConfig c = testing::boxConfig(12, 12, 24);
  c.materials[0].rheology.viscosity = 50.0f;
  auto particles = testing::lattice(c, 12, 12, 8, 0.2);
  testing::wrap(c, particles);
  const Solver own = this->start(c, particles), asked = this->start(c, particles);
  for (int k = 0; k < 200; ++k) {
    const Result<FlowStep> a = own->step(1.0);
    ASSERT_TRUE(a.ok());
    const Result<FlowStep> b = asked->step(10.0 * a->seconds);
    ASSERT_TRUE(b.ok());
    ASSERT_EQ(a->seconds, b->seconds);
    ASSERT_NE(b->limit, StepLimit::Asked);
  }
  for (double FlowConfig::*factor :
       {&FlowConfig::courant, &FlowConfig::forceFactor, &FlowConfig::viscousFactor}) {
    FlowConfig wild = c;
    wild.*factor *= 10.0;
    EXPECT_TRUE(!TypeParam::make(wild).ok() || wild.*factor <= 1.0);
    wild.*factor = 2.5;
    EXPECT_FALSE(TypeParam::make(wild).ok());
  }
}

TYPED_TEST_P(FlowHard, SpacingsFromACentimetreToTwoMetresGiveTheSameFlow) {
  // Froude's law: a collapse looks the same at every size.
  double front[3] = {};
  int k = 0;
  for (const double spacing : {0.01, 0.05, 2.0}) {
    FlowConfig c = testing::boxConfig(8, 8, 8);
    c.spacing = spacing;
    c.periodic[0] = false;
    c.density = DensityMode::Continuity;
    c.domainMin = {-4 * spacing, 0, -4 * spacing};
    c.domainMax = {60 * spacing, 8 * spacing, 30 * spacing};
    c.walls.planes = {{}, {{0, 0, 0}, {1, 0, 0}, {}, 0}};
    c.walls.surfaces[0].friction = WallFriction::FreeSlip;
    const double depth = 12 * spacing, scale = std::sqrt(9.80665 * depth);
    c.materials[0].soundSpeed = 14.0 * scale;
    c.materials[0].rheology.viscosity = static_cast<float>(0.002 * 1000.0 * scale * depth);
    const Solver solver = this->start(c, testing::lattice(c, 12, 8, 12));
    this->runFor(*solver, 1.5 * depth / scale);
    for (const FlowSample& s : solver->samples())
      front[k] = std::max(front[k], s.particle.position.x / spacing);
    this->figure("spacing %.2f m: front at %.3f spacings\n", spacing, front[k]);
    ++k;
  }
  EXPECT_GT(front[0], 20.0);
  EXPECT_NEAR(front[0] / front[1], 1.0, 0.01);
  EXPECT_NEAR(front[2] / front[1], 1.0, 0.01);
}

TYPED_TEST_P(FlowHard, EightyMetresASecondIntoAWall) {
  // Once with a sound speed as it should be, once hardly above the flow's.
  for (const double sound : {800.0, 100.0}) {
    FlowConfig c = testing::boxConfig(8, 8, 8);
    c.spacing = 0.2;
    c.periodic[0] = c.periodic[1] = false;
    c.density = DensityMode::Continuity;
    c.domainMin = {-30, -30, -1};
    c.domainMax = {10, 30, 60};
    c.materials[0].soundSpeed = sound;
    c.walls.planes = {{}, {{4, 0, 0}, {-1, 0, 0.2}, {}, 0}};
    auto particles = testing::lattice(c, 12, 12, 8, 0.1, {0, 0, 0});
    for (FlowParticle& p : particles) p.velocity = {80.0, 0, 0};
    const Solver solver = this->start(c, particles);
    this->run(*solver, kInstant, 1);
    const double before = energyOf(c, solver->samples());
    double deepest = 0.0;
    const Vec3d normal = normalized(Vec3d{-1, 0, 0.2});
    for (int k = 0; k < (fullLength() ? 100 : 20); ++k) {
      this->runFor(*solver, 0.005);
      const auto samples = solver->samples();
      ASSERT_LT(energyOf(c, samples), 1.001 * before) << sound;
      for (const FlowSample& s : samples)
        deepest =
            std::max({deepest, -s.particle.position.z, -dot(normal, s.particle.position - Vec3d{4, 0, 0})});
    }
    EXPECT_LT(deepest, 0.1 * c.spacing) << sound;
    this->figure("80 m/s into a wall, sound %.0f m/s: deepest %.4f spacings\n", sound, deepest / c.spacing);
  }
}

TYPED_TEST_P(FlowHard, ABrokenParticleIsNamed) {
  FlowConfig c = testing::boxConfig(12, 12, 24);
  c.materials[0].rheology.viscosity = 50.0f;
  c.smoothing = 0.2;
  c.density = DensityMode::Continuity;
  auto particles = testing::lattice(c, 12, 12, 8);
  particles[700].velocity = {2e38, 2e38, 2e38};
  const Solver solver = this->start(c, particles);
  const Result<FlowStep> done = solver->step(1e-3);
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().where.find("particle 700"), std::string::npos) << done.error().text();
  EXPECT_NE(done.error().where.find("stage"), std::string::npos) << done.error().text();
}

TYPED_TEST_P(FlowHard, SloshingGainsNoEnergy) {
  FlowConfig c = testing::boxConfig(8, 8, 8);
  c.periodic[0] = false;
  c.density = DensityMode::Continuity;
  const double length = 24 * c.spacing;
  c.domainMin = {-0.2, 0, -0.2};
  c.domainMax = {length + 0.2, 0.4, 2.0};
  c.walls.planes = {{}, {{0, 0, 0}, {1, 0, 0}, {}, 0}, {{length, 0, 0}, {-1, 0, 0}, {}, 0}};
  c.walls.surfaces[0].friction = WallFriction::FreeSlip;
  c.materials[0].soundSpeed = 25.0;
  c.materials[0].rheology.viscosity = 1.0f;
  auto particles = testing::lattice(c, 24, 8, 12, 0.05);
  testing::wrap(c, particles);
  // All of it moves to one side, a third of the speed of long waves.
  for (FlowParticle& p : particles) p.velocity.x = 0.8;
  const Solver solver = this->start(c, particles);
  this->run(*solver, kInstant, 1);
  const double before = energyOf(c, solver->samples());
  double most = 0.0, seconds = 0.0;
  for (int k = 0; k < (fullLength() ? 400 : 12); ++k) {
    seconds += this->run(*solver, 1.0, 250);
    most = std::max(most, energyOf(c, solver->samples()) / before);
  }
  const auto samples = solver->samples();
  EXPECT_EQ(samples.size(), 24u * 8u * 12u);
  EXPECT_LT(most, 1.001);
  EXPECT_GT(lowestOf(samples), 0.0);
  this->figure("sloshing: %.1f s, most energy %.5f of the start's, at the end %.5f\n", seconds, most,
               energyOf(c, samples) / before);
}

REGISTER_TYPED_TEST_SUITE_P(FlowHard, CrossFluidsRunDownASteepSlope, BinghamBelowItsYieldStressStays,
                            AHundredMetresOfWaterRest, WaterFallsEightyMetresOntoAStep,
                            AFilmOneParticleThickSlides, WhatFliesAloneForgetsItsPressureAndComesToRest,
                            ParticlesAtTheSamePlaceStayFinite, WhatIsFilledIntoTheGroundIsNotThere,
                            AStepTenTimesTooLargeShrinks, SpacingsFromACentimetreToTwoMetresGiveTheSameFlow,
                            EightyMetresASecondIntoAWall, ABrokenParticleIsNamed, SloshingGainsNoEnergy);

}  // namespace spin::contract
