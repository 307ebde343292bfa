// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/air_part.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spin {
namespace {

TEST(Half, EveryHalfComesBackFromItsFloat) {
  for (std::uint32_t k = 0; k < 0x10000; ++k) {
    const auto half = static_cast<std::uint16_t>(k);
    const float value = floatFromHalf(half);
    if (std::isnan(value))
      EXPECT_TRUE(std::isnan(floatFromHalf(halfFromFloat(value)))) << k;
    else
      EXPECT_EQ(halfFromFloat(value), half) << k;
  }
}

TEST(Half, RoundsToTheNearest) {
  EXPECT_EQ(floatFromHalf(halfFromFloat(1.0f + 0x1p-11f)), 1.0f);  // a tie goes to the even one
  EXPECT_EQ(floatFromHalf(halfFromFloat(1.0f + 3 * 0x1p-11f)), 1.0f + 0x1p-9f);
  EXPECT_EQ(floatFromHalf(halfFromFloat(0x1.8p-25f)), 0x1p-24f);
  EXPECT_EQ(floatFromHalf(halfFromFloat(-0x1p-26f)), 0.0f);
  EXPECT_TRUE(std::isinf(floatFromHalf(halfFromFloat(65520.0f))));
  EXPECT_EQ(floatFromHalf(halfFromFloat(65519.0f)), 65504.0f);
}

AirPart twoBricks() {
  AirPart part;
  part.origin = {1, 2, 3};
  part.cell = 0.5;
  part.bricks = {{5, -1, 0}, {-7, 3, 2}};
  AirField mist{"mist", "kg/m3", 1, 1e-3f, {}};
  for (std::size_t k = 0; k < part.cells(); ++k) mist.halves.push_back(halfFromFloat(static_cast<float>(k)));
  AirField velocity{"velocity", "m/s", 3, 1.0f, {}};
  velocity.halves.assign(3 * part.cells(), halfFromFloat(-2.0f));
  part.fields = {mist, velocity};
  return part;
}

std::shared_ptr<FramePart> copyOf(const AirPart& part) {
  ByteWriter out;
  part.save(out);
  ByteReader in(out.bytes().data(), out.bytes().size());
  return AirPart::load(in);
}

TEST(AirPart, ComesBackAsItWasSaved) {
  const AirPart part = twoBricks();
  const auto loaded = copyOf(part);
  ASSERT_TRUE(loaded);
  const auto& back = static_cast<const AirPart&>(*loaded);
  EXPECT_EQ(back.bricks, part.bricks);
  EXPECT_EQ(back.cell, 0.5);
  const AirField *mist = back.find("mist"), *velocity = back.find("velocity");
  ASSERT_TRUE(mist != nullptr && velocity != nullptr);
  EXPECT_FLOAT_EQ(mist->at(1, 0, 7), 0.001f * (kBrickCells + 7));
  EXPECT_EQ(velocity->at(1, 2, 255), -2.0f);
  EXPECT_EQ(back.find("snow"), nullptr);
}

TEST(AirPart, RefusesWhatDoesNotFit) {
  AirPart part = twoBricks();
  part.fields[0].halves.pop_back();
  EXPECT_FALSE(copyOf(part));
  part = twoBricks();
  std::swap(part.bricks[0], part.bricks[1]);
  EXPECT_FALSE(copyOf(part));
  part = twoBricks();
  part.cell = 0.0;
  EXPECT_FALSE(copyOf(part));
}

TEST(AirPart, NamesWhatIsNotFinite) {
  AirPart part = twoBricks();
  EXPECT_EQ(part.firstNonFinite(), "");
  part.fields[1].halves[9] = halfFromFloat(NAN);
  EXPECT_EQ(part.firstNonFinite(), "velocity of the air, number 9");
}

}  // namespace
}  // namespace spin
