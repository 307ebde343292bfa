// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>
#include <limits>

#include "core/sph/flow_state.h"
#include "tests/support/flow_contract.h"

/// Keeping and taking up a state, sinks, samples and changes under way: see flow_contract.h.
namespace spin::contract {

template <class Traits>
class FlowStateContract : public FlowContract<Traits> {
 protected:
  /// A stirred block that falls on a floor, with friction, smoothing, wind and a box that it leaves.
  static FlowConfig config() {
    FlowConfig c = testing::freeConfig(24, 24, 24);
    c.walls.planes = {{{0, 0, 4 * c.spacing}, {0, 0, 1}, {}, 0}};
    c.walls.surfaces = {{WallFriction::Coulomb, 0.3f, 0.01f}};
    c.smoothing = 0.2;
    c.windDrag = 0.1;
    c.wind = {5, 0, 0};
    c.leapFrog = true;
    Rheology& r = c.materials[0].rheology;
    r.law = RheologyLaw::Yield;
    r.cohesion = 3.0f;
    r.most = 5.0f;
    return c;
  }
  static std::vector<FlowParticle> block(const FlowConfig& c) {
    const double s = c.spacing;
    auto particles = testing::lattice(c, 10, 10, 10, 0.2, {6 * s, 6 * s, 5 * s});
    testing::stir(particles, 1.0);
    return particles;
  }
};
TYPED_TEST_SUITE_P(FlowStateContract);

inline bool sameBits(const FlowSolverState& a, const FlowSolverState& b) {
  const auto same = [](const auto& p, const auto& q) {
    return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size() * sizeof(p[0])) == 0;
  };
  const FlowHostState &p = a.particles, &q = b.particles;
  return same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z) && same(p.records, q.records) &&
         same(p.extras, q.extras) && same(p.ids, q.ids) && same(p.excess, q.excess) &&
         same(p.given, q.given) && a.nextId == b.nextId && a.lastStep == b.lastStep &&
         a.losses.left == b.losses.left && a.losses.sunk == b.losses.sunk &&
         a.losses.taken == b.losses.taken && a.losses.leftGiven == b.losses.leftGiven &&
         a.losses.sunkGiven == b.losses.sunkGiven && a.losses.takenGiven == b.losses.takenGiven;
}

TYPED_TEST_P(FlowStateContract, GoesOnFromAStateBitForBit) {
  for (int variant = 0; variant < 4; ++variant) {
    FlowConfig c = this->config();
    if (variant == 1) c.density = DensityMode::Continuity;
    if (variant >= 2) c.pressure = PressureMode::Implicit, c.leapFrog = false;
    if (variant == 3) c.viscosity = ViscosityMode::Auto, c.materials[0].rheology.most = 500.0f;
    const Solver straight = this->start(c, this->block(c));
    const Solver other = this->start(c, {});
    this->run(*straight, 2e-4, 12);
    ASSERT_TRUE(other->restore(straight->state()).ok());
    EXPECT_TRUE(sameBits(straight->state(), other->state())) << "variant " << variant;
    for (Solver const* solver : {&straight, &other}) {
      this->run(**solver, 2e-4, 5);
      ASSERT_TRUE((*solver)->add({{c.domainMin + Vec3d{2, 2, 20} * c.spacing, {}, 0, 0}}).ok());
      this->run(**solver, 2e-4, 5);
    }
    EXPECT_TRUE(sameBits(straight->state(), other->state())) << "variant " << variant;
    EXPECT_EQ(straight->samples().back().particle.id, 1000u);
  }
}

TYPED_TEST_P(FlowStateContract, AStateThatDoesNotFitIsRefusedAndChangesNothing) {
  const FlowConfig c = this->config();
  const Solver solver = this->start(c, this->block(c));
  this->run(*solver, 2e-4, 2);
  const FlowSolverState good = solver->state();
  const auto refuses = [&](const auto& change) {
    FlowSolverState bad = good;
    change(bad);
    const Status status = solver->restore(bad);
    return !status.ok() && sameBits(solver->state(), good);
  };
  EXPECT_TRUE(refuses([](FlowSolverState& s) { s.particles.y.pop_back(); }));
  EXPECT_TRUE(refuses([](FlowSolverState& s) { s.particles.excess.push_back(0.0f); }));
  EXPECT_TRUE(refuses([](FlowSolverState& s) { s.particles.x[7] = -1; }));
  EXPECT_TRUE(refuses([](FlowSolverState& s) { s.particles.z[7] = INT32_MAX; }));
  EXPECT_TRUE(refuses([](FlowSolverState& s) { s.particles.extras[3].material = 3; }));
  EXPECT_TRUE(refuses([](FlowSolverState& s) { s.particles.ids[3] = 5000; }));
  EXPECT_TRUE(refuses(
      [](FlowSolverState& s) { s.particles.records[9].vy = std::numeric_limits<float>::infinity(); }));
  EXPECT_TRUE(refuses([](FlowSolverState& s) { s.lastStep = std::nan(""); }));
}

