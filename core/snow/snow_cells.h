// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/parallel.h"
#include "core/physics/snow_column_state.h"
#include "core/snow/snow_cells_view.h"

namespace spin {

/// Many snow columns with their soil, one by one independent, advanced together; the same bits with any
/// number of threads. A cell starts bare, at the temperature it is given.
class SnowCells {
 public:
  /// materials: at most 256; cells start with number 0.
  SnowCells(std::size_t count, std::vector<GroundMaterial> materials, const SnowParameters& parameters);

  std::size_t size() const { return m_count; }

  MeltLaw law = MeltLaw::EnergyBalance;
  DegreeDayLaw degreeDay;
  PublishedMeltLaw published;
  bool groundKnown = false;  ///< kDeepTemperature rules the published law, else the air's temperature

  /// By cell, `size()` of them count.
  std::vector<float>& setting(SnowCellSetting setting) { return m_settings[setting]; }
  const std::vector<float>& setting(SnowCellSetting setting) const { return m_settings[setting]; }
  void setMaterial(std::size_t cell, std::uint8_t material);
  const GroundMaterial& material(std::size_t cell) const { return m_materials[m_material[cell]]; }
  /// Soil temperatures from the top and the surface's, K above 273.15 K.
  void setSoil(std::size_t cell, const std::array<float, kSoilLayers>& temperatures);

  SnowColumn<float> column(std::size_t cell) const;
  void setColumn(std::size_t cell, const SnowColumn<float>& column);
  /// kg/m2 that ran off in the last step.
  float runoff(std::size_t cell) const { return m_runoff[cell]; }

  /// kg of snow and water on some cells.
  double mass(std::size_t begin, std::size_t end) const;
  /// The state by array, padded; for checkpoints.
  const std::array<std::vector<float>, kSnowStateFields>& state() const { return m_state; }
  /// False if the sizes do not fit.
  bool setState(std::array<std::vector<float>, kSnowStateFields> state);

  /// One step of an hour or less. Longer steps are the caller's to cut.
  SnowStepTotals advance(const SnowStepWeather& weather, CpuBackend& backend, Isa isa = bestIsa());

  /// kg of snow and water on all cells.
  double mass() const;
  /// J in snow and soil, zero with ice and moist soil at 273.15 K.
  double energy() const;

 private:
  std::size_t m_count;
  std::vector<GroundMaterial> m_materials;
  SnowParameters m_parameters;
  std::array<std::vector<float>, kSnowStateFields> m_state;
  std::array<std::vector<float>, kSnowCellSettings> m_settings;
  std::vector<std::uint8_t> m_material;
  std::vector<float> m_runoff;
};

/// Snow water equivalent, kg/m2.
double columnMass(const SnowColumn<float>& column);
/// Heat in the snow, J/m2, zero for ice at 273.15 K.
double columnSnowHeat(const SnowColumn<float>& column);
/// Heat in snow and soil, J/m2.
double columnEnergy(const SnowColumn<float>& column, const GroundMaterial& ground);

}  // namespace spin
