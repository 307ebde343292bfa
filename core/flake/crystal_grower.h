// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/random.h"
#include "core/base/result.h"

namespace spin {

/// Habits of snow crystals that the automaton grows: fern-like and plain stars, stars with broad branches,
/// and plates with corners.
enum class CrystalHabit : std::uint8_t { Fern, Stellar, Broad, Plate };

/// The lattice map of Gravner and Griffeath 2008 ("Modeling snow crystal growth II"), in its own numbers.
struct CrystalLaw {
  double vapour = 0.5;        ///< rho: vapour far away, mass per cell
  double tipMass = 1.4;       ///< beta: boundary mass at which a tip (one or two neighbours) freezes
  double hollowMass = 0.08;   ///< alpha: ... a hollow (three neighbours) where vapour is scarce
  double scarce = 0.025;      ///< theta: vapour round a hollow below which it is scarce
  double freezing = 0.003;    ///< kappa: share of the vapour at the boundary that is crystal at once
  double melting = 0.06;      ///< mu: share of the boundary mass that turns to vapour in a step
  double sublimation = 5e-5;  ///< gamma: share of the boundary's crystal mass that does
};
CrystalLaw crystalLaw(CrystalHabit habit);

struct CrystalSettings {
  CrystalLaw law = crystalLaw(CrystalHabit::Stellar);
  std::uint64_t seed = 1;
  int cells = 160;         ///< from the nucleus to the tips when it is grown
  double weather = 0.3;    ///< how much the air changes on the crystal's way, 0..1; makes each one its own
  int mostSteps = 200000;  ///< it stops there whatever its size
};

/// Fails with what is wrong where the settings make no crystal.
Status checkCrystalSettings(const CrystalSettings& settings);

/// Grows one snow crystal on a hexagonal lattice, step by step. Only one of the twelve sectors is computed;
/// the others are its images by index, so the symmetry is exact.
class CrystalGrower {
 public:
  /// The settings must pass checkCrystalSettings.
  explicit CrystalGrower(const CrystalSettings& settings);

  /// Does that many steps, fewer if it is grown then. Fails only with ErrorKind::Cancelled.
  Status grow(int steps, const CancelToken& cancel);
  bool done() const { return m_reach >= m_settings.cells || m_steps >= m_settings.mostSteps; }
  /// Share of the wanted size, 0..1.
  double progress() const;

  const CrystalSettings& settings() const { return m_settings; }
  int reach() const { return m_reach; }  ///< cells from the nucleus to the farthest tip
  int steps() const { return m_steps; }
  /// Whether the cell (i, j) is ice: at i e + j f, e and f unit vectors 60 degrees apart.
  bool frozen(int i, int j) const;
  /// Crystal mass of a cell, about its thickness; 0 outside the ice.
  double thickness(int i, int j) const;
  /// Cells of ice in all sectors.
  int iceCells() const;
  /// Mass of ice, boundary and vapour in all sectors.
  double totalMass() const;

 private:
  static constexpr std::int32_t kNone = -1;
  void buildSector();
  std::int32_t indexOf(int i, int j) const;
  void changeWeather();
  void diffuse();
  void freeze();
  void attach();
  void melt();
  void addIce(std::int32_t cell);

  CrystalSettings m_settings;
  CrystalLaw m_law;
  int m_rings = 0;  ///< cells from the nucleus to the rim where the vapour is held
  int m_reach = 0;
  int m_steps = 0;
  int m_spell = -1;                                         ///< of the weather
  std::vector<std::int32_t> m_firstOfRow;                   ///< by i: index of the cell (i, 0)
  std::vector<std::array<std::int32_t, 6>> m_neighbours;    ///< by cell; the last "cell" is the rim's vapour
  std::vector<std::int32_t> m_ring;                         ///< by cell: cells from the nucleus
  std::vector<double> m_share;                              ///< by cell: images
  std::vector<double> m_vapour, m_next, m_boundary, m_ice;  ///< by cell
  std::vector<std::uint8_t> m_frozen, m_touched;            ///< by cell: ice, and beside ice
  std::vector<std::int32_t> m_edge, m_joining;              ///< cells beside ice, in order
};

}  // namespace spin
