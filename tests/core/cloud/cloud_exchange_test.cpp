// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/cloud/air_contact.h"
#include "core/cloud/cloud_exchange.h"
#include "core/cloud/spray.h"
#include "core/flow/flow_materials.h"
#include "core/physics/humid_air.h"
#include "core/sph/flow_setup.h"
#include "tests/core/cloud/fake_air.h"
#include "tests/support/flow_scenes.h"

namespace spin {
namespace {

using test::FakeAir;

/// Water (or snow) in the air over level ground at height 0, with an air and everything else of a part.
struct CloudTest {
  AirNode settings;
  FlowConfig config;
  std::unique_ptr<FlowSolver> flow;
  AirConfig air;
  std::unique_ptr<FakeAir> grid;
  SurroundingAir surrounding = SurroundingAir::of(273.15, 101325.0, 0.8);
  CloudSolids solids;
  Box3d box{{-50, -50, 0}, {50, 50, 100}};
  std::vector<FlowParticle> rejoining;
  SnowFallout cover;
  CloudState state;
  FlowVelocities before;
  double film = 0.0;

  explicit CloudTest(bool snow = false, double cell = 0.5) {
    config.spacing = 0.1;
    config.domainMin = {-20, -20, -1}, config.domainMax = {20, 20, 60};
    config.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0}};
    if (snow) config.materials[0] = flowMaterialPreset(FlowMaterialKind::DrySnow).material;
    config.materials[0].soundSpeed = 30.0;
    settings.waterWarms = false;
    air.cell = cell, air.origin = box.min;
    SceneSnapshot scene;
    const Result<CloudSolids> made = CloudSolids::make(scene, FlowScene{}, air.cell, {});
    SPIN_CHECK(made.ok(), "no solids");
    solids = *made;
    grid = std::make_unique<FakeAir>(air);
    auto solver = makeFlowSolverCpu(config, 1, bestIsa());
    SPIN_CHECK(solver.ok(), solver.error().text());
    flow = std::move(*solver);
  }
  void block(int nx, int ny, int nz, Vec3d corner, Vec3d velocity) {
    auto particles = testing::lattice(config, nx, ny, nz, 0.0, corner);
    for (FlowParticle& p : particles) p.velocity = velocity;
    ASSERT_TRUE(flow->add(particles).ok());
  }
  /// A sampled step so short that nothing moves.
  void sample() {
    flow->sample(true);
    ASSERT_TRUE(flow->step(1e-7).ok());
  }
  CloudPart part(double seconds) {
    return {settings, film, film + seconds, 1,          *grid,      air.origin, air.cell, surrounding,
            solids,   box,  config,         flow.get(), &rejoining, &cover,     &before};
  }
  AirStep run(double seconds, bool withFlow = true) {
    CloudPart p = part(seconds);
    if (!withFlow) p.flow = nullptr, p.rejoining = nullptr;
    const Result<AirStep> done = CloudExchange(p, state).run();
    SPIN_CHECK(done.ok(), done.error().text());
    film += seconds;
    return *done;
  }
  double flowMass() const {
    double sum = 0.0;
    for (const FlowSample& s : flow->samples()) sum += (1.0 - s.particle.given) * config.particleMass(0);
    return sum;
  }
  Vec3d flowMomentum() const {
    Vec3d sum{};
    for (const FlowSample& s : flow->samples())
      sum += s.particle.velocity * ((1.0 - s.particle.given) * config.particleMass(0));
    return sum;
  }
  double sprayMass() const {
    double sum = 0.0;
    for (const SprayParcel& p : state.parcels)
      sum += static_cast<double>(p.units) * kGivenUnit * config.particleMass(0);
    return sum;
  }
};

