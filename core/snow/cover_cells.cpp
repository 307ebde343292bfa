// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/cover_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/units.h"
#include "core/physics/humidity.h"
#include "core/physics/moved_snow.h"

namespace spin {
namespace {

/// What has lain for a while: its albedo is half-way from that of new snow to that of old.
constexpr double kAged = 0.5;

}  // namespace

CoverCells::CoverCells(const SceneSnapshot& scene, const SnowGround& ground, CpuBackend& backend)
    : m_ground(ground),
      m_site(scene, ground, backend),
      m_ages(scene.settings<SnowCoverNode>(0.0).law != CoverLaw::Lies),
      m_cells(m_site.makeCells(scene)),
      m_freshMass(m_site.size(), 0.0),
      m_freshDepth(m_site.size(), 0.0) {}

void CoverCells::setSnow(std::size_t cell, double mass, double density, float temperature, float albedo) {
  if (!m_ages) {
    m_freshMass[cell] = mass;
    m_freshDepth[cell] = mass / density;
    return;
  }
  SnowColumn<float> column = m_cells.column(cell);
  column.snow[0].ice = static_cast<float>(mass);
  column.rest = static_cast<float>(mass - static_cast<double>(column.snow[0].ice));
  column.snow[0].depth = static_cast<float>(mass / density);
  column.snow[0].temperature = mass > 0.0 ? temperature : 0.0f;
  column.albedo = albedo;
  m_cells.setColumn(cell, column);
}

const GroundLayers* CoverCells::layersOf(std::size_t grid) const {
  for (std::size_t t = 0; t < m_ground.terrain.size(); ++t)
    if (m_ground.terrain[t].grid == grid) return &m_site.layers()[t];
  return nullptr;
}

double CoverCells::layOld(const SceneSnapshot& scene, const ExposureField& field, double swe,
                          double density) {
  const auto cover = scene.settings<SnowCoverNode>(0.0);
  const float air = coverWeather(scene, {{}, {}}).step.airTemperature;
  const auto albedo = static_cast<float>(cover.oldAlbedo + kAged * (cover.freshAlbedo - cover.oldAlbedo));
  double added = 0.0;
  for (std::size_t g = 0; g < field.grids.size(); ++g) {
    const GroundLayers* layers = layersOf(g);
    for (std::size_t c = 0; c < field.grids[g].held.size(); ++c) {
      const std::size_t cell = m_site.firstCells()[g] + c;
      const double fell = swe * static_cast<double>(field.grids[g].held[c]);
      double mass = fell, depth = fell / density;
      const double painted = layers ? static_cast<double>(layers->startDepth[c]) : std::nan("");
      if (!std::isnan(painted)) {
        mass = painted * layers->startDensity + (layers->startAdds ? fell : 0.0);
        depth = painted + (layers->startAdds ? depth : 0.0);
      }
      if (!(mass > 0.0 || fell > 0.0)) continue;
      added += (mass - fell) * areaOf(cell);
      const float temperature = std::min(air + static_cast<float>(m_site.airOffset(cell)), 0.0f);
      setSnow(cell, mass, depth > 0.0 ? mass / depth : density, temperature, albedo);
    }
  }
  return added;
}

double CoverCells::lyingShare(std::size_t cell, const CoverWeather& weather) const {
  if (m_ages || !(weather.precipitation > 0.0)) return 1.0;
  const SnowStepWeather& now = weather.step;
  if (!now.splitByTemperature)
    return static_cast<double>(now.snowfall) / static_cast<double>(now.snowfall + now.rainfall);
  return snowShare(static_cast<double>(now.airTemperature) + m_site.airOffset(cell),
                   static_cast<double>(now.relativeHumidity));
}

CoverCells::Fallen CoverCells::fall(const SceneSnapshot& scene, double filmTime, const ExposureField& field,
                                    const CoverWeather& weather, double fallen, double density,
                                    CpuBackend& backend) {
  constexpr std::size_t kCells = 8192;
  Fallen total;
  const std::vector<float>& higher = m_site.fallFactors();
  for (std::size_t g = 0; g < field.grids.size(); ++g) {
    const std::vector<float>& held = field.grids[g].held;
    const GroundLayers* layers = layersOf(g);
    const std::vector<float> clear = layers ? clearedShares(scene, *layers, filmTime) : std::vector<float>();
    const std::size_t first = m_site.firstCells()[g];
    std::vector<Fallen> sums((held.size() + kCells - 1) / kCells);
    backend.forChunks(
        "cover", held.size(), kCells, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
          for (std::size_t c = begin; c < end; ++c) {
            const std::size_t cell = first + c;
            const double level = fallen * static_cast<double>(held[c]);
            const double arrived = higher.empty() ? level : level * static_cast<double>(higher[cell]);
            const double cleared = clear.empty() ? 0.0 : arrived * static_cast<double>(clear[c]);
            sums[chunk].gained += (arrived - level) * areaOf(cell);
            const double lies = (arrived - cleared) * lyingShare(cell, weather);
            sums[chunk].cleared += cleared * areaOf(cell);
            sums[chunk].runoff += (arrived - cleared - lies) * areaOf(cell);
            m_freshMass[cell] += lies;
            m_freshDepth[cell] += lies / density;
          }
        });
    for (const Fallen& sum : sums) {
      total.gained += sum.gained;
      total.cleared += sum.cleared;
      total.runoff += sum.runoff;
    }
  }
  return total;
}

