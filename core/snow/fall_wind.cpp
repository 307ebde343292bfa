// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/fall_wind.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/fields/terrain_surface.h"
#include "core/sim/shared_registry.h"
#include "core/snow/snow_scene.h"
#include "core/snow/wind_shelter.h"

namespace spin {
namespace {

constexpr int kMostColumns = 96;
constexpr double kFinest = 0.5;   ///< m, side of a column
constexpr double kMargin = 40.0;  ///< m round models, in which the wind finds back to its own
constexpr double kRim = 0.15;     ///< share of the columns over which the change fades out at the rim
/// Columns that a step goes back along the way of fall. Beyond the diagonal of a column the four round its
/// start have all been found before.
constexpr double kStepColumns = 3.0;
constexpr double kMiddleSize = 2.0;  ///< -log(1 - u) of the flakes that hide most

/// Land and models in plan that the columns stand on.
struct Plan {
  double x0, y0, x1, y1;
};

Plan planOf(const SceneSnapshot& scene, const std::vector<StandingModel>& models) {
  const Raster<float>& h = scene.terrain->heights;
  const Plan land{h.x(0), h.y(0), h.x(h.width - 1), h.y(h.height - 1)};
  Box3d box;
  for (const StandingModel& model : models)
    for (const PlacedTriangle& triangle : model.triangles)
      for (const Vec3f& corner : triangle.corners)
        box.extend(corner.to<double>() + model.placement.translation);
  if (box.empty()) return land;
  const double margin = std::max(kMargin, 0.5 * std::max(box.size().x, box.size().y));
  const Plan round{std::max(box.min.x - margin, land.x0), std::max(box.min.y - margin, land.y0),
                   std::min(box.max.x + margin, land.x1), std::min(box.max.y + margin, land.y1)};
  return round.x0 < round.x1 && round.y0 < round.y1 ? round : land;
}

Raster<float> heightsOver(const Plan& plan, const Raster<float>& heights) {
  const double side = std::max(plan.x1 - plan.x0, plan.y1 - plan.y0);
  const double cell = std::max(side / kMostColumns, kFinest);
  const auto cells = [&](double length) { return std::max(static_cast<int>(length / cell), 1); };
  Raster<float> over(cells(plan.x1 - plan.x0), cells(plan.y1 - plan.y0), plan.x0 + 0.5 * cell,
                     plan.y0 + 0.5 * cell, cell);
  const TerrainSurface surface(heights);
  for (int j = 0; j < over.height; ++j)
    for (int i = 0; i < over.width; ++i)
      over.at(i, j) = static_cast<float>(
          surface.heightAt(over.x(i), over.y(j)).value_or(std::numeric_limits<double>::quiet_NaN()));
  return over;
}

/// Heights above the ground at which shifts are kept.
std::vector<double> levelsUpTo(double top) {
  std::vector<double> levels{0.0};
  for (double step = 1.5; levels.back() < top; step *= 1.25) levels.push_back(levels.back() + step);
  return levels;
}

double fallSpeedOf(const FallingFlakes& flakes) {
  return flakes.classes[static_cast<std::size_t>(flakeClassOf(kMiddleSize))].fallSpeed;
}

}  // namespace

std::shared_ptr<const WindTable> makeFallWindTable(const SceneSnapshot& scene, const SnowGround& ground,
                                                   CpuBackend& backend) {
  if (!scene.terrain || ground.terrain.empty()) return nullptr;
  const std::vector<StandingModel> models = modelsAtStart(scene, ground);
  const Raster<float> heights = heightsOver(planOf(scene, models), scene.terrain->heights);
  WindSettings settings;
  settings.mostColumns = kMostColumns;
  settings.firstLayer = std::clamp(heights.cellSize, 1.0, 4.0);
  settings.tolerance = 1e-4;
  const auto field = WindField::make(heights, {obstacleTops(heights, models)}, settings, backend);
  return field ? registryOf<WindTable>().intern(field->table()) : nullptr;
}

/// A place among four columns.
struct FallWind::Spot {
  std::array<std::size_t, 4> column{};
  std::array<double, 4> weight{};
};

bool FallWind::find(double x, double y, Spot& spot) const {
  const WindTable& t = *m_field.table();
  const double u = (x - t.originX) / t.cell, v = (y - t.originY) / t.cell;
  if (!(u >= 0.0 && v >= 0.0 && u <= t.width - 1 && v <= t.height - 1)) return false;
  const int i = std::min(static_cast<int>(u), std::max(t.width - 2, 0)),
            j = std::min(static_cast<int>(v), std::max(t.height - 2, 0));
  const double fu = u - i, fv = v - j;
  const auto column = [&](int a, int b) {
    return static_cast<std::size_t>(std::min(b, t.height - 1)) * static_cast<std::size_t>(t.width) +
           static_cast<std::size_t>(std::min(a, t.width - 1));
  };
  spot = {{column(i, j), column(i + 1, j), column(i, j + 1), column(i + 1, j + 1)},
          {(1 - fu) * (1 - fv), fu * (1 - fv), (1 - fu) * fv, fu * fv}};
  return true;
}

double FallWind::groundAt(const Spot& spot) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) sum += spot.weight[k] * static_cast<double>(m_ground[spot.column[k]]);
  return sum;
}

