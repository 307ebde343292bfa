// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>

#include "core/math/noise.h"
#include "core/math/sampling.h"

namespace spin {
namespace {

TEST(Sobol, First64PointsFallIntoAll64CellsOfEachPairOfDimensions) {
  // A shift by exclusive-or keeps this. Pairs (0,1) and (2,3) are the ones used together.
  const auto points = sobolPoints(64);
  for (const std::uint32_t shift : {0u, 0xdeadbeefu})
    for (std::size_t d = 0; d < 4; ++d) {
      std::set<int> strata;
      for (const auto& p : points) strata.insert(static_cast<int>(shifted(p[d], shift) * 64));
      EXPECT_EQ(strata.size(), 64u) << "dimension " << d;
    }
  std::set<std::pair<int, int>> cells;
  for (const auto& p : points)
    cells.insert({static_cast<int>(shifted(p[0], 7u) * 8), static_cast<int>(shifted(p[1], 99u) * 8)});
  EXPECT_EQ(cells.size(), 64u);
}

TEST(Cone, DirectionsAreUniformInSolidAngle) {
  const double angle = 0.6;
  const Frame3d frame = frameAround(normalized(Vec3d{0.3, -0.5, -0.8}));
  const double oneMinusCos = 1.0 - std::cos(angle);
  const int n = 1 << 14;
  const auto points = sobolPoints(n);
  double sumCos = 0.0, sumCos2 = 0.0;
  Vec3d across{};
  for (const auto& p : points) {
    const Vec3d d = coneDirection(frame, oneMinusCos, shifted(p[2], 1u), shifted(p[3], 2u));
    EXPECT_NEAR(length(d), 1.0, 1e-12);
    const double c = dot(d, frame.n);
    EXPECT_GE(c, std::cos(angle) - 1e-12);
    sumCos += c / n, sumCos2 += c * c / n;
    across += (d - frame.n * c) / static_cast<double>(n);
  }
  // Uniform in solid angle is uniform in the cosine.
  const double low = std::cos(angle);
  EXPECT_NEAR(sumCos, 0.5 * (1 + low), 1e-4);
  EXPECT_NEAR(sumCos2, (1 - low * low * low) / (3 * (1 - low)), 1e-4);
  EXPECT_NEAR(length(across), 0.0, 1e-3);
}

TEST(Cone, ZeroAngleGivesTheAxis) {
  const Frame3d frame = frameAround({0, 0, -1});
  EXPECT_EQ(coneDirection(frame, 0.0, 0.9, 0.1), (Vec3d{0, 0, -1}));
}

/// Leaving out short octaves takes away detail and nothing else, so coarse and fine grids agree on the rest.
TEST(Noise, OctavesWeighTheSameOnAllGrids) {
  for (int k = 0; k < 50; ++k) {
    const Vec3d p{0.37 * k, 1.91 * k, 0.37};
    const double coarse = octaveNoise(p, 24.0, 24.0, 5), fine = octaveNoise(p, 24.0, 0.5, 5);
    const double longest = gradientNoise(p / 24.0, 5);
    EXPECT_NEAR(coarse, longest / 1.6, 1e-12);
    EXPECT_LE(std::abs(fine - coarse), 1.0);
    EXPECT_NEAR(octaveNoise(p, 24.0, 12.0, 5) - coarse, 0.6 / 1.6 * gradientNoise(p / 12.0, 6), 1e-12);
  }
}

TEST(Noise, IsContinuousBoundedAndCentred) {
  double sum = 0.0, most = 0.0, roughest = 0.0;
  const int n = 20000;
  for (int k = 0; k < n; ++k) {
    const Vec3d p{0.137 * k, 0.0731 * k, 0.5};
    const double v = gradientNoise(p, 3);
    sum += v / n;
    most = std::max(most, std::abs(v));
    roughest = std::max(roughest, std::abs(gradientNoise(p + Vec3d{1e-4, 0, 0}, 3) - v));
  }
  EXPECT_NEAR(sum, 0.0, 0.02);
  EXPECT_LE(most, 1.1);
  EXPECT_GT(most, 0.4);
  EXPECT_LT(roughest, 1e-3);
  EXPECT_EQ(gradientNoise({-4, 7, 12}, 3), 0.0);
  EXPECT_NE(gradientNoise({0.4, 0.3, 0.2}, 3), gradientNoise({0.4, 0.3, 0.2}, 4));
}

}  // namespace
}  // namespace spin