TYPED_TEST_P(FlowStateContract, SinksAndTheDomainCountWhatTheyTake) {
  FlowConfig c = this->config();
  c.gravity = {};
  c.windDrag = 0.0;
  const double s = c.spacing;
  FlowSinkConfig box;
  box.low = {0, 0, 0}, box.high = {7 * s, 24 * s, 24 * s};
  FlowSinkConfig plane;
  plane.point = {15 * s, 0, 0}, plane.normal = {-1, 0, 0};
  const Solver solver = this->start(c, testing::lattice(c, 10, 10, 10, 0.0, {6 * s, 6 * s, 6 * s}));
  this->run(*solver, 1e-6, 1);
  EXPECT_EQ(solver->losses().sunk[0], 0u);
  c.sinks = {box, plane};
  ASSERT_TRUE(solver->reconfigure(c).ok());
  this->run(*solver, 1e-6, 1);
  EXPECT_EQ(solver->losses().sunk[0], 200u) << "a layer at 6.5 s and one at 15.5 s";
  EXPECT_EQ(solver->samples().size(), 800u);
  this->run(*solver, 1e-6, 2);
  EXPECT_EQ(solver->losses().sunk[0], 200u) << "each is counted once";
  EXPECT_EQ(solver->count(), 800u);
  c.sinks.clear();
  c.windDrag = 50.0;
  c.wind = {0, 0, 300};
  ASSERT_TRUE(solver->reconfigure(c).ok());
  this->runFor(*solver, 0.3);
  const FlowLosses losses = solver->losses();
  EXPECT_EQ(losses.left[0] + losses.sunk[0] + solver->samples().size(), 1000u);
  EXPECT_EQ(losses.left[0], 800u) << "blown out of the box";
}

TYPED_TEST_P(FlowStateContract, ReconfiguringKeepsParticlesAndRefusesAnotherLayout) {
  FlowConfig c = this->config();
  const Solver solver = this->start(c, this->block(c));
  this->run(*solver, 2e-4, 2);
  const FlowSolverState before = solver->state();
  FlowConfig finer = c;
  finer.spacing *= 0.5;
  EXPECT_FALSE(solver->reconfigure(finer).ok());
  FlowConfig larger = c;
  larger.domainMax.x *= 2.0;
  EXPECT_FALSE(solver->reconfigure(larger).ok());
  FlowConfig broken = c;
  broken.wind.x = std::nan("");
  EXPECT_FALSE(solver->reconfigure(broken).ok());
  EXPECT_TRUE(sameBits(solver->state(), before));
  c.gravity = {0, 0, 0};
  c.walls.surfaces[0].tangent = 1.0f;
  EXPECT_TRUE(solver->reconfigure(c).ok());
  EXPECT_TRUE(sameBits(solver->state(), before));
}

/// What is left of the mass of particles that are there or were taken, in whole kGivenUnit.
inline std::int64_t unitsLeft(const FlowSolver& solver) {
  std::int64_t sum = 0;
  for (const FlowSample& s : solver.samples()) sum += unitsGiven(1.0 - s.particle.given);
  const FlowLosses losses = solver.losses();
  for (std::size_t m = 0; m < kMostMaterials; ++m)
    sum += static_cast<std::int64_t>(losses.left[m] + losses.sunk[m] + losses.taken[m]) * unitsGiven(1.0) -
           losses.leftGiven[m] - losses.sunkGiven[m] - losses.takenGiven[m];
  return sum;
}

