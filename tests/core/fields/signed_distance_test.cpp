// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/signed_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/random.h"
#include "core/fields/mesh_distance.h"
#include "tests/support/meshes.h"

namespace spin {
namespace {

using Field = std::shared_ptr<const SignedDistance>;

Field make(const TriangleMesh& mesh, double cell, double reach, double least = 0.0, int threads = 2) {
  SignedDistanceOptions options;
  options.cell = cell;
  options.reach = reach;
  options.leastThickness = least;
  options.threads = threads;
  auto made = SignedDistance::make(mesh, options);
  if (!made) throw std::runtime_error(made.error().text());
  return *made;
}

std::optional<SignedDistanceView::Value> at(const SignedDistance& field, Vec3d p) {
  SignedDistanceView::Value value;
  const Vec3f f = p.to<float>();
  if (!field.view({}).sample(f.x, f.y, f.z, value)) return {};
  return value;
}

double boxDistance(Vec3d p, Vec3d half) {
  const Vec3d q{std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
  const Vec3d out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return length(out) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

Vec3d draw(std::uint64_t i, double range) {
  const CounterRandom random{3, 9};
  const auto u = [&](std::uint32_t d) { return range * (2.0 * random.uniformDouble(i, d) - 1.0); };
  return {u(0), u(1), u(2)};
}

TEST(SignedDistanceTest, OfABoxIsThatOfTheFormulaWithinAQuarterOfACell) {
  const double spacing = 0.1;
  const Field field = make(testing::cubeMesh(1.0), 0.5 * spacing, 0.2);
  int checked = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Vec3d p = draw(i, 0.72);
    const double exact = boxDistance(p, {0.5, 0.5, 0.5});
    if (exact > 0.19 || exact < -0.2 * spacing) continue;  // deeper the middle planes of edges are rounded
    const auto value = at(*field, p);
    ASSERT_TRUE(value) << p.x << " " << p.y << " " << p.z;
    ASSERT_NEAR(static_cast<double>(value->distance), exact, 0.25 * field->cell())
        << p.x << " " << p.y << " " << p.z;
    ++checked;
  }
  EXPECT_GT(checked, 5000);
}

TEST(SignedDistanceTest, OfASphereHasDistanceAndNormal) {
  const Field field = make(testing::sphereMesh(1.0, 4), 0.05, 0.2);
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Vec3d p = draw(i, 1.3);
    const double r = length(p);
    if (std::abs(r - 1.0) > 0.19) continue;
    const auto value = at(*field, p);
    ASSERT_TRUE(value);
    ASSERT_NEAR(static_cast<double>(value->distance), r - 1.0, 5e-3);
    const Vec3d g = Vec3f{value->x, value->y, value->z}.to<double>();
    ASSERT_GT(dot(normalized(g), p / r), 0.995);
  }
}

TEST(SignedDistanceTest, DeepInsideIsSolidAndFarOutsideIsNothingAtLittleMemory) {
  const Field field = make(testing::cubeMesh(6.0), 0.05, 0.2);
  const auto deep = at(*field, {1.0, -2.0, 1.5});
  ASSERT_TRUE(deep);
  EXPECT_FLOAT_EQ(deep->distance, -0.2f);
  EXPECT_FALSE(at(*field, {0, 0, 3.0 + 1.5}));
  EXPECT_FALSE(at(*field, {100, 0, 0}));
  EXPECT_FALSE(at(*field, {std::numeric_limits<double>::quiet_NaN(), 0, 0}));
  // The band is a shell round 216 m2.
  EXPECT_LT(field->bytes(), 2.0 * 216.0 * 3 * 0.4 / std::pow(0.05, 3) * sizeof(float));
}

TEST(SignedDistanceTest, WindingDoesNotMatterAndShellsAreJoined) {
  TriangleMesh mesh = testing::joined(testing::boxMesh({0, 0, 0}, {1, 1, 1}),
                                      testing::boxMesh({0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}));
  std::swap(mesh.indices[1], mesh.indices[2]);  // one triangle
  for (std::size_t t = 12; t < 24; ++t)
    std::swap(mesh.indices[3 * t], mesh.indices[3 * t + 1]);  // a whole box
  const Field field = make(mesh, 0.05, 0.2);
  EXPECT_LT(at(*field, {0.9, 0.9, 0.9})->distance, 0.0f) << "inside both";
  EXPECT_LT(at(*field, {0.55, 0.55, 0.55})->distance, 0.0f) << "by the second's corner, inside the first";
  EXPECT_LT(at(*field, {1.45, 1.45, 1.0})->distance, 0.0f);
  EXPECT_GT(at(*field, {1.05, 0.4, 0.4})->distance, 0.0f);
}

TEST(SignedDistanceTest, PseudonormalsTellTheSideAtEdgesAndCorners) {
  // A wedge whose edge is sharper than any face normal can decide alone.
  TriangleMesh wedge;
  wedge.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0.05}, {1, 1, 0.05}, {1, 0, -0.05}, {1, 1, -0.05}};
  wedge.indices = {0, 2, 1, 1, 2, 3, 0, 1, 4, 1, 5, 4, 2, 4, 3, 3, 4, 5, 0, 4, 2, 1, 3, 5};
  const auto shells = makeMeshShells(wedge);
  ASSERT_TRUE(shells.ok());
  ASSERT_EQ(shells->shells.size(), 1u);
  ASSERT_TRUE(shells->closed());
  const ShellDistance distance(*shells, 0);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Vec3d d = draw(i, 0.4);
    const Vec3d p{-std::abs(d.x) - 1e-3, 0.5 + d.y, d.z};  // before the edge: outside
    EXPECT_GT(*distance.signedDistance(p - shells->origin, 10.0), 0.0);
    const Vec3d q{0.3 + 0.5 * std::abs(d.x), 0.5 + d.y, 0.01 * d.z};
    EXPECT_LT(*distance.signedDistance(q - shells->origin, 10.0), 0.0);
  }
}

