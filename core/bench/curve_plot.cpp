// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/curve_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bench/svg_plot.h"

namespace spin {
namespace {

constexpr double kWidth = 760, kHeight = 320, kLeft = 60, kRight = 220, kTop = 15, kBottom = 45;
constexpr const char* kColours[] = {"#222222", "#1b6ca8", "#c0392b", "#2e8b57", "#8e44ad", "#d68910"};

/// 1, 2 or 5 times a power of ten, about a fifth of the range.
double tickOf(double range) {
  const double power = std::pow(10.0, std::floor(std::log10(range / 5.0)));
  const double lead = range / 5.0 / power;
  return power * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

struct CurveFrame {
  double xMost = 0.0, yMost = 0.0;
  double x(double v) const { return kLeft + v / xMost * (kWidth - kLeft - kRight); }
  double y(double v) const { return kHeight - kBottom - v / yMost * (kHeight - kTop - kBottom); }
};

std::string axesOf(const CurveFrame& frame, const std::string& xLabel, const std::string& yLabel) {
  std::string out = fmt::format("<rect x='{}' y='{}' width='{}' height='{}' fill='none' stroke='#888'/>\n",
                                kLeft, kTop, kWidth - kLeft - kRight, kHeight - kTop - kBottom);
  for (double v = 0.0; v <= frame.xMost * 1.0001; v += tickOf(frame.xMost))
    out += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>{:.4g}</text>\n", frame.x(v),
                       kHeight - kBottom + 16, v);
  for (double v = 0.0; v <= frame.yMost * 1.0001; v += tickOf(frame.yMost))
    out += fmt::format(
        "<line x1='{0}' y1='{1:.1f}' x2='{2}' y2='{1:.1f}' stroke='#ddd'/>"
        "<text x='{3}' y='{4:.1f}' text-anchor='end'>{5:.4g}</text>\n",
        kLeft, frame.y(v), kWidth - kRight, kLeft - 6, frame.y(v) + 4, v);
  out += fmt::format("<text x='{}' y='{}' text-anchor='middle'>{}</text>\n", 0.5 * (kLeft + kWidth - kRight),
                     kHeight - 8, htmlEscape(xLabel));
  return out + fmt::format("<text transform='translate(16,{}) rotate(-90)' text-anchor='middle'>{}</text>\n",
                           0.5 * kHeight, htmlEscape(yLabel));
}

std::string curveOf(const PlotCurve& curve, const CurveFrame& frame, std::size_t number) {
  const char* colour = kColours[number % std::size(kColours)];
  std::string out, path;
  const auto flush = [&] {
    if (!path.empty()) out += fmt::format("<polyline points='{}' fill='none' stroke='{}'/>\n", path, colour);
    path.clear();
  };
  for (const auto& [x, y] : curve.points) {
    if (!std::isfinite(y)) {
      flush();
    } else if (curve.dots) {
      out += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='1.6' fill='{}'/>\n", frame.x(x), frame.y(y),
                         colour);
    } else {
      path += fmt::format("{:.1f},{:.1f} ", frame.x(x), frame.y(y));
    }
  }
  flush();
  return out + fmt::format("<text x='{}' y='{}' fill='{}'>{}</text>\n", kWidth - kRight + 10,
                           kTop + 14 + 18.0 * static_cast<double>(number), colour, htmlEscape(curve.name));
}

}  // namespace

std::string curvePlotSvg(const std::vector<PlotCurve>& curves, const std::string& xLabel,
                         const std::string& yLabel) {
  CurveFrame frame;
  for (const PlotCurve& curve : curves)
    for (const auto& [x, y] : curve.points) {
      if (!std::isfinite(y)) continue;
      frame.xMost = std::max(frame.xMost, x);
      frame.yMost = std::max(frame.yMost, y);
    }
  if (!(frame.xMost > 0.0 && frame.yMost > 0.0)) return {};
  std::string out = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' "
      "font-family='sans-serif' font-size='12'><rect width='{0}' height='{1}' fill='white'/>\n",
      kWidth, kHeight);
  out += axesOf(frame, xLabel, yLabel);
  for (std::size_t i = 0; i < curves.size(); ++i) out += curveOf(curves[i], frame, i);
  return out + "</svg>\n";
}

}  // namespace spin
