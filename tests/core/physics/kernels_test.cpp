// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/physics/kernels.h"

#include <gtest/gtest.h>

#include "core/physics/equation_of_state.h"

namespace spin {
namespace {

/// Midpoint rule; the integrands are smooth up to a kink at 1/2 and 1, which are cell borders.
template <class F>
double integrate(double from, double to, const F& f) {
  constexpr int kCells = 20000;
  const double step = (to - from) / kCells;
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i) sum += f(from + (i + 0.5) * step);
  return sum * step;
}

/// Sum of W V over a lattice of two spacings a support, seen from a point of the lattice.
template <class Shape>
double latticeSum(double norm, const Shape& shape) {
  double sum = 0.0;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k) sum += shape(0.5 * std::sqrt(double(i * i + j * j + k * k)));
  return sum * norm / 8.0;
}

TEST(KernelTest, VolumeIntegralsAreOne) {
  const auto volume = [](double norm, auto shape) {
    return norm * integrate(0, 1, [&](double q) { return 4 * kPi * q * q * shape(q); });
  };
  EXPECT_NEAR(volume(CubicSpline::kNorm, [](double q) { return CubicSpline::shape(q); }), 1.0, 1e-6);
  EXPECT_NEAR(volume(Poly6::kNorm, [](double q) { return Poly6::shapeOfSquare(q * q); }), 1.0, 1e-6);
  EXPECT_NEAR(volume(Spiky::kNorm, [](double q) { return Spiky::shape(q); }), 1.0, 1e-6);
  EXPECT_NEAR(volume(ViscosityKernel::kNorm, [](double q) { return ViscosityKernel::shape(q); }), 1.0, 1e-6);
}

TEST(KernelTest, ViscosityKernelsLaplacianIsThatOfItsShape) {
  constexpr double e = 1e-4;
  for (double q = 0.05; q < 0.99; q += 0.01) {
    const double slope = (ViscosityKernel::shape(q + e) - ViscosityKernel::shape(q - e)) / (2 * e);
    EXPECT_NEAR(ViscosityKernel::slope(q), slope, 1e-4 / (q * q * q * q)) << q;
    // (q^2 f')' / q^2
    const double out = (q + e) * (q + e) * ViscosityKernel::slope(q + e),
                 in = (q - e) * (q - e) * ViscosityKernel::slope(q - e);
    EXPECT_NEAR(ViscosityKernel::laplacian(q), (out - in) / (2 * e * q * q), 1e-5) << q;
  }
}

TEST(KernelTest, DensityKernelsSumToOneOnALatticeAndSpikyDoesNot) {
  EXPECT_NEAR(latticeSum(CubicSpline::kNorm, [](double q) { return CubicSpline::shape(q); }), 1.0, 0.01);
  EXPECT_NEAR(latticeSum(Poly6::kNorm, [](double q) { return Poly6::shapeOfSquare(q * q); }), 1.0, 0.01);
  EXPECT_NEAR(latticeSum(Spiky::kNorm, [](double q) { return Spiky::shape(q); }), 1.24, 0.01);
}

TEST(KernelTest, SlopesAreTheDerivativesOfTheShapes) {
  constexpr double e = 1e-6;
  for (double q = 0.01; q < 1.2; q += 0.01) {
    const double cubic = (CubicSpline::shape(q + e) - CubicSpline::shape(q - e)) / (2 * e);
    EXPECT_NEAR(CubicSpline::slopeOverQ(q) * q, cubic, 1e-4) << q;
    const double spiky = (Spiky::shape(q + e) - Spiky::shape(q - e)) / (2 * e);
    EXPECT_NEAR(Spiky::slope(q), spiky, 1e-4) << q;
    const double poly6 =
        (Poly6::shapeOfSquare((q + e) * (q + e)) - Poly6::shapeOfSquare((q - e) * (q - e))) / (2 * e);
    EXPECT_NEAR(Poly6::slopeOverQOfSquare(q * q) * q, poly6, 1e-4) << q;
  }
  EXPECT_EQ(CubicSpline::slopeOverQ(0.0), -12.0);
}

