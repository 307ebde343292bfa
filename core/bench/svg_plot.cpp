// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace spin {
namespace {

constexpr double kWidth = 640, kHeight = 400, kLeft = 80, kRight = 220, kTop = 20, kBottom = 50;
constexpr const char* kColours[] = {"#1b6ca8", "#c0392b", "#2e8b57", "#8e44ad", "#d68910", "#5d6d7e"};

bool drawable(double v) {
  return std::isfinite(v) && v > 0.0;
}

/// Decades from low to high onto pixels from `from` to `to`.
struct Axis {
  double low = std::numeric_limits<double>::infinity(), high = -low, from = 0, to = 1;
  void include(double v) {
    low = std::min(low, std::floor(std::log10(v)));
    high = std::max(high, std::ceil(std::log10(v)));
  }
  void finish() {
    if (high <= low) high = low + 1;
  }
  double at(double v) const { return from + (std::log10(v) - low) / (high - low) * (to - from); }
};

std::string axesSvg(const Axis& x, const Axis& y, const std::string& xLabel, const std::string& yLabel) {
  std::string out = fmt::format("<rect x='{}' y='{}' width='{}' height='{}' fill='none' stroke='#888'/>\n",
                                x.from, y.to, x.to - x.from, y.from - y.to);
  for (double d = x.low; d <= x.high; ++d) {
    const double p = x.at(std::pow(10.0, d));
    out += fmt::format("<line x1='{0:.1f}' y1='{1}' x2='{0:.1f}' y2='{2}' stroke='#ddd'/>", p, y.from, y.to);
    out += fmt::format("<text x='{:.1f}' y='{}' text-anchor='middle'>1e{:.0f}</text>\n", p, y.from + 16, d);
  }
  for (double d = y.low; d <= y.high; ++d) {
    const double p = y.at(std::pow(10.0, d));
    out += fmt::format("<line x1='{1}' y1='{0:.1f}' x2='{2}' y2='{0:.1f}' stroke='#ddd'/>", p, x.from, x.to);
    out += fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>1e{:.0f}</text>\n", x.from - 6, p + 4, d);
  }
  out += fmt::format("<text x='{}' y='{}' text-anchor='middle'>{}</text>\n", 0.5 * (x.from + x.to),
                     y.from + 36, htmlEscape(xLabel));
  return out + fmt::format("<text transform='translate(20,{}) rotate(-90)' text-anchor='middle'>{}</text>\n",
                           0.5 * (y.from + y.to), htmlEscape(yLabel));
}

std::string seriesSvg(const PlotSeries& s, const Axis& x, const Axis& y, std::size_t number) {
  const char* colour = kColours[number % std::size(kColours)];
  std::string path, dots;
  for (const auto& [px, py] : s.points) {
    if (!drawable(px) || !drawable(py)) continue;
    path += fmt::format("{:.1f},{:.1f} ", x.at(px), y.at(py));
    dots += fmt::format(
        "<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}'><title>{:.4g} s, {:.4g}</title></circle>\n",
        x.at(px), y.at(py), colour, px, py);
  }
  std::string out = fmt::format("<polyline points='{}' fill='none' stroke='{}'/>\n{}", path, colour, dots);
  if (s.hasBar && drawable(s.bar))
    out += fmt::format(
        "<line x1='{1}' y1='{0:.1f}' x2='{2}' y2='{0:.1f}' stroke='{3}' stroke-dasharray='6 4'/>\n",
        y.at(s.bar), x.from, x.to, colour);
  return out + fmt::format("<text x='{}' y='{}' fill='{}'>{}</text>\n", x.to + 10,
                           y.to + 16 + 18.0 * double(number), colour, htmlEscape(s.name));
}

}  // namespace

std::string htmlEscape(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string logPlotSvg(const std::vector<PlotSeries>& series, const std::string& xLabel,
                       const std::string& yLabel) {
  Axis x, y;
  x.from = kLeft, x.to = kWidth - kRight, y.from = kHeight - kBottom, y.to = kTop;
  bool any = false;
  for (const PlotSeries& s : series) {
    for (const auto& [px, py] : s.points)
      if (drawable(px) && drawable(py)) x.include(px), y.include(py), any = true;
    if (s.hasBar && drawable(s.bar)) y.include(s.bar);
  }
  if (!any) return {};
  x.finish();
  y.finish();
  std::string out = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' "
      "font-family='sans-serif' font-size='12'>\n",
      kWidth, kHeight);
  out += axesSvg(x, y, xLabel, yLabel);
  for (std::size_t i = 0; i < series.size(); ++i) out += seriesSvg(series[i], x, y, i);
  return out + "</svg>\n";
}

}  // namespace spin