TEST(SignedDistanceTest, SheetsAndThinSolidsActAsPlatesOfTheLeastThickness) {
  const double spacing = 0.1;
  TriangleMesh one;
  one.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  one.indices = {0, 1, 2};
  const TriangleMesh plate = testing::boxMesh({-1, -1, -0.005}, {1, 1, 0.005});
  for (const TriangleMesh& mesh : {one, plate}) {
    const Field field = make(mesh, 0.5 * spacing, 0.2, spacing);
    for (double z = -0.2; z <= 0.2; z += 0.013) {
      const auto value = at(*field, {0.02, -0.3, z});
      ASSERT_TRUE(value);
      ASSERT_NEAR(static_cast<double>(value->distance), std::abs(z) - 0.5 * spacing,
                  0.03 * spacing + 0.25 * spacing * (std::abs(z) < 0.05))
          << z;
      if (std::abs(z) > 0.06) {
        ASSERT_GT(static_cast<double>(value->z) * z, 0.0) << "away from the plate";
      }
    }
    EXPECT_LT(at(*field, {0.02, -0.3, 0.0})->distance, -0.2f * static_cast<float>(spacing));
  }
  // What is thick enough stays as it is.
  const Field thick = make(testing::cubeMesh(1.0), 0.05, 0.2, spacing);
  EXPECT_NEAR(at(*thick, {0.51, 0.1, 0.1})->distance, 0.01, 2e-3);
}

TEST(SignedDistanceTest, ThreadsDoNotChangeABitAndCancelStops) {
  const TriangleMesh mesh = testing::sphereMesh(1.0, 2);
  const Field one = make(mesh, 0.05, 0.2, 0.1, 1), four = make(mesh, 0.05, 0.2, 0.1, 4);
  EXPECT_EQ(one->values(), four->values());
  EXPECT_EQ(one->blocks(), four->blocks());
  SignedDistanceOptions options;
  options.cell = 0.05;
  options.reach = 0.2;
  options.cancel.cancel();
  const auto stopped = SignedDistance::make(mesh, options);
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
}

TEST(SignedDistanceTest, RefusesWhatCannotBe) {
  SignedDistanceOptions options;
  options.cell = 1e-6;
  options.reach = 1e-5;
  EXPECT_EQ(SignedDistance::make(testing::cubeMesh(10.0), options).error().kind, ErrorKind::OutOfResources);
  options.cell = 1e-3;
  options.reach = 2e-2;
  options.mostBytes = 1e6;
  EXPECT_EQ(SignedDistance::make(testing::cubeMesh(1.0), options).error().kind, ErrorKind::OutOfResources);
  options = {};
  EXPECT_FALSE(SignedDistance::make(testing::cubeMesh(1.0), options).ok()) << "no cell";
  options.cell = options.reach = 0.1;
  TriangleMesh bad = testing::cubeMesh(1.0);
  bad.positions[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(SignedDistance::make(bad, options).ok());
  bad = testing::cubeMesh(1.0);
  bad.indices[4] = 8;
  EXPECT_FALSE(SignedDistance::make(bad, options).ok());
  bad.indices.clear();
  EXPECT_FALSE(SignedDistance::make(bad, options).ok());
  bad.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  bad.indices = {0, 1, 2};
  EXPECT_FALSE(SignedDistance::make(bad, options).ok()) << "no area";
}

}  // namespace
}  // namespace spin
