// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace spin::test {

struct VtpArray {
  std::string type;
  int components = 1;
  std::vector<double> values;
};

/// What a strict reader finds in a VTP file with appended raw data; `problem` says what is wrong with it.
struct VtpFile {
  std::string problem;
  std::size_t points = 0;
  std::map<std::string, VtpArray> arrays;
};

VtpFile readVtp(const std::string& path);
/// Value of an XML attribute within one element's text; empty if it is not there.
std::string attributeOf(const std::string& element, const std::string& name);

}  // namespace spin::test
