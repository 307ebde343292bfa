// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/fields/mesh_distance.h"
#include "core/math/transform.h"
#include "tests/support/flow_scenes.h"
#include "tests/support/meshes.h"

/// What solids of every kind must do to particles on every device: let none through. Instantiate
/// FlowWallsContract with the struct that FlowContract takes.
namespace spin::contract {

template <class Traits>
class FlowWallsContract : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string why;
    if (!Traits::available(why)) GTEST_SKIP() << why;
  }

  /// Everything that a test throws: no gravity, 10 m/s, room to fly off.
  static FlowConfig openConfig() {
    FlowConfig c;
    c.spacing = 0.05;
    c.materials[0].soundSpeed = 100.0;
    c.gravity = {};
    c.domainMin = {-1, -1, -1};
    c.domainMax = {1, 1, 1};
    return c;
  }
  /// A block of 6^3 particles and single ones before it, about `middle`, all with one velocity.
  static std::vector<FlowParticle> shot(const FlowConfig& c, Vec3d middle, Vec3d velocity) {
    const double half = 3 * c.spacing;
    auto particles = testing::lattice(c, 6, 6, 6, 0.2, middle - Vec3d{half, half, half});
    const CounterRandom random{12, 7};
    for (std::uint64_t i = 0; i < 60; ++i) {
      FlowParticle p;
      const auto u = [&](std::uint32_t d) { return 5 * half * (random.uniformDouble(i, d) - 0.5); };
      const Vec3d ahead = normalized(velocity), spread{u(0), u(1), u(2)};
      // Sideways over five half widths, along the way just before the block.
      p.position = middle + spread - ahead * dot(ahead, spread) + ahead * (1.2 * half + 0.1 * (half + u(3)));
      particles.push_back(p);
    }
    for (FlowParticle& p : particles) p.velocity = velocity;
    return particles;
  }
  /// Runs and gives the least `distance` that any particle ever had after a step, in spacings.
  static double deepest(const FlowConfig& c, const std::vector<FlowParticle>& particles, double seconds,
                        const std::function<double(Vec3d)>& distance) {
    auto solver = Traits::make(c);
    if (!solver) throw std::runtime_error(solver.error().text());
    if (const Status added = (*solver)->add(particles); !added)
      throw std::runtime_error(added.error().text());
    double least = 1e30;
    for (int step = 0; seconds > 0.0; ++step) {
      const auto done = (*solver)->step(1.0);
      if (!done) throw std::runtime_error(done.error().text());
      seconds -= done->seconds;
      if (step % 4 != 0) continue;
      for (const FlowSample& s : (*solver)->samples()) least = std::min(least, distance(s.particle.position));
    }
    return least / c.spacing;
  }
};
TYPED_TEST_SUITE_P(FlowWallsContract);

TYPED_TEST_P(FlowWallsContract, OneTriangleStopsWhatComesFromEitherSide) {
  FlowConfig c = this->openConfig();
  typename FlowWallsConfig::MeshWall wall;
  wall.triangles.positions = {{0, -5, -3}, {0, 5, -3}, {0.02, 0, 6}};
  wall.triangles.indices = {0, 1, 2};
  c.walls.meshes = {wall};
  auto particles = this->shot(c, {-0.5, 0, 0}, {10, 0, 0});
  const std::size_t left = particles.size();
  for (const FlowParticle& p : this->shot(c, {0.5, 0, 0}, {-10, 0, 0})) particles.push_back(p);
  auto solver = TypeParam::make(c);
  ASSERT_TRUE(solver.ok()) << solver.error().text();
  ASSERT_TRUE((*solver)->add(particles).ok());
  for (double seconds = 0.0; seconds < 0.08;) {
    seconds += (*solver)->step(1.0)->seconds;
    for (const FlowSample& s : (*solver)->samples()) {
      const double x = s.particle.position.x - 0.02 * (s.particle.position.z + 3) / 9;
      if (s.particle.id < left)
        ASSERT_LT(x, 0.0) << s.particle.id;
      else
        ASSERT_GT(x, 0.0) << s.particle.id;
    }
  }
}

TYPED_TEST_P(FlowWallsContract, ABoxIsEnteredNeitherByFacesNorByEdgesAndCorners) {
  for (const Vec3d turn : {Vec3d{0, 0, 0}, Vec3d{0, 0, 45}, Vec3d{35.264, 0, 45}}) {
    FlowConfig c = this->openConfig();
    typename FlowWallsConfig::MeshWall box;
    box.triangles = testing::cubeMesh(0.5);
    const Transform turned = rotationOfDegrees(turn);
    for (Vec3d& p : box.triangles.positions) p = turned.point(p) + Vec3d{0.3, 0, 0};
    c.walls.meshes = {box};
    const auto shells = makeMeshShells(box.triangles);
    const ShellDistance exact(*shells, 0);
    const double least = this->deepest(c, this->shot(c, {-0.4, 0, 0}, {10, 0, 0}), 0.1, [&](Vec3d p) {
      return *exact.signedDistance(p - shells->origin, 1e30);
    });
    EXPECT_GT(least, -0.1) << turn.x << " " << turn.z;
    EXPECT_LT(least, 1.0) << "they do arrive";
  }
}

