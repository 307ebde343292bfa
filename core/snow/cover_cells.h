// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/sim/serialize.h"
#include "core/snow/cover_site.h"
#include "core/snow/cover_weather.h"
#include "core/snow/exposure_field.h"
#include "core/snow/snow_fallout.h"

namespace spin {

/// Snow on all cells of a scene: columns, and what has fallen on them since they were last advanced. Columns
/// take at least a minute at once: in shorter steps floats would lose what warms them.
class CoverCells {
 public:
  static constexpr double kLeastStep = 60.0;   ///< s
  static constexpr double kMostStep = 3600.0;  ///< s

  /// ground must outlive it.
  CoverCells(const SceneSnapshot& scene, const SnowGround& ground, CpuBackend& backend);

  /// Snow that lies at the start: so much on open level ground (kg/m2) as if it had fallen in the field's
  /// directions, and what is painted. Returns the kg that painting adds.
  double layOld(const SceneSnapshot& scene, const ExposureField& field, double swe, double density);

  /// kg that came in beyond, or were taken from, what the field says.
  struct Fallen {
    double gained = 0.0;   ///< by altitude; may be negative
    double cleared = 0.0;  ///< by whoever keeps ground clear
    double runoff = 0.0;   ///< rain, where no column takes it up
  };
  /// So much precipitation on open level ground, kg/m2, as snow of a density unless the columns decide.
  Fallen fall(const SceneSnapshot& scene, double filmTime, const ExposureField& field,
              const CoverWeather& weather, double fallen, double density, CpuBackend& backend);
  /// Snow that settled out of the air, at an air temperature above 273.15 K: it lies on the terrain's cells
  /// below it. What lies beyond them is moved to `refused`.
  void settle(SnowFallout& fallout, double airTemperature);
  /// What crossed the columns' borders, and the time for which they were advanced.
  struct Advanced {
    SnowStepTotals totals;
    double seconds = 0.0;
  };
  /// Advances the columns if what waits is long enough or has to be done.
  Advanced advance(const SceneSnapshot& scene, const TimeSpan& span, double fallen, CpuBackend& backend,
                   Isa isa);

  /// What moves when snow moves along the ground, by cell; nothing waits (see waits()).
  struct Moving {
    std::vector<double> depth;   ///< m
    std::vector<double> mass;    ///< kg/m2, ice and water
    std::vector<double> liquid;  ///< kg/m2
    std::vector<double> heat;    ///< J/m2, zero for ice at 273.15 K
  };
  /// Snow that fell since the columns were last advanced lies on top of them and cannot move yet.
  bool waits() const { return m_ages && m_waitingSeconds > 0.0; }
  Moving moving() const;
  /// Makes the snow of the cells what it has become: what a cell lost left all its layers alike, what it
  /// gained lies on top. `before` is what moving() gave.
  void move(const Moving& before, const Moving& after, CpuBackend& backend);

  /// kg on all cells.
  double deposited() const;
  /// Snow of one grid; liquid and temperature only where columns are advanced.
  CoverPart::Values valuesOf(std::size_t grid) const;

  void save(ByteWriter& out) const;
  bool load(ByteReader& in);

 private:
  void setSnow(std::size_t cell, double mass, double density, float temperature, float albedo);
  /// Cell of the terrain that accounts for a place; none beyond it.
  std::optional<std::size_t> terrainCellAt(Vec3d position) const;
  /// What painted layers say of a grid; null where it has none.
  const GroundLayers* layersOf(std::size_t grid) const;
  /// Share of what falls on a cell that lies there as snow if no column decides.
  double lyingShare(std::size_t cell, const CoverWeather& weather) const;
  double areaOf(std::size_t cell) const { return static_cast<double>(m_cells.setting(kCellArea)[cell]); }

  const SnowGround& m_ground;
  CoverSite m_site;
  bool m_ages = true;  ///< columns are advanced at all
  SnowCells m_cells;
  std::vector<double> m_freshMass;   ///< kg/m2 since the columns' last step
  std::vector<double> m_freshDepth;  ///< m
  double m_waitingSeconds = 0.0;     ///< since then
  double m_waitingFallen = 0.0;      ///< kg/m2 on open level ground since then
  FrameTime m_waitingFrom;
  double m_waitingTo = 0.0;  ///< s of weather
};

}  // namespace spin
