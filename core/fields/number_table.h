// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace spin {

/// Rows of numbers from a text with columns between white space, commas or semicolons.
struct NumberTable {
  std::size_t columns = 0;
  std::vector<double> values;      ///< row by row; NaN where the text says that a value is missing
  std::vector<std::size_t> lines;  ///< line of each row in the text, from 1

  std::size_t rows() const { return lines.size(); }
  double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

/// Reads a table of at least `columns` columns; further ones are left out. Lines that are empty or begin with
/// # are skipped, and so is one line of names before the first numbers. A value is missing where the field is
/// empty, "nan", "na", "null" or "-", or -99, -999, -9999 or -99999 with any decimals of 0. Anything else
/// that is no finite number is an error that names the line. `where`: the file, for the error.
Result<NumberTable> readNumberTable(std::string_view text, std::size_t columns, const std::string& where);

/// The text of a file, at most 256 MB.
Result<std::string> readTextFile(const std::string& path);

}  // namespace spin
