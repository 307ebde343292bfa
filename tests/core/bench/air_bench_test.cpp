// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What the cases of the air are held against.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/bench/air_flows.h"
#include "core/bench/bubble_reference.h"
#include "core/bench/lid_cavity_reference.h"
#include "core/bench/straight_line.h"

namespace spin {
namespace {

/// Largest difference of the box's velocities from `exact(place)` at their faces' centres.
double mostApart(const AirBox& box, double cell, Vec3d (*exact)(Vec3d)) {
  double most = 0.0;
  box.forEach([&](int i, int j, int k) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d p{i + (axis == 0 ? 0.0 : 0.5), j + (axis == 1 ? 0.0 : 0.5), k + (axis == 2 ? 0.0 : 0.5)};
      const double value = static_cast<double>(box.at(static_cast<AirValue>(axis), i, j, k));
      most = std::max(most, std::abs(value - exact(p * cell)[axis]));
    }
  });
  return most;
}

TEST(AirBox, FindsEveryValueOnce) {
  AirBox box({32, 8, 12});
  float count = 0.0f;
  box.forEach([&](int i, int j, int k) { box.at(AirValue::Snow, i, j, k) = ++count; });
  EXPECT_EQ(count, 32.0f * 8 * 12);
  EXPECT_EQ(box.sum(AirValue::Snow), 0.5 * 3072 * 3073);
  EXPECT_EQ(box.sum(AirValue::Mist) + box.sum(AirValue::Warmth), 0.0);
  // Cell (17, 5, 9) is cell (1, 1, 1) of brick (1, 1, 2), the last but 0.
  const AirState& state = box.state();
  const std::size_t brick = 1 + 2 * (1 + 2 * 2);
  EXPECT_EQ(state.bricks[brick], (std::array<std::int32_t, 3>{1, 1, 2}));
  EXPECT_EQ(state.values[(4 * state.bricks.size() + brick) * kBrickCells + 1 + 16 + 64],
            box.at(AirValue::Snow, 17, 5, 9));
  const AirBox again(state);
  EXPECT_EQ(again.cells(), box.cells());
  EXPECT_EQ(again.at(AirValue::Snow, 31, 7, 11), count);
}

TEST(AirBox, OutflowCountsAllSixFaces) {
  AirBox box({16, 4, 4});
  box.at(AirValue::U, 3, 1, 1) = -0.5f;
  box.at(AirValue::W, 3, 1, 2) = 0.25f;
  EXPECT_EQ(box.mostOutflow(), 0.75);
  EXPECT_EQ(box.face(0, 16, 1, 1), 0.0f);
}

TEST(AirFlows, VorticesAreThoseOfTaylorAndGreen) {
  AirBox box({64, 4, 64});
  setVortices(box, 2.0);
  EXPECT_LT(box.mostOutflow(), 1e-6);
  EXPECT_LT(mostApart(box, 1.0 / 64,
                      [](Vec3d p) {
                        const double k = 2.0 * kPi;
                        return Vec3d{-2.0 * std::sin(k * p.x) * std::cos(k * p.z), 0.0,
                                     2.0 * std::cos(k * p.x) * std::sin(k * p.z)};
                      }),
            2e-3);
}

TEST(AirFlows, TurningGoesRoundOnceASecond) {
  AirBox box({112, 4, 100});
  setTurning(box, 100);
  EXPECT_LT(box.mostOutflow(), 1e-5);
  EXPECT_NEAR(box.at(AirValue::U, 50, 0, 75), -2.0 * kPi * 0.255, 1e-4);
  EXPECT_NEAR(box.at(AirValue::W, 75, 0, 50), 2.0 * kPi * 0.255, 1e-4);
  EXPECT_EQ(box.at(AirValue::W, 50, 0, 99), 0.0f);
}

TEST(AirFlows, DeformationIsThatOfLeVeque) {
  AirBox box({48, 48, 48});
  setDeformation(box, 1.0);
  EXPECT_LT(box.mostOutflow(), 1e-5);
  EXPECT_LT(mostApart(box, 1.0 / 48,
                      [](Vec3d p) {
                        const auto s = [](double x) { return std::sin(kPi * x); };
                        return Vec3d{2.0 * s(p.x) * s(p.x) * s(2 * p.y) * s(2 * p.z),
                                     -s(2 * p.x) * s(p.y) * s(p.y) * s(2 * p.z),
                                     -s(2 * p.x) * s(2 * p.y) * s(p.z) * s(p.z)};
                      }),
            0.01);
}

TEST(AirFlows, DiffusionModeIsAnEigenvectorOfTheLattice) {
  AirBox box({32, 4, 32});
  const int waves = 3;
  setDiffusionMode(box, waves);
  const double sine = std::sin(0.5 * kPi * waves / 32), eigenvalue = 8.0 * sine * sine;
  // u is 0 on the sides in x and mirrored at those in z.
  const auto u = [&](int i, int k) {
    return static_cast<double>(box.face(0, i, 1, std::min(std::max(k, 0), 31)));
  };
  for (int k = 0; k < 32; ++k)
    for (int i = 1; i < 32; ++i) {
      const double laplacian = u(i - 1, k) + u(i + 1, k) + u(i, k - 1) + u(i, k + 1) - 4.0 * u(i, k);
      ASSERT_NEAR(-laplacian, eigenvalue * u(i, k), 1e-6) << i << ", " << k;
    }
}