TYPED_TEST_P(FlowStateContract, AnExchangeChangesWhatItNamesAndNothingElse) {
  const FlowConfig c = this->config();
  const Solver solver = this->start(c, this->block(c));
  this->run(*solver, 2e-4, 3);
  solver->sample(true);
  this->run(*solver, 2e-4, 1);
  const auto before = solver->samples();
  std::vector<FlowExchange> changes;
  for (const std::uint32_t id : {900u, 3u, 411u})
    changes.push_back({id, before[id].particle.velocity + Vec3d{0.5, -0.25, 1.0}, 0.125, id == 411u});
  ASSERT_TRUE(solver->exchange(changes).ok());
  const auto after = solver->samples();
  ASSERT_EQ(after.size(), 999u);
  for (const FlowSample& s : after) {
    const FlowSample& old = before[s.particle.id];
    const bool named = s.particle.id == 900 || s.particle.id == 3;
    const Vec3d gain = s.particle.velocity - old.particle.velocity;
    EXPECT_LT(length(gain - (named ? Vec3d{0.5, -0.25, 1.0} : Vec3d{})), 1e-6);
    EXPECT_EQ(s.particle.given, named ? 0.125 : 0.0);
    EXPECT_EQ(s.particle.position, old.particle.position);
    EXPECT_EQ(s.neighbours, old.neighbours) << "what was sampled stays";
  }
  EXPECT_EQ(solver->losses().taken[0], 1u);
  EXPECT_EQ(solver->losses().takenGiven[0], unitsGiven(0.125));
  this->run(*solver, 2e-4, 3);
  EXPECT_EQ(solver->count(), 999u);
  EXPECT_EQ(solver->losses().taken[0], 1u) << "counted once";
  EXPECT_EQ(solver->samples()[3].particle.given, 0.125) << "carried along";
}

TYPED_TEST_P(FlowStateContract, WhatParticlesGaveLeavesWithThemAndIsKept) {
  FlowConfig c = this->config();
  c.windDrag = 50.0;
  c.wind = {0, 0, 300};
  FlowSinkConfig box;
  box.low = {0, 0, 0}, box.high = {8 * c.spacing, 24 * c.spacing, 24 * c.spacing};
  const Solver straight = this->start(c, this->block(c)), other = this->start(c, {});
  this->run(*straight, 2e-4, 2);
  std::vector<FlowExchange> changes;
  std::int64_t given = 0;
  for (const FlowSample& s : straight->samples())
    if (s.particle.id % 3 == 0) {
      changes.push_back(
          {s.particle.id, s.particle.velocity, 1e-3 * (s.particle.id % 500) - 0.1, s.particle.id % 60 == 0});
      given += unitsGiven(changes.back().given);
    }
  ASSERT_TRUE(straight->exchange(changes).ok());
  EXPECT_EQ(unitsLeft(*straight), std::int64_t{1000} * unitsGiven(1.0) - given);
  // Came back with less than a whole particle's mass.
  FlowParticle back;
  back.position = c.domainMin + Vec3d{12, 12, 20} * c.spacing, back.given = 0.75;
  ASSERT_TRUE(straight->add({back}).ok());
  ASSERT_TRUE(other->restore(straight->state()).ok());
  c.sinks = {box};
  for (Solver const* solver : {&straight, &other}) {
    ASSERT_TRUE((*solver)->reconfigure(c).ok());
    this->run(**solver, 2e-4, 5);
  }
  EXPECT_TRUE(sameBits(straight->state(), other->state()));
  EXPECT_GT(straight->losses().sunkGiven[0], 0);
  this->runFor(*straight, 0.3);
  EXPECT_GT(straight->losses().left[0], 0u);
  EXPECT_GT(straight->losses().leftGiven[0], 0);
  EXPECT_EQ(unitsLeft(*straight), std::int64_t{1000} * unitsGiven(1.0) - given + unitsGiven(0.25));
}

TYPED_TEST_P(FlowStateContract, AnExchangeThatCannotBeChangesNothing) {
  const FlowConfig c = this->config();
  const Solver solver = this->start(c, this->block(c));
  this->run(*solver, 2e-4, 2);
  const FlowSolverState good = solver->state();
  const FlowExchange fine{7, {1, 2, 3}, 0.5, false};
  const auto refuses = [&](const FlowExchange& bad) {
    return !solver->exchange({fine, bad}).ok() && sameBits(solver->state(), good);
  };
  EXPECT_TRUE(refuses({1000, {}, 0.0, false})) << "no such particle";
  EXPECT_TRUE(refuses({7, {}, 0.0, false})) << "twice";
  EXPECT_TRUE(refuses({8, {std::nan(""), 0, 0}, 0.0, false}));
  EXPECT_TRUE(refuses({8, {}, 1.5, false}));
  ASSERT_TRUE(solver->exchange({{8, {}, 1.0, true}}).ok());
  EXPECT_FALSE(solver->exchange({{8, {}, 1.0, true}}).ok()) << "it is gone";
}

TYPED_TEST_P(FlowStateContract, AfterAnotherFormOfPressureItGoesOnAsIfItHadNeverHadIt) {
  FlowConfig c = this->config(), other = c;
  c.leapFrog = other.leapFrog = false;
  c.pressure = PressureMode::Implicit;
  c.walls.planes[0].point.z = other.walls.planes[0].point.z = 5 * c.spacing;
  const Solver changed = this->start(c, this->block(c)), fresh = this->start(other, {});
  this->run(*changed, 2e-4, 12);
  ASSERT_TRUE(fresh->restore(changed->state()).ok());
  ASSERT_TRUE(changed->reconfigure(other).ok());
  for (Solver const* solver : {&changed, &fresh}) this->run(**solver, 2e-4, 5);
  EXPECT_TRUE(sameBits(changed->state(), fresh->state()));
}

