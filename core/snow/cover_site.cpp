// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/cover_site.h"

#include <algorithm>
#include <cmath>

#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/snow/cover_weather.h"
#include "core/snow/ground_materials.h"

namespace spin {
namespace {

/// What a house or a car has below its surface; numbers of the materials after those of the terrain.
std::vector<GroundMaterial> materialsOfScene() {
  constexpr float kDeepest = 1.0f;  // m from the last soil layer to where the ground's temperature holds
  constexpr float kThin[kSoilLayers] = {0.01f, 0.02f, 0.04f, 0.08f};
  std::vector<GroundMaterial> materials;
  for (int t = 0; t < kGroundTypeCount; ++t) {
    materials.push_back(groundMaterial(static_cast<GroundType>(t)));
    materials.back().deepConductance = materials.back().conductivity / kDeepest;
  }
  for (int t = 0; t < kGroundTypeCount; ++t) {
    materials.push_back(groundMaterial(static_cast<GroundType>(t)));
    std::copy(std::begin(kThin), std::end(kThin), materials.back().thickness);
    materials.back().evaporation = 0.0f;
    materials.back().frozenWater = 0.0f;
  }
  return materials;
}

SnowParameters parametersOf(const SnowCoverNode& cover, double newSnowDensity) {
  SnowParameters p;
  p.freshAlbedo = static_cast<float>(std::max(cover.freshAlbedo, cover.oldAlbedo));
  p.oldAlbedo = static_cast<float>(std::min(cover.freshAlbedo, cover.oldAlbedo));
  p.windHeight = static_cast<float>(cover.windHeight);
  p.airHeight = static_cast<float>(cover.airHeight);
  p.newSnowDensity = static_cast<float>(newSnowDensity);
  return p;
}

MeltLaw meltLaw(CoverLaw law) {
  switch (law) {
    case CoverLaw::DegreeDay:
      return MeltLaw::DegreeDay;
    case CoverLaw::Published:
      return MeltLaw::Published;
    case CoverLaw::EnergyBalance:
    case CoverLaw::Lies:
      break;
  }
  return MeltLaw::EnergyBalance;
}

/// Mean normal of a patch's cell.
Vec3d cellNormal(const ModelGround& model, const ModelPatch& patch, std::size_t cell) {
  Vec3d sum{};
  double before = 0.0;
  for (std::uint32_t k = patch.cellStart[cell]; k < patch.cellStart[cell + 1]; ++k) {
    const PatchPiece& piece = patch.pieces[k];
    Vec3d n = normalized(model.triangles[piece.source].normal());
    if (n.z < 0.0) n = -n;
    sum = sum + n * (static_cast<double>(piece.areaToHere) - before);
    before = static_cast<double>(piece.areaToHere);
  }
  return length(sum) > 0.0 ? normalized(sum) : Vec3d{0, 0, 1};
}

}  // namespace

CoverSite::CoverSite(const SceneSnapshot& scene, const SnowGround& ground, CpuBackend& backend)
    : m_ground(ground) {
  m_first.push_back(0);
  for (const CoverGrid& grid : ground.layout->grids) m_first.push_back(m_first.back() + grid.base.size());
  m_material.assign(size(), static_cast<std::uint8_t>(GroundType::Vegetation));
  m_groundTemperature.assign(size(), 0.0f);
  m_height.assign(size(), 0.0f);
  addTerrain(scene, ground, backend);
  addModels(scene, ground);
  addHeights(scene);
}

void CoverSite::addTerrain(const SceneSnapshot& scene, const SnowGround& ground, CpuBackend& backend) {
  const auto cover = scene.settings<SnowCoverNode>(0.0);
  if (ground.terrain.empty()) return;
  const Raster<float>& heights = scene.terrain->heights;
  const bool sunny = scene.settings<WeatherNode>(0.0).sun != MeltingSun::None;
  if (cover.slopesAndShadow && sunny && cover.law == CoverLaw::EnergyBalance) {
    ScopedStage stage(backend.timings(), "horizon");
    m_horizon = HorizonMap::make(heights, cover.horizonReach, backend);
    m_horizonCell.assign(size(), kNoHorizon);
    m_normals.assign(size(), Vec3f{});
  }
  const double unpainted = scene.settings<GroundTemperatureLayerNode>(0.0).base;
  for (const TerrainGrid& terrain : ground.terrain) {
    const Raster<float>& base = ground.layout->grids[terrain.grid].base;
    m_layers.push_back(groundLayersOn(scene, base));
    const GroundLayers& layers = m_layers.back();
    const std::size_t first = m_first[terrain.grid];
    for (int j = 0; j < base.height; ++j)
      for (int i = 0; i < base.width; ++i) {
        const std::size_t cell = first + base.index(i, j);
        const std::size_t c = base.index(i, j);
        const auto painted = static_cast<double>(layers.temperature[c]);
        m_material[cell] = static_cast<std::uint8_t>(layers.type[c]);
        m_groundTemperature[cell] =
            static_cast<float>(kelvinToCelsius(std::isnan(painted) ? unpainted : painted));
        m_height[cell] = std::isnan(base.at(i, j)) ? 0.0f : base.at(i, j);
        if (!m_horizon) continue;
        const int ci = std::clamp(heights.column(base.x(i)), 0, heights.width - 1);
        const int cj = std::clamp(heights.row(base.y(j)), 0, heights.height - 1);
        m_horizonCell[cell] = static_cast<std::uint32_t>(heights.index(ci, cj));
      }
  }
}

void CoverSite::addModels(const SceneSnapshot& scene, const SnowGround& ground) {
  const double air = coverWeather(scene, {{}, {}}).step.airTemperature;
  for (const ModelGround& model : ground.models) {
    const SceneNode& node = nodeOf(scene, model);
    const auto evaluated = evaluate(node, 0.0);
    const auto surface = static_cast<std::uint8_t>(static_cast<const ModelNode&>(*evaluated).surface);
    const Vec3d place = scene.modelTransform(node, 0.0).translation;
    for (const ModelPatch& patch : model.patches) {
      const Raster<float>& base = ground.layout->grids[patch.grid].base;
      for (std::size_t c = 0; c < base.size(); ++c) {
        const std::size_t cell = m_first[patch.grid] + c;
        m_material[cell] = static_cast<std::uint8_t>(kGroundTypeCount + surface);
        m_groundTemperature[cell] = static_cast<float>(air);
        if (!std::isnan(base.values[c])) m_height[cell] = static_cast<float>(place.z) + base.values[c];
        if (!m_horizon) continue;
        m_normals[cell] = cellNormal(model, patch, c).to<float>();
        const Raster<float>& heights = scene.terrain->heights;
        const auto width = static_cast<std::size_t>(base.width);
        const int i = heights.column(place.x + base.x(static_cast<int>(c % width)));
        const int j = heights.row(place.y + base.y(static_cast<int>(c / width)));
        if (heights.contains(i, j)) m_horizonCell[cell] = static_cast<std::uint32_t>(heights.index(i, j));
      }
    }
  }
}

void CoverSite::addHeights(const SceneSnapshot& scene) {
  const auto weather = scene.settings<WeatherNode>(0.0);
  const double level = weatherLevel(scene);
  if (weather.lapseRate != 0.0) {
    m_airOffset.resize(size());
    for (std::size_t c = 0; c < size(); ++c)
      m_airOffset[c] = static_cast<float>((level - static_cast<double>(m_height[c])) * weather.lapseRate);
  }
  if (weather.precipitationGradient == 0.0) return;
  m_fallFactor.resize(size());
  for (std::size_t c = 0; c < size(); ++c) {
    const double higher = static_cast<double>(m_height[c]) - level;
    m_fallFactor[c] = static_cast<float>(std::max(1.0 + higher * weather.precipitationGradient, 0.0));
  }
}

SnowCells CoverSite::makeCells(const SceneSnapshot& scene) const {
  const auto cover = scene.settings<SnowCoverNode>(0.0);
  const double density = scene.settings<SimulationNode>(0.0).newSnowDensity;
  SnowCells cells(size(), materialsOfScene(), parametersOf(cover, density));
  cells.law = meltLaw(cover.law);
  cells.degreeDay.factor = static_cast<float>(cover.degreeDayFactor);
  cells.degreeDay.threshold = static_cast<float>(kelvinToCelsius(cover.degreeDayThreshold));
  cells.groundKnown = scene.first<GroundTemperatureLayerNode>() != nullptr;
  for (std::size_t g = 0; g + 1 < m_first.size(); ++g) {
    const CoverGrid& grid = m_ground.layout->grids[g];
    for (std::size_t cell = m_first[g]; cell < m_first[g + 1]; ++cell) {
      const std::size_t c = cell - m_first[g];
      cells.setMaterial(cell, m_material[cell]);
      std::array<float, kSoilLayers> soil;
      soil.fill(m_groundTemperature[cell]);
      cells.setSoil(cell, soil);
      cells.setting(kDeepTemperature)[cell] = m_groundTemperature[cell];
      cells.setting(kAirOffset)[cell] = static_cast<float>(airOffset(cell));
      cells.setting(kCellArea)[cell] = std::isnan(grid.base.values[c]) ? 0.0f : grid.area.values[c];
      if (m_horizonCell.empty() || m_horizonCell[cell] == kNoHorizon) continue;
      const Vec3f own = m_normals[cell];
      const double view =
          own.z > 0.0f ? 0.5 * (1.0 + static_cast<double>(own.z)) : m_horizon->skyView(m_horizonCell[cell]);
      cells.setting(kSkyView)[cell] = static_cast<float>(view);
    }
  }
  return cells;
}

bool CoverSite::inShadow(std::size_t cell, Vec3d towardsSun) const {
  const double azimuth = std::atan2(towardsSun.x, towardsSun.y);
  const double level = std::hypot(towardsSun.x, towardsSun.y);
  return towardsSun.z < level * m_horizon->horizonTangent(m_horizonCell[cell], azimuth);
}

void CoverSite::light(const Sun& sun, SnowCells& cells, CpuBackend& backend) const {
  if (!m_horizon) return;
  std::vector<float>& beam = cells.setting(kBeamFactor);
  backend.forEach("sunlight", size(), [&](std::size_t c) {
    if (m_horizonCell[c] == kNoHorizon) return;
    const Vec3d own = m_normals[c].to<double>();
    double factor = 0.0;
    if (own.z <= 0.0)
      factor = m_horizon->beamFactor(m_horizonCell[c], sun.direction);
    else if (sun.isUp() && !inShadow(c, sun.direction))
      factor = slopeBeamFactor(own, sun.direction);
    beam[c] = static_cast<float>(factor);
  });
}

void CoverSite::heat(const SceneSnapshot& scene, double filmTime, SnowCells& cells) const {
  std::vector<float>& heat = cells.setting(kGroundHeat);
  std::fill(heat.begin(), heat.end(), 0.0f);
  for (const ModelGround& model : m_ground.models) {
    const double power = static_cast<const ModelNode&>(*evaluate(nodeOf(scene, model), filmTime)).heat;
    for (const ModelPatch& patch : model.patches)
      std::fill(heat.begin() + static_cast<std::ptrdiff_t>(m_first[patch.grid]),
                heat.begin() + static_cast<std::ptrdiff_t>(m_first[patch.grid + 1]),
                static_cast<float>(power));
  }
  for (const SceneNode* node : scene.all<HeatSourceNode>()) {
    const auto evaluated = evaluate(*node, filmTime);
    const auto& source = static_cast<const HeatSourceNode&>(*evaluated);
    for (const TerrainGrid& terrain : m_ground.terrain) {
      const Raster<float>& base = m_ground.layout->grids[terrain.grid].base;
      const auto low = [&](double at, double origin, int most) {
        return std::clamp(static_cast<int>(std::floor((at - source.radius - origin) / base.cellSize)), 0,
                          most);
      };
      const auto high = [&](double at, double origin, int most) {
        return std::clamp(static_cast<int>(std::ceil((at + source.radius - origin) / base.cellSize)) + 1, 0,
                          most);
      };
      const int i1 = high(source.position.x, base.originX, base.width);
      const int j1 = high(source.position.y, base.originY, base.height);
      for (int j = low(source.position.y, base.originY, base.height); j < j1; ++j)
        for (int i = low(source.position.x, base.originX, base.width); i < i1; ++i) {
          const double r =
              std::hypot(base.x(i) - source.position.x, base.y(j) - source.position.y) / source.radius;
          const double fade = r < 1.0 ? (1.0 - r * r) * (1.0 - r * r) : 0.0;
          heat[m_first[terrain.grid] + base.index(i, j)] += static_cast<float>(source.power * fade);
        }
    }
  }
}

}  // namespace spin
