// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/base/units.h"
#include "core/snow/ground_materials.h"

namespace spin {
namespace {

using Totals = SnowStepTotals;

/// Cells of a valley: every ground, all heights, lights and skies.
SnowCells variousCells(std::size_t count) {
  std::vector<GroundMaterial> materials;
  for (int type = 0; type < kGroundTypeCount; ++type)
    materials.push_back(groundMaterial(static_cast<GroundType>(type)));
  SnowCells cells(count, materials, {});
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    cells.setMaterial(i, static_cast<std::uint8_t>(i * 5 / 3 % kGroundTypeCount));
    cells.setSoil(i, {std::sin(x) * 3.0f, 3.0f, 5.0f, 7.0f});
    cells.setting(kAirOffset)[i] = -8.0f + 16.0f * std::sin(0.37f * x);
    cells.setting(kBeamFactor)[i] = 1.0f + std::sin(0.11f * x);
    cells.setting(kSkyView)[i] = 0.7f + 0.3f * std::cos(0.23f * x);
    cells.setting(kFallFactor)[i] = 0.5f + 0.5f * std::cos(0.17f * x);
    cells.setting(kCellArea)[i] = 25.0f;
  }
  return cells;
}

/// Hour of a made-up winter and spring that snows, thaws, rains and freezes.
SnowStepWeather winterHour(int hour, int hours) {
  SnowStepWeather w;
  const double day = std::max(0.0, std::sin(2.0 * kPi * (hour % 24 - 6) / 24.0));
  const double season = static_cast<double>(hour) / hours;
  w.airTemperature =
      static_cast<float>(-6.0 + 14.0 * season * season + 5.0 * day + 5.0 * std::sin(hour / 37.0));
  w.directShortwave = static_cast<float>((150.0 + 350.0 * season) * day);
  w.diffuseShortwave = static_cast<float>(80.0 * day);
  w.longwave = static_cast<float>(260.0 + 30.0 * std::sin(hour / 53.0));
  w.snowfall = hour % 130 < 20 ? 4e-4f : 0.0f;
  w.relativeHumidity = static_cast<float>(0.7 + 0.25 * std::sin(hour / 41.0));
  w.wind = static_cast<float>(std::max(0.0, 3.0 + 4.0 * std::sin(hour / 19.0)));
  w.splitByTemperature = true;
  return w;
}

bool allFinite(const SnowCells& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const SnowColumn<float> c = cells.column(i);
    for (const SnowLayer<float>& layer : c.snow) {
      if (!(layer.ice >= 0.0f && layer.liquid >= 0.0f && layer.depth >= 0.0f)) return false;
      if (!(layer.temperature <= 0.0f && layer.temperature >= -150.0f)) return false;
      if (layer.temperature < 0.0f && layer.liquid > 0.0f) return false;
      // Never denser than ice with its pores full of water.
      if (layer.ice > 917.01f * layer.depth) return false;
    }
    for (const float soil : c.soil)
      if (!(std::abs(soil) < 150.0f)) return false;
    if (!(c.albedo >= 0.0f && c.albedo <= 1.0f && std::abs(c.surface) < 160.0f)) return false;
    if (c.ice() > 0.0f && c.surface > 0.0f) return false;
  }
  return true;
}

/// Runs hours of one weather and expects mass to close to 1e-6 and, by energy balance, energy to
/// 0.1 W/m2 in every one.
Totals runHours(SnowCells& cells, const SnowStepWeather& w, int hours) {
  CpuBackend backend(1);
  Totals all;
  double area = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) area += static_cast<double>(cells.setting(kCellArea)[i]);
  const double massBefore = cells.mass();
  for (int h = 0; h < hours; ++h) {
    const double energy = cells.energy();
    const Totals step = cells.advance(w, backend);
    if (cells.law == MeltLaw::EnergyBalance) {
      EXPECT_NEAR((cells.energy() - energy - step.energyIn()) / (area * static_cast<double>(w.seconds)), 0.0,
                  0.1)
          << h;
    }
    all += step;
  }
  const double moved = massBefore + all[Totals::kSnowIn] + all[Totals::kRainIn] + area;
  EXPECT_NEAR((cells.mass() - massBefore - all.massIn()) / moved, 0.0, 1e-6);
  EXPECT_TRUE(allFinite(cells));
  return all;
}