TEST(CloudExchange, MassAndMomentumCloseAsBooked) {
  CloudTest t;
  t.settings.impactAcceleration = 10.0;
  t.settings.sprayRate = 20.0;
  t.settings.trappedLow = 0.0, t.settings.trappedHigh = 0.5;
  t.settings.waterWarms = true, t.settings.waterTemperature = 283.15;
  t.block(8, 8, 8, {0, 0, 3}, {1, 2, -12});
  t.block(1, 1, 1, {3, 3, 5}, {3, 0, -8});
  auto stirred = testing::lattice(t.config, 6, 6, 6, 0.3, {5, 5, 3});
  testing::stir(stirred, 6.0);
  ASSERT_TRUE(t.flow->add(stirred).ok());
  t.sample();
  auto faster = t.flow->samples();
  for (FlowSample& s : faster) s.particle.velocity = s.particle.velocity * 2.0;
  t.before.note(faster);
  const double mass = t.flowMass();
  const Vec3d momentum = t.flowMomentum();
  t.run(1.0 / 24.0);
  const CloudAccount& a = t.state.account;
  const AirBudget air = t.grid->budget();
  EXPECT_GT(t.state.parcels.size(), 1u) << "one was alone, and some were thrown up";
  EXPECT_GT(a.toAir, 0.0);
  EXPECT_NEAR((mass - t.flowMass()) / (a.fromFlow - a.toFlow), 1.0, 1e-9);
  EXPECT_NEAR((air.added[0] + air.added[1] + air.added[3]) / a.toAir, 1.0, 1e-9);
  EXPECT_NEAR((a.fromFlow - a.toFlow) / (a.toAir + t.sprayMass()), 1.0, 1e-9);
  const Vec3d lost = momentum - t.flowMomentum();
  const double size = length(lost);
  EXPECT_GT(size, 1.0);
  EXPECT_LT(length(lost - a.impulseFromFlow) / size, 1e-6);
  EXPECT_LT(length(air.addedImpulse - a.impulseToAir) / size, 1e-9);
  EXPECT_LT(length(a.impulseFromFlow - a.impulseToAir - a.impulseToSpray) / size, 1e-6);
}

TEST(CloudExchange, WhatIsGivenDoesNotDependOnTheStep) {
  double given[2];
  for (int fine = 0; fine < 2; ++fine) {
    // Cells so large that the air is not dragged along much.
    CloudTest t(false, 20.0);
    t.settings.spray = false;
    t.settings.mistRate = 0.5;
    t.block(8, 8, 4, {0, 0, 3}, {0, 0, -20});
    t.sample();
    for (int k = 0; k < (fine ? 16 : 2); ++k) t.run(fine ? 0.01 : 0.08);
    given[fine] = t.state.account.toAir;
  }
  EXPECT_GT(given[0], 1.0);
  EXPECT_NEAR(given[1] / given[0], 1.0, 0.03);
}

TEST(CloudExchange, AnImpactGivesMistBySpeedTakenWithItsMomentum) {
  CloudTest t;
  t.settings.spray = false, t.settings.mistRate = 0.0, t.settings.mistSpeed = 0.5;
  t.settings.impactWater = 1e-3;
  t.block(8, 8, 8, {0, 0, 0}, {0, 0, -6});
  for (int k = 0; k < 10; ++k) ASSERT_TRUE(t.flow->step(2e-4).ok());
  t.before.note(t.flow->samples());
  t.flow->sample(true);
  ASSERT_TRUE(t.flow->step(2e-4).ok());
  const auto before = t.flow->samples();
  t.run(2e-4);
  const auto after = t.flow->samples();
  int hit = 0;
  Vec3d impulse{};
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec3d then = *t.before.of(before[i].particle.id), now = before[i].particle.velocity;
    const double taken = length(now - then - t.config.gravity * 2e-4);
    EXPECT_LT(length(after[i].particle.velocity - now), 1e-4 * length(now)) << "what is left goes on";
    if (taken <= t.settings.impactAcceleration * 2e-4) {
      EXPECT_EQ(after[i].particle.given, 0.0);
      continue;
    }
    ++hit;
    const double share = -std::expm1(-t.settings.impactWater * taken);
    EXPECT_NEAR(after[i].particle.given / share, 1.0, 1e-3);
    impulse += now * (after[i].particle.given * t.config.particleMass(0));
  }
  EXPECT_GT(hit, 60) << "the lowest layers";
  EXPECT_LT(hit, 512);
  EXPECT_LT(length(t.state.account.impulseToAir - impulse), 3e-2 * length(impulse)) << "not twice";
}

