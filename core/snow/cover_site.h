// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/nodes/cover_nodes.h"
#include "core/physics/sunlight.h"
#include "core/snow/ground_layers.h"
#include "core/snow/horizon.h"
#include "core/snow/snow_cells.h"
#include "core/snow/snow_ground.h"

namespace spin {

/// How the cover's cells lie in the scene, for all grids of a layout one after the other: what is below them,
/// how high and how steep they are, what hides the sky. Fixed for a run but for sun and heat.
class CoverSite {
 public:
  CoverSite(const SceneSnapshot& scene, const SnowGround& ground, CpuBackend& backend);

  std::size_t size() const { return m_first.back(); }
  /// Number of a grid's first cell; grids + 1 of them.
  const std::vector<std::size_t>& firstCells() const { return m_first; }

  /// Materials, soil, areas, sky, heights: everything that does not change with time.
  SnowCells makeCells(const SceneSnapshot& scene) const;
  /// Sun and heat of a time.
  void light(const Sun& sun, SnowCells& cells, CpuBackend& backend) const;
  void heat(const SceneSnapshot& scene, double filmTime, SnowCells& cells) const;

  /// Precipitation over that at the weather's altitude, by cell; empty where it is the same everywhere.
  const std::vector<float>& fallFactors() const { return m_fallFactor; }
  /// Painted layers by SnowGround::terrain.
  const std::vector<GroundLayers>& layers() const { return m_layers; }
  double airOffset(std::size_t cell) const {
    return m_airOffset.empty() ? 0.0 : static_cast<double>(m_airOffset[cell]);
  }
  /// Rough bytes per cell of what such a site and its cells hold.
  static constexpr double kBytesPerCell = 150.0;

 private:
  static constexpr std::uint32_t kNoHorizon = std::numeric_limits<std::uint32_t>::max();

  void addTerrain(const SceneSnapshot& scene, const SnowGround& ground, CpuBackend& backend);
  void addModels(const SceneSnapshot& scene, const SnowGround& ground);
  void addHeights(const SceneSnapshot& scene);
  bool inShadow(std::size_t cell, Vec3d towardsSun) const;

  const SnowGround& m_ground;
  std::vector<std::size_t> m_first;
  std::vector<GroundLayers> m_layers;
  std::vector<std::uint8_t> m_material;      ///< number of makeCells()' materials
  std::vector<float> m_groundTemperature;    ///< K above 273.15 K
  std::vector<float> m_airOffset;            ///< K; empty = 0
  std::vector<float> m_fallFactor;           ///< empty = 1
  std::vector<float> m_height;               ///< m, local
  std::vector<std::uint32_t> m_horizonCell;  ///< cell of the terrain's horizon map; empty = all lie open
  std::vector<Vec3f> m_normals;              ///< of model cells; zero = take the horizon map's
  std::optional<HorizonMap> m_horizon;
};

}  // namespace spin