SnowCells snowyCell(float swe, float temperature, float soil, GroundMaterial ground = {}) {
  SnowCells cells(1, {ground}, {});
  SnowColumn<float> c = cells.column(0);
  c.snow[2].ice = swe;
  c.snow[2].depth = swe / 300.0f;
  c.snow[2].temperature = temperature;
  for (float& layer : c.soil) layer = soil;
  c.surface = temperature;
  cells.setColumn(0, c);
  return cells;
}

float waterIn(const SnowCells& cells) {
  const SnowColumn<float> c = cells.column(0);
  return c.snow[0].liquid + c.snow[1].liquid + c.snow[2].liquid;
}

TEST(SnowCells, MassAndEnergyCloseOverASeason) {
  constexpr int kHours = 5000;
  SnowCells cells = variousCells(333);
  CpuBackend backend(1);
  Totals all;
  const double mass = cells.mass(), energy = cells.energy();
  for (int h = 0; h < kHours; ++h) all += cells.advance(winterHour(h, kHours), backend);
  const double fell = all[Totals::kSnowIn] + all[Totals::kRainIn];
  EXPECT_NEAR((cells.mass() - mass - all.massIn()) / fell, 0.0, 1e-6);
  const double area = 333.0 * 25.0;
  EXPECT_NEAR((cells.energy() - energy - all.energyIn()) / (area * kHours * 3600.0), 0.0, 0.1);
  EXPECT_TRUE(allFinite(cells));
  // The season did something: much melted, some froze again, and some cells are bare now.
  EXPECT_GT(all[Totals::kMelted], 0.2 * fell);
  EXPECT_GT(all[Totals::kRefrozen], 0.01 * fell);
}

TEST(SnowCells, AnyNumberOfThreadsGivesTheSameBits) {
  constexpr int kHours = 400;
  constexpr std::size_t kCells = 10'007;
  SnowCells one = variousCells(kCells), three = variousCells(kCells);
  CpuBackend single(1), several(3);
  for (int h = 0; h < kHours; h += 4) {
    const Totals a = one.advance(winterHour(h, kHours), single),
                 b = three.advance(winterHour(h, kHours), several);
    ASSERT_EQ(std::memcmp(a.sums.data(), b.sums.data(), sizeof a.sums), 0) << h;
  }
  for (std::size_t i = 0; i < kCells; ++i) {
    const SnowColumn<float> a = one.column(i), b = three.column(i);
    ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << i;
  }
}

