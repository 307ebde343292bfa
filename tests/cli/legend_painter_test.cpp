// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/legend_painter.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spin {
namespace {

ImageFloat grey(int width, int height) {
  ImageFloat image{width, height, {}};
  image.rgba.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 0.5f);
  return image;
}

ValueLegend speeds() {
  ValueLegend legend;
  legend.title = "Speed";
  legend.unit = "m/s";
  legend.scale.high = 30.0;
  legend.ticks = {{0.0, "0"}, {0.5, "15"}, {1.0, "30"}};
  return legend;
}

TEST(LegendPainter, ShowsTheColoursFromLowToHighAtTheRightRim) {
  ImageFloat image = grey(1280, 720);
  drawLegend(image, speeds());
  int leftmost = 1280;
  std::vector<int> rows;
  const auto pixel = [&](int x, int y) { return &image.rgba[static_cast<std::size_t>((y * 1280 + x) * 4)]; };
  for (int y = 0; y < 720; ++y)
    for (int x = 0; x < 1280; ++x)
      if (pixel(x, y)[0] != 0.5f || pixel(x, y)[1] != 0.5f) leftmost = std::min(leftmost, x);
  EXPECT_GT(leftmost, 1100);
  // Down the middle of the bar: yellow above, violet below, green between.
  const Vec3d top = scaleColour(speeds().scale, 1.0), bottom = scaleColour(speeds().scale, 0.0);
  int topRow = -1, bottomRow = -1;
  for (int y = 0; y < 720; ++y)
    for (int x = leftmost; x < 1280; ++x) {
      const auto is = [&](Vec3d c) {
        return std::abs(static_cast<double>(pixel(x, y)[0]) - c.x) < 0.01 &&
               std::abs(static_cast<double>(pixel(x, y)[1]) - c.y) < 0.01 &&
               std::abs(static_cast<double>(pixel(x, y)[2]) - c.z) < 0.01;
      };
      if (is(top) && topRow < 0) topRow = y;
      if (is(bottom)) bottomRow = y;
    }
  EXPECT_GT(topRow, 200);
  EXPECT_GT(bottomRow, topRow + 200);
  EXPECT_LT(bottomRow, 520);
}

TEST(LegendPainter, ClassesGetASwatchEach) {
  ValueLegend legend;
  legend.title = "Particle class";
  legend.scale.classes = true;
  legend.scale.high = 8.0;
  legend.ticks = {{0.0, "Within the flow"}, {0.125, "Isolated"}};
  ImageFloat image = grey(640, 360);
  drawLegend(image, legend);
  for (const ValueLegend::Tick& tick : legend.ticks) {
    const Vec3d colour = scaleColour(legend.scale, tick.place);
    int found = 0;
    for (std::size_t k = 0; k < image.rgba.size(); k += 4)
      found += std::abs(static_cast<double>(image.rgba[k]) - colour.x) < 1e-3 &&
               std::abs(static_cast<double>(image.rgba[k + 1]) - colour.y) < 1e-3;
    EXPECT_GE(found, 30) << tick.text;
  }
}

TEST(LegendPainter, LeavesPicturesAloneThatHaveNoRoom) {
  for (const int size : {16, 40, 64}) {
    ImageFloat image = grey(size, size);
    drawLegend(image, speeds());
    EXPECT_EQ(image.rgba, grey(size, size).rgba);
  }
}

}  // namespace
}  // namespace spin
