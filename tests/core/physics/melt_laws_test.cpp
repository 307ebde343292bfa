// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/physics/melt_laws.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/physics/bulk_transfer.h"
#include "core/physics/humidity.h"
#include "core/physics/sunlight.h"

namespace spin {
namespace {

TEST(BoundedMath, IsAccurateWhereItSaysSo) {
  for (double x = -16.0; x <= 16.0; x += 0.37) {
    EXPECT_NEAR(boundedExp(x) / std::exp(x), 1.0, 5e-6) << x;
    EXPECT_NEAR(static_cast<double>(boundedExp(static_cast<float>(x))) / std::exp(x), 1.0, 1e-5) << x;
  }
  for (double x = 1.0; x < 1e7; x *= 1.7) {
    EXPECT_NEAR(boundedLog(x), std::log(x), 1e-5) << x;
    EXPECT_NEAR(static_cast<double>(boundedLog(static_cast<float>(x))), std::log(x), 3e-5) << x;
  }
  for (double x = 0.0; x < 6.0; x += 0.11) EXPECT_NEAR(positiveTanh(x), std::tanh(x), 5e-6) << x;
}

TEST(BoundedMath, HoldsItsEnds) {
  EXPECT_DOUBLE_EQ(boundedExp(1e9), boundedExp(16.0));
  EXPECT_DOUBLE_EQ(boundedExp(-1e9), boundedExp(-16.0));
  EXPECT_EQ(boundedLog(0.0), 0.0);
  EXPECT_DOUBLE_EQ(boundedLog(1e30), boundedLog(1e7));
}

TEST(Humidity, SaturationIsMagnusOverIceAndWater) {
  const auto pressure = [](double q) { return q * 1e5 / 0.622; };
  EXPECT_NEAR(pressure(saturation(0.0, 1e5).humidity), 611.2, 0.01);
  // World Meteorological Organization tables: 103.3 Pa over ice at -20, 2339 Pa over water at 20 degC.
  EXPECT_NEAR(pressure(saturation(-20.0, 1e5).humidity), 103.3, 0.7);
  EXPECT_NEAR(pressure(saturation(20.0, 1e5).humidity), 2339.0, 10.0);
  const double h = 1e-3;
  for (const double t : {-40.0, -3.0, 7.0}) {
    const double slope = (saturation(t + h, 8e4).humidity - saturation(t - h, 8e4).humidity) / (2.0 * h);
    EXPECT_NEAR(saturation(t, 8e4).slope / slope, 1.0, 1e-3) << t;
  }
  // Air of 100 % over water is supersaturated over ice.
  EXPECT_GT(airHumidity(-10.0, 1.0, 1e5), saturation(-10.0, 1e5).humidity * 1.05);
}

TEST(Humidity, PrecipitationTurnsToRainAsItWarms) {
  EXPECT_GT(snowShare(-5.0, 0.9), 0.999);
  EXPECT_LT(snowShare(6.0, 0.9), 0.005);
  EXPECT_NEAR(snowShare((10.04 - 9.0 * 0.8) / 1.41, 0.8), 0.5, 1e-5);
  EXPECT_GT(snowShare(2.0, 0.5), snowShare(2.0, 0.95)) << "dry air cools flakes by evaporation";
}

TEST(BulkTransfer, IsTheLogLawInNeutralAirAndLouisBesideIt) {
  const NeutralTransfer<double> t = neutralTransfer(10.0, 2.0, 0.01);
  EXPECT_NEAR(t.coefficient, 0.16 / (std::log(1000.0) * std::log(2000.0)), 1e-8);
  EXPECT_DOUBLE_EQ(stabilityFactor(0.0, t.unstable), 1.0);
  EXPECT_NEAR(stabilityFactor(0.2, t.unstable), 1.0 / (1.0 + 3.0 * std::sqrt(2.0)), 1e-12);
  EXPECT_GT(stabilityFactor(-0.2, t.unstable), 1.0);
  EXPECT_LT(stabilityFactor(1e6, t.unstable), 1e-6);
  EXPECT_TRUE(std::isfinite(stabilityFactor(-1e6, t.unstable)));
}

TEST(DegreeDay, MeltsAboveItsThresholdOnly) {
  const DegreeDayLaw law;
  EXPECT_EQ(degreeDayMelt(law, -3.0), 0.0);
  EXPECT_NEAR(degreeDayMelt(law, 5.0) * 86400.0, 20.0, 1e-5);
}

TEST(DegreeDay, MeanOfTheWarmPartOfADay) {
  EXPECT_NEAR(positiveDegreeMean(0.0, 5.0), 1.59155, 1e-5);
  EXPECT_NEAR(positiveDegreeMean(2.0, 5.0), 2.72066, 1e-5);
  EXPECT_NEAR(positiveDegreeMean(-2.0, 5.0), 0.72066, 1e-5);
  EXPECT_DOUBLE_EQ(positiveDegreeMean(6.0, 5.0), 6.0);
  EXPECT_DOUBLE_EQ(positiveDegreeMean(-6.0, 5.0), 0.0);
  EXPECT_DOUBLE_EQ(positiveDegreeMean(3.0, 0.0), 3.0);
}

TEST(PublishedMelt, IsTheFormulaWhereItIsSound) {
  const PublishedMelt<double> melt = publishedMelt(PublishedMeltLaw{}, 0.6276, 2.0);
  EXPECT_NEAR(melt.rate, 0.6276 * 8.0 / (3150.0 * 0.4 * 2.0), 1e-9);
  EXPECT_EQ(melt.guarded, 0.0);
  EXPECT_EQ(melt.negative, 0.0);
}

TEST(PublishedMelt, PoleIsGuardedAndReported) {
  const PublishedMeltLaw law;
  const PublishedMelt<double> melt = publishedMelt(law, 0.6276, 0.0);
  EXPECT_EQ(melt.guarded, 1.0);
  EXPECT_TRUE(std::isfinite(melt.rate));
  EXPECT_NEAR(melt.rate, publishedMelt(law, 0.6276, static_cast<double>(law.leastDifference)).rate, 1e-3);
}

TEST(PublishedMelt, GrowthIsClampedAndReported) {
  for (const double ground : {-1e-3, -1.0, -30.0}) {
    const PublishedMelt<double> melt = publishedMelt(PublishedMeltLaw{}, 0.6276, ground);
    EXPECT_EQ(melt.rate, 0.0) << ground;
    EXPECT_GT(melt.negative, 0.0) << ground;
  }
  // Ground warmer than what is below it: the law turns negative too.
  EXPECT_GT(publishedMelt(PublishedMeltLaw{}, 0.6276, 15.0).negative, 0.0);
}

TEST(PublishedMelt, MoreConductiveGroundMeltsMore) {
  double before = 0.0;
  for (const double conductivity : {0.1255, 0.1674, 0.4427, 0.6276}) {
    const double rate = publishedMelt(PublishedMeltLaw{}, conductivity, 1.0).rate;
    EXPECT_GT(rate, before);
    before = rate;
  }
}

double utc(int daysFrom2026, double hour) {
  return 1767225600.0 + daysFrom2026 * 86400.0 + hour * 3600.0;  // 2026-01-01 00:00 UTC
}

double highestSun(int day, double latitudeDegrees) {
  double highest = -90.0;
  for (double hour = 0.0; hour < 24.0; hour += 0.05) {
    const Sun sun = sunAt(utc(day, hour), degreesToRadians(latitudeDegrees), 0.0);
    highest = std::max(highest, radiansToDegrees(std::asin(sun.direction.z)));
  }
  return highest;
}

TEST(Sunlight, StandsWhereSeasonAndLatitudeSay) {
  // 2026: equinox 20 March 14:46 UTC, solstices 21 June and 21 December; obliquity 23.44 degrees.
  EXPECT_NEAR(highestSun(78, 45.0), 45.0, 0.2);
  EXPECT_NEAR(highestSun(171, 45.0), 45.0 + 23.44, 0.1);
  EXPECT_NEAR(highestSun(354, 45.0), 45.0 - 23.44, 0.1);
  EXPECT_LT(highestSun(354, 80.0), 0.0) << "polar night";
  EXPECT_NEAR(highestSun(171, -45.0), 45.0 - 23.44, 0.1) << "winter of the southern half";
}

TEST(Sunlight, RisesInTheEastAndIsNearestInJanuary) {
  const double latitude = degreesToRadians(45.0);
  EXPECT_GT(sunAt(utc(78, 7.0), latitude, 0.0).direction.x, 0.9);
  EXPECT_LT(sunAt(utc(78, 17.0), latitude, 0.0).direction.x, -0.9);
  const Sun noon = sunAt(utc(78, 12.0), latitude, 0.0);
  EXPECT_LT(noon.direction.y, -0.6);
  EXPECT_NEAR(length(noon.direction), 1.0, 1e-12);
  // 90 degrees further east noon is six hours earlier.
  EXPECT_NEAR(sunAt(utc(78, 6.0), latitude, degreesToRadians(90.0)).direction.z, noon.direction.z, 2e-3);
  EXPECT_NEAR(sunAt(utc(3, 0.0), 0.0, 0.0).extraterrestrial / sunAt(utc(184, 0.0), 0.0, 0.0).extraterrestrial,
              1.069, 0.002);
}

TEST(Sunlight, DirectAndDiffuseAreTheWhole) {
  for (const double global : {0.0, 5.0, 200.0, 600.0, 1300.0})
    for (const double sine : {-0.5, 0.0, 0.01, 0.1, 0.7, 1.0}) {
      const Shortwave light = splitShortwave(global, sine, 1361.0);
      EXPECT_NEAR(light.direct + light.diffuse, global, 1e-9);
      EXPECT_GE(light.direct, 0.0);
      EXPECT_GE(light.diffuse, 0.0);
    }
  EXPECT_GT(splitShortwave(700.0, 0.7, 1361.0).direct, 500.0) << "a clear sky is mostly direct";
  EXPECT_GT(splitShortwave(100.0, 0.7, 1361.0).diffuse, 98.0) << "an overcast one is not";
  EXPECT_EQ(splitShortwave(-3.0, 0.5, 1361.0).diffuse, 0.0);
}

TEST(Sunlight, SlopesTowardsTheSunGetMore) {
  const Vec3d sun = normalized(Vec3d{0.0, -1.0, 1.0});
  const double s = std::sin(degreesToRadians(30.0)), c = std::cos(degreesToRadians(30.0));
  EXPECT_NEAR(slopeBeamFactor({0, 0, 1}, sun), 1.0, 1e-12);
  EXPECT_NEAR(slopeBeamFactor({0, -s, c}, sun), s + c, 1e-12);
  EXPECT_NEAR(slopeBeamFactor({0, s, c}, sun), c - s, 1e-12);
  EXPECT_EQ(slopeBeamFactor({0, c, s}, sun), 0.0);
  EXPECT_EQ(slopeBeamFactor({0, 0, 1}, {0, -1, 0}), 0.0);
}

}  // namespace
}  // namespace spin