TEST(CloudExchange, NoParticleGivesMoreThanItMay) {
  CloudTest t;
  t.settings.spray = false;
  t.settings.mistRate = 10.0, t.settings.mostGiven = 0.3;
  t.block(6, 6, 2, {0, 0, 3}, {0, 0, -30});
  t.sample();
  for (int k = 0; k < 30; ++k) t.run(0.04);
  for (const FlowSample& s : t.flow->samples()) EXPECT_LE(s.particle.given, 0.3 + 1e-9);
}

TEST(CloudExchange, StillWaterAndSlowSnowGiveNothing) {
  for (const bool snow : {false, true}) {
    CloudTest t(snow);
    t.block(8, 8, 4, {0, 0, 0.05}, {1, 0, 0});
    t.sample();
    t.run(0.1);
    EXPECT_EQ(t.state.account.toAir, 0.0);
    EXPECT_TRUE(t.state.parcels.empty());
  }
}

TEST(CloudExchange, FastSnowGivesPowderNotMist) {
  CloudTest t(true);
  t.settings.spray = false;
  t.block(8, 8, 4, {0, 0, 0.5}, {30, 0, 0});
  t.sample();
  t.run(0.1);
  const AirBudget air = t.grid->budget();
  EXPECT_GT(air.added[static_cast<std::size_t>(AirScalar::Snow)], 0.0);
  EXPECT_EQ(air.added[static_cast<std::size_t>(AirScalar::Mist)], 0.0);
  EXPECT_EQ(air.added[static_cast<std::size_t>(AirScalar::Warmth)], 0.0);
}

TEST(CloudExchange, WarmMistSharesItsHeatWithTheAir) {
  // A breath of it brings all its heat; much of it takes the air to its own temperature and no further.
  for (const double rate : {1e-5, 100.0}) {
    CloudTest t;
    t.settings.spray = false, t.settings.waterWarms = false;
    t.settings.mistRate = rate, t.settings.mostGiven = 0.9;
    t.settings.waterTemperature = t.surrounding.temperature + 10.0;
    t.block(8, 8, 4, {0, 0, 3}, {0, 0, -20});
    t.sample();
    t.run(0.1);
    const AirBudget air = t.grid->budget();
    const double mist = air.added[0], capacity = t.surrounding.carrier.density * kDryAirHeat;
    EXPECT_GT(mist, 0.0);
    const double share = air.added[2] * capacity / (mist * kWaterHeat * 10.0);
    if (rate < 1.0) {
      EXPECT_NEAR(share, 1.0, 1e-3);
    } else {
      EXPECT_LT(share, 0.9);
    }
    for (double x = -2.0; x < 4.0; x += 0.5)
      for (double z = 0.5; z < 8.0; z += 0.5) {
        const Result<std::vector<AirCellNow>> cells = t.grid->cellsAt({{x, 0.5, z}});
        ASSERT_TRUE(cells.ok());
        EXPECT_LE((*cells)[0].densities[2], 10.0 + 1e-4);
      }
  }
}

TEST(CloudExchange, TheAirTearsLumpsToDrops) {
  CloudTest t;
  t.settings.sprayLife = 1e6;
  const CarrierAir& air = t.surrounding.carrier;
  SprayParcel p;
  p.position = {0, 0, 90}, p.velocity = {0, 0, -30}, p.diameter = 0.1, p.units = unitsGiven(1.0) / 100;
  t.state.parcels = {p};
  const double takes = breakUpTime(0.1, 30.0, 1000.0, air.density);
  const double slow = std::sqrt(1000.0 / air.density), weber = air.density * 900.0 * 0.1 / 0.0749;
  EXPECT_NEAR(takes, 0.766 * std::pow(weber - 12.0, 0.25) * slow * 0.1 / 30.0, 1e-9);
  EXPECT_NEAR(breakUpTime(0.1, 60.0, 1000.0, air.density), 5.5 * slow * 0.1 / 60.0, 1e-9);
  const double drop = largestDrop(30.0, air.density);
  t.run(0.01, false);
  EXPECT_NEAR(t.state.parcels.at(0).diameter, drop + (0.1 - drop) * std::exp(-0.01 / takes), 1e-9);
  for (int k = 0; k < 400; ++k) t.run(0.01, false);
  EXPECT_LT(t.state.parcels.at(0).diameter, 3e-3);
  EXPECT_GT(t.state.parcels.at(0).diameter, 5e-4);
  EXPECT_EQ(breakUpTime(0.1, 0.5, 1000.0, air.density), HUGE_VAL) << "a breath tears nothing";
}

