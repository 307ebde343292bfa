// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/terrain_gdal/ascii_check.h"

#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <vector>

namespace spin {
namespace {

constexpr std::size_t kLongestToken = 64;

bool isNumber(const std::string& token) {
  std::string lower;
  for (const char c : token) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const std::size_t sign = lower[0] == '-' || lower[0] == '+' ? 1 : 0;
  if (const std::string word = lower.substr(sign); word == "nan" || word == "inf") return true;
  bool digit = false;
  for (const char c : lower) {
    if (c >= '0' && c <= '9')
      digit = true;
    else if (c != '+' && c != '-' && c != '.' && c != ',' && c != 'e')
      return false;
  }
  return digit;
}

/// Takes the file apart into tokens with their line.
class GridTokens {
 public:
  /// False as soon as a token of the data part is no number.
  bool add(const char* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      const char c = data[i];
      const bool space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
      if (!space && m_token.size() < kLongestToken) m_token += c;
      if (space && !endToken()) return false;
      if (c == '\n') {
        ++m_line;
        m_headerLine = false;
      }
    }
    return true;
  }
  bool endToken() {
    if (m_token.empty()) return true;
    // "ncols 4": a line of the header starts with a word, and is the first of its line.
    if (!m_data && !m_headerLine) {
      m_headerLine = std::isalpha(static_cast<unsigned char>(m_token[0])) != 0 && !isNumber(m_token);
      m_data = !m_headerLine;
    }
    if (m_data && !isNumber(m_token)) return false;
    m_token.clear();
    return true;
  }
  std::size_t line() const { return m_line; }
  const std::string& token() const { return m_token; }

 private:
  std::string m_token;
  std::size_t m_line = 1;
  bool m_headerLine = false;
  bool m_data = false;
};

}  // namespace

Status checkAsciiGrid(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> buffer(std::size_t{1} << 20);
  GridTokens tokens;
  bool sound = true;
  while (sound && file) {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    sound = tokens.add(buffer.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (sound && tokens.endToken()) return {};
  std::string shown;
  for (const char c : tokens.token()) shown += std::isprint(static_cast<unsigned char>(c)) ? c : '?';
  return badInput("The raster could not be read", path,
                  fmt::format("line {} holds \"{}\" where a number is wanted", tokens.line(), shown),
                  "Correct the line, or export the raster again");
}

}  // namespace spin
