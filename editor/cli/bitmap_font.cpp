// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/bitmap_font.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace spin {
namespace {

/// Per character from blank to tilde: nine rows from the top, each one digit of base 32 (0-9, A-V) whose five
/// bits are the row's pixels, the highest on the left.
constexpr std::array<std::string_view, 95> kGlyphs = {
    "000000000", "444440400", "AAA000000", "AAVAVAA00", "4FKE5U400", "OP248J300", "CIK8LID00", "444000000",
    "248884200", "842224800", "04LEL4000", "044V44000", "00000C480", "000E00000", "00000CC00", "11248GG00",
    "EHJLPHE00", "4C4444E00", "EH1248V00", "V2421HE00", "26AIV2200", "VGU11HE00", "68GUHHE00", "V12488800",
    "EHHEHHE00", "EHHF12C00", "0CC0CC000", "0CC0C4800", "248G84200", "00V0V0000", "842124800", "EH1240400",
    "EH1DLLE00", "EHHVHHH00", "UHHUHHU00", "EHGGGHE00", "SIHHHIS00", "VGGUGGV00", "VGGUGGG00", "EHGNHHF00",
    "HHHVHHH00", "E44444E00", "72222IC00", "HIKOKIH00", "GGGGGGV00", "HRLLHHH00", "HHPLJHH00", "EHHHHHE00",
    "UHHUGGG00", "EHHHLID00", "UHHUKIH00", "FGGE11U00", "V44444400", "HHHHHHE00", "HHHHHA400", "HHHLLLA00",
    "HHA4AHH00", "HHHA44400", "V1248GV00", "E88888E00", "GG8421100", "E22222E00", "4AH000000", "0000000V0",
    "842000000", "00E1FHF00", "GGMPHHU00", "00EGGHE00", "11DJHHF00", "00EHVGE00", "698S88800", "00FHHHF1E",
    "GGMPHHH00", "40C444E00", "2062222IC", "GGIKOKI00", "C44444E00", "00QLLHH00", "00MPHHH00", "00EHHHE00",
    "00UHHHUGG", "00FHHHF11", "00MPGGG00", "00FGE1U00", "88S889600", "00HHHJD00", "00HHHA400", "00HHLLA00",
    "00HA4AH00", "00HHHHF1E", "00V248V00", "644844600", "444444400", "C44244C00", "008L20000"};

int digit(char c) {
  return c <= '9' ? c - '0' : c - 'A' + 10;
}

/// Base letters of U+00C0 .. U+00FF.
constexpr std::string_view kLatinBase = "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty";

/// Base letters of U+0100 .. U+017F.
constexpr std::string_view kExtendedBase =
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlLlLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTt"
    "UuUuUuUuUuUuWwYyYZzZzZzs";

static_assert(kLatinBase.size() == 64 && kExtendedBase.size() == 128);

std::string fontLetters(unsigned point) {
  if (point >= 0x20 && point < 0x7f) return {static_cast<char>(point)};
  if (point >= 0xc0 && point <= 0xff) return {kLatinBase[point - 0xc0]};
  if (point >= 0x100 && point <= 0x17f) return {kExtendedBase[point - 0x100]};
  switch (point) {
    case 0xa9:
      return "(c)";
    case 0xb0:
      return "deg";
    case 0xb2:
      return "2";
    case 0xb3:
      return "3";
    case 0xb5:
      return "u";
    case 0xb7:
    case 0x2022:
      return "*";
    case 0x2010:
    case 0x2011:
    case 0x2012:
    case 0x2013:
    case 0x2014:
      return "-";
    case 0x2018:
    case 0x2019:
      return "'";
    case 0x201c:
    case 0x201d:
    case 0x201e:
      return "\"";
    case '\t':
    case 0xa0:
      return " ";
    default:
      return "?";
  }
}

/// Next code point of well-formed UTF-8; '?' for a stray byte.
unsigned nextPoint(const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const unsigned first = byte(at++);
  const int more = first < 0x80 ? 0 : first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : -1;
  if (more < 0) return '?';
  unsigned point = more == 0 ? first : first & (0x3fu >> more);
  for (int i = 0; i < more; ++i) {
    if (at >= text.size() || (byte(at) & 0xc0) != 0x80) return '?';
    point = point << 6 | (byte(at++) & 0x3f);
  }
  return point;
}

/// Blends a square of `size` pixels towards a grey.
void blend(ImageFloat& image, int x0, int y0, int size, float grey, float share) {
  for (int y = std::max(y0, 0); y < std::min(y0 + size, image.height); ++y)
    for (int x = std::max(x0, 0); x < std::min(x0 + size, image.width); ++x) {
      float* pixel = &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                      static_cast<std::size_t>(x))];
      for (int c = 0; c < 3; ++c) pixel[c] += share * (grey - pixel[c]);
      pixel[3] = std::max(pixel[3], share);
    }
}

