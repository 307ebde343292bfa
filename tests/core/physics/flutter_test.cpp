// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/physics/flutter.h"

#include <gtest/gtest.h>

namespace spin {
namespace {

constexpr FlutterLaw kLaws[] = {FlutterLaw::Steady, FlutterLaw::Decaying};

TEST(Flutter, VelocityIsTheRateOfTheOffsetAndThereIsNoLeap) {
  const double h = 1e-5;
  for (const FlutterLaw law : kLaws)
    for (std::uint64_t k = 0; k < 50; ++k) {
      const Flutter flutter = drawFlutter({3, 1}, k);
      for (double t = 0.0; t < 12.0; t += 0.0173) {
        const FlutterState a = flutterAt(flutter, law, 0.2, 3.0, t),
                           b = flutterAt(flutter, law, 0.2, 3.0, t + h);
        // Where the decaying law begins anew its speed leaps, its place does not.
        EXPECT_LT(std::hypot(b.offset.x - a.offset.x, b.offset.y - a.offset.y), 1.1 * h * 0.2 * 3.0 * 1.3);
        if (law == FlutterLaw::Decaying) continue;
        EXPECT_NEAR((b.offset.x - a.offset.x) / h, a.velocity.x, 1e-4);
        EXPECT_NEAR((b.offset.y - a.offset.y) / h, a.velocity.y, 1e-4);
      }
    }
}

TEST(Flutter, NoFlakeSwingsFartherThanTheAmplitude) {
  for (const FlutterLaw law : kLaws) {
    double largest = 0.0;
    for (std::uint64_t k = 0; k < 2000; ++k)
      for (double t = 0.0; t < 5.0; t += 0.1) {
        const FlutterState s = flutterAt(drawFlutter({1, 1}, k), law, 0.3, 3.0, t);
        largest = std::max(largest, std::hypot(s.offset.x, s.offset.y));
      }
    EXPECT_LE(largest, 0.3 + 1e-12);
    EXPECT_GT(largest, 0.2);
  }
}

TEST(Flutter, DecayingSwingsGetSmallerAndBeginAnew) {
  const double whole = 2.0 * kPi * kSwings;
  double last = 2.0;
  for (int swing = 0; swing < 4; ++swing) {
    const double peak = swingAt(FlutterLaw::Decaying, 2.0 * kPi * (swing + 0.2)).offset;
    EXPECT_LT(peak, last);
    EXPECT_NEAR(peak, std::sin(0.4 * kPi) / (1.2 + swing), 1e-12);
    last = peak;
  }
  EXPECT_NEAR(swingAt(FlutterLaw::Decaying, whole - 1e-9).offset, 0.0, 1e-8);
  EXPECT_NEAR(swingAt(FlutterLaw::Decaying, 3.0 * whole + 1.0).offset,
              swingAt(FlutterLaw::Decaying, 1.0).offset, 1e-12);
}

TEST(Flutter, DecayingSlopeIsTheDerivative) {
  for (double a = 0.1; a < 24.0; a += 0.37) {
    const double h = 1e-6;
    const double rate =
        (swingAt(FlutterLaw::Decaying, a + h).offset - swingAt(FlutterLaw::Decaying, a - h).offset) / (2 * h);
    EXPECT_NEAR(rate, swingAt(FlutterLaw::Decaying, a).slope, 1e-8);
  }
}

TEST(Flutter, WindMakesItStrongerWithinBounds) {
  EXPECT_EQ(flutterGain(0.0, 1.0), 1.0);
  EXPECT_NEAR(flutterGain(1.0, 1.0), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(flutterGain(60.0, 0.5), 2.0);
}

}  // namespace
}  // namespace spin
