// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/bench/season_run.h"

namespace spin {
namespace {

TEST(SnowSite, ReadsHeightsAndSoil) {
  const auto site = readSnowSite(R"({"latitude_deg": 45.3, "temperature_height_m": 1.5,
      "temperature_height_above_snow": true, "wind_height_m": 10, "something_else": [],
      "soil_temperature_K": [273.15, 274.15, 275.15, 277.15]})",
                                 "a");
  ASSERT_TRUE(site) << site.error().text();
  EXPECT_FLOAT_EQ(site->parameters.airHeight, 1.5f);
  EXPECT_TRUE(site->parameters.airAboveSnow);
  EXPECT_FALSE(site->parameters.windAboveSnow);
  ASSERT_EQ(site->soil.size(), static_cast<std::size_t>(kSoilLayers));
  // Middles of the given layers: 0.05, 0.2, 0.5, 1.1 m; of ours: 0.05, 0.25, 0.8, 2.2 m.
  EXPECT_NEAR(site->soil[0], 0.0f, 1e-4f);
  EXPECT_NEAR(site->soil[1], 1.0f + 0.05f / 0.3f, 1e-3f);
  EXPECT_NEAR(site->soil[2], 3.0f, 1e-3f);
  EXPECT_NEAR(site->soil[3], 4.0f, 1e-3f);
}

TEST(SnowSite, TakesAnotherSoil) {
  const auto site = readSnowSite(R"({"ground": "rock", "soil_conductivity_W_mK": 1.5,
      "soil_temperature_K": [270, 271], "soil_layers_m": [0.5, 5]})",
                                 "a");
  ASSERT_TRUE(site) << site.error().text();
  EXPECT_FLOAT_EQ(site->ground.conductivity, 1.5f);
  EXPECT_FLOAT_EQ(site->ground.frozenWater, 0.0f);
  EXPECT_NEAR(site->soil[0], -3.15f, 1e-3f);
}

TEST(SnowSite, RefusesWhatCannotBe) {
  for (const char* text :
       {"", "[]", "{", R"({"wind_height_m": "ten"})", R"({"wind_height_m": -1})",
        R"({"wind_height_m": 1e999})", R"({"latitude_deg": 91})", R"({"ground": "cheese"})",
        R"({"ground": 3})", R"({"soil_temperature_K": []})", R"({"soil_temperature_K": 280})",
        R"({"soil_temperature_K": [5]})", R"({"soil_temperature_K": [280, "x"]})",
        R"({"soil_temperature_K": [280], "soil_layers_m": [1, 2]})",
        R"({"temperature_height_above_snow": 1})"})
    EXPECT_FALSE(readSnowSite(text, "a")) << text;
}

SeasonFiles madeUpSeason(std::int64_t step) {
  SeasonFiles season;
  season.name = "made up";
  season.site = *readSnowSite("{}", "a");
  season.site.soil.assign(kSoilLayers, 2.0f);
  season.weather.step = step;
  const int count = static_cast<int>(120 * 86400 / step);
  for (int i = 0; i < count; ++i) {
    const double day = static_cast<double>(i) * static_cast<double>(step) / 86400.0;
    WeatherRecord r;
    r.longwave = 270.0;
    r.shortwave = 60.0 + day;
    r.snowfall = day < 60.0 ? 3e-5 : 0.0;
    r.airTemperature = day < 60.0 ? 265.0 : 278.0;
    r.relativeHumidity = 0.8;
    r.wind = 2.0;
    r.pressure = 9e4;
    season.weather.records.push_back(r);
  }
  return season;
}

TEST(SeasonRun, ScoresItsOwnDaysAsPerfect) {
  const SeasonFiles season = madeUpSeason(3600);
  const SeasonRun run = runSeason(season, {}, {});
  ASSERT_EQ(run.days.size(), 120u);
  EXPECT_LT(run.massResidual, 1e-6);
  EXPECT_LT(run.worstResidual, 0.1);
  std::vector<SnowObservation> days;
  for (const SeasonDay& d : run.days) days.push_back({d.day, 0.5, 0.0, d.depth, d.swe, 300.0, 280.0});
  const SeasonScore same = scoreSeason(run, days);
  EXPECT_EQ(same.sweDays, 120);
  EXPECT_EQ(same.sweError, 0.0);
  EXPECT_TRUE(same.meltsOut);
  EXPECT_EQ(same.meltOutError, 0.0);
  for (SnowObservation& d : days) d.swe -= 10.0, d.depth = std::nan("");
  const SeasonScore shifted = scoreSeason(run, days);
  EXPECT_NEAR(shifted.sweError, 10.0, 1e-9);
  EXPECT_NEAR(shifted.sweBias, 10.0, 1e-9);
  EXPECT_EQ(shifted.depthDays, 0);
  EXPECT_FALSE(shifted.meltsOut);
}

TEST(SeasonRun, CutsLongStepsIntoHours) {
  const SeasonRun hours = runSeason(madeUpSeason(3600), {}, {});
  const SeasonRun days = runSeason(madeUpSeason(86400), {}, {});
  ASSERT_EQ(hours.days.size(), days.days.size());
  EXPECT_NEAR(hours.hours, days.hours, 1e-6);
  EXPECT_NEAR(days.days[59].swe, hours.days[59].swe, 0.05 * hours.days[59].swe);
}

}  // namespace
}  // namespace spin