TEST(CloudExchange, ADropThatFliesReachesItsTerminalSpeedAndLands) {
  CloudTest t;
  t.settings.lumpDiameter = t.settings.dropDiameter;
  t.settings.sprayLife = 1e6;
  t.block(1, 1, 1, {0, 0, 40}, {0, 0, 0});
  t.sample();
  t.run(0.04);
  ASSERT_EQ(t.state.parcels.size(), 1u);
  EXPECT_EQ(t.flow->samples().size(), 0u) << "it has left the flow";
  const double drop = t.state.parcels[0].diameter;
  for (int k = 0; k < 50; ++k) t.run(0.04);
  ASSERT_EQ(t.state.parcels.size(), 1u);
  const SprayParcel& p = t.state.parcels[0];
  const Vec3d wind = t.grid->velocities({p.position})[0];
  EXPECT_NEAR(length(p.velocity - wind) / sphereTerminalSpeed(drop, 1000.0, t.surrounding.carrier), 1.0, 0.25)
      << "the air goes along";
  for (int k = 0; k < 400 && !t.state.parcels.empty(); ++k) t.run(0.04);
  EXPECT_TRUE(t.state.parcels.empty());
  ASSERT_EQ(t.rejoining.size(), 1u) << "much of a particle flows on";
  EXPECT_GE(t.rejoining[0].position.z, 0.0);
  EXPECT_GE(t.rejoining[0].velocity.z, -1e-6);
  EXPECT_NEAR(t.state.account.toFlow / t.config.particleMass(0), 1.0, 1e-2);
}

TEST(CloudExchange, ADropFallsBackIntoThePoolThatItFliesOver) {
  CloudTest t;
  t.block(16, 16, 8, {0, 0, 0.05}, {});
  t.sample();
  SprayParcel p;
  p.position = {0.8, 0.8, 2.0}, p.velocity = {0, 0, -5}, p.diameter = 2e-3, p.units = unitsGiven(1.0);
  t.state.parcels = {p};
  p.units = unitsGiven(0.1), p.position.x = 0.5;
  t.state.parcels.push_back(p);
  t.film = 1.0;
  t.settings.sprayLife = 1e6;
  for (int k = 0; k < 20 && !t.state.parcels.empty(); ++k) t.run(0.04);
  ASSERT_EQ(t.rejoining.size(), 1u);
  EXPECT_NEAR(t.rejoining[0].position.z, 0.85, 0.2) << "at the surface, not at the bottom";
  double gathered = 0.0;
  for (const FlowSample& s : t.flow->samples()) gathered -= s.particle.given;
  EXPECT_NEAR(gathered, 0.1, 1e-5) << "a small one is taken in by a particle that is there";
}

TEST(CloudExchange, SprayFraysIntoMistByItsLife) {
  CloudTest t;
  SprayParcel p;
  p.position = {0, 0, 90}, p.diameter = t.settings.dropDiameter, p.units = unitsGiven(1.0);
  t.state.parcels = {p};
  t.settings.sprayLife = 1.0;
  for (int k = 0; k < 10; ++k) t.run(0.1, false);
  EXPECT_NEAR(t.sprayMass() / t.config.particleMass(0), std::exp(-1.0), 1e-3);
  EXPECT_NEAR(t.grid->budget().added[0] / t.config.particleMass(0), 1.0 - std::exp(-1.0), 1e-3);
}

TEST(CloudExchange, BeyondTheMostParcelsWhatIsAloneStaysInTheFlow) {
  CloudTest t;
  t.settings.mostDrops = 2;
  for (int k = 0; k < 5; ++k) t.block(1, 1, 1, {2.0 * k, 0, 10}, {0, 0, -3});
  t.sample();
  t.run(0.01);
  EXPECT_EQ(t.state.parcels.size(), 2u);
  EXPECT_EQ(t.flow->samples().size(), 3u);
  EXPECT_EQ(t.state.account.refused, 3u);
}