/// Whether the letter covers the pixel or one beside it.
bool covers(char c, int column, int row, int reach) {
  for (int y = row - reach; y <= row + reach; ++y)
    for (int x = column - reach; x <= column + reach; ++x)
      if (BitmapFont::covers(c, x, y)) return true;
  return false;
}

}  // namespace

bool BitmapFont::covers(char c, int column, int row) {
  if (c < ' ' || c > '~') return false;
  if (column < 0 || row < 0 || column >= kGlyphWidth || row >= kGlyphHeight) return false;
  const std::string_view glyph = kGlyphs[static_cast<std::size_t>(c - ' ')];
  return (digit(glyph[static_cast<std::size_t>(row)]) >> (kGlyphWidth - 1 - column)) & 1;
}

std::string toFontLetters(const std::string& utf8) {
  std::string letters;
  for (std::size_t at = 0; at < utf8.size();) letters += fontLetters(nextPoint(utf8, at));
  return letters;
}

std::vector<std::string> wrapText(const std::string& text, int columns) {
  const auto width = static_cast<std::size_t>(std::max(columns, 1));
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > width) {
    std::size_t cut = rest.rfind(' ', width);
    const bool word = cut != std::string::npos && cut > 0;
    if (!word) cut = width;
    lines.push_back(rest.substr(0, cut));
    rest = rest.substr(word ? cut + 1 : cut);
  }
  if (!rest.empty()) lines.push_back(rest);
  return lines;
}

// Light letters with a dark rim are legible on snow and on forest alike.
void drawText(ImageFloat& image, const std::string& letters, int x0, int y0, int scale) {
  for (std::size_t i = 0; i < letters.size(); ++i)
    for (int row = -1; row <= BitmapFont::kGlyphHeight; ++row)
      for (int column = -1; column <= BitmapFont::kGlyphWidth; ++column) {
        const int x = x0 + (static_cast<int>(i) * BitmapFont::kAdvance + column) * scale;
        const int y = y0 + row * scale;
        // The rims of neighbours overlap in one column; a letter is never darkened by the next one's rim.
        const bool ofBefore = column < 0 && i > 0;
        if (covers(letters[i], column, row, 0))
          blend(image, x, y, scale, 0.95f, 0.95f);
        else if (!ofBefore && covers(letters[i], column, row, 1))
          blend(image, x, y, scale, 0.02f, 0.85f);
        else if (column == BitmapFont::kGlyphWidth && i + 1 < letters.size() &&
                 covers(letters[i + 1], -1, row, 1))
          blend(image, x, y, scale, 0.02f, 0.85f);
      }
}

int textScale(int pictureHeight) {
  return std::max(1, (pictureHeight + 180) / 360);
}

void drawCaption(ImageFloat& image, const std::vector<std::string>& paragraphs) {
  const int scale = textScale(image.height);
  const int margin = 5 * scale;
  const int columns = (image.width - 2 * margin) / (BitmapFont::kAdvance * scale);
  std::vector<std::string> lines;
  for (const std::string& paragraph : paragraphs)
    for (std::string& line : wrapText(toFontLetters(paragraph), columns)) lines.push_back(std::move(line));
  int y = image.height - margin - static_cast<int>(lines.size()) * BitmapFont::kLineHeight * scale;
  for (const std::string& line : lines) {
    drawText(image, line, margin, y, scale);
    y += BitmapFont::kLineHeight * scale;
  }
}

}  // namespace spin