TEST(KernelTest, NothingReachesBeyondTheSupport) {
  for (const double q : {1.0, 1.0000001, 2.0, 1e6}) {
    EXPECT_EQ(CubicSpline::shape(q), 0.0) << q;
    EXPECT_EQ(CubicSpline::slopeOverQ(q), 0.0) << q;
    EXPECT_EQ(Poly6::shapeOfSquare(q * q), 0.0) << q;
    EXPECT_EQ(Spiky::shape(q), 0.0) << q;
    EXPECT_EQ(ViscosityKernel::shape(q), 0.0) << q;
    EXPECT_EQ(ViscosityKernel::slope(q), 0.0) << q;
    EXPECT_EQ(ViscosityKernel::laplacian(q), 0.0) << q;
  }
  EXPECT_EQ(CubicSpline::slopeOverQ(1.0f), 0.0f);
}

TEST(HalfSpaceTest, PlaneIntegralEqualsQuadrature) {
  for (double s = -1.0; s <= 1.0; s += 0.125) {
    // Rings of radius r in the plane at distance s; r dr = q dq.
    const double reference = std::abs(s) >= 1 ? 0.0 : integrate(std::abs(s), 1, [&](double q) {
      return 2 * kPi * q * CubicSpline::kNorm * CubicSpline::shape(q);
    });
    EXPECT_NEAR(CubicSpline::planeIntegral(s), reference, 1e-6) << s;
  }
}

TEST(HalfSpaceTest, HalfSpaceIntegralEqualsQuadrature) {
  for (double s = -1.25; s <= 1.25; s += 0.125) {
    // Share of the sphere of radius q that lies beyond the plane: (1 - s/q)/2, cut to [0, 1].
    const double reference = integrate(0, 1, [&](double q) {
      const double share = std::fmin(1.0, std::fmax(0.0, 0.5 * (1.0 - s / q)));
      return share * 4 * kPi * q * q * CubicSpline::kNorm * CubicSpline::shape(q);
    });
    EXPECT_NEAR(CubicSpline::halfSpaceIntegral(s), reference, 1e-6) << s;
    EXPECT_NEAR(double(CubicSpline::halfSpaceIntegral(float(s))), reference, 1e-6) << s;
  }
}

TEST(HalfSpaceTest, SlopeOfTheHalfSpaceIntegralIsThePlaneIntegral) {
  constexpr double e = 1e-3;
  for (double s = -0.95; s < 1.0; s += 0.05) {
    const double slope =
        (CubicSpline::halfSpaceIntegral(s + e) - CubicSpline::halfSpaceIntegral(s - e)) / (2 * e);
    EXPECT_NEAR(slope, -CubicSpline::planeIntegral(s), 2e-4) << s;
  }
}

TEST(HalfSpaceTest, SlopeOfTheMomentIsTheHalfSpaceIntegral) {
  constexpr double e = 1e-3;
  for (double s = 0.05; s < 1.0; s += 0.05) {
    const double slope =
        (CubicSpline::halfSpaceMoment(s + e) - CubicSpline::halfSpaceMoment(s - e)) / (2 * e);
    EXPECT_NEAR(slope, -CubicSpline::halfSpaceIntegral(s), 1e-5) << s;
  }
  EXPECT_EQ(CubicSpline::halfSpaceMoment(1.0), 0.0);
}

TEST(StateEquationTest, IsLinearInTheExcess) {
  EXPECT_DOUBLE_EQ(linearPressure(0.01, 1000.0, 20.0), 4000.0);
  EXPECT_EQ(clampTension(-3.0, 0.0), 0.0);
  EXPECT_EQ(clampTension(-3.0, 2.0), -2.0);
  EXPECT_EQ(clampTension(-1.0, 2.0), -1.0);
  EXPECT_EQ(clampTension(3.0, 2.0), 3.0);
}

}  // namespace
}  // namespace spin
