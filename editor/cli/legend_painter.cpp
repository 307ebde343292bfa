// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/legend_painter.h"

#include <algorithm>
#include <cmath>

#include "editor/cli/bitmap_font.h"

namespace spin {
namespace {

constexpr int kBarWidth = 7, kBarMargin = 5, kTickGap = 3;  // in pixels of a letter
constexpr double kBarShare = 0.4;                           // of the picture's height

void fill(ImageFloat& image, int x0, int y0, int width, int height, Vec3d colour) {
  for (int y = std::max(y0, 0); y < std::min(y0 + height, image.height); ++y)
    for (int x = std::max(x0, 0); x < std::min(x0 + width, image.width); ++x) {
      float* pixel = &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                      static_cast<std::size_t>(x))];
      for (int c = 0; c < 3; ++c) pixel[c] = static_cast<float>(colour[c]);
      pixel[3] = 1.0f;
    }
}

int widthOf(const std::string& text, int scale) {
  return static_cast<int>(text.size()) * BitmapFont::kAdvance * scale;
}

/// A swatch for each kind of particle that is there.
void drawClasses(ImageFloat& image, const ValueLegend& legend, int x, int top, int scale) {
  int y = top;
  for (const ValueLegend::Tick& tick : legend.ticks) {
    fill(image, x - scale, y - scale, (kBarWidth + 2) * scale, (kBarWidth + 2) * scale, {0.02, 0.02, 0.02});
    fill(image, x, y, kBarWidth * scale, kBarWidth * scale, scaleColour(legend.scale, tick.place));
    drawText(image, toFontLetters(tick.text), x + (kBarWidth + kTickGap) * scale, y, scale);
    y += (BitmapFont::kLineHeight + 1) * scale;
  }
}

void drawAmounts(ImageFloat& image, const ValueLegend& legend, int x, int top, int height, int scale) {
  fill(image, x - scale, top - scale, (kBarWidth + 2) * scale, height + 2 * scale, {0.02, 0.02, 0.02});
  for (int row = 0; row < height; ++row)
    fill(image, x, top + row, kBarWidth * scale, 1,
         scaleColour(legend.scale, 1.0 - (row + 0.5) / static_cast<double>(height)));
  for (const ValueLegend::Tick& tick : legend.ticks) {
    const int y = top + static_cast<int>(std::lround((1.0 - tick.place) * (height - 1)));
    fill(image, x + kBarWidth * scale, y, 2 * scale, scale, {0.95, 0.95, 0.95});
    drawText(image, toFontLetters(tick.text), x + (kBarWidth + kTickGap) * scale, y - 3 * scale, scale);
  }
}

}  // namespace

int drawLegend(ImageFloat& image, const ValueLegend& legend, int taken) {
  const int scale = textScale(image.height);
  std::string title = legend.title;
  if (!legend.unit.empty()) title += ", " + legend.unit;
  title = toFontLetters(title);
  int widest = 0;
  for (const ValueLegend::Tick& tick : legend.ticks)
    widest = std::max(widest, widthOf(toFontLetters(tick.text), scale));
  const int bar = (kBarWidth + kTickGap) * scale + widest;
  const int margin = kBarMargin * scale;
  const int height = static_cast<int>(kBarShare * image.height);
  const int needed = std::max(bar, widthOf(title, scale)) + 2 * margin;
  if (taken + needed > image.width / 2 || height < 4 * BitmapFont::kLineHeight * scale) return taken;
  const int top = image.height / 2 - height / 2;
  const int right = image.width - taken - margin;
  drawText(image, title, right - widthOf(title, scale), top - BitmapFont::kLineHeight * scale * 3 / 2, scale);
  const int x = right - bar;
  if (legend.scale.classes)
    drawClasses(image, legend, x, top, scale);
  else
    drawAmounts(image, legend, x, top, height, scale);
  return taken + needed;
}

}  // namespace spin