TEST(SnowCells, CellsDoNotDependOnTheirNeighbours) {
  constexpr int kHours = 300;
  SnowCells many = variousCells(70);
  SnowCells alone(1, {many.material(61)}, {});
  for (std::size_t s = 0; s < kSnowCellSettings; ++s) {
    const auto setting = static_cast<SnowCellSetting>(s);
    alone.setting(setting)[0] = many.setting(setting)[61];
  }
  alone.setColumn(0, many.column(61));
  CpuBackend backend(1);
  for (int h = 0; h < kHours; ++h) {
    many.advance(winterHour(h, kHours), backend);
    alone.advance(winterHour(h, kHours), backend);
  }
  const SnowColumn<float> a = many.column(61), b = alone.column(0);
  EXPECT_GT(columnMass(a), 1.0);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST(SnowCells, InstructionSetsAgree) {
  constexpr int kHours = 2000;
  std::vector<double> masses, energies;
  for (const Isa isa : runnableIsas()) {
    SnowCells cells = variousCells(64);
    CpuBackend backend(1);
    for (int h = 0; h < kHours; ++h) cells.advance(winterHour(h, kHours), backend, isa);
    masses.push_back(cells.mass());
    energies.push_back(cells.energy());
  }
  for (std::size_t i = 1; i < masses.size(); ++i) {
    EXPECT_NEAR(masses[i] / masses[0], 1.0, 1e-3);
    EXPECT_NEAR(energies[i] / energies[0], 1.0, 1e-3);
  }
}

TEST(SnowCells, WetSnowRefreezesInACold) {
  SnowCells cells = snowyCell(200.0f, 0.0f, 0.0f);
  SnowStepWeather warm;
  warm.airTemperature = 4.0f;
  warm.diffuseShortwave = 300.0f;
  runHours(cells, warm, 12);
  const float water = waterIn(cells);
  EXPECT_GT(water, 2.0f);
  SnowStepWeather cold;
  cold.airTemperature = -15.0f;
  cold.longwave = 180.0f;
  const double mass = cells.mass();
  const Totals night = runHours(cells, cold, 240);
  EXPECT_EQ(waterIn(cells), 0.0f);
  EXPECT_NEAR(night[Totals::kRefrozen], static_cast<double>(water), 0.5);
  EXPECT_EQ(night[Totals::kRunoff], 0.0);
  EXPECT_NEAR(cells.mass(), mass - night[Totals::kSublimated], 1e-3);
  EXPECT_LT(cells.column(0).snow[0].temperature, -3.0f);
}

TEST(SnowCells, RainWarmsAndFreezesInColdSnow) {
  SnowCells cells = snowyCell(100.0f, -10.0f, -5.0f);
  SnowStepWeather w;
  w.airTemperature = 3.0f;
  w.rainfall = 5.0f / 3600.0f;
  const Totals hour = runHours(cells, w, 1);
  EXPECT_GT(hour[Totals::kRefrozen], 4.9);
  EXPECT_EQ(hour[Totals::kRunoff], 0.0);
}

TEST(SnowCells, RainRunsOffBareGround) {
  SnowCells cells = snowyCell(0.0f, 0.0f, 8.0f);
  SnowStepWeather w;
  w.airTemperature = 8.0f;
  w.rainfall = 2e-3f;
  const Totals day = runHours(cells, w, 24);
  EXPECT_NEAR(day[Totals::kRunoff], day[Totals::kRainIn], 1e-4);
  EXPECT_NEAR(cells.mass(), 0.0, 1e-4);
}

TEST(SnowCells, SettlesTowardsItsDensities) {
  SnowCells cells = snowyCell(0.0f, 0.0f, -1.0f);
  SnowStepWeather w;
  w.airTemperature = -8.0f;
  w.longwave = 230.0f;
  w.snowfall = 30.0f / 3600.0f;
  runHours(cells, w, 1);
  const double fresh = 30.0 / static_cast<double>(cells.column(0).depth());
  EXPECT_NEAR(fresh, 67.9 + 51.3 * std::exp(-8.0 / 2.59), 3.0);
  w.snowfall = 0.0f;
  runHours(cells, w, 200);
  const double settled = cells.mass() / static_cast<double>(cells.column(0).depth());
  EXPECT_NEAR(settled, 300.0 - (300.0 - fresh) * std::exp(-1.0), 8.0);
}

TEST(SnowCells, AlbedoAgesFasterWhenWetAndIsRefreshed) {
  SnowStepWeather cold;
  cold.airTemperature = -12.0f;
  cold.longwave = 200.0f;
  SnowCells dry = snowyCell(300.0f, -10.0f, -1.0f), wet = snowyCell(300.0f, 0.0f, 0.0f);
  SnowStepWeather warm;
  warm.airTemperature = 3.0f;
  warm.longwave = 330.0f;
  runHours(dry, cold, 100);
  runHours(wet, warm, 100);
  EXPECT_NEAR(static_cast<double>(dry.column(0).albedo), 0.5 + 0.35 * std::exp(-0.1), 0.01);
  EXPECT_NEAR(static_cast<double>(wet.column(0).albedo), 0.5 + 0.35 * std::exp(-1.0), 0.02);
  cold.snowfall = 10.0f / 3600.0f;
  runHours(wet, cold, 5);
  EXPECT_GT(wet.column(0).albedo, 0.84f);
}

TEST(SnowCells, MoreConductiveGroundKeepsLessAndColderKeepsMore) {
  // Thin snow on warm ground under a grey, frosty sky: only the ground melts it.
  const auto left = [](float conductivity, float soil) {
    GroundMaterial ground;
    ground.conductivity = conductivity;
    SnowCells cells = snowyCell(40.0f, 0.0f, soil, ground);
    SnowStepWeather w;
    w.airTemperature = -1.0f;
    w.longwave = 305.0f;
    w.relativeHumidity = 0.95f;
    runHours(cells, w, 240);
    return cells.mass();
  };
  EXPECT_GT(left(0.1255f, 6.0f), left(0.1674f, 6.0f) + 0.1);
  EXPECT_GT(left(0.1674f, 6.0f), left(0.4427f, 6.0f) + 0.1);
  EXPECT_GT(left(0.4427f, 6.0f), left(0.6276f, 6.0f) + 0.1);
  EXPECT_GT(left(0.6276f, 1.0f), left(0.6276f, 6.0f) + 0.1);
  EXPECT_GE(left(0.6276f, -2.0f), left(0.6276f, 1.0f));
}

TEST(SnowCells, HeatedGroundMeltsWhatLiesOnIt) {
  SnowCells cells = snowyCell(50.0f, 0.0f, 0.0f), heated = snowyCell(50.0f, 0.0f, 0.0f);
  heated.setting(kGroundHeat)[0] = 100.0f;
  SnowStepWeather w;
  w.airTemperature = -1.0f;
  w.longwave = 305.0f;
  runHours(cells, w, 72);
  const Totals melt = runHours(heated, w, 72);
  EXPECT_LT(heated.mass(), cells.mass() - 20.0);
  EXPECT_NEAR(melt[Totals::kGroundIn], 100.0 * 72.0 * 3600.0, 1.0);
}

TEST(SnowCells, GroundTemperatureBelowHoldsTheSoil) {
  GroundMaterial ground;
  ground.deepConductance = 5.0f;
  SnowCells cells = snowyCell(0.0f, 0.0f, 5.0f, ground);
  cells.setting(kDeepTemperature)[0] = -10.0f;
  SnowStepWeather w;
  w.airTemperature = -10.0f;
  w.longwave = 272.0f;
  w.relativeHumidity = 0.9f;
  const Totals days = runHours(cells, w, 24 * 400);
  EXPECT_LT(days[Totals::kGroundIn], 0.0);
  EXPECT_LT(cells.column(0).soil[3], -8.0f) << "frozen through, from 5 degrees";
}

TEST(SnowHardCases, StillAirAndStorm) {
  for (const float wind : {0.0f, 60.0f})
    for (const float air : {-20.0f, 0.0f, 10.0f}) {
      SnowCells cells = snowyCell(80.0f, -5.0f, 2.0f);
      SnowStepWeather w;
      w.airTemperature = air;
      w.wind = wind;
      w.relativeHumidity = 0.3f;
      runHours(cells, w, 100);
    }
}

TEST(SnowHardCases, PolarNight) {
  SnowCells cells = snowyCell(200.0f, -30.0f, -15.0f);
  SnowStepWeather w;
  w.airTemperature = -60.0f;
  w.longwave = 90.0f;
  w.wind = 0.0f;
  w.pressure = 65000.0f;
  const Totals night = runHours(cells, w, 24 * 180);
  EXPECT_EQ(night[Totals::kMelted], 0.0);
  EXPECT_LT(cells.column(0).surface, -55.0f);
}

TEST(SnowHardCases, SixtyDegrees) {
  for (const float wind : {0.0f, 20.0f, 60.0f}) {
    SnowCells cells = snowyCell(300.0f, -40.0f, -20.0f);
    SnowStepWeather w;
    w.airTemperature = 60.0f;
    w.longwave = 600.0f;
    w.diffuseShortwave = 1100.0f;
    w.wind = wind;
    runHours(cells, w, 24 * 10);
    EXPECT_EQ(cells.column(0).ice(), 0.0f) << wind;
  }
}

TEST(SnowHardCases, FromSixtyToMinusSixtyInAnHour) {
  SnowCells cells = snowyCell(300.0f, 0.0f, 5.0f);
  SnowStepWeather hot, cold;
  hot.airTemperature = 60.0f;
  cold.airTemperature = -60.0f;
  cold.longwave = 100.0f;
  for (int day = 0; day < 5; ++day) {
    runHours(cells, hot, 1);
    runHours(cells, cold, 1);
  }
}

TEST(SnowHardCases, TenMetresOfSnowInAnHour) {
  SnowCells cells = snowyCell(0.0f, 0.0f, 5.0f);
  SnowStepWeather w;
  w.airTemperature = -1.0f;
  w.snowfall = 1000.0f / 3600.0f;
  const Totals hour = runHours(cells, w, 1);
  EXPECT_NEAR(hour[Totals::kSnowIn], 1000.0, 0.01);
  EXPECT_GT(cells.column(0).depth(), 9.0f);
  EXPECT_NEAR(cells.column(0).snow[0].depth, 0.1f, 1e-4f);
  w.snowfall = 0.0f;
  runHours(cells, w, 500);
}

TEST(SnowHardCases, FlurriesOnWarmGround) {
  SnowCells cells = snowyCell(0.0f, 0.0f, 8.0f);
  SnowStepWeather w;
  w.airTemperature = 0.5f;
  for (int i = 0; i < 200; ++i) {
    w.snowfall = i % 3 == 0 ? 1e-7f * static_cast<float>(i * i) : 0.0f;
    w.diffuseShortwave = i % 5 == 0 ? 500.0f : 0.0f;
    runHours(cells, w, 1);
  }
}

TEST(SnowHardCases, ShortStepsAgreeWithHours) {
  SnowCells hours = snowyCell(100.0f, -3.0f, 1.0f), minutes = snowyCell(100.0f, -3.0f, 1.0f);
  CpuBackend backend(1);
  for (int h = 0; h < 400; ++h) {
    SnowStepWeather w = winterHour(h, 400);
    hours.advance(w, backend);
    w.seconds = 60.0f;
    for (int m = 0; m < 60; ++m) minutes.advance(w, backend);
  }
  EXPECT_GT(minutes.mass(), 20.0);
  EXPECT_NEAR(hours.mass() / minutes.mass(), 1.0, 0.05);
}

TEST(SnowLawsChoice, DegreeDayMeltsByTheAirAlone) {
  SnowCells cells = snowyCell(100.0f, 0.0f, 0.0f);
  cells.law = MeltLaw::DegreeDay;
  SnowStepWeather w;
  w.airTemperature = 3.0f;
  const Totals day = runHours(cells, w, 24);
  EXPECT_NEAR(day[Totals::kRunoff], 12.0, 1e-3);
  EXPECT_NEAR(cells.mass(), 88.0, 1e-3);
}

TEST(SnowLawsChoice, PublishedLawIsGuardedAndReported) {
  SnowStepWeather w;
  w.airTemperature = 0.0f;  // T_gr = T_m
  SnowCells pole = snowyCell(1e5f, 0.0f, 0.0f);
  pole.law = MeltLaw::Published;
  const Totals guarded = runHours(pole, w, 1);
  EXPECT_EQ(guarded[Totals::kGuardedArea], 1.0);
  EXPECT_TRUE(std::isfinite(guarded[Totals::kMelted]));
  w.airTemperature = -5.0f;
  SnowCells frost = snowyCell(100.0f, 0.0f, 0.0f);
  frost.law = MeltLaw::Published;
  const Totals clamped = runHours(frost, w, 1);
  EXPECT_EQ(clamped[Totals::kGuardedArea], 0.0);
  EXPECT_GT(clamped[Totals::kClampedGrowth], 0.0);
  EXPECT_NEAR(frost.mass(), 100.0, 1e-4);
  // No snow, nothing to report.
  SnowCells bare = snowyCell(0.0f, 0.0f, 0.0f);
  bare.law = MeltLaw::Published;
  EXPECT_EQ(runHours(bare, w, 1)[Totals::kClampedGrowth], 0.0);
}

}  // namespace
}  // namespace spin
