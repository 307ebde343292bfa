// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/sim/serialize.h"

namespace spin {

/// Two winds over land, one along x and one along y, over the wind that level ground would have at the same
/// height: by columns of boxes that follow the ground (core/snow/wind_field.h solves and asks them). It holds
/// for any wind, so the frames of a film share it.
struct WindTable {
  /// Parts along x, y and z of both winds.
  struct Ratios {
    std::array<float, 3> byX{}, byY{};
  };
  int width = 0, height = 0, layers = 0;
  double originX = 0.0, originY = 0.0, cell = 1.0;  ///< centre of the first column and side of all, m
  double roughness = 0.01;                          ///< of the ground, m
  double top = 0.0;                                 ///< m
  std::vector<float> depth;                         ///< m from ground to the top, by column
  std::vector<double> levels;                       ///< heights of the layers' borders over that, 0 to 1
  std::vector<Ratios> ratios;                       ///< by column, layers within

  /// A place among four columns.
  struct Place {
    std::array<std::size_t, 4> column{};
    std::array<double, 4> weight{};
  };
  /// Beside the table that of its edge.
  Place placeOf(double x, double y) const;
  /// Whether a place lies between the centres of columns.
  bool holds(double x, double y) const;
  /// Ground under a place, m.
  double groundHeight(const Place& place) const;

  std::size_t columns() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t bytes() const {
    return depth.size() * sizeof(float) + levels.size() * sizeof(double) + ratios.size() * sizeof(Ratios);
  }
};

void putShared(const WindTable& table, ByteWriter& out);
/// Null if the bytes are none; known by its content (SharedRegistry) afterwards.
std::shared_ptr<const void> loadWindTable(ByteReader& in);

}  // namespace spin
