// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/physics/drop_laws.h"
#include "core/physics/humid_air.h"
#include "core/physics/spray_birth.h"

namespace spin {
namespace {

TEST(AirLaws, HumidAirIsLighterByItsVapour) {
  // Dry air of 0 degC at sea level (ISO 2533) weighs 1.2923 kg/m3.
  EXPECT_NEAR(humidAirDensity(101325.0, 0.0, 0.0), 1.2923, 2e-4);
  // Table of the CIPM-2007 equation: 20 degC, 101325 Pa, 50 % humidity: 1.1992 kg/m3.
  const double vapour = 0.5 * saturationPressureWater(20.0);
  EXPECT_NEAR(humidAirDensity(101325.0, vapour, 20.0), 1.1992, 1e-3);
}

TEST(AirLaws, SaturationIsThatOfTheTables) {
  // Murphy and Koop 2005, table C1.
  EXPECT_NEAR(saturationPressureWater(0.0), 611.2, 0.5);
  EXPECT_NEAR(saturationPressureWater(20.0) / 2339.0, 1.0, 3e-3);
  EXPECT_NEAR(saturationPressureIce(-20.0) / 103.2, 1.0, 5e-3);
  EXPECT_NEAR(vapourDensity(611.2, 0.0) * 1e3, 4.85, 0.02) << "g/m3";
  EXPECT_LT(saturationPressureIce(-10.0), saturationPressureWater(-10.0));
}

TEST(AirLaws, DropsFallAsMeasured) {
  // Gunn and Kinzer 1949, table 2, at 20 degC and 101.3 kPa.
  const CarrierAir air{1.2, 1.81e-5};
  const double measured[][2] = {{0.1e-3, 0.27}, {0.3e-3, 1.17}, {0.5e-3, 2.06}, {1e-3, 4.03}, {2e-3, 6.49}};
  for (const auto& [diameter, speed] : measured)
    EXPECT_NEAR(sphereTerminalSpeed(diameter, 1000.0, air) / speed, 1.0, 0.1) << diameter;
  // Stokes for mist: d^2 (rho - rho_a) g / 18 mu.
  EXPECT_NEAR(sphereTerminalSpeed(10e-6, 1000.0, air) / (1e-10 * 998.8 * kStandardGravity / (18 * 1.81e-5)),
              1.0, 5e-3);
  EXPECT_EQ(sphereTerminalSpeed(1e-3, 1.0, air), 0.0) << "lighter than air";
}

TEST(AirLaws, AirTearsWhatIsFast) {
  // We = 12 at 28 m/s, the speed of a fall of 40 m: about a millimetre.
  EXPECT_NEAR(largestDrop(28.0, 1.25), 0.92e-3, 0.02e-3);
  EXPECT_NEAR(largestDrop(14.0, 1.25) / largestDrop(28.0, 1.25), 4.0, 1e-12);
}

TEST(AirLaws, ADropOfAMillimetreCoolsInSeconds) {
  // 1 mm at 4 m/s: time constant rho d^2 c / (6 Nu k), 4 to 8 s.
  const CarrierAir air{1.25, 1.75e-5};
  const double rate = dropHeatRate(1e-3, 1000.0, 4.0, air, airConductivity(283.15)) / kWaterHeat;
  EXPECT_GT(1.0 / rate, 2.0);
  EXPECT_LT(1.0 / rate, 8.0);
  EXPECT_NEAR(airConductivity(273.15), 0.0243, 3e-4);
}

TEST(AirLaws, PotentialsAreThoseOfIhmsen) {
  EXPECT_EQ(clampedPotential(2.0, 5.0, 20.0), 0.0);
  EXPECT_EQ(clampedPotential(25.0, 5.0, 20.0), 1.0);
  EXPECT_DOUBLE_EQ(clampedPotential(12.5, 5.0, 20.0), 0.5);
  EXPECT_EQ(clampedPotential(6.0, 6.0, 6.0), 1.0) << "no division by nothing";
  // Two that meet head on trap twice their relative speed, two that part nothing.
  EXPECT_DOUBLE_EQ(trappedAir({3, 0, 0}, {-1, 0, 0}), 6.0);
  EXPECT_DOUBLE_EQ(trappedAir({3, 0, 0}, {1, 0, 0}), 0.0);
  EXPECT_DOUBLE_EQ(trappedAir({3, 0, 0}, {0, 1, 0}), 3.0);
  // On a ridge the neighbour lies below and its normal leans away; in a trough it does not count.
  EXPECT_GT(crestBend({0, 0, 1}, {0.6, 0, 0.8}, {1, 0, -0.3}), 0.19);
  EXPECT_EQ(crestBend({0, 0, 1}, {-0.6, 0, 0.8}, {1, 0, 0.3}), 0.0);
  EXPECT_TRUE(goesForward({1, 0, 1}, {0, 0, 1}));
  EXPECT_FALSE(goesForward({1, 0, 0}, {0, 0, 1}));
}

TEST(AirLaws, ShareOfARateDoesNotDependOnTheStep) {
  double left = 1.0;
  for (int k = 0; k < 24; ++k) left *= 1.0 - shareOfRate(0.7, 1.0 / 24.0);
  EXPECT_NEAR(1.0 - left, shareOfRate(0.7, 1.0), 1e-12);
}

}  // namespace
}  // namespace spin
