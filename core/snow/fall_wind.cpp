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

constexpr int kMostColumns = 80;  ///< summed up within a tenth of a second
constexpr double kFinest = 0.5;   ///< m, side of a column
constexpr double kMargin = 40.0;  ///< m round models, in which the wind finds back to its own
constexpr double kRim = 0.15;     ///< share of the columns over which the change fades out at the rim
/// Columns that a step goes back along the way of fall. Beyond the diagonal of a column the four round its
/// start have all been found before.
constexpr double kStepColumns = 3.0;

/// Land and models in plan that the columns stand on.
struct Plan {
  double x0, y0, x1, y1;
};

Plan planOf(const Raster<float>& h) {
  return {h.x(0), h.y(0), h.x(h.width - 1), h.y(h.height - 1)};
}

/// Round the models on the land; all of it where none stands there.
Plan planRound(const std::vector<StandingModel>& models, const Raster<float>& heights) {
  const Plan land = planOf(heights);
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

/// Shares of the air's depth at which shifts are kept: the middles of the field's layers, between which the
/// field itself is interpolated, the ground and the top.
std::vector<double> levelsOf(const WindTable& table) {
  std::vector<double> levels{0.0};
  for (std::size_t k = 0; k + 1 < table.levels.size(); ++k)
    levels.push_back(0.5 * (table.levels[k] + table.levels[k + 1]));
  levels.push_back(1.0);
  return levels;
}

}  // namespace

std::shared_ptr<const WindTable> makeFallWindTable(const SceneSnapshot& scene, const SnowGround& ground,
                                                   CpuBackend& backend, const CancelToken& cancel) {
  if (!scene.terrain || ground.terrain.empty()) return nullptr;
  const std::vector<StandingModel> models = modelsAtStart(scene, ground);
  // Models may stand where there is no ground.
  for (const Plan& plan : {planRound(models, scene.terrain->heights), planOf(scene.terrain->heights)}) {
    const Raster<float> heights = heightsOver(plan, scene.terrain->heights);
    WindSettings settings;
    settings.mostColumns = kMostColumns;
    settings.firstLayer = std::clamp(heights.cellSize, 1.0, 4.0);
    settings.tolerance = 1e-4;
    settings.cancel = &cancel;
    const auto field = WindField::make(heights, {obstacleTops(heights, models)}, settings, backend);
    if (field) return registryOf<WindTable>().intern(field->table());
    if (cancel.cancelled()) break;
  }
  return nullptr;
}

