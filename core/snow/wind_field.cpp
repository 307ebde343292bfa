// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/wind_field.h"

#include <algorithm>
#include <cmath>

#include "core/snow/exposure_field.h"
#include "core/snow/wind_columns.h"

namespace spin {
namespace {

constexpr double kProfileTop = 300.0;  ///< m above which the level wind grows no more
constexpr double kMostSolid = 0.999;   ///< a box is closed from here on

/// Integral of the level profile from the ground to a height, m2/s.
double profileIntegral(double above, double roughness) {
  const double norm = 1.0 / std::log(10.0 / roughness);
  const auto integral = [&](double z) {
    return z <= roughness ? 0.0 : norm * (z * std::log(z / roughness) - z + roughness);
  };
  if (above <= kProfileTop) return integral(above);
  return integral(kProfileTop) + (above - kProfileTop) * logProfile(kProfileTop, roughness);
}

/// Mean of the level profile between two heights.
double profileMean(double from, double to, double roughness) {
  if (to - from < 1e-9) return logProfile(from, roughness);
  return (profileIntegral(to, roughness) - profileIntegral(from, roughness)) / (to - from);
}

/// Means of the raster's heights over the columns; columns without data take the mean of their neighbours,
/// those first that have some.
bool fillGround(const Raster<float>& ground, WindColumns& g, double x0, double y0) {
  std::vector<double> sum(g.columns(), 0.0);
  std::vector<int> count(g.columns(), 0);
  const auto put = [&](int i, int j, int ci, int cj) {
    const float z = ground.at(i, j);
    if (!std::isfinite(z)) return;
    const std::size_t c = g.column(std::clamp(ci, 0, g.width - 1), std::clamp(cj, 0, g.height - 1));
    sum[c] += static_cast<double>(z);
    ++count[c];
  };
  for (int j = 0; j < ground.height; ++j)
    for (int i = 0; i < ground.width; ++i)
      put(i, j, static_cast<int>(std::floor((ground.x(i) - x0) / g.cell)),
          static_cast<int>(std::floor((ground.y(j) - y0) / g.cell)));
  if (std::all_of(count.begin(), count.end(), [](int n) { return n == 0; })) return false;
  g.ground.resize(g.columns());
  for (std::size_t c = 0; c < g.columns(); ++c) g.ground[c] = count[c] > 0 ? sum[c] / count[c] : 0.0;
  for (bool holes = true; holes;) {
    holes = false;
    const std::vector<int> known = count;
    for (int j = 0; j < g.height; ++j)
      for (int i = 0; i < g.width; ++i) {
        if (known[g.column(i, j)] > 0) continue;
        double near = 0.0;
        int found = 0;
        for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          const int ni = i + di, nj = j + dj;
          if (ni < 0 || nj < 0 || ni >= g.width || nj >= g.height || known[g.column(ni, nj)] == 0) continue;
          near += g.ground[g.column(ni, nj)];
          ++found;
        }
        if (found == 0) {
          holes = true;
          continue;
        }
        g.ground[g.column(i, j)] = near / found;
        count[g.column(i, j)] = 1;
      }
  }
  return true;
}

void setLevels(const WindSettings& settings, WindColumns& g) {
  const auto [low, high] = std::minmax_element(g.ground.begin(), g.ground.end());
  // What a hill does to the wind fades over its own width upwards; the top lies above that.
  const double extent = g.cell * std::max(g.width, g.height);
  g.top = *high + std::max({2.0 * (*high - *low), 0.5 * extent, 20.0});
  const double depth = g.top - *low;
  double thickness = std::min(settings.firstLayer, 0.25 * depth), sum = 0.0;
  std::vector<double> borders{0.0};
  while (sum < depth && borders.size() < 64) {
    sum += thickness;
    thickness *= settings.layerGrowth;
    borders.push_back(sum);
  }
  for (double& border : borders) border /= sum;
  borders.back() = 1.0;
  g.levels = std::move(borders);
  g.layers = static_cast<int>(g.levels.size()) - 1;
}

/// Shares of boxes that models fill: by the cells of their tops within the column.
void addObstacles(const std::vector<ObstacleTops>& obstacles, double x0, double y0, WindColumns& g) {
  g.solid.assign(g.boxes(), 0.0f);
  for (const ObstacleTops& tops : obstacles)
    for (int j = 0; j < tops.height; ++j)
      for (int i = 0; i < tops.width; ++i) {
        const double top = static_cast<double>(tops.at(i, j));
        const int ci = static_cast<int>(std::floor((tops.x(i) - x0) / g.cell)),
                  cj = static_cast<int>(std::floor((tops.y(j) - y0) / g.cell));
        if (!std::isfinite(top) || ci < 0 || cj < 0 || ci >= g.width || cj >= g.height) continue;
        const std::size_t c = g.column(ci, cj);
        const double share = std::min(1.0, tops.cellSize * tops.cellSize / (g.cell * g.cell));
        double bottom = g.ground[c];
        for (int k = 0; k < g.layers && bottom < top; ++k) {
          const double thick = g.thickness(c, k);
          float& solid = g.solid[c * static_cast<std::size_t>(g.layers) + static_cast<std::size_t>(k)];
          solid += static_cast<float>(share * std::min(1.0, (top - bottom) / thick));
          bottom += thick;
        }
      }
  for (float& share : g.solid) share = static_cast<double>(share) >= kMostSolid ? 1.0f : share;
}

struct Side {
  std::size_t a, b;  ///< columns on both sides; the same at the border
};

Side sideOf(const WindColumns& g, int i, int j, int di, int dj) {
  const auto inside = [&](int x, int y) { return x >= 0 && y >= 0 && x < g.width && y < g.height; };
  const std::size_t after = inside(i, j) ? g.column(i, j) : g.column(i - di, j - dj);
  const std::size_t before = inside(i - di, j - dj) ? g.column(i - di, j - dj) : after;
  return {before, after};
}

double openShare(const WindColumns& g, std::size_t a, std::size_t b, int k) {
  if (g.solid.empty()) return 1.0;
  const auto n = static_cast<std::size_t>(g.layers), layer = static_cast<std::size_t>(k);
  return 1.0 - static_cast<double>(std::max(g.solid[a * n + layer], g.solid[b * n + layer]));
}

/// Calls visit(face, side, layer) for all upright faces of an axis.
template <class Visit>
void uprightFaces(const WindColumns& g, int axis, const Visit& visit) {
  const int di = axis == 0 ? 1 : 0, dj = 1 - di;
  for (int j = 0; j < g.height + dj; ++j)
    for (int i = 0; i < g.width + di; ++i)
      for (int k = 0; k < g.layers; ++k)
        visit(axis == 0 ? xFace(g, i, j, k) : yFace(g, i, j, k), sideOf(g, i, j, di, dj), k);
}

WindFaces emptyFaces(const WindColumns& g) {
  const auto n = static_cast<std::size_t>(g.layers);
  const auto w = static_cast<std::size_t>(g.width), h = static_cast<std::size_t>(g.height);
  return {std::vector<double>((w + 1) * h * n, 0.0), std::vector<double>(w * (h + 1) * n, 0.0),
          std::vector<double>(w * h * (n + 1), 0.0)};
}

/// Slope of the border below layer k in a column, along an axis.
double borderSlope(const WindColumns& g, int i, int j, int axis, int k) {
  const int di = axis == 0 ? 1 : 0, dj = 1 - di;
  const std::size_t before = g.column(std::max(i - di, 0), std::max(j - dj, 0)),
                    after = g.column(std::min(i + di, g.width - 1), std::min(j + dj, g.height - 1));
  const double level = g.levels[static_cast<std::size_t>(k)];
  const double rise =
      (g.ground[after] + level * g.depth(after)) - (g.ground[before] + level * g.depth(before));
  const int steps = (di > 0 ? std::min(i + 1, g.width - 1) - std::max(i - 1, 0)
                            : std::min(j + 1, g.height - 1) - std::max(j - 1, 0));
  return steps > 0 ? rise / (steps * g.cell) : 0.0;
}

}  // namespace