TEST(LidCavity, ReferenceLiesInTheSquareInOrder) {
  const auto check = [](const auto& points) {
    for (std::size_t k = 0; k < std::size(points); ++k) {
      EXPECT_TRUE(points[k].at > 0.0 && points[k].at < 1.0);
      EXPECT_TRUE(k == 0 || points[k].at < points[k - 1].at);
      for (const double speed : points[k].speed) EXPECT_LT(std::abs(speed), 1.0);
    }
  };
  check(kCavityU);
  check(kCavityV);
  // Extrema at Re 1000 by Botella and Peyret (1998): u -0.3885698 at 0.1717, v 0.3769447 at 0.1578.
  EXPECT_NEAR(kCavityU[10].speed[2], -0.3885698, 1e-4);
  EXPECT_NEAR(kCavityV[10].speed[2], 0.3769447, 1e-4);
}

/// Cosine transform (DCT-II) along one axis of an array of n^axes values, or back.
void transform(std::vector<double>& values, int n, std::size_t stride, bool back) {
  std::vector<double> wave(static_cast<std::size_t>(n * n)), line(static_cast<std::size_t>(n));
  for (int m = 0; m < n; ++m)
    for (int i = 0; i < n; ++i)
      wave[static_cast<std::size_t>(back ? i * n + m : m * n + i)] =
          std::sqrt((m == 0 ? 1.0 : 2.0) / n) * std::cos(kPi * m * (i + 0.5) / n);
  const auto size = static_cast<std::size_t>(n);
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (at / stride % size != 0) continue;
    for (std::size_t row = 0; row < size; ++row) {
      line[row] = 0.0;
      for (std::size_t i = 0; i < size; ++i) line[row] += wave[row * size + i] * values[at + i * stride];
    }
    for (std::size_t row = 0; row < size; ++row) values[at + row * stride] = line[row];
  }
}

/// Mean acceleration of the faces that touch the bubble, over g'; the last axis is the vertical.
double bubbleShare(int axes, int n) {
  const auto size = static_cast<std::size_t>(n);
  std::size_t cells = 1;
  for (int d = 0; d < axes; ++d) cells *= size;
  std::vector<double> push(cells), pressure(cells);
  const auto inside = [&](std::size_t cell) {
    double r2 = 0.0;
    for (int d = 0; d < axes; ++d, cell /= size) {
      const double x = (static_cast<double>(cell % size) + 0.5) / n - 0.5;
      r2 += x * x;
    }
    return r2 < kBubbleRadius * kBubbleRadius ? 1.0 : 0.0;
  };
  // Of the face below each cell; the vertical goes fastest. 0 on the floor.
  for (std::size_t c = 0; c < cells; ++c)
    if (c % size != 0) push[c] = 0.5 * (inside(c) + inside(c - 1));
  for (std::size_t c = 0; c < cells; ++c) pressure[c] = (c % size + 1 < size ? push[c + 1] : 0.0) - push[c];
  std::size_t stride = 1;
  for (int d = 0; d < axes; ++d, stride *= size) transform(pressure, n, stride, false);
  for (std::size_t c = 0; c < cells; ++c) {
    double eigenvalue = 0.0;
    std::size_t rest = c;
    for (int d = 0; d < axes; ++d, rest /= size)
      eigenvalue += 2.0 * std::cos(kPi * static_cast<double>(rest % size) / n) - 2.0;
    pressure[c] = c == 0 ? 0.0 : pressure[c] / eigenvalue;
  }
  stride = 1;
  for (int d = 0; d < axes; ++d, stride *= size) transform(pressure, n, stride, true);
  double sum = 0.0;
  int faces = 0;
  for (std::size_t c = 0; c < cells; ++c)
    if (push[c] > 0.0) {
      sum += push[c] - (pressure[c] - pressure[c - 1]);
      ++faces;
    }
  return sum / faces;
}

TEST(Bubble, SharesSolveTheLatticesEquations) {
  EXPECT_NEAR(bubbleShare(3, 64), kSphereShare, 1e-4);
  EXPECT_NEAR(bubbleShare(2, 128), kCylinderShare, 1e-4);
}

TEST(StraightLine, FindsSlopeAndOffset) {
  const StraightLine line = fitLine({1.0, 2.0, 4.0}, {1.5, 2.0, 3.0});
  EXPECT_NEAR(line.slope, 0.5, 1e-12);
  EXPECT_NEAR(line.offset, 1.0, 1e-12);
  EXPECT_NEAR(fitLine({0, 1, 2}, {0, 3, 0}).slope, 0.0, 1e-12);
}

}  // namespace
}  // namespace spin