/// Between the columns round p and their levels; below the ground that on it.
Vec3d FallWind::sample(const std::vector<Vec3f>& values, Vec3d p) const {
  const WindTable& t = *m_field.table();
  const WindTable::Place place = t.placeOf(p.x, p.y);
  const double above = std::max(p.z - t.groundHeight(place), 0.0);
  Vec3d sum{};
  for (std::size_t c = 0; c < 4; ++c) {
    if (place.weight[c] == 0.0) continue;
    const std::size_t column = place.column[c];
    const double share = above / static_cast<double>(t.depth[column]);
    const auto after = std::upper_bound(m_levels.begin() + 1, m_levels.end() - 1, share);
    const auto k = static_cast<std::size_t>(after - m_levels.begin()) - 1;
    const double f = std::clamp((share - m_levels[k]) / (m_levels[k + 1] - m_levels[k]), 0.0, 1.0);
    const Vec3f* at = values.data() + column * m_levels.size() + k;
    sum += (at[0].to<double>() * (1.0 - f) + at[1].to<double>() * f) * place.weight[c];
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
/// The parts of the step are the shorter the nearer they are: light wind comes from high above.
Vec3d FallWind::arrive(Vec3d p, const std::vector<Vec3f>& change) const {
  const double seconds = kStepColumns * m_field.cellSize() / std::hypot(m_wind.x, m_wind.y);
  const Vec3d back = Vec3d{-m_wind.x, -m_wind.y, kMiddleFall} * seconds;
  const int parts = std::clamp(static_cast<int>(std::ceil(std::sqrt(kMiddleFall * seconds))), 3, 16);
  const WindTable& t = *m_field.table();
  Vec3d sum{};
  for (int k = 0; k < parts; ++k) {
    const double middle = (k + 0.5) / parts;
    const Vec3d q = p + back * (middle * middle);
    if (!t.holds(q.x, q.y) || q.z > t.top) break;
    sum += sample(change, q) * ((2.0 * k + 1.0) / (parts * parts));
  }
  const Vec3d q = p + back;
  const bool inside = t.holds(q.x, q.y) && q.z <= t.top;
  return sum * seconds + (inside ? sample(m_shift, q) : Vec3d{});
}

FallWind::FallWind(std::shared_ptr<const WindTable> table, Vec2d wind, CpuBackend& backend)
    : m_field(std::move(table)), m_wind(wind) {
  const WindTable& t = *m_field.table();
  m_levels = levelsOf(t);
  const std::size_t levels = m_levels.size();
  const double speed = std::hypot(wind.x, wind.y);
  const double grown = std::clamp((speed - kCalm) / (4.0 * kCalm), 0.0, 1.0);
  m_strength = grown * grown * (3.0 - 2.0 * grown);
  const auto width = static_cast<std::size_t>(t.width);
  const auto placeOf = [&](std::size_t c) {
    return Vec2d{t.originX + static_cast<double>(c % width) * t.cell,
                 t.originY + static_cast<double>(c / width) * t.cell};
  };
  std::vector<Vec3f> change(t.columns() * levels);
  m_shift.resize(change.size());
  backend.forEach(
      "flake wind", t.columns(),
      [&](std::size_t c) {
        const Vec2d at = placeOf(c);
        const double window = windowAt(at.x, at.y);
        for (std::size_t k = 0; k < levels; ++k)
          change[c * levels + k] =
              (m_field.changeAt(at.x, at.y, m_levels[k] * static_cast<double>(t.depth[c]), wind) * window)
                  .to<float>();
      },
      8);
  // Columns in bands across the wind, so narrow that no step back ends in its own band.
  const double band = (kStepColumns - std::sqrt(2.0)) * t.cell;
  std::vector<std::vector<std::size_t>> bands;
  const auto along = [&](std::size_t c) {
    const Vec2d at = placeOf(c);
    return (at.x * wind.x + at.y * wind.y) / speed;
  };
  double least = along(0);
  for (const std::size_t corner : {width - 1, t.columns() - width, t.columns() - 1})
    least = std::min(least, along(corner));
  for (std::size_t c = 0; c < t.columns(); ++c) {
    const auto number = static_cast<std::size_t>((along(c) - least) / band);
    if (number >= bands.size()) bands.resize(number + 1);
    bands[number].push_back(c);
  }
  for (const std::vector<std::size_t>& columns : bands)
    backend.forEach(
        "flake wind", columns.size(),
        [&](std::size_t n) {
          const std::size_t c = columns[n];
          const Vec2d at = placeOf(c);
          for (std::size_t k = 0; k < levels; ++k)
            m_shift[c * levels + k] =
                arrive({at.x, at.y, t.top - (1.0 - m_levels[k]) * static_cast<double>(t.depth[c])}, change)
                    .to<float>();
        },
        8);
}

std::shared_ptr<const FallWind> FallWind::of(const FallingFlakes& flakes, CpuBackend& backend) {
  const Vec2d wind{flakes.wind.x, flakes.wind.y};
  if (!flakes.landWind || !(std::hypot(wind.x, wind.y) > kCalm)) return nullptr;
  return std::make_shared<FallWind>(flakes.landWind, wind, backend);
}

bool FallWind::holdsFor(const FallingFlakes& flakes) const {
  return flakes.landWind == m_field.table() && flakes.wind.x == m_wind.x && flakes.wind.y == m_wind.y;
}

Vec3d FallWind::shiftAt(Vec3d p) const {
  if (!m_field.table()->holds(p.x, p.y)) return {};
  return sample(m_shift, p) * (windowAt(p.x, p.y) * m_strength);
}

Vec3d FallWind::velocityAt(Vec3d p, Vec3d velocity) const {
  const double speed = length(velocity);
  if (!(speed > 0.0)) return {};
  const double seconds = 0.25 * m_field.cellSize() / speed;
  return (shiftAt(p + velocity * seconds) - shiftAt(p - velocity * seconds)) * (0.5 / seconds);
}

Vec3d FallWind::before(Vec3d p) const {
  Vec3d q = p, rest = p - q - shiftAt(q);
  double step = 1.0;
  for (int k = 0; k < 16; ++k) {
    const Vec3d next = q + rest * step, nextRest = p - next - shiftAt(next);
    // Behind walls the shift changes so fast that whole steps run past.
    if (length(nextRest) > length(rest)) {
      step *= 0.5;
      continue;
    }
    q = next, rest = nextRest;
  }
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