TYPED_TEST_P(FlowWallsContract, ThinPlatesAreNotCrossed) {
  FlowConfig c = this->openConfig();
  typename FlowWallsConfig::MeshWall plate;
  plate.triangles = testing::boxMesh({0.0, -3, -3}, {0.004, 3, 3});
  c.walls.meshes = {plate};
  const double least =
      this->deepest(c, this->shot(c, {-0.4, 0, 0}, {10, 3, 0}), 0.08, [](Vec3d p) { return -p.x; });
  EXPECT_GT(least, 0.0);
}

TYPED_TEST_P(FlowWallsContract, SteppedGroundIsNotEntered) {
  FlowConfig c = this->openConfig();
  c.gravity = {0, 0, -9.81};
  const double cell = 0.0625;
  Raster<float> ground(40, 40, -1.2, -1.2, cell);
  TriangleMesh mesh;
  for (int j = 0; j < ground.height; ++j)
    for (int i = 0; i < ground.width; ++i) {
      // Steps of four cells, up at 45 degrees on the whole; each riser is one cell.
      ground.at(i, j) = static_cast<float>(0.25 * std::floor(i / 4.0) - 1.2);
      mesh.positions.push_back({ground.x(i), ground.y(j), static_cast<double>(ground.at(i, j))});
    }
  for (std::uint32_t j = 0; j < 39; ++j)
    for (std::uint32_t i = 0; i < 39; ++i)
      for (const std::uint32_t k : {0u, 1u, 41u, 0u, 41u, 40u}) mesh.indices.push_back(40 * j + i + k);
  c.walls.ground = ground;
  const auto shells = makeMeshShells(mesh);
  const ShellDistance exact(*shells, 0);
  const double least = this->deepest(c, this->shot(c, {-0.45, 0, 0.4}, {8, 1, -6}), 0.12, [&](Vec3d p) {
    const auto near = exact.nearest(p - shells->origin, 1e30);
    return near->normal.z * (p.z - shells->origin.z - near->point.z) +
                       near->normal.x * (p.x - shells->origin.x - near->point.x) <
                   0.0
               ? -near->distance
               : near->distance;
  });
  EXPECT_GT(least, -0.1);
  EXPECT_LT(least, 1.0) << "they do arrive";
}

TYPED_TEST_P(FlowWallsContract, AMeshFloorCarriesLikeAPlane) {
  FlowConfig c = testing::boxConfig(8, 8, 16);
  std::vector<double> pressures;
  for (const bool mesh : {false, true}) {
    if (mesh) {
      typename FlowWallsConfig::MeshWall floor;
      floor.triangles = testing::boxMesh({-1, -1, -0.5}, {2, 2, 0});
      c.walls.planes.clear();
      c.walls.meshes = {floor};
    }
    auto solver = TypeParam::make(c);
    ASSERT_TRUE(solver.ok());
    ASSERT_TRUE((*solver)->add(testing::lattice(c, 8, 8, 4)).ok());
    for (int k = 0; k < 20; ++k) ASSERT_TRUE((*solver)->step(1.0).ok());
    double sum = 0.0;
    for (const FlowSample& s : (*solver)->samples()) sum += s.pressure;
    pressures.push_back(sum);
  }
  EXPECT_NEAR(pressures[1], pressures[0], 2e-3 * pressures[0]);
}

TYPED_TEST_P(FlowWallsContract, RefusesMeshesThatCannotBe) {
  FlowConfig c = this->openConfig();
  c.walls.meshes.resize(1);
  EXPECT_FALSE(TypeParam::make(c).ok()) << "no triangles";
  c.walls.meshes[0].triangles = testing::cubeMesh(0.5);
  c.walls.meshes[0].surface = 7;
  EXPECT_FALSE(TypeParam::make(c).ok()) << "no such surface";
  c.walls.meshes[0].surface = 0;
  SignedDistanceOptions options;
  options.cell = options.reach = 0.01;
  c.walls.meshes[0].field = *SignedDistance::make(testing::cubeMesh(0.5), options);
  EXPECT_FALSE(TypeParam::make(c).ok()) << "a field that is too narrow";
}

REGISTER_TYPED_TEST_SUITE_P(FlowWallsContract, OneTriangleStopsWhatComesFromEitherSide,
                            ABoxIsEnteredNeitherByFacesNorByEdgesAndCorners, ThinPlatesAreNotCrossed,
                            SteppedGroundIsNotEntered, AMeshFloorCarriesLikeAPlane,
                            RefusesMeshesThatCannotBe);

}  // namespace spin::contract
