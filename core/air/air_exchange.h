// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/air/air_solver.h"
#include "core/air/air_window.h"
#include "core/air/brick_solids.h"

namespace spin {

using CellKey = std::array<std::int32_t, 3>;  ///< in cells from the lattice's corner
inline constexpr std::uint32_t kNoCell = UINT32_MAX;

CellKey cellOf(const AirConfig& config, Vec3d place);
BrickKey brickOf(const CellKey& cell);
/// Place of a cell in the arrays of its brick.
std::size_t cellInBrick(const CellKey& cell, const BrickKey& key);
bool inDomain(const AirConfig& config, const BrickKey& key);
/// Index in the window's arrays, or kNoCell where the cell's brick is not active.
std::uint32_t activeIndex(const AirWindow& window, const CellKey& cell);

/// Velocities at a cell's lower and upper faces.
struct CellFaces {
  std::array<float, 3> low{}, high{};
};
/// Sets those of closed faces, where the arrays hold what the air beside them is carried with: the air goes
/// as fast through them as the solid moves. `cell` is computed.
void closeFaces(const AirConfig& config, const AirWindow& window, const std::vector<BrickSolids>& solids,
                const CellKey& cell, CellFaces& faces);

/// What is added to cells and faces: each once, in ascending order.
struct SourceLists {
  std::vector<std::uint32_t> cells;
  std::array<std::vector<float>, kAirScalars> amounts;  ///< per volume
  std::array<std::vector<std::uint32_t>, 3> faces;
  std::array<std::vector<float>, 3> impulses;  ///< N s
  std::array<std::vector<float>, 3> masses;    ///< kg that came with them
};

/// The cell itself or the lowest open one of the two above it; its open share, 0 where there is none.
float takingCell(const AirWindow& window, const std::vector<BrickSolids>& solids, CellKey& cell);

/// Sums sources up by cell and face, in their order. What lies in a solid goes to the nearest open cell
/// above; what has none, or is beyond the bricks, is booked as left.
SourceLists listSources(const AirConfig& config, const AirWindow& window,
                        const std::vector<BrickSolids>& solids, const std::vector<AirSource>& sources,
                        AirBudget& budget);
/// An impulse in a cell, and the mass that came with it, are shared by its open faces along each axis;
/// mergeFaces() sums up what came together.
void addImpulse(const AirWindow& window, const std::vector<BrickSolids>& solids, const CellKey& cell,
                Vec3d impulse, double mass, SourceLists& lists, AirBudget& budget);
void mergeFaces(SourceLists& lists);

/// Particles by the cell that they are in.
struct DragCells {
  std::vector<CellKey> cell;
  std::vector<std::uint32_t> index;             ///< in the arrays, by cell
  std::vector<std::vector<std::uint32_t>> who;  ///< particles, by cell
};
DragCells binDrag(const AirConfig& config, const AirWindow& window, const std::vector<BrickSolids>& solids,
                  const std::vector<AirDrag>& particles);
/// Solves each cell's air with its particles, implicitly: with c = rate t / (1 + rate t), the air ends at
/// (M u + sum m c v) / (M + sum m c) and every particle moves by c of the way there; M is the mass of a cell
/// of air of that density, with its load (see LoadPass). Returns the air's impulses.
std::vector<Vec3d> exchangeDrag(const DragCells& cells, const std::vector<CellFaces>& faces,
                                const std::vector<float>& load, double density, double cellSize,
                                double seconds, std::vector<AirDrag>& particles);

struct ListedAdd {
  float* values;
  const std::uint32_t* index;
  const float* amount;
  SPIN_HD void operator()(std::size_t i) const { values[index[i]] += amount[i]; }
};
struct ListedWrite {
  float* values;
  const std::uint32_t* index;
  const float* amount;
  SPIN_HD void operator()(std::size_t i) const { values[index[i]] = amount[i]; }
};
struct ListedRead {
  const float* values;
  const std::uint32_t* index;
  float* to;
  SPIN_HD void operator()(std::size_t i) const { to[i] = index[i] == kNoCell ? 0.0f : values[index[i]]; }
};
/// Impulses at faces, after the mass that came with them has been added; `unit` = 1 over the mass of a cell
/// of the air round the cloud.
struct ListedPush {
  float* u;
  const float* load;
  const std::uint32_t* index;
  const float *impulse, *mass;
  int step;
  float unit;
  SPIN_HD void operator()(std::size_t i) const {
    const std::uint32_t at = index[i];
    const float density = 1.0f + 0.5f * (load[at] + load[at - static_cast<std::uint32_t>(step)]);
    u[at] += (impulse[i] - mass[i] * u[at]) * unit / density;
  }
};

}  // namespace spin
