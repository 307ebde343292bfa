// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_cells.h"

#include "core/base/check.h"

namespace spin {
namespace {

/// Calls visit(number) for the numbers of a column in the order of the state's arrays.
template <class Column, class Visit>
void visitColumn(Column& column, const Visit& visit) {
  for (auto& layer : column.snow) {
    visit(layer.ice);
    visit(layer.liquid);
    visit(layer.depth);
    visit(layer.temperature);
  }
  for (auto& soil : column.soil) visit(soil);
  visit(column.albedo);
  visit(column.surface);
  visit(column.rest);
}

}  // namespace

double columnMass(const SnowColumn<float>& column) {
  double mass = static_cast<double>(column.rest);
  for (const SnowLayer<float>& layer : column.snow)
    mass += static_cast<double>(layer.ice) + static_cast<double>(layer.liquid);
  return mass;
}

double columnSnowHeat(const SnowColumn<float>& column) {
  double heat = 0.0;
  for (const SnowLayer<float>& layer : column.snow)
    heat += kIceHeat * static_cast<double>(layer.ice) * static_cast<double>(layer.temperature) +
            kFusionHeat * static_cast<double>(layer.liquid);
  return heat;
}

double columnEnergy(const SnowColumn<float>& column, const GroundMaterial& ground) {
  double heat = columnSnowHeat(column);
  for (int i = 0; i < kSoilLayers; ++i)
    heat += static_cast<double>(ground.thickness[i]) * soilEnthalpy(static_cast<double>(column.soil[i]),
                                                                    static_cast<double>(ground.heatCapacity),
                                                                    static_cast<double>(ground.frozenWater));
  return heat;
}

SnowCells::SnowCells(std::size_t count, std::vector<GroundMaterial> materials,
                     const SnowParameters& parameters)
    : m_count(count), m_materials(std::move(materials)), m_parameters(parameters) {
  SPIN_CHECK(!m_materials.empty() && m_materials.size() <= 256, "1 to 256 materials");
  const std::size_t padded = (count + kSnowCellPadding - 1) / kSnowCellPadding * kSnowCellPadding;
  for (std::vector<float>& field : m_state) field.assign(padded, 0.0f);
  m_state[kAlbedoField].assign(padded, parameters.freshAlbedo);
  for (std::vector<float>& field : m_settings) field.assign(padded, 0.0f);
  for (const SnowCellSetting ones : {kBeamFactor, kSkyView, kFallFactor})
    m_settings[ones].assign(padded, 1.0f);
  m_settings[kCellArea].assign(padded, 1.0f);
  std::fill(m_settings[kCellArea].begin() + static_cast<std::ptrdiff_t>(count), m_settings[kCellArea].end(),
            0.0f);
  m_material.assign(padded, 0);
  m_runoff.assign(padded, 0.0f);
}

void SnowCells::setMaterial(std::size_t cell, std::uint8_t material) {
  SPIN_CHECK(material < m_materials.size(), "no such material");
  m_material[cell] = material;
}

void SnowCells::setSoil(std::size_t cell, const std::array<float, kSoilLayers>& temperatures) {
  SnowColumn<float> c = column(cell);
  std::copy(temperatures.begin(), temperatures.end(), c.soil);
  c.surface = temperatures[0];
  setColumn(cell, c);
}

SnowColumn<float> SnowCells::column(std::size_t cell) const {
  SnowColumn<float> column;
  std::size_t field = 0;
  visitColumn(column, [&](float& value) { value = m_state[field++][cell]; });
  return column;
}

void SnowCells::setColumn(std::size_t cell, const SnowColumn<float>& column) {
  std::size_t field = 0;
  visitColumn(column, [&](const float& value) { m_state[field++][cell] = value; });
}

SnowStepTotals SnowCells::advance(const SnowStepWeather& weather, CpuBackend& backend, Isa isa) {
  constexpr std::size_t kCells = 4096;
  static_assert(kCells % kSnowCellPadding == 0);
  SPIN_CHECK(weather.seconds > 0.0f && weather.seconds <= 3600.0f, "a step is an hour at most");
  SnowCellsView view;
  for (std::size_t f = 0; f < kSnowStateFields; ++f) view.state[f] = m_state[f].data();
  for (std::size_t f = 0; f < kSnowCellSettings; ++f) {
    SPIN_CHECK(m_settings[f].size() == m_runoff.size(), "a setting has a number per cell");
    view.settings[f] = m_settings[f].data();
  }
  view.material = m_material.data();
  view.materials = m_materials.data();
  view.runoff = m_runoff.data();
  view.parameters = m_parameters;
  view.weather = weather;
  view.law = law;
  view.degreeDay = degreeDay;
  view.published = published;
  view.groundKnown = groundKnown;
  const SnowCellsLoop loop = snowCellsLoopFor(isa);
  const std::size_t padded = m_runoff.size();
  std::vector<SnowStepTotals> chunks((padded + kCells - 1) / kCells);
  backend.forChunks("snow cells", padded, kCells, [&](std::size_t begin, std::size_t end, std::size_t c) {
    chunks[c] = loop(view, begin, end);
  });
  SnowStepTotals totals;
  for (const SnowStepTotals& chunk : chunks) totals += chunk;
  return totals;
}

double SnowCells::mass() const {
  return mass(0, m_count);
}

double SnowCells::mass(std::size_t begin, std::size_t end) const {
  double mass = 0.0;
  for (std::size_t i = begin; i < end; ++i)
    mass += static_cast<double>(m_settings[kCellArea][i]) * columnMass(column(i));
  return mass;
}

bool SnowCells::setState(std::array<std::vector<float>, kSnowStateFields> state) {
  for (const std::vector<float>& field : state)
    if (field.size() != m_runoff.size()) return false;
  m_state = std::move(state);
  return true;
}

double SnowCells::energy() const {
  double heat = 0.0;
  for (std::size_t i = 0; i < m_count; ++i)
    heat += static_cast<double>(m_settings[kCellArea][i]) * columnEnergy(column(i), material(i));
  return heat;
}

}  // namespace spin
