// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/air/brick_solids.h"

namespace spin {
namespace {

/// A ball that moves along x, known within a box.
AirSolid ball(Vec3d middle, double radius, double speed) {
  const Vec3d far = (radius + 2.0) * Vec3d{1, 1, 1};
  return {[=](Vec3d p) { return length(p - middle) - radius; },
          [=](Vec3d) {
            return Vec3d{speed, 0, 0};
          },
          middle - far, middle + far};
}

/// Sum of what the solids' motion takes out of all cells of a box, m3/s, and of its magnitude.
std::array<double, 2> pushed(const AirConfig& config) {
  std::array<double, 2> sums{};
  for (std::int32_t z = 0; z < config.highBrick[2]; ++z)
    for (std::int32_t y = 0; y < config.highBrick[1]; ++y)
      for (std::int32_t x = 0; x < config.highBrick[0]; ++x)
        for (const float flux : cutBrick(config, {x, y, z}).flux) {
          sums[0] += static_cast<double>(flux) * config.cell * config.cell;
          sums[1] += std::abs(static_cast<double>(flux)) * config.cell * config.cell;
        }
  return sums;
}

TEST(AirSolids, OnlyWhatMovesPushesTheAir) {
  AirConfig c;
  c.cell = 0.5;
  c.highBrick = {4, 12, 12};
  c.solids.push_back(ball({16, 12, 12}, 4.33, 2.0));
  const std::array<double, 2> alone = pushed(c);
  // What goes out before it comes in behind it: twice its section times its speed.
  EXPECT_NEAR(alone[0], 0.0, 1e-3);
  EXPECT_NEAR(alone[1], 2.0 * 2.0 * 3.14159 * 4.33 * 4.33, 6.0);
  // A steep slope that comes close to the ball, but no cell holds both.
  c.solids.push_back({[](Vec3d p) { return (p.z + p.x - 20.6) / std::sqrt(2.0); }, {}});
  const std::array<double, 2> beside = pushed(c);
  EXPECT_NEAR(beside[0], alone[0], 1e-3);
  EXPECT_NEAR(beside[1], alone[1], 1e-3);
}

TEST(AirSolids, DistancesNeedNotBeTrueFarFromTheSurface) {
  // The height over the ground below, beside a cliff: what is solid is known, how near is not.
  AirConfig c;
  c.cell = 0.8;
  c.highBrick = {3, 4, 16};
  c.solids.push_back({[](Vec3d p) { return p.z - (p.x < 14.1 ? 40.0 : -1.0); }, {}});
  for (std::int32_t z = 0; z < c.highBrick[2]; ++z)
    for (std::int32_t x = 0; x < c.highBrick[0]; ++x) {
      const BrickSolids solids = cutBrick(c, {x, 1, z});
      for (int k = 0; k < static_cast<int>(kBrickCells); ++k) {
        const double right = c.cell * (x * kBrickX + k % kBrickX + 1),
                     top = c.cell * (z * kBrickZ + k / 64 + 1);
        if (right <= 14.1 && top <= 40.0) {
          EXPECT_EQ(solids.volume[static_cast<std::size_t>(k)], 0.0f) << right << ' ' << top;
        }
        if (right - c.cell >= 14.1) {
          EXPECT_EQ(solids.volume[static_cast<std::size_t>(k)], 1.0f) << right << ' ' << top;
        }
      }
    }
}

}  // namespace
}  // namespace spin
