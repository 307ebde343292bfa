// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace spin {

/// One curve over linear axes; a value that is not finite interrupts it.
struct PlotCurve {
  std::string name;
  std::vector<std::pair<double, double>> points;
  bool dots = false;  ///< observations: dots instead of a line
};

/// An SVG element of curves over linear axes that begin at zero upwards.
std::string curvePlotSvg(const std::vector<PlotCurve>& curves, const std::string& xLabel,
                         const std::string& yLabel);

}  // namespace spin
