// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "core/air/air_solver.h"
#include "core/bench/bench_case.h"

namespace spin {

/// Fields of an AirState, in its order.
enum class AirValue { U, V, W, Mist, Snow, Warmth, Vapour, Pressure, SecondPressure, Share };

/// The state of a box all of which is computed, by cells: what the cases fill in and read out. Velocities lie
/// at the lower faces of cells, in m/s.
class AirBox {
 public:
  /// Nothing anywhere. Cells along each axis must fill whole bricks.
  explicit AirBox(std::array<int, 3> cells);
  /// The state must hold every brick of a box.
  explicit AirBox(AirState state);

  std::array<int, 3> cells() const { return m_cells; }
  float& at(AirValue field, int i, int j, int k) { return m_state.values[index(field, i, j, k)]; }
  float at(AirValue field, int i, int j, int k) const { return m_state.values[index(field, i, j, k)]; }
  /// Velocity at a face of the lattice, 0 at the high sides of the box.
  float face(int axis, int i, int j, int k) const;
  void clear(AirValue field);
  const AirState& state() const { return m_state; }

  /// visit(i, j, k) of all cells, x fastest.
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (int k = 0; k < m_cells[2]; ++k)
      for (int j = 0; j < m_cells[1]; ++j)
        for (int i = 0; i < m_cells[0]; ++i) visit(i, j, k);
  }
  /// Velocities without any divergence on the lattice: curl of a potential on the cells' edges.
  /// `potential(axis, i, j, k)` is its line integral over the edge along that axis from node (i, j, k) on,
  /// divided by the square of the cell size: m/s.
  void setCurl(const std::function<double(int axis, int i, int j, int k)>& potential);
  /// Largest |net outflow of a cell| / (face area), m/s: the divergence times the cell size. For boxes with
  /// closed sides and nothing solid inside.
  double mostOutflow() const;
  /// Sum of a field over all cells.
  double sum(AirValue field) const;

 private:
  std::size_t index(AirValue field, int i, int j, int k) const;

  std::array<int, 3> m_cells{}, m_bricks{};
  AirState m_state;
};

/// A closed box of so many cells, computed everywhere, that nothing pulls at and nothing changes in: cases
/// switch on what they measure.
AirConfig stillBox(std::array<int, 3> cells, double cell);

/// On the device, threads and instruction set that the options ask for.
Result<std::unique_ptr<AirSolver>> startAir(const AirConfig& config, const BenchOptions& options);
/// Device, instruction set and threads of the row.
void nameDevice(const AirSolver& solver, const BenchOptions& options, BenchRow& row);

/// A hilly ground between 0.1 and 0.25 of `size` above the box's floor, m; what the cases stand on.
AirSolid hills(double size);
AirSolid ball(Vec3d centre, double radius);

}  // namespace spin
