// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/model_assimp/ply_check.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

namespace spin {
namespace {

constexpr std::size_t kLongestHeader = std::size_t{64} << 10;

struct PlyElement {
  std::string name;
  double rows = 0.0;      ///< double: a hostile count must not wrap round
  double leastBytes = 0;  ///< of one row
};

double sizeOfType(const std::string& type) {
  for (const char* one : {"char", "uchar", "int8", "uint8"})
    if (type == one) return 1.0;
  for (const char* two : {"short", "ushort", "int16", "uint16"})
    if (type == two) return 2.0;
  return type == "double" || type == "float64" ? 8.0 : 4.0;
}

/// The header up to and with "end_header"; empty if there is none.
std::string headerOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kLongestHeader, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.rfind("ply", 0) != 0) return {};
  const std::size_t end = text.find("end_header");
  const std::size_t line = end == std::string::npos ? end : text.find('\n', end);
  return line == std::string::npos ? std::string() : text.substr(0, line + 1);
}

std::vector<PlyElement> elementsOf(const std::string& header) {
  std::vector<PlyElement> elements;
  const bool ascii = header.find("format ascii") != std::string::npos;
  std::istringstream lines(header);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, type;
    words >> word;
    if (word == "element") {
      PlyElement element;
      words >> element.name >> element.rows;
      if (!words) element.rows = -1.0;
      elements.push_back(element);
    } else if (word == "property" && !elements.empty() && words >> type) {
      std::string counter;
      if (type == "list") words >> counter;
      // In text, a digit and what separates it from the next.
      elements.back().leastBytes += ascii ? 2.0 : sizeOfType(type == "list" ? counter : type);
    }
  }
  return elements;
}

}  // namespace

Status checkPlyFile(const std::string& path) {
  const auto bad = [&](const std::string& why) {
    return badInput("The model could not be read", path, why,
                    "The file may be cut off: copy or export it again");
  };
  const std::string header = headerOf(path);
  if (header.empty()) return bad("its header is not that of a PLY file, or is cut off");
  std::error_code error;
  const double size = static_cast<double>(std::filesystem::file_size(path, error));
  double need = static_cast<double>(header.size());
  for (const PlyElement& element : elementsOf(header)) {
    if (!(element.rows >= 0.0)) return bad(fmt::format("the number of its \"{}\" is none", element.name));
    need += element.rows * element.leastBytes;
  }
  // The last line of a text file may lack its end.
  if (error || need > size + 1.0)
    return bad(fmt::format("it promises at least {:.0f} bytes and has {:.0f}", need, size));
  return {};
}

}  // namespace spin