double logProfile(double above, double roughness) {
  const double z = std::min(above, kProfileTop);
  return z <= roughness ? 0.0 : std::log(z / roughness) / std::log(10.0 / roughness);
}

WindFaces windConductances(const WindColumns& g, double verticalStiffness) {
  WindFaces c = emptyFaces(g);
  for (const int axis : {0, 1}) {
    std::vector<double>& faces = axis == 0 ? c.x : c.y;
    uprightFaces(g, axis, [&](std::size_t face, const Side& side, int k) {
      const double area = 0.5 * (g.thickness(side.a, k) + g.thickness(side.b, k)) * g.cell;
      const double distance = side.a == side.b ? 0.5 * g.cell : g.cell;
      faces[face] = area / distance * openShare(g, side.a, side.b, k);
    });
  }
  const double area = g.cell * g.cell / verticalStiffness;
  for (std::size_t column = 0; column < g.columns(); ++column)
    for (int k = 1; k <= g.layers; ++k) {
      const double below = g.thickness(column, k - 1);
      const bool top = k == g.layers;
      const double distance = top ? 0.5 * below : 0.5 * (below + g.thickness(column, k));
      double open = 1.0;
      if (!top && !g.solid.empty()) {
        const std::size_t box = column * static_cast<std::size_t>(g.layers) + static_cast<std::size_t>(k);
        open = 1.0 - static_cast<double>(std::max(g.solid[box - 1], g.solid[box]));
      }
      c.z[zFace(g, column, k)] = area / distance * open;
    }
  return c;
}