TYPED_TEST_P(FlowStateContract, NoStepIsSoLongThatWindIsOvershot) {
  for (const PressureMode pressure : {PressureMode::EquationOfState, PressureMode::Implicit}) {
    FlowConfig c = testing::freeConfig(24, 24, 24);
    c.pressure = pressure;
    c.windDrag = 1000.0;
    c.wind = {60, 0, 0};
    const double s = c.spacing;
    const Solver solver = this->start(c, testing::lattice(c, 1, 1, 1, 0.0, {12 * s, 12 * s, 12 * s}));
    double before = 0.0;
    for (int step = 0; step < 4; ++step) {
      this->run(*solver, 5e-4, 1);
      ASSERT_EQ(solver->samples().size(), 1u);
      const double speed = solver->samples()[0].particle.velocity.x;
      EXPECT_GE(speed, before);
      EXPECT_LE(speed, 60.0 * (1.0 + 1e-6));
      before = speed;
    }
    EXPECT_GT(before, 55.0);
  }
}

TYPED_TEST_P(FlowStateContract, ASampledStepTellsNeighboursAndTheWholeAcceleration) {
  FlowConfig c = testing::freeConfig(12, 12, 12);
  c.materials[0].rheology.viscosity = 0.0f;
  const Solver solver = this->start(c, testing::lattice(c, 8, 8, 8, 0.0, Vec3d{2, 2, 2} * c.spacing));
  this->run(*solver, kNow, 1);
  EXPECT_EQ(solver->samples()[0].neighbours, -1);
  const auto velocities = solver->samples();
  solver->sample(true);
  const double seconds = this->run(*solver, 1e-5, 1);
  int inner = 0, corner = 0;
  const auto samples = solver->samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3d change = samples[i].particle.velocity - velocities[i].particle.velocity;
    EXPECT_LT(length(samples[i].pairAcceleration - change * (1.0 / seconds)), 0.05) << i;
    inner += samples[i].neighbours == 26 ? 1 : 0;
    corner += samples[i].neighbours <= 7 ? 1 : 0;
  }
  EXPECT_EQ(inner, 6 * 6 * 6) << "those two spacings away are at the very end of the support";
  EXPECT_EQ(corner, 8);
  solver->sample(false);
  this->run(*solver, 1e-5, 1);
  EXPECT_EQ(solver->samples()[0].neighbours, -1);
}

TYPED_TEST_P(FlowStateContract, TurbulentGroundHoldsWithTheSquareOfTheSpeed) {
  // A sheet that slides at v on a rough floor: d v / dt = -k v^2 / depth.
  FlowConfig c = testing::boxConfig(12, 12, 24);
  c.walls.surfaces = {{WallFriction::Coulomb, 0.0f, 0.05f}};
  c.materials[0].rheology.viscosity = 5000.0f;  // a plug
  c.smoothing = 0.5;
  auto particles = testing::lattice(c, 12, 12, 4);
  for (FlowParticle& p : particles) p.velocity = {4.0, 0.0, 0.0};
  const Solver solver = this->start(c, particles);
  const double seconds = 0.003, depth = 4 * c.spacing;  // before it bounces off the floor
  this->runFor(*solver, seconds);
  double speed = 0.0;
  for (const FlowSample& s : solver->samples()) speed += s.particle.velocity.x;
  speed /= static_cast<double>(particles.size());
  const double expected = 4.0 / (1.0 + 0.05 * 4.0 * seconds / depth);
  EXPECT_NEAR((4.0 - speed) / (4.0 - expected), 1.0, 0.02);
}

REGISTER_TYPED_TEST_SUITE_P(
    FlowStateContract, GoesOnFromAStateBitForBit, AStateThatDoesNotFitIsRefusedAndChangesNothing,
    SinksAndTheDomainCountWhatTheyTake, ReconfiguringKeepsParticlesAndRefusesAnotherLayout,
    AfterAnotherFormOfPressureItGoesOnAsIfItHadNeverHadIt, NoStepIsSoLongThatWindIsOvershot,
    ASampledStepTellsNeighboursAndTheWholeAcceleration, AnExchangeChangesWhatItNamesAndNothingElse,
    WhatParticlesGaveLeavesWithThemAndIsKept, AnExchangeThatCannotBeChangesNothing,
    TurbulentGroundHoldsWithTheSquareOfTheSpeed);

}  // namespace spin::contract
