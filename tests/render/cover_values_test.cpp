// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/cover_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "tests/render/render_scene.h"

namespace spin::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// One grid of four cells of 1 m: 0.5 m of snow of 200 kg/m3, as much of 400, none, and no surface.
CoverPart fourCells() {
  auto layout = std::make_shared<CoverLayout>();
  CoverGrid grid{"terrain", "terrain", Raster<float>(4, 1, 0.0, 0.0, 1.0), {}};
  grid.base.values = {0.0f, 0.0f, 0.0f, kNan};
  grid.area = grid.base.sameShape<float>(1.0f);
  layout->grids = {grid};
  CoverPart cover;
  cover.layout = layout;
  auto exposure = std::make_shared<CoverExposure>();
  exposure->grids = {{1.0f, 0.25f, 0.5f, kNan}};
  cover.exposure = exposure;
  CoverPart::Values v;
  v.swe = {100.0f, 200.0f, 0.0f, kNan};
  v.depth = {0.5f, 0.5f, 0.0f, kNan};
  v.liquid = {0.0f, 4.0f, 0.0f, kNan};
  v.temperature = {263.15f, 273.15f, 278.15f, kNan};
  cover.values = {v};
  return cover;
}

TEST(CoverValues, AreInTheUnitsOfTheLegend) {
  const CoverPart cover = fourCells();
  const auto of = [&](std::size_t cell, SnowDisplay shows) { return coverValue(cover, 0, cell, shows); };
  EXPECT_FLOAT_EQ(of(0, SnowDisplay::Depth), 0.5f);
  EXPECT_FLOAT_EQ(of(1, SnowDisplay::Swe), 200.0f);
  EXPECT_FLOAT_EQ(of(0, SnowDisplay::Density), 200.0f);
  EXPECT_FLOAT_EQ(of(1, SnowDisplay::Density), 400.0f);
  EXPECT_NEAR(of(0, SnowDisplay::Temperature), -10.0f, 1e-4f);
  EXPECT_NEAR(of(2, SnowDisplay::Temperature), 5.0f, 1e-4f) << "of the bare surface";
  EXPECT_FLOAT_EQ(of(1, SnowDisplay::LiquidWater), 4.0f);
  EXPECT_FLOAT_EQ(of(1, SnowDisplay::Exposure), 0.25f);
  EXPECT_STREQ(coverUnit(SnowDisplay::Temperature), "\u00b0C");
}

TEST(CoverValues, AreMissingWhereNothingIs) {
  CoverPart cover = fourCells();
  for (const SnowDisplay shows :
       {SnowDisplay::Depth, SnowDisplay::Swe, SnowDisplay::Density, SnowDisplay::LiquidWater}) {
    EXPECT_TRUE(std::isnan(coverValue(cover, 0, 2, shows))) << "bare";
    EXPECT_TRUE(std::isnan(coverValue(cover, 0, 3, shows))) << "no surface";
  }
  EXPECT_TRUE(std::isnan(coverValue(cover, 0, 3, SnowDisplay::Temperature)));
  cover.exposure = nullptr;
  cover.values[0].temperature.clear();
  cover.values[0].liquid.clear();
  EXPECT_TRUE(std::isnan(coverValue(cover, 0, 0, SnowDisplay::Exposure)));
  EXPECT_TRUE(std::isnan(coverValue(cover, 0, 0, SnowDisplay::Temperature)));
  EXPECT_EQ(coverValue(cover, 0, 0, SnowDisplay::LiquidWater), 0.0f) << "nothing melts";
}

TEST(CoverValues, TheRangeIsTheFramesOrTheSettings) {
  const CoverPart cover = fourCells();
  RenderNode settings;
  settings.snowDisplay = SnowDisplay::Swe;
  EXPECT_EQ(coverScale(settings, cover).low, 0.0);
  EXPECT_EQ(coverScale(settings, cover).high, 100.0) << "99 of 100 of two values: the lower one";
  settings.snowDisplay = SnowDisplay::Temperature;
  EXPECT_LT(coverScale(settings, cover).low, -9.0) << "does not begin at 0";
  settings.snowDisplay = SnowDisplay::Exposure;
  EXPECT_EQ(coverScale(settings, cover).high, 1.0);
  settings.snowRangeAuto = false;
  settings.snowRangeLow = 0.2;
  settings.snowRangeHigh = 0.2;
  EXPECT_GT(coverScale(settings, cover).high, coverScale(settings, cover).low) << "an empty range";
}

TEST(CoverValues, ColoursSayWhatTheScaleSays) {
  const CoverPart cover = fourCells();
  ValueScale scale;
  scale.high = 500.0;
  const auto texels = coverColours(cover, 0, SnowDisplay::Density, scale);
  ASSERT_EQ(texels.size(), 4u);
  EXPECT_EQ(texels[0][3], 255);
  EXPECT_EQ(texels[2][3], 0) << "bare";
  EXPECT_EQ(texels[3][3], 0) << "no surface";
  const Vec3d c = scaleColour(scale, 400.0 / 500.0);
  EXPECT_NEAR(texels[1][0] * texels[1][0] / 65025.0, c.x, 0.01);
  EXPECT_NEAR(texels[1][1] * texels[1][1] / 65025.0, c.y, 0.01);
  EXPECT_NEAR(texels[1][2] * texels[1][2] / 65025.0, c.z, 0.01);
}

TEST(CoverValues, SharesOfThePublishedBlendAreExposureTimesWhatTheSlopeHolds) {
  CoverPart cover = fourCells();
  const SlopeHold hold{degreesToRadians(30.0), degreesToRadians(60.0)};
  const auto level = coverShares(cover, 0, hold);
  EXPECT_EQ(level[0][3], 255);
  EXPECT_NEAR(level[1][3], 64, 1);
  auto layout = std::make_shared<CoverLayout>(*cover.layout);
  layout->grids[0].base.values = {0.0f, 3.0f, 6.0f, kNan};  // 71.6 degrees
  cover.layout = layout;
  EXPECT_EQ(coverShares(cover, 0, hold)[1][3], 0);
  layout->grids[0].base.values = {0.0f, 1.0f, 2.0f, kNan};  // 45 degrees: half way
  EXPECT_NEAR(coverShares(cover, 0, hold)[0][3], 128, 1);
}

TEST(CoverLegend, IsThereOnlyWhereColoursStandForValues) {
  Frame frame;
  frame.parts["cover"] = std::make_shared<CoverPart>(fourCells());
  const auto scene = [](SnowDisplay shows, bool legend) {
    SceneBuilder builder;
    builder.add<RenderNode>(kRenderType, "render", [=](RenderNode& r) {
      r.snowDisplay = shows;
      r.flowLegend = legend;
    });
    return builder.build();
  };
  EXPECT_FALSE(coverLegend(*scene(SnowDisplay::Natural, true), &frame, 0.0));
  EXPECT_FALSE(coverLegend(*scene(SnowDisplay::Depth, false), &frame, 0.0));
  EXPECT_FALSE(coverLegend(*scene(SnowDisplay::Depth, true), nullptr, 0.0));
  EXPECT_FALSE(coverLegend(*scene(SnowDisplay::Depth, true), std::make_unique<Frame>().get(), 0.0));
  const auto legend = coverLegend(*scene(SnowDisplay::Depth, true), &frame, 0.0);
  ASSERT_TRUE(legend);
  EXPECT_STREQ(legend->title, "Snow depth");
  EXPECT_EQ(legend->unit, "m");
  EXPECT_GE(legend->ticks.size(), 3u);
}

}  // namespace
}  // namespace spin::test