std::optional<std::size_t> CoverCells::terrainCellAt(Vec3d position) const {
  for (const TerrainGrid& terrain : m_ground.terrain) {
    const Raster<float>& base = m_ground.layout->grids[terrain.grid].base;
    const auto i = static_cast<int>(std::lround((position.x - base.originX) / base.cellSize));
    const auto j = static_cast<int>(std::lround((position.y - base.originY) / base.cellSize));
    if (i < 0 || j < 0 || i >= base.width || j >= base.height) continue;
    const std::size_t cell = m_site.firstCells()[terrain.grid] +
                             static_cast<std::size_t>(j) * static_cast<std::size_t>(base.width) +
                             static_cast<std::size_t>(i);
    // Where a finer grid accounts for the ground, the cells of the coarse one have no area.
    if (areaOf(cell) > 0.0) return cell;
  }
  return std::nullopt;
}

void CoverCells::settle(SnowFallout& fallout, double airTemperature) {
  for (const SnowGrain& grain : std::exchange(fallout.falling, {})) {
    const std::optional<std::size_t> cell = terrainCellAt(grain.position);
    if (!cell) {
      fallout.refused.push_back(grain);
      continue;
    }
    const double mass = grain.kilograms / areaOf(*cell), depth = mass / grain.density;
    if (!m_ages) {
      m_freshMass[*cell] += mass;
      m_freshDepth[*cell] += depth;
      continue;
    }
    SnowColumn<float> column = m_cells.column(*cell);
    const double t = std::min(airTemperature + m_site.airOffset(*cell), 0.0);
    layOnColumn(column, {depth, mass, 0.0, kIceHeat * mass * t});
    m_cells.setColumn(*cell, column);
  }
}

CoverCells::Advanced CoverCells::advance(const SceneSnapshot& scene, const TimeSpan& span, double fallen,
                                         CpuBackend& backend, Isa isa) {
  if (!m_ages) return {};
  if (m_waitingSeconds == 0.0 || span.from.weather != m_waitingTo) {
    // After a pause the weather of the time before it is not asked again.
    m_waitingFrom = span.from;
    m_waitingFrom.weather -= m_waitingSeconds;
  }
  m_waitingTo = span.to.weather;
  m_waitingSeconds += span.seconds();
  m_waitingFallen += fallen;
  if (m_waitingSeconds < kLeastStep) return {};
  const TimeSpan waiting{m_waitingFrom, span.to};
  CoverWeather weather = coverWeather(scene, waiting);
  SnowStepWeather& step = weather.step;
  step.seconds = static_cast<float>(std::min(m_waitingSeconds, kMostStep));
  const float sum = step.snowfall + step.rainfall;
  const auto rate = static_cast<float>(m_waitingFallen / static_cast<double>(step.seconds));
  const float asSnow = sum > 0.0f ? step.snowfall / sum : 1.0f;
  step.snowfall = rate * asSnow;
  step.rainfall = rate - step.snowfall;
  std::vector<float>& factor = m_cells.setting(kFallFactor);
  backend.forEach("cover", m_site.size(), [&](std::size_t c) {
    factor[c] = m_waitingFallen > 0.0 ? static_cast<float>(m_freshMass[c] / m_waitingFallen) : 0.0f;
    m_freshMass[c] = m_freshDepth[c] = 0.0;
  });
  m_site.light(weather.sun, m_cells, backend);
  m_site.heat(scene, waiting.middleFilm(), m_cells);
  m_waitingSeconds = m_waitingFallen = 0.0;
  return {m_cells.advance(step, backend, isa), static_cast<double>(step.seconds)};
}