Vec3d FallWind::sample(const Spot& spot, double above) const {
  const auto after = std::upper_bound(m_levels.begin() + 1, m_levels.end() - 1, above);
  const auto k = static_cast<std::size_t>(after - m_levels.begin()) - 1;
  const double f = std::clamp((above - m_levels[k]) / (m_levels[k + 1] - m_levels[k]), 0.0, 1.0);
  Vec3d sum{};
  for (std::size_t c = 0; c < 4; ++c) {
    const Vec3f* shift = m_shift.data() + spot.column[c] * m_levels.size() + k;
    sum += (shift[0].to<double>() * (1.0 - f) + shift[1].to<double>() * f) * spot.weight[c];
  }
  return sum;
}

double FallWind::windowAt(double x, double y) const {
  const WindTable& t = *m_field.table();
  const auto share = [](double at, int count) {
    const double rim = std::max(kRim * (count - 1), 1e-9);
    const double in = std::clamp(std::min(at, count - 1 - at) / rim, 0.0, 1.0);
    return in * in * (3.0 - 2.0 * in);
  };
  return share((x - t.originX) / t.cell, t.width) * share((y - t.originY) / t.cell, t.height);
}

/// The shift at a node: that where a step back along the way of fall begins, and what the wind adds on it.
Vec3d FallWind::arrive(Vec3d p) const {
  const double speed = std::hypot(m_wind.x, m_wind.y);
  const double seconds = kStepColumns * m_field.cellSize() / speed, climb = m_fallSpeed * seconds;
  const Vec3d back = Vec3d{-m_wind.x, -m_wind.y, m_fallSpeed} * seconds;
  const int parts = std::clamp(static_cast<int>(std::ceil(climb / 2.0)), 3, 24);
  Vec3d change{};
  for (int k = 0; k < parts; ++k) {
    const Vec3d q = p + back * ((k + 0.5) / parts);
    Spot spot;
    if (!find(q.x, q.y, spot)) break;
    const double above = std::max(q.z - groundAt(spot), 0.0);
    change += m_field.changeAt(q.x, q.y, above, m_wind) * (windowAt(q.x, q.y) / parts);
  }
  Spot from;
  const Vec3d q = p + back;
  const bool inside = find(q.x, q.y, from);
  const double above = inside ? q.z - groundAt(from) : 0.0;
  return change * seconds + (inside && above < m_levels.back() ? sample(from, above) : Vec3d{});
}

