// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/physics/rheology.h"

#include <gtest/gtest.h>

#include "core/physics/equation_of_state.h"

namespace spin {
namespace {

double viscosity(const Rheology& r, double rate, double pressure = 0.0) {
  return static_cast<double>(apparentViscosity(r, static_cast<float>(rate), static_cast<float>(pressure)));
}

TEST(RheologyTest, PowerLawAndYieldAreTheirFormulas) {
  Rheology r;
  r.law = RheologyLaw::Yield;
  r.viscosity = 3.0f;
  r.exponent = 0.5f;
  EXPECT_NEAR(viscosity(r, 4.0), 1.5, 1e-6);
  r.cohesion = 20.0f;
  r.frictionTangent = 0.5f;
  // Far above 1/m the regularisation is complete: tau = K gd^n + c + p tan phi.
  EXPECT_NEAR(viscosity(r, 4.0, 100.0) * 4.0, 3.0 * 2.0 + 20.0 + 50.0, 1e-4);
  EXPECT_NEAR(viscosity(r, 4.0, -100.0) * 4.0, 3.0 * 2.0 + 20.0, 1e-4) << "tension adds no friction";
}

TEST(RheologyTest, AtRestTheViscosityIsFiniteAndTheStressGrowsSteadily) {
  Rheology r;
  r.law = RheologyLaw::Yield;
  r.viscosity = 1.0f;
  r.cohesion = 10.0f;
  r.regularisation = 100.0f;
  // tau_y (1 - exp(-m gd)) / gd -> m tau_y.
  EXPECT_NEAR(viscosity(r, 0.0), 1.0 + 1000.0, 0.2);
  double before = 0.0;
  for (double rate = 1e-5; rate < 1e3; rate *= 1.5) {
    const double stress = viscosity(r, rate) * rate;
    EXPECT_GT(stress, before) << rate;
    before = stress;
  }
}

TEST(RheologyTest, CrossGoesFromOnePlateauToTheOtherAndIsHeldInItsLimits) {
  Rheology r;
  r.law = RheologyLaw::Cross;
  r.viscosity = 100.0f;
  r.viscosityAtSpeed = 1.0f;
  r.crossFactor = 3000.0f;
  r.exponent = 2.0f;
  EXPECT_NEAR(viscosity(r, 0.0), 100.0, 1e-3);
  EXPECT_NEAR(viscosity(r, 1e3), 1.0, 1e-3);
  EXPECT_NEAR(viscosity(r, 0.0182574), 1.0 + 99.0 / 2.0, 1e-2) << "K gd^n = 1";
  // The published set is not monotone: the stress falls from 0.92 to 0.36 Pa between 0.019 and 0.18 1/s.
  EXPECT_NEAR(viscosity(r, 0.019) * 0.019, 0.92, 0.01);
  EXPECT_NEAR(viscosity(r, 0.18) * 0.18, 0.36, 0.01);
  r.least = 5.0f;
  r.most = 60.0f;
  EXPECT_EQ(viscosity(r, 1e3), 5.0);
  EXPECT_EQ(viscosity(r, 0.0), 60.0);
}

TEST(RheologyTest, ShearRateIsThatOfTheSymmetricPart) {
  const float shear[9] = {0, 0, 3, 0, 0, 0, 0, 0, 0};     // du/dz = 3
  const float spin[9] = {0, 2, 0, -2, 0, 0, 0, 0, 0};     // a rigid rotation
  const float stretch[9] = {1, 0, 0, 0, 1, 0, 0, 0, -2};  // keeps the volume: the trace is 0, the rate is not
  EXPECT_FLOAT_EQ(shearRateOf(shear), 3.0f);
  EXPECT_FLOAT_EQ(shearRateOf(spin), 0.0f);
  EXPECT_FLOAT_EQ(shearRateOf(stretch), std::sqrt(12.0f));
}

TEST(EquationOfStateTest, TaitIsItsPowerAndKeepsSmallExcesses) {
  for (const double e : {-0.05, 1e-3, 0.1, 0.5})
    EXPECT_NEAR(taitPressure(e, 1000.0, 30.0) / (1000.0 * 900.0 / 7.0 * (std::pow(1.0 + e, 7.0) - 1.0)), 1.0,
                1e-12)
        << e;
  EXPECT_NEAR(static_cast<double>(taitPressure(1e-7f, 1000.0f, 30.0f)), 0.09, 1e-6)
      << "rho0 c^2 e, no cancellation";
  EXPECT_NEAR(taitPressure(1e-9, 1000.0, 30.0) / linearPressure(1e-9, 1000.0, 30.0), 1.0, 1e-6);
}

}  // namespace
}  // namespace spin