CoverCells::Moving CoverCells::moving() const {
  Moving now;
  if (!m_ages) {
    now.depth = m_freshDepth;
    now.mass = m_freshMass;
    now.liquid.assign(m_site.size(), 0.0);
    now.heat.assign(m_site.size(), 0.0);
    return now;
  }
  for (std::vector<double>* field : {&now.depth, &now.mass, &now.liquid, &now.heat})
    field->assign(m_site.size(), 0.0);
  for (std::size_t c = 0; c < m_site.size(); ++c) {
    const SnowColumn<float> column = m_cells.column(c);
    now.mass[c] = columnMass(column);
    now.heat[c] = columnSnowHeat(column);
    for (const SnowLayer<float>& layer : column.snow) {
      now.depth[c] += static_cast<double>(layer.depth);
      now.liquid[c] += static_cast<double>(layer.liquid);
    }
  }
  return now;
}

void CoverCells::move(const Moving& before, const Moving& after, CpuBackend& backend) {
  if (!m_ages) {
    m_freshDepth = after.depth;
    m_freshMass = after.mass;
    return;
  }
  backend.forEach("cover", m_site.size(), [&](std::size_t c) {
    const double mass = after.mass[c] - before.mass[c];
    const double liquid = after.liquid[c] - before.liquid[c];
    if (mass == 0.0 && liquid == 0.0 && after.depth[c] == before.depth[c]) return;
    SnowColumn<float> column = m_cells.column(c);
    const MovedSnow change{after.depth[c] - before.depth[c], mass - liquid, liquid,
                           after.heat[c] - before.heat[c]};
    if (mass <= 0.0)
      takeFromColumn(column, change);
    else
      layOnColumn(column, change);
    m_cells.setColumn(c, column);
  });
}

double CoverCells::deposited() const {
  double kilograms = m_cells.mass();
  for (std::size_t c = 0; c < m_freshMass.size(); ++c) kilograms += areaOf(c) * m_freshMass[c];
  return kilograms;
}

CoverPart::Values CoverCells::valuesOf(std::size_t grid) const {
  const std::size_t first = m_site.firstCells()[grid], end = m_site.firstCells()[grid + 1];
  CoverPart::Values values;
  values.swe.resize(end - first);
  values.depth.resize(end - first);
  if (m_ages) values.liquid.resize(end - first);
  if (m_ages) values.temperature.resize(end - first);
  for (std::size_t cell = first; cell < end; ++cell) {
    const std::size_t c = cell - first;
    double swe = m_freshMass[cell], depth = m_freshDepth[cell];
    if (m_ages) {
      const SnowColumn<float> column = m_cells.column(cell);
      swe += columnMass(column);
      depth += static_cast<double>(column.depth());
      for (const SnowLayer<float>& layer : column.snow) values.liquid[c] += layer.liquid;
      values.temperature[c] = static_cast<float>(celsiusToKelvin(static_cast<double>(column.surface)));
    }
    // Roundings of a column that has melted may leave a trace of either sign.
    values.swe[c] = static_cast<float>(std::max(swe, 0.0));
    values.depth[c] = static_cast<float>(std::max(depth, 0.0));
  }
  return values;
}

void CoverCells::save(ByteWriter& out) const {
  out.put(m_waitingSeconds);
  out.put(m_waitingFallen);
  for (const double value : {m_waitingFrom.film, m_waitingFrom.weather, m_waitingTo}) out.put(value);
  out.putArray(m_freshMass);
  out.putArray(m_freshDepth);
  if (!m_ages) return;
  for (const std::vector<float>& field : m_cells.state()) out.putArray(field);
}

bool CoverCells::load(ByteReader& in) {
  m_waitingSeconds = in.get<double>();
  m_waitingFallen = in.get<double>();
  m_waitingFrom.film = in.get<double>();
  m_waitingFrom.weather = in.get<double>();
  m_waitingTo = in.get<double>();
  m_freshMass = in.getArray<double>();
  m_freshDepth = in.getArray<double>();
  if (!in.ok() || m_freshMass.size() != m_site.size() || m_freshDepth.size() != m_site.size()) return false;
  if (!m_ages) return true;
  std::array<std::vector<float>, kSnowStateFields> state;
  for (std::vector<float>& field : state) field = in.getArray<float>();
  return in.ok() && m_cells.setState(std::move(state));
}

}  // namespace spin