WindFaces levelWind(const WindColumns& g, int axis, double roughness) {
  WindFaces flow = emptyFaces(g);
  uprightFaces(g, axis, [&](std::size_t face, const Side& side, int k) {
    const double depth = 0.5 * (g.depth(side.a) + g.depth(side.b));
    const double from = g.levels[static_cast<std::size_t>(k)] * depth,
                 to = g.levels[static_cast<std::size_t>(k) + 1] * depth;
    const double through = (profileIntegral(to, roughness) - profileIntegral(from, roughness)) * g.cell;
    (axis == 0 ? flow.x : flow.y)[face] = through * openShare(g, side.a, side.b, k);
  });
  // A level wind also crosses the sloping borders of layers.
  for (int j = 0; j < g.height; ++j)
    for (int i = 0; i < g.width; ++i) {
      const std::size_t c = g.column(i, j);
      for (int k = 1; k < g.layers; ++k) {
        const double speed = logProfile(g.levels[static_cast<std::size_t>(k)] * g.depth(c), roughness);
        const std::size_t box = c * static_cast<std::size_t>(g.layers) + static_cast<std::size_t>(k);
        const double open =
            g.solid.empty() ? 1.0 : 1.0 - static_cast<double>(std::max(g.solid[box - 1], g.solid[box]));
        flow.z[zFace(g, c, k)] = -speed * borderSlope(g, i, j, axis, k) * g.cell * g.cell * open;
      }
    }
  return flow;
}

namespace {

/// Wind at the middle of a box over the level wind there.
std::array<float, 3> boxRatios(const WindColumns& g, const WindFaces& flow, int i, int j, int k,
                               double roughness) {
  const std::size_t c = g.column(i, j);
  const auto speedX = [&](int face) {
    const Side side = sideOf(g, face, j, 1, 0);
    return flow.x[xFace(g, face, j, k)] / (0.5 * (g.thickness(side.a, k) + g.thickness(side.b, k)) * g.cell);
  };
  const auto speedY = [&](int face) {
    const Side side = sideOf(g, i, face, 0, 1);
    return flow.y[yFace(g, i, face, k)] / (0.5 * (g.thickness(side.a, k) + g.thickness(side.b, k)) * g.cell);
  };
  const double u = 0.5 * (speedX(i) + speedX(i + 1)), v = 0.5 * (speedY(j) + speedY(j + 1));
  double w = 0.0;
  for (const int border : {k, k + 1})
    w += 0.5 * (flow.z[zFace(g, c, border)] / (g.cell * g.cell) + u * borderSlope(g, i, j, 0, border) +
                v * borderSlope(g, i, j, 1, border));
  const double from = g.levels[static_cast<std::size_t>(k)] * g.depth(c),
               to = g.levels[static_cast<std::size_t>(k) + 1] * g.depth(c);
  const double level = std::max(profileMean(from, to, roughness), 1e-9);
  return {static_cast<float>(u / level), static_cast<float>(v / level), static_cast<float>(w / level)};
}

}  // namespace

