// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/physics/drag.h"
#include "core/physics/flake_fall.h"
#include "core/physics/size_spectrum.h"
#include "core/physics/slope_hold.h"
#include "core/physics/snow_density.h"

namespace spin {
namespace {

constexpr Vec3d kGravity{0, 0, -kStandardGravity};
constexpr FlakeFallLaw kLaws[] = {kUnrimedDendriteAggregate, kRimedDendriteAggregate, kHexagonalGraupel};

TEST(FlakeFall, SpeedsAndMassesAreThoseOfTheTable) {
  // 4 mm, by hand: 0.8 4^0.16 = 0.998662, 0.073 4^1.4 = 0.508401 mg.
  EXPECT_NEAR(kUnrimedDendriteAggregate.terminalSpeed(4e-3), 0.998662, 1e-5);
  EXPECT_NEAR(kUnrimedDendriteAggregate.mass(4e-3), 0.508401e-6, 1e-11);
  EXPECT_NEAR(kRimedDendriteAggregate.terminalSpeed(1e-3), 0.79, 1e-12);
  EXPECT_NEAR(kRimedDendriteAggregate.mass(1e-3), 0.037e-6, 1e-18);
  EXPECT_NEAR(kHexagonalGraupel.terminalSpeed(2e-3), 0.86 * std::sqrt(std::sqrt(2.0)), 1e-12);
}

TEST(FlakeFall, SizeAndMassInvertEachOtherOnBothSidesOfTheLargestMeasured) {
  for (const FlakeFallLaw& law : kLaws)
    for (const double d : {0.1e-3, 1e-3, 0.99 * law.largestMeasured, 1.01 * law.largestMeasured, 60e-3})
      EXPECT_NEAR(law.diameterOfMass(law.mass(d)), d, 1e-12 * d) << d;
}

TEST(FlakeFall, BeyondTheLargestMeasuredTheDensityStaysTheSame) {
  for (const FlakeFallLaw& law : kLaws) {
    const double d = law.largestMeasured;
    EXPECT_NEAR(law.mass(2 * d) / law.mass(d), 8.0, 1e-9);
    EXPECT_NEAR(law.mass(d * (1 + 1e-9)) / law.mass(d), 1.0, 1e-7);
  }
}

TEST(Drag, TerminalStateIsExactForAnyStep) {
  const Vec3d wind{7, -3, 0.5};
  for (const double v : {0.2, 1.0, 4.0})
    for (const double h : {1e-4, 1.0 / 24, 1.0, 1000.0}) {
      const Vec3d next = dragStep(wind + Vec3d{0, 0, -v}, wind, v, kGravity, h);
      EXPECT_NEAR(length(next - (wind + Vec3d{0, 0, -v})), 0.0, 1e-9 * (1.0 + h));
    }
}

TEST(Drag, StepsOfASecondNeitherExplodeNorOvershoot) {
  for (const double v : {0.1, 1.0, 5.0}) {
    Vec3d velocity{80, 0, 30};
    double previous = length(velocity);
    for (int k = 0; k < 20; ++k) {
      velocity = dragStep(velocity, {}, v, kGravity, 1.0);
      EXPECT_LE(length(velocity), std::max(previous, v) * (1.0 + 1e-12));
      previous = length(velocity);
    }
    EXPECT_NEAR(velocity.z, -v, 1e-3 * v);
  }
}

TEST(Drag, SmallStepsFollowTheClosedSolutionFromRest) {
  // Along gravity v(t) = v_t tanh(g t/v_t).
  const double terminal = 1.2, end = 0.1;
  double last = 1.0;
  for (const int steps : {100, 200, 400}) {
    Vec3d velocity{};
    for (int k = 0; k < steps; ++k) velocity = dragStep(velocity, {}, terminal, kGravity, end / steps);
    const double error = std::abs(-velocity.z - terminal * std::tanh(kStandardGravity * end / terminal));
    EXPECT_LT(error, 0.6 * last);  // first order: halves with the step
    last = error;
  }
  EXPECT_LT(last, 1e-3);
}

TEST(Drag, ImplicitStepSolvesTheLaw) {
  const Vec3d before{3, 1, -0.5}, wind{1, 0, 0};
  const double h = 0.07, v = 0.9;
  const Vec3d after = dragStep(before, wind, v, kGravity, h);
  const Vec3d expected = before + dragAcceleration(after, wind, v, kGravity) * h;
  EXPECT_NEAR(length(after - expected), 0.0, 1e-12);
}

TEST(Drag, AdvanceReachesTerminalSpeedAndItsWay) {
  Vec3d velocity{};
  const double v = 1.0;
  const Vec3d way = dragAdvance(velocity, {}, v, kGravity, 1.0);
  EXPECT_NEAR(velocity.z, -v, 1e-4);
  // s(t) = v^2/g ln cosh(g t/v) = v t - v^2/g ln 2.
  EXPECT_NEAR(-way.z, 1.0 - std::log(2.0) / kStandardGravity, 0.01);
}

TEST(SizeSpectrum, FluxIsThePrecipitation) {
  for (const FlakeFallLaw& law : kLaws)
    for (const double mmPerHour : {0.1, 1.0, 5.0, 50.0}) {
      const double rate = millimetresPerHourToSi(mmPerHour);
      const SizeSpectrum s = makeSizeSpectrum(law, rate);
      double flux = 0.0, mass = 0.0, speed = 0.0;
      const double h = 1e-4 / s.slope;
      for (int k = 1; k < 500000; ++k) {
        const double x = k * h, m = massOfMeltedDiameter(x) * s.intercept * std::exp(-s.slope * x) * h;
        const double v = law.terminalSpeed(law.diameterOfMass(massOfMeltedDiameter(x)));
        mass += m, flux += m * v, speed += m * v * v;
      }
      EXPECT_NEAR(flux / rate, 1.0, 1e-6);
      EXPECT_NEAR(mass / s.massConcentration, 1.0, 1e-6);
      EXPECT_NEAR(speed / flux / s.meanFallSpeed, 1.0, 1e-6);
    }
}

TEST(SizeSpectrum, HasThePublishedShapeAndAlmostThePublishedNumber) {
  const double rate = millimetresPerHourToSi(1.0);
  EXPECT_NEAR(publishedSpectrumIntercept(rate) / spectrumSlope(rate), 1092.0, 1.0);
  EXPECT_NEAR(spectrumSlope(millimetresPerHourToSi(4.0)), 2290.0 * std::pow(4.0, -0.45), 1e-6);
  // Unscaled the published spectrum carries 1.1 to 1.7 times its own rate with these speeds.
  const SizeSpectrum s = makeSizeSpectrum(kUnrimedDendriteAggregate, rate);
  const double excess = publishedSpectrumIntercept(rate) / s.intercept;
  EXPECT_GT(excess, 1.1);
  EXPECT_LT(excess, 1.7);
}

TEST(SizeSpectrum, QuantilesInvertTheDistribution) {
  const SizeSpectrum s = makeSizeSpectrum(kHexagonalGraupel, millimetresPerHourToSi(2.0));
  for (const double u : {0.0, 0.1, 0.5, 0.999})
    EXPECT_NEAR(1.0 - std::exp(-s.slope * s.meltedDiameter(u)), u, 1e-12);
}

TEST(SizeSpectrum, NothingFallsAtNoRate) {
  const SizeSpectrum s = makeSizeSpectrum(kUnrimedDendriteAggregate, 0.0);
  EXPECT_EQ(s.numberDensity, 0.0);
  EXPECT_EQ(s.massConcentration, 0.0);
  EXPECT_GT(s.meanFallSpeed, 0.1);
  EXPECT_TRUE(std::isfinite(s.slope));
}

TEST(SnowDensity, FollowsTheFitBelowZeroAndStopsAbove) {
  EXPECT_NEAR(newSnowDensity(kZeroCelsius), 67.9 + 51.3, 1e-9);
  EXPECT_NEAR(newSnowDensity(celsiusToKelvin(-5.0)), 67.9 + 51.3 * std::exp(-5.0 / 2.59), 1e-9);
  EXPECT_EQ(newSnowDensity(celsiusToKelvin(20.0)), newSnowDensity(kZeroCelsius));
}

TEST(SlopeHold, StepsSmoothlyBetweenItsAngles) {
  const SlopeHold hold;
  const auto at = [&](double degrees) { return hold.share(std::cos(degreesToRadians(degrees))); };
  EXPECT_EQ(at(0), 1.0);
  EXPECT_EQ(at(29.9), 1.0);
  EXPECT_NEAR(at(45), 0.5, 1e-12);
  EXPECT_NEAR(at(37.5), 1.0 - (0.25 * 0.25 * (3 - 0.5)), 1e-12);
  EXPECT_EQ(at(60.1), 0.0);
  EXPECT_EQ(at(120), 0.0);
  EXPECT_EQ(hold.share(1.0 + 1e-15), 1.0);
}

TEST(SlopeHold, EqualAnglesGiveASharpLimit) {
  const SlopeHold hold{degreesToRadians(40), degreesToRadians(40)};
  EXPECT_EQ(hold.share(std::cos(degreesToRadians(39))), 1.0);
  EXPECT_EQ(hold.share(std::cos(degreesToRadians(41))), 0.0);
}

}  // namespace
}  // namespace spin