FallWind::FallWind(std::shared_ptr<const WindTable> table, Vec2d wind, double fallSpeed, CpuBackend& backend)
    : m_field(std::move(table)), m_wind(wind), m_fallSpeed(fallSpeed) {
  const WindTable& t = *m_field.table();
  double deepest = 0.0;
  for (const float depth : t.depth) {
    m_ground.push_back(static_cast<float>(t.top) - depth);
    deepest = std::max(deepest, static_cast<double>(depth));
  }
  m_levels = levelsUpTo(deepest);
  m_shift.resize(t.columns() * m_levels.size());
  // Columns in bands across the wind, so narrow that no step back ends in its own band.
  const double speed = std::hypot(wind.x, wind.y);
  const double band = (kStepColumns - std::sqrt(2.0)) * t.cell;
  std::vector<std::vector<std::size_t>> bands;
  const auto along = [&](int i, int j) { return (i * wind.x + j * wind.y) / speed * t.cell; };
  double least = 0.0;
  for (const auto& [i, j] :
       {std::pair{0, 0}, {t.width - 1, 0}, {0, t.height - 1}, {t.width - 1, t.height - 1}})
    least = std::min(least, along(i, j));
  for (int j = 0; j < t.height; ++j)
    for (int i = 0; i < t.width; ++i) {
      const auto number = static_cast<std::size_t>((along(i, j) - least) / band);
      if (number >= bands.size()) bands.resize(number + 1);
      bands[number].push_back(static_cast<std::size_t>(j) * static_cast<std::size_t>(t.width) +
                              static_cast<std::size_t>(i));
    }
  for (const std::vector<std::size_t>& columns : bands)
    backend.forEach(
        "flake wind", columns.size(),
        [&](std::size_t n) {
          const std::size_t c = columns[n], width = static_cast<std::size_t>(t.width);
          const double x = t.originX + static_cast<double>(c % width) * t.cell,
                       y = t.originY + static_cast<double>(c / width) * t.cell;
          for (std::size_t k = 0; k < m_levels.size(); ++k)
            m_shift[c * m_levels.size() + k] =
                arrive({x, y, static_cast<double>(m_ground[c]) + m_levels[k]}).to<float>();
        },
        8);
}

std::shared_ptr<const FallWind> FallWind::of(const FallingFlakes& flakes, CpuBackend& backend) {
  if (!flakes.landWind || !(fallSpeedOf(flakes) > 0.0)) return nullptr;
  return std::make_shared<FallWind>(flakes.landWind, Vec2d{flakes.wind.x, flakes.wind.y}, fallSpeedOf(flakes),
                                    backend);
}

bool FallWind::holdsFor(const FallingFlakes& flakes) const {
  return flakes.landWind == m_field.table() && flakes.wind.x == m_wind.x && flakes.wind.y == m_wind.y &&
         fallSpeedOf(flakes) == m_fallSpeed;
}

Vec3d FallWind::shiftAt(Vec3d p) const {
  Spot spot;
  return find(p.x, p.y, spot) ? sample(spot, std::max(p.z - groundAt(spot), 0.0)) * windowAt(p.x, p.y)
                              : Vec3d{};
}

Vec3d FallWind::velocityAt(Vec3d p, Vec3d velocity) const {
  const double speed = length(velocity);
  if (!(speed > 0.0)) return {};
  const double seconds = 0.25 * m_field.cellSize() / speed;
  return (shiftAt(p + velocity * seconds) - shiftAt(p - velocity * seconds)) * (0.5 / seconds);
}

Vec3d FallWind::before(Vec3d p) const {
  Vec3d q = p;
  for (int k = 0; k < 12; ++k) q = p - shiftAt(q);
  return q;
}

double FallWind::spread(Vec3d p, double halfBox) const {
  const Vec3d own = shiftAt(p);
  double most = 0.0;
  for (int k = -3; k <= 3; ++k)
    for (int j = -3; j <= 3; ++j)
      for (int i = -3; i <= 3; ++i)
        most = std::max(most,
                        length(shiftAt(p + Vec3d{double(i), double(j), double(k)} * (halfBox / 3.0)) - own));
  return 1.25 * most;
}

}  // namespace spin