TEST(CloudExchange, WhatSettlesInFrostIsSnowForTheCoverAndWaterInThaw) {
  for (const double kelvin : {263.15, 278.15}) {
    CloudTest t;
    t.surrounding = SurroundingAir::of(kelvin, 101325.0, 0.9);
    AirSource low, high;
    low.position = {0, 0, 0.2}, low.amounts = {2.0, 0.5, 0, 0};
    high.position = {0, 0, 20}, high.amounts = {1.0, 0, 0, 0};
    ASSERT_TRUE(t.grid->add({low, high}).ok());
    t.grid->setSettling(1e3);
    t.run(0.1, false);
    double covered = 0.0;
    for (const SnowGrain& g : t.cover.falling) covered += g.kilograms;
    const bool frost = kelvin < 273.15;
    EXPECT_NEAR(covered, frost ? 2.5 : 0.5, 1e-6);
    EXPECT_NEAR(t.state.account.ranOff, frost ? 0.0 : 3.0, 1e-6);
    EXPECT_NEAR(t.state.account.onThings, frost ? 1.0 : 0.0, 1e-6) << "up there it hangs on a wall";
    EXPECT_NEAR(t.state.account.settled, covered, 1e-12);
  }
}

AirConfig twoMetres() {
  AirConfig config;
  config.cell = 2.0;
  return config;
}

TEST(AirContact, NoStepOvershootsWaterOrSaturation) {
  const SurroundingAir air = SurroundingAir::of(273.15, 101325.0, 0.5);
  const double water = 283.15, volume = 8.0;
  const WaterContact strong{{1, 1, 1}, {}, 1e9, 0.0, 1e-9, 100.0, 100.0};
  FakeAir calm{twoMetres()};
  const ContactEffect all = *exchangeHeat({strong}, calm, water, air, 1.0);
  ASSERT_EQ(all.sources.size(), 1u);
  EXPECT_NEAR(all.sources[0].amounts[2] / volume, 10.0, 1e-9);
  EXPECT_NEAR(all.sources[0].amounts[3] / volume / air.excessOver(water), 1.0, 1e-6);
  EXPECT_NEAR(all.vapour[0], all.sources[0].amounts[3], 1e-12);
  // In a short time as Newton's law says, and each contact by its share.
  WaterContact weak = strong, weaker = strong;
  weak.conductance = 3.0, weaker.conductance = 1.0;
  const ContactEffect some = *exchangeHeat({weak, weaker}, calm, water, air, 0.1);
  EXPECT_NEAR(some.sources[0].amounts[2] * air.carrier.density * kDryAirHeat / (4.0 * 10.0 * 0.1), 1.0, 1e-4);
  EXPECT_NEAR(some.vapour[0] / some.vapour[1], 3.0, 5e-3);
}

TEST(AirContact, ColdWaterTakesVapourOutOfMoistAir) {
  const SurroundingAir air = SurroundingAir::of(293.15, 101325.0, 0.9);
  FakeAir moist{twoMetres()};
  const ContactEffect effect =
      *exchangeHeat({{{1, 1, 1}, {}, 1e3, 0.0, 1e-9, 1.0, 1e-3}}, moist, 278.15, air, 1.0);
  EXPECT_LT(effect.sources[0].amounts[2], 0.0);
  EXPECT_NEAR(effect.vapour[0], -1e-3, 1e-8) << "no more than it has room for";
}

TEST(FlowCells, FindsAllThatIsNear) {
  FlowConfig c;
  c.spacing = 0.1;
  auto particles = testing::lattice(c, 9, 7, 5, 0.45, {-1, 2, 3});
  std::vector<FlowSample> samples;
  for (const FlowParticle& p : particles) samples.push_back({p});
  const FlowCells cells(samples, 0.25);
  for (const Vec3d p :
       {Vec3d{-0.7, 2.3, 3.2}, Vec3d{-1.1, 1.95, 3.0}, Vec3d{5, 5, 5}, Vec3d{-0.15, 2.6, 3.45}}) {
    int expected = 0;
    for (const FlowParticle& q : particles) expected += length(q.position - p) < 0.25 ? 1 : 0;
    EXPECT_EQ(cells.count(p), expected);
  }
  EXPECT_EQ(FlowCells({}, 0.25).count({}), 0);
}

}  // namespace
}  // namespace spin