Result<WindField> WindField::make(const Raster<float>& ground, const std::vector<ObstacleTops>& obstacles,
                                  const WindSettings& settings, CpuBackend& backend) {
  const Error none = badInput("The wind has no ground to blow over", "terrain", "no cell has a height");
  if (ground.empty()) return none;
  WindColumns g;
  const double sizeX = ground.width * ground.cellSize, sizeY = ground.height * ground.cellSize;
  g.cell = std::max(ground.cellSize, std::max(sizeX, sizeY) / std::max(settings.mostColumns, 2));
  g.width = std::max(1, static_cast<int>(std::ceil(sizeX / g.cell - 1e-9)));
  g.height = std::max(1, static_cast<int>(std::ceil(sizeY / g.cell - 1e-9)));
  const double x0 = ground.originX - 0.5 * ground.cellSize, y0 = ground.originY - 0.5 * ground.cellSize;
  if (!fillGround(ground, g, x0, y0)) return none;
  setLevels(settings, g);
  if (!obstacles.empty()) addObstacles(obstacles, x0, y0, g);

  auto table = std::make_shared<WindTable>();
  table->width = g.width, table->height = g.height, table->layers = g.layers;
  table->originX = x0 + 0.5 * g.cell, table->originY = y0 + 0.5 * g.cell, table->cell = g.cell;
  table->roughness = settings.roughness;
  table->levels = g.levels;
  table->top = g.top;
  table->depth.resize(g.columns());
  for (std::size_t c = 0; c < g.columns(); ++c) table->depth[c] = static_cast<float>(g.depth(c));
  table->ratios.resize(g.boxes());
  WindField field(table);
  const WindFaces conductance = windConductances(g, settings.verticalStiffness);
  for (const int axis : {0, 1}) {
    WindFaces flow = levelWind(g, axis, settings.roughness);
    const WindBalance balance = balanceWind(g, conductance, settings.tolerance, settings.mostIterations,
                                            backend, flow, settings.cancel);
    if (settings.cancel && settings.cancel->cancelled()) return cancelledError();
    field.m_divergence = std::max(field.m_divergence, balance.divergence);
    field.m_iterations = std::max(field.m_iterations, balance.iterations);
    for (int j = 0; j < g.height; ++j)
      for (int i = 0; i < g.width; ++i)
        for (int k = 0; k < g.layers; ++k) {
          WindTable::Ratios& ratios =
              table
                  ->ratios[g.column(i, j) * static_cast<std::size_t>(g.layers) + static_cast<std::size_t>(k)];
          (axis == 0 ? ratios.byX : ratios.byY) = boxRatios(g, flow, i, j, k, settings.roughness);
        }
  }
  return field;
}

std::array<double, 6> WindField::ratiosAt(double x, double y, double above) const {
  const WindTable::Place place = m_table->placeOf(x, y);
  std::array<double, 6> sum{};
  for (std::size_t corner = 0; corner < 4; ++corner) {
    if (place.weight[corner] == 0.0) continue;
    const std::size_t c = place.column[corner];
    const double s = std::clamp(above / static_cast<double>(m_table->depth[c]), 0.0, 1.0);
    // Between the middles of the layers; the lowest and highest half hold their layer's.
    const auto after = std::upper_bound(m_table->levels.begin(), m_table->levels.end() - 1, s);
    const int k = static_cast<int>(after - m_table->levels.begin()) - 1;
    const auto middle = [&](int layer) {
      return 0.5 * (m_table->levels[static_cast<std::size_t>(layer)] +
                    m_table->levels[static_cast<std::size_t>(layer) + 1]);
    };
    const int low = s < middle(k) ? std::max(k - 1, 0) : k, high = std::min(low + 1, m_table->layers - 1);
    const double f =
        high > low ? std::clamp((s - middle(low)) / (middle(high) - middle(low)), 0.0, 1.0) : 0.0;
    const WindTable::Ratios& a =
        m_table->ratios[c * static_cast<std::size_t>(m_table->layers) + static_cast<std::size_t>(low)];
    const WindTable::Ratios& b =
        m_table->ratios[c * static_cast<std::size_t>(m_table->layers) + static_cast<std::size_t>(high)];
    for (std::size_t q = 0; q < 3; ++q) {
      sum[q] += place.weight[corner] *
                ((1 - f) * static_cast<double>(a.byX[q]) + f * static_cast<double>(b.byX[q]));
      sum[q + 3] += place.weight[corner] *
                    ((1 - f) * static_cast<double>(a.byY[q]) + f * static_cast<double>(b.byY[q]));
    }
  }
  return sum;
}

Vec3d WindField::at(double x, double y, double above, Vec2d wind10) const {
  const std::array<double, 6> r = ratiosAt(x, y, above);
  const double level = logProfile(above, m_table->roughness);
  return Vec3d{r[0] * wind10.x + r[3] * wind10.y, r[1] * wind10.x + r[4] * wind10.y,
               r[2] * wind10.x + r[5] * wind10.y} *
         level;
}

Vec3d WindField::changeAt(double x, double y, double above, Vec2d wind) const {
  const std::array<double, 6> r = ratiosAt(x, y, above);
  return {(r[0] - 1.0) * wind.x + r[3] * wind.y, r[1] * wind.x + (r[4] - 1.0) * wind.y,
          r[2] * wind.x + r[5] * wind.y};
}

double WindField::groundHeight(double x, double y) const {
  return m_table->groundHeight(m_table->placeOf(x, y));
}

double WindField::speedUp(double x, double y, double above, Vec2d wind10) const {
  const std::array<double, 6> r = ratiosAt(x, y, above);
  const double size = std::hypot(wind10.x, wind10.y);
  if (!(size > 0.0)) return 1.0;
  return std::hypot(r[0] * wind10.x + r[3] * wind10.y, r[1] * wind10.x + r[4] * wind10.y) / size;
}

}  // namespace spin
