// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flake/flake_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace spin {
namespace {

constexpr double kRim = 1.0;        // pixels that stay clear round the flake
constexpr double kFatness = 1.15;   // of drawn discs
constexpr double kTouching = 1.06;  // distance of discs that have grown together
constexpr double kFinest = 3.0;     // pixels of a disc's diameter on the canvas it is drawn on
constexpr int kLargestCanvas = 4096;
constexpr int kSamples = 4;         // of a crystal's picture, per pixel and axis
constexpr double kClearest = 0.45;  // cover of the thinnest ice

Status checkSize(int size) {
  if (size >= kSmallestPicture && size <= kLargestPicture) return {};
  return badInput(
      "The flake cannot be drawn", "size",
      fmt::format("{} pixels are not between {} and {}", size, kSmallestPicture, kLargestPicture));
}

/// A picture on a finer canvas, and the means over its blocks.
class Canvas {
 public:
  Canvas(int size, int factor) : m_size(size), m_factor(factor), m_ink(square(size * factor), 0.0f) {}

  /// Lays a disc over what is there; coordinates in canvas pixels.
  void disc(Vec2d centre, double radius) {
    const int n = m_size * m_factor;
    const int x0 = std::max(static_cast<int>(centre.x - radius - 1.0), 0);
    const int y0 = std::max(static_cast<int>(centre.y - radius - 1.0), 0);
    const int x1 = std::min(static_cast<int>(centre.x + radius + 1.0), n - 1);
    const int y1 = std::min(static_cast<int>(centre.y + radius + 1.0), n - 1);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double dx = x + 0.5 - centre.x, dy = y + 0.5 - centre.y;
        raise(x, y, radius - std::sqrt(dx * dx + dy * dy) + 0.5);
      }
  }

  /// Lays a bar over what is there, from one point to another.
  void bar(Vec2d from, Vec2d to, double halfWidth) {
    const int n = m_size * m_factor;
    const auto low = [&](double a, double b) {
      return std::max(static_cast<int>(std::min(a, b) - halfWidth - 1.0), 0);
    };
    const auto high = [&](double a, double b) {
      return std::min(static_cast<int>(std::max(a, b) + halfWidth + 1.0), n - 1);
    };
    const Vec2d way = to - from;
    const double squared = way.x * way.x + way.y * way.y;
    for (int y = low(from.y, to.y); y <= high(from.y, to.y); ++y)
      for (int x = low(from.x, to.x); x <= high(from.x, to.x); ++x) {
        const Vec2d d{x + 0.5 - from.x, y + 0.5 - from.y};
        const double t = std::clamp((d.x * way.x + d.y * way.y) / squared, 0.0, 1.0);
        const double dx = d.x - t * way.x, dy = d.y - t * way.y;
        raise(x, y, halfWidth - std::sqrt(dx * dx + dy * dy) + 0.5);
      }
  }

  FlakePicture picture(double radius) const {
    FlakePicture made{m_size, radius, std::vector<float>(square(m_size), 0.0f)};
    const int n = m_size * m_factor;
    const double share = 1.0 / (m_factor * m_factor);
    for (int y = 0; y < m_size; ++y)
      for (int x = 0; x < m_size; ++x) {
        double sum = 0.0;
        for (int b = 0; b < m_factor; ++b)
          for (int a = 0; a < m_factor; ++a)
            sum += static_cast<double>(
                m_ink[static_cast<std::size_t>(y * m_factor + b) * static_cast<std::size_t>(n) +
                      static_cast<std::size_t>(x * m_factor + a)]);
        made.cover[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size) +
                   static_cast<std::size_t>(x)] = static_cast<float>(sum * share);
      }
    return made;
  }

 private:
  static std::size_t square(int n) { return static_cast<std::size_t>(n) * static_cast<std::size_t>(n); }
  void raise(int x, int y, double ink) {
    float& pixel = m_ink[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size * m_factor) +
                         static_cast<std::size_t>(x)];
    pixel = std::max(pixel, static_cast<float>(std::clamp(ink, 0.0, 1.0)));
  }

  int m_size, m_factor;
  std::vector<float> m_ink;
};

/// Calls f(a, b) once for each pair of points that are nearer to each other than `reach`.
template <class F>
void forPairs(const std::vector<Vec2d>& points, double reach, const F& f) {
  using Cell = std::pair<int, int>;
  const auto cellOf = [&](Vec2d p) {
    return Cell{static_cast<int>(std::floor(p.y / reach)), static_cast<int>(std::floor(p.x / reach))};
  };
  std::vector<std::pair<Cell, std::size_t>> sorted;
  sorted.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) sorted.emplace_back(cellOf(points[k]), k);
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [cell, a] : sorted)
    for (int row = cell.first - 1; row <= cell.first + 1; ++row) {
      auto other = std::lower_bound(sorted.begin(), sorted.end(),
                                    std::pair(Cell{row, cell.second - 1}, std::size_t{0}));
      for (; other != sorted.end() && other->first <= Cell{row, cell.second + 1}; ++other) {
        const std::size_t b = other->second;
        const Vec2d d = points[b] - points[a];
        if (a < b && d.x * d.x + d.y * d.y < reach * reach) f(points[a], points[b]);
      }
    }
}

