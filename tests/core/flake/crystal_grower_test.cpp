// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <vector>

#include "core/base/hash.h"
#include "core/flake/crystal_grower.h"
#include "core/flake/flake_picture.h"

namespace spin {
namespace {

CrystalSettings settingsOf(CrystalHabit habit, int cells, std::uint64_t seed = 1) {
  CrystalSettings settings;
  settings.law = crystalLaw(habit);
  settings.cells = cells;
  settings.seed = seed;
  return settings;
}

CrystalGrower grown(const CrystalSettings& settings) {
  CrystalGrower crystal(settings);
  EXPECT_TRUE(crystal.grow(settings.mostSteps, CancelToken()).ok());
  EXPECT_TRUE(crystal.done());
  return crystal;
}

std::string bitsOf(const CrystalGrower& crystal) {
  Hasher hasher;
  for (int j = -crystal.reach(); j <= crystal.reach(); ++j)
    for (int i = -crystal.reach(); i <= crystal.reach(); ++i) hasher.add(crystal.thickness(i, j));
  return hasher.digest().hex();
}

std::size_t iceCells(const CrystalGrower& crystal) {
  std::size_t count = 0;
  for (int j = -crystal.reach(); j <= crystal.reach(); ++j)
    for (int i = -crystal.reach(); i <= crystal.reach(); ++i) count += crystal.frozen(i, j) ? 1 : 0;
  return count;
}

TEST(Crystal, HasSixEqualMirroredArmsToTheBit) {
  const CrystalGrower crystal = grown(settingsOf(CrystalHabit::Fern, 50));
  for (int j = -50; j <= 50; ++j)
    for (int i = -50; i <= 50; ++i) {
      const double own = crystal.thickness(i, j);
      ASSERT_EQ(crystal.thickness(-j, i + j), own);  // turned by 60 degrees
      ASSERT_EQ(crystal.thickness(j, i), own);       // mirrored
    }
  EXPECT_TRUE(crystal.frozen(50, 0));
  EXPECT_FALSE(crystal.frozen(51, 0));
}

TEST(Crystal, IceHangsTogether) {
  const CrystalGrower crystal = grown(settingsOf(CrystalHabit::Stellar, 50));
  const int reach = crystal.reach(), width = 2 * reach + 1;
  std::vector<bool> seen(static_cast<std::size_t>(width) * static_cast<std::size_t>(width), false);
  std::vector<std::pair<int, int>> open{{0, 0}};
  std::size_t count = 0;
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (std::abs(i) > reach || std::abs(j) > reach || !crystal.frozen(i, j)) continue;
    const auto at = static_cast<std::size_t>((j + reach) * width + i + reach);
    if (seen[at]) continue;
    seen[at] = true, ++count;
    for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}})
      open.push_back({i + a, j + b});
  }
  EXPECT_EQ(count, iceCells(crystal));
  EXPECT_GT(count, 300u);
}

TEST(Crystal, MassStaysUntilTheRimIsFelt) {
  CrystalSettings settings = settingsOf(CrystalHabit::Stellar, 200);
  CrystalGrower crystal(settings);
  const double before = crystal.totalMass();
  ASSERT_TRUE(crystal.grow(300, CancelToken()).ok());
  EXPECT_GT(crystal.reach(), 2);
  EXPECT_NEAR(crystal.totalMass() / before, 1.0, 1e-12);
}

TEST(Crystal, SameSeedSameBitsHoweverItIsCut) {
  const CrystalSettings settings = settingsOf(CrystalHabit::Broad, 40, 9);
  const CrystalGrower whole = grown(settings);
  CrystalGrower pieces(settings);
  while (!pieces.done()) ASSERT_TRUE(pieces.grow(3, CancelToken()).ok());
  EXPECT_EQ(bitsOf(whole), bitsOf(pieces));
  EXPECT_NE(bitsOf(whole), bitsOf(grown(settingsOf(CrystalHabit::Broad, 40, 10))));
}

/// Share of the hexagon through the tips that is ice: ferns are open, plates full.
TEST(Crystal, HabitsDiffer) {
  const auto share = [](CrystalHabit habit) {
    CrystalSettings settings = settingsOf(habit, 60);
    settings.weather = 0.0;
    const CrystalGrower crystal = grown(settings);
    const double r = crystal.reach();
    return static_cast<double>(iceCells(crystal)) / (3.0 * r * (r + 1.0) + 1.0);
  };
  const double fern = share(CrystalHabit::Fern), broad = share(CrystalHabit::Broad),
               plate = share(CrystalHabit::Plate);
  EXPECT_LT(fern, 0.45);
  EXPECT_GT(broad, fern + 0.05);
  EXPECT_GT(plate, 0.7);
}

TEST(Crystal, CancelStopsAtOnceAndStepsAreShort) {
  CrystalGrower crystal(settingsOf(CrystalHabit::Plate, 1000));
  const CancelToken cancel;
  cancel.cancel();
  EXPECT_EQ(crystal.grow(100000, cancel).error().kind, ErrorKind::Cancelled);
  EXPECT_EQ(crystal.steps(), 0);
  // The longest wait for a look at the flag is one step of the largest crystal.
  const auto start = std::chrono::steady_clock::now();
  ASSERT_TRUE(crystal.grow(1, CancelToken()).ok());
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 1.0);
}

TEST(Crystal, RefusesWhatMakesNoCrystal) {
  const auto refused = [](auto change) {
    CrystalSettings settings;
    change(settings);
    return !checkCrystalSettings(settings).ok();
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(checkCrystalSettings({}).ok());
  EXPECT_TRUE(refused([](CrystalSettings& s) { s.cells = 7; }));
  EXPECT_TRUE(refused([](CrystalSettings& s) { s.cells = 1001; }));
  EXPECT_TRUE(refused([](CrystalSettings& s) { s.mostSteps = 0; }));
  EXPECT_TRUE(refused([&](CrystalSettings& s) { s.weather = nan; }));
  EXPECT_TRUE(refused([&](CrystalSettings& s) { s.law.vapour = nan; }));
  EXPECT_TRUE(refused([](CrystalSettings& s) { s.law.tipMass = 0.5; }));
  EXPECT_TRUE(refused([](CrystalSettings& s) { s.law.melting = 0.9; }));
  EXPECT_TRUE(refused([](CrystalSettings& s) { s.law.freezing = -0.1; }));
  EXPECT_TRUE(refused([&](CrystalSettings& s) { s.law.scarce = nan; }));
}

TEST(CrystalPicture, IsDrawnAsItIs) {
  const CrystalGrower crystal = grown(settingsOf(CrystalHabit::Stellar, 40));
  const auto picture = drawCrystal(crystal, 128);
  ASSERT_TRUE(picture.ok());
  // Cells of area sqrt(3)/2 cover at least what the clearest ice does and at most all they have.
  const double cell = picture->radius / (crystal.reach() + 0.7);
  const double area = static_cast<double>(iceCells(crystal)) * 0.8660254037844386 * cell * cell;
  EXPECT_GT(picture->total(), 0.45 * area);
  EXPECT_LT(picture->total(), 1.01 * area);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) EXPECT_NEAR(picture->at(x, y), picture->at(127 - x, y), 0.07);
  EXPECT_FALSE(drawCrystal(crystal, 7).ok());
  EXPECT_FALSE(drawCrystal(crystal, kLargestPicture + 1).ok());
}

}  // namespace
}  // namespace spin
