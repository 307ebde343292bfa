// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/bitmap_font.h"

#include <gtest/gtest.h>

#include <set>

namespace spin {
namespace {

std::string shape(char c) {
  std::string pixels;
  for (int row = 0; row < BitmapFont::kGlyphHeight; ++row)
    for (int column = 0; column < BitmapFont::kGlyphWidth; ++column)
      pixels += BitmapFont::covers(c, column, row) ? '#' : '.';
  return pixels;
}

TEST(BitmapFont, EveryLetterHasAShapeOfItsOwn) {
  std::set<std::string> shapes;
  for (char c = ' '; c <= '~'; ++c) shapes.insert(shape(c));
  EXPECT_EQ(shapes.size(), 95u);
  EXPECT_EQ(shape(' ').find('#'), std::string::npos);
}

TEST(BitmapFont, LettersStandUprightAndUnmirrored) {
  EXPECT_TRUE(BitmapFont::covers('L', 0, 0) && !BitmapFont::covers('L', 4, 0));
  EXPECT_TRUE(BitmapFont::covers('L', 0, 6) && BitmapFont::covers('L', 4, 6));
  EXPECT_TRUE(BitmapFont::covers('g', 3, 8)) << "descends below the baseline";
}

TEST(BitmapFont, OtherLettersAreFolded) {
  EXPECT_EQ(toFontLetters("\u00a9 Land Tirol \u2013 G\u00f6tzens"), "(c) Land Tirol - Gotzens");
  EXPECT_EQ(toFontLetters("\u0160t\u011bp\u00e1n"), "Stepan");
  EXPECT_EQ(toFontLetters("\u96ea"), "?");
  EXPECT_EQ(toFontLetters("a\xff\xc3"), "a??") << "damaged UTF-8";
}

TEST(BitmapFont, TextIsBrokenAtBlanks) {
  EXPECT_EQ(wrapText("one two three", 8), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapText("abcdefghij", 4), (std::vector<std::string>{"abcd", "efgh", "ij"}));
  EXPECT_TRUE(wrapText("", 4).empty());
}

ImageFloat grey(int width, int height) {
  ImageFloat image{width, height, {}};
  image.rgba.assign(static_cast<std::size_t>(width * height) * 4, 0.5f);
  return image;
}

TEST(Caption, LiesSmallInTheLowerLeftWithLightAndShadow) {
  ImageFloat image = grey(1280, 720);
  drawCaption(image, {"Kontertal", "Data: somebody"});
  int bright = 0, dark = 0, lowest = 0, highest = 720, rightmost = 0;
  for (int y = 0; y < 720; ++y)
    for (int x = 0; x < 1280; ++x) {
      const float value = image.rgba[static_cast<std::size_t>((y * 1280 + x) * 4)];
      if (value == 0.5f) continue;
      (value > 0.5f ? bright : dark) += 1;
      lowest = std::max(lowest, y);
      highest = std::min(highest, y);
      rightmost = std::max(rightmost, x);
    }
  EXPECT_GT(bright, 500);
  EXPECT_GT(dark, 200);
  EXPECT_LT(lowest, 720);
  EXPECT_GT(highest, 640) << "two lines need no more than a ninth of the height";
  EXPECT_LT(rightmost, 200);
}

TEST(Caption, NeverLeavesThePicture) {
  for (const int size : {16, 17, 64}) {
    ImageFloat image = grey(size, size);
    drawCaption(image, {"A very long caption that cannot fit into such a small picture at all"});
    EXPECT_EQ(image.rgba.size(), static_cast<std::size_t>(size * size) * 4);
  }
}

}  // namespace
}  // namespace spin
