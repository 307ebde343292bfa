// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/vtp_reader.h"

#include <cstdint>
#include <cstring>

#include "tests/plugins/support.h"

namespace spin::test {
namespace {

template <class T>
void convert(const char* data, std::size_t bytes, std::vector<double>& out) {
  for (std::size_t at = 0; at + sizeof(T) <= bytes; at += sizeof(T)) {
    T value;
    std::memcpy(&value, data + at, sizeof value);
    out.push_back(static_cast<double>(value));
  }
}

std::string readArray(const std::string& bytes, std::size_t base, const std::string& element,
                      std::size_t& end, VtpArray& array) {
  if (attributeOf(element, "format") != "appended") return "an array is not appended";
  array.type = attributeOf(element, "type");
  if (const std::string n = attributeOf(element, "NumberOfComponents"); !n.empty())
    array.components = std::stoi(n);
  const std::size_t at = base + std::stoull(attributeOf(element, "offset"));
  if (at != end) return "an array does not start where the one before ends";
  if (at + 8 > bytes.size()) return "an array lies outside";
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data() + at, 8);
  if (size > bytes.size() - at - 8) return "an array is longer than the file";
  end = at + 8 + size;
  if (array.type == "Float32")
    convert<float>(bytes.data() + at + 8, size, array.values);
  else if (array.type == "Float64")
    convert<double>(bytes.data() + at + 8, size, array.values);
  else if (array.type == "Int64")
    convert<std::int64_t>(bytes.data() + at + 8, size, array.values);
  else
    return "unknown type " + array.type;
  return {};
}

}  // namespace

std::string attributeOf(const std::string& element, const std::string& name) {
  const std::size_t at = element.find(" " + name + "=\"");
  if (at == std::string::npos) return {};
  const std::size_t start = at + name.size() + 3;
  return element.substr(start, element.find('"', start) - start);
}

VtpFile readVtp(const std::string& path) {
  VtpFile file;
  const std::string bytes = readBytes(path);
  const std::string mark = "<AppendedData encoding=\"raw\">";
  const std::size_t appended = bytes.find(mark);
  if (appended == std::string::npos) return file.problem = "no appended data", file;
  const std::string xml = bytes.substr(0, appended);
  const std::string root =
      xml.substr(xml.find("<VTKFile"), xml.find('>', xml.find("<VTKFile")) - xml.find("<VTKFile"));
  if (attributeOf(root, "type") != "PolyData" || attributeOf(root, "byte_order") != "LittleEndian" ||
      attributeOf(root, "header_type") != "UInt64")
    return file.problem = "wrong root: " + root, file;
  const std::size_t piece = xml.find("<Piece");
  if (piece == std::string::npos) return file.problem = "no piece", file;
  file.points = std::stoull(attributeOf(xml.substr(piece, xml.find('>', piece) - piece), "NumberOfPoints"));
  const std::size_t base = bytes.find('_', appended + mark.size()) + 1;
  std::size_t end = base;
  for (std::size_t at = xml.find("<DataArray"); at != std::string::npos;
       at = xml.find("<DataArray", at + 1)) {
    const std::string element = xml.substr(at, xml.find("/>", at) - at);
    VtpArray array;
    file.problem = readArray(bytes, base, element, end, array);
    if (!file.problem.empty()) return file;
    file.arrays[attributeOf(element, "Name")] = array;
  }
  if (bytes.substr(end) != "\n</AppendedData>\n</VTKFile>\n") file.problem = "bytes behind the arrays";
  return file;
}

}  // namespace spin::test