/// Ice of a crystal at a point of the plane, 0 where there is none; unit: the distance of neighbouring cells.
class CrystalInk {
 public:
  explicit CrystalInk(const CrystalGrower& crystal) : m_crystal(&crystal) {
    std::vector<double> masses;
    for (int i = 0; i <= crystal.reach(); ++i)
      for (int j = 0; j <= i; ++j)
        if (crystal.frozen(i, j)) masses.push_back(crystal.thickness(i, j));
    std::sort(masses.begin(), masses.end());
    m_thin = masses[masses.size() / 50];
    m_thick = std::max(masses[masses.size() - 1 - masses.size() / 50], m_thin + 1e-9);
  }
  double at(Vec2d p) const {
    constexpr double kRootThird = 0.57735026918962576;
    // Skew coordinates along e = (1, 0) and f = (1/2, sqrt(3)/2), rounded to the nearest hexagon.
    const double v = 2.0 * kRootThird * p.y, u = p.x - 0.5 * v;
    double i = std::round(u), j = std::round(v);
    const double du = u - i, dv = v - j, dw = -(du + dv) - std::round(-(du + dv));
    if (std::round(-(u + v)) + i + j != 0.0) {
      if (std::abs(du) > std::abs(dv) && std::abs(du) > std::abs(dw))
        i = -j - std::round(-(u + v));
      else if (std::abs(dv) > std::abs(dw))
        j = -i - std::round(-(u + v));
    }
    const int a = static_cast<int>(i), b = static_cast<int>(j);
    if (!m_crystal->frozen(a, b)) return 0.0;
    const double thickness = (m_crystal->thickness(a, b) - m_thin) / (m_thick - m_thin);
    return kClearest + (1.0 - kClearest) * std::clamp(thickness, 0.0, 1.0);
  }

 private:
  const CrystalGrower* m_crystal;
  double m_thin = 0.0, m_thick = 1.0;
};

}  // namespace

double FlakePicture::total() const {
  double sum = 0.0;
  for (const float c : cover) sum += static_cast<double>(c);
  return sum;
}

Result<FlakePicture> drawFlake(const std::vector<Vec2d>& centres, int size, double reach) {
  if (Status status = checkSize(size); !status) return status.error();
  if (centres.empty()) return badInput("The flake cannot be drawn", "flake", "it has no particles");
  for (const Vec2d& p : centres) reach = std::max(reach, std::sqrt(p.x * p.x + p.y * p.y));
  const double radius = 0.5 * size - kRim, scale = radius / (reach + 0.5 * kFatness);
  int factor = 1;
  while (factor * scale < kFinest && 2 * factor * size <= kLargestCanvas) factor *= 2;
  factor = std::max(factor, 2);
  Canvas canvas(size, factor);
  const double fine = scale * factor, middle = 0.5 * size * factor;
  for (const Vec2d& p : centres)
    canvas.disc({middle + fine * p.x, middle + fine * p.y}, 0.5 * kFatness * fine);
  forPairs(centres, kTouching, [&](Vec2d a, Vec2d b) {
    canvas.bar({middle + fine * a.x, middle + fine * a.y}, {middle + fine * b.x, middle + fine * b.y},
               0.5 * kFatness * fine);
  });
  return canvas.picture(radius);
}

Result<FlakePicture> drawCrystal(const CrystalGrower& crystal, int size, int cells) {
  if (Status status = checkSize(size); !status) return status.error();
  const double radius = 0.5 * size - kRim;
  FlakePicture made{size, radius, {}};
  made.cover.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  const CrystalInk ink(crystal);
  const double cell = (std::max(crystal.reach(), cells) + 0.7) / radius;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      double sum = 0.0;
      for (int b = 0; b < kSamples; ++b)
        for (int a = 0; a < kSamples; ++a)
          sum += ink.at({(x + (a + 0.5) / kSamples - 0.5 * size) * cell,
                         (y + (b + 0.5) / kSamples - 0.5 * size) * cell});
      made.cover.push_back(static_cast<float>(sum / (kSamples * kSamples)));
    }
  return made;
}

FlakePicture halved(const FlakePicture& picture) {
  SPIN_CHECK(picture.size % 2 == 0, "only a picture of even size has a half");
  const int n = picture.size / 2;
  FlakePicture half{n, 0.5 * picture.radius, {}};
  half.cover.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      half.cover.push_back(0.25f * (picture.at(2 * x, 2 * y) + picture.at(2 * x + 1, 2 * y) +
                                    picture.at(2 * x, 2 * y + 1) + picture.at(2 * x + 1, 2 * y + 1)));
  return half;
}

}  // namespace spin
