// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "plugins/sdk/exporter.h"

namespace spin {

/// A small fixed-width letter set (cells of 6 x 10 pixels, ASCII) for captions where no font library is.
struct BitmapFont {
  static constexpr int kAdvance = 6;
  static constexpr int kLineHeight = 11;
  static constexpr int kGlyphWidth = 5;
  static constexpr int kGlyphHeight = 9;  ///< the baseline is below row 6
  /// Whether the glyph of an ASCII character covers (column, row); nothing is covered outside the cell.
  static bool covers(char c, int column, int row);
};

/// UTF-8 text in the letters of the font: accents are dropped, the copyright sign becomes "(c)", others "?".
std::string toFontLetters(const std::string& utf8);
/// Breaks at blanks so that no line has more than `columns` letters (a longer word is cut).
std::vector<std::string> wrapText(const std::string& text, int columns);

/// Letters of the font with a dark rim, from the upper left corner; each pixel of a letter is a square of
/// `scale` pixels. What lies beside the picture is left out.
void drawText(ImageFloat& image, const std::string& letters, int x0, int y0, int scale);
/// Size of a letter's pixel in pictures of this height.
int textScale(int pictureHeight);
/// Draws text lines into the lower left corner, light with a dark rim, sized to the picture's height.
void drawCaption(ImageFloat& image, const std::vector<std::string>& paragraphs);

}  // namespace spin
