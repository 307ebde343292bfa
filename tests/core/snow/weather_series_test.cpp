// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/weather_series.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/fields/number_table.h"

namespace spin {
namespace {

std::string row(int day, int hour, const std::string& rest = "100 280 1e-4 .000E+00 272.5 80 2.5 87480.") {
  return fmt::format("2005 10 {} {} {}\n", day, hour, rest);
}

TEST(WeatherSeries, ReadsWhiteSpaceAndCommas) {
  const auto spaces = readWeather(
      "2005 12 31 23 0.0 283.1 .000E+00 2e-4 277.8 78.2 0.6 87480.\n"
      "  2006\t1 1 0 +1.5 280 0 0 277 90 0 87000\r\n",
      "a");
  ASSERT_TRUE(spaces) << spaces.error().text();
  const auto commas = readWeather(
      "\xEF\xBB\xBFyear,month,day,hour,sw,lw,snow,rain,t,rh,u,p\n# a remark\n"
      "2005,12,31,23, 0.0 ,283.1,0,2e-4,277.8,78.2,0.6,87480\n"
      "2006,1,1,0,1.5,280,0,0,277,90,0,87000",
      "b");
  ASSERT_TRUE(commas) << commas.error().text();
  for (const auto* series : {&*spaces, &*commas}) {
    ASSERT_EQ(series->records.size(), 2u);
    EXPECT_EQ(series->step, 3600);
    EXPECT_EQ(series->start, 1136070000);  // 2005-12-31 23:00 UTC
    EXPECT_DOUBLE_EQ(series->records[0].rainfall, 2e-4);
    EXPECT_DOUBLE_EQ(series->records[0].relativeHumidity, 0.782);
    EXPECT_DOUBLE_EQ(series->records[1].shortwave, 1.5);
    EXPECT_TRUE(series->gapReport().empty());
  }
}

TEST(WeatherSeries, FillsGapsAndSaysSo) {
  std::string text;
  for (int day = 1; day <= 3; ++day)
    for (int hour = 0; hour < 24; ++hour) {
      if (day == 2 && hour >= 6 && hour < 12) continue;
      const double light = hour == 12 ? 400.0 : 0.0;
      const std::string t = day == 1 && hour == 5 ? "-9999" : fmt::format("{}", 270.0 + hour);
      const std::string sw = day == 3 && hour == 12 ? "NaN" : fmt::format("{}", light);
      text += row(day, hour, fmt::format("{} 280 1e-4 0 {} 80 2.5 -99.00", sw, t));
    }
  EXPECT_FALSE(readWeather(text, "a")) << "no row has the pressure";
  for (std::size_t at = text.find("-99.00"); at != std::string::npos; at = text.find("-99.00"))
    text.replace(at, 6, "9e4");
  const auto series = readWeather(text, "a");
  ASSERT_TRUE(series) << series.error().text();
  ASSERT_EQ(series->records.size(), 72u);
  EXPECT_EQ(series->missingRows, 6u);
  EXPECT_EQ(series->filled[4], 7u);
  EXPECT_EQ(series->longestGap, 6 * 3600);
  EXPECT_NEAR(series->records[5].airTemperature, 275.0, 1e-9);
  EXPECT_NEAR(series->records[24 + 8].airTemperature, 278.0, 1e-9);
  EXPECT_EQ(series->records[24 + 8].snowfall, 0.0) << "what nobody measured is not made up";
  EXPECT_NEAR(series->records[48 + 12].shortwave, 400.0, 1e-9) << "noon is filled from another day's noon";
  EXPECT_NE(series->gapReport().find("6 rows are missing"), std::string::npos);
}

TEST(WeatherSeries, TakesOtherStepsAndMidnightAs24) {
  const auto days = readWeather(row(1, 0) + row(2, 0) + row(4, 0), "a");
  ASSERT_TRUE(days);
  EXPECT_EQ(days->step, 86400);
  EXPECT_EQ(days->records.size(), 4u);
  const auto midnight = readWeather(row(1, 23) + row(1, 24) + row(2, 1), "a");
  ASSERT_TRUE(midnight) << midnight.error().text();
  EXPECT_EQ(midnight->records.size(), 3u);
  const auto halves =
      readWeather("2005 10 1 0 0 280 0 0 270 80 2 9e4\n2005 10 1 0.5 0 280 0 0 270 80 2 9e4\n", "a");
  ASSERT_TRUE(halves);
  EXPECT_EQ(halves->step, 1800);
}

TEST(WeatherSeries, RefusesWhatCannotBe) {
  const std::string good = row(1, 0);
  const auto refuses = [&](const std::string& text, const std::string& saying) {
    const auto series = readWeather(text, "file.txt");
    EXPECT_FALSE(series) << saying;
    if (series) return;
    EXPECT_NE(series.error().text().find(saying), std::string::npos) << series.error().text();
  };
  refuses("", "no row");
  refuses("\n \n# nothing\n", "no row");
  refuses("year month day\n", "no row");
  refuses(good, "one row");
  refuses(std::string("2005 10 1 0 \0 1", 15), "no text");
  refuses(good + "2005 10 1 1 100 280\n", "line 2 has 6 of 12 columns");
  refuses(good + row(1, 1, "abc 280 0 0 272 80 2 9e4"), "line 2, column 5: 'abc'");
  refuses(good + row(1, 1, "1e999 280 0 0 272 80 2 9e4"), "is no number");
  refuses(good + row(1, 1, "inf 280 0 0 272 80 2 9e4"), "is no number");
  refuses(good + row(1, 1, "1x 280 0 0 272 80 2 9e4"), "is no number");
  refuses(good + row(1, 1, "0 280 0 0 -3.5 80 2 9e4"), "air temperature of -3.5 K");
  refuses(good + row(1, 1, "0 280 0 0 270 80 2 900"), "pressure of 900 Pa");
  refuses(good + row(1, 1, "0 280 5 0 270 80 2 9e4"), "snowfall of 5");
  refuses(good + row(1, 1, "0 280 0 0 270 80 500 9e4"), "wind of 500");
  refuses(good + good, "not later");
  refuses(row(2, 0) + row(1, 0), "not later");
  refuses(good + row(32, 1), "no date");
  refuses("2005 2 29 0 0 280 0 0 270 80 2 9e4\n", "no date");
  refuses("nan 2 28 0 0 280 0 0 270 80 2 9e4\n", "no date");
  refuses("1e300 2 28 0 0 280 0 0 270 80 2 9e4\n", "no date");
  refuses(good + row(1, 25), "no hour");
  refuses(good + row(1, 2) + row(1, 5), "whole number of steps");
  refuses(good + "2005 10 1 0.001 0 280 0 0 270 80 2 9e4\n", "apart");
  refuses(
      "1800 1 1 0 0 280 0 0 270 80 2 9e4\n1800 1 1 0.05 0 280 0 0 270 80 2 9e4\n"
      "2999 1 1 0 0 280 0 0 270 80 2 9e4\n",
      "10,000,000");
}

TEST(WeatherSeries, NightIsNeverNegative) {
  const auto series = readWeather(row(1, 0, "-3 280 0 0 270 80 2 9e4") + row(1, 1), "a");
  ASSERT_TRUE(series);
  EXPECT_EQ(series->records[0].shortwave, 0.0);
}

TEST(Observations, ReadDaysWithGaps) {
  const auto days = readObservations(
      "2005 10 1 0.17 1.20 0.00 0.00 -99.00 10.72\n"
      "2005 10 3 -99 -99 1.58 440 -5 0.5\n",
      "a");
  ASSERT_TRUE(days) << days.error().text();
  ASSERT_EQ(days->size(), 2u);
  EXPECT_EQ((*days)[1].day - (*days)[0].day, 2);
  EXPECT_TRUE(std::isnan((*days)[0].surfaceTemperature));
  EXPECT_TRUE(std::isnan((*days)[1].albedo));
  EXPECT_DOUBLE_EQ((*days)[1].swe, 440.0);
  EXPECT_DOUBLE_EQ((*days)[1].surfaceTemperature, 268.15);
  EXPECT_FALSE(readObservations("2005 10 1 0.17 1.2 158 0 0 0\n", "a")) << "158 m of snow";
  EXPECT_FALSE(readObservations("2005 10 1 0.17 1.2 1 0 0\n", "a"));
  EXPECT_FALSE(readObservations("2005 10 2 .2 0 0 0 0 0\n2005 10 1 .2 0 0 0 0 0\n", "a"));
}

TEST(Observations, CalendarIsGregorian) {
  EXPECT_EQ(daysFromCivil(1970, 1, 1), 0);
  EXPECT_EQ(daysFromCivil(2000, 3, 1), 11017);
  EXPECT_EQ(daysFromCivil(2000, 2, 29), 11016);
  EXPECT_EQ(daysFromCivil(1969, 12, 31), -1);
}

TEST(NumberTable, FilesThatAreNone) {
  EXPECT_FALSE(readTextFile("/"));
  EXPECT_FALSE(readTextFile("no such file"));
}

}  // namespace
}  // namespace spin
