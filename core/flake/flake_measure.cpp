// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flake/flake_measure.h"

#include <algorithm>

namespace spin {
namespace {

/// Least-squares line through points that are added one by one.
class LineFit {
 public:
  void add(double x, double y) { m_n += 1.0, m_x += x, m_y += y, m_xx += x * x, m_xy += x * y; }
  double slope() const { return (m_n * m_xy - m_x * m_y) / (m_n * m_xx - m_x * m_x); }
  double intercept() const { return (m_y - slope() * m_x) / m_n; }

 private:
  double m_n = 0.0, m_x = 0.0, m_y = 0.0, m_xx = 0.0, m_xy = 0.0;
};

/// Running sums of a growing cluster.
struct Sums {
  double n = 0.0, x = 0.0, y = 0.0, rr = 0.0;
  void add(Vec2d p) { n += 1.0, x += p.x, y += p.y, rr += p.x * p.x + p.y * p.y; }
  double gyration() const {
    if (n == 0.0) return 0.0;
    return std::sqrt(std::max(rr / n - (x * x + y * y) / (n * n), 0.0));
  }
};

constexpr double kRatio = 1.05;  // of neighbouring points of a fit

}  // namespace

double gyrationRadius(const std::vector<Vec2d>& centres, std::size_t count) {
  Sums sums;
  for (std::size_t k = 0; k < std::min(count, centres.size()); ++k) sums.add(centres[k]);
  return sums.gyration();
}

double gyrationDimension(const std::vector<Vec2d>& centres) {
  if (centres.size() < 500) return 0.0;
  double next = std::max(50.0, static_cast<double>(centres.size()) / 100.0);
  Sums sums;
  LineFit fit;
  for (const Vec2d& p : centres) {
    sums.add(p);
    if (sums.n < next) continue;
    fit.add(std::log(sums.n), std::log(sums.gyration()));
    next *= kRatio;
  }
  return 1.0 / fit.slope();
}

MassRadiusLaw massRadiusLaw(const std::vector<Vec2d>& centres) {
  std::vector<double> radii;
  radii.reserve(centres.size());
  for (const Vec2d& p : centres) radii.push_back(std::sqrt(p.x * p.x + p.y * p.y));
  std::sort(radii.begin(), radii.end());
  if (radii.empty() || radii.back() < 16.0) return {};
  LineFit fit;
  for (double r = 4.0; r <= 0.5 * radii.back(); r *= kRatio) {
    const auto inside = std::upper_bound(radii.begin(), radii.end(), r) - radii.begin();
    fit.add(std::log(r), std::log(static_cast<double>(inside)));
  }
  return {std::exp(fit.intercept()), fit.slope()};
}

}  // namespace spin
