// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace spin {

/// One curve of a plot: points (x, y), joined in the given order.
struct PlotSeries {
  std::string name;
  std::vector<std::pair<double, double>> points;
  bool hasBar = false;
  double bar = 0.0;  ///< drawn as a dashed level
};

/// An SVG element with logarithmic axes. Points that are not positive and finite have no place on such axes
/// and are left out; empty if none is left.
std::string logPlotSvg(const std::vector<PlotSeries>& series, const std::string& xLabel,
                       const std::string& yLabel);

/// Replaces the characters that mean something in HTML.
std::string htmlEscape(const std::string& text);

}  // namespace spin
