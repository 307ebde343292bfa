// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/cancel.h"
#include "core/base/parallel.h"
#include "core/fields/raster.h"

namespace spin {

/// Boxes of air over terrain, in columns: box k of column c has number c * layers + k. Column borders are
/// upright, layers' borders follow the ground below and are level at the top.
struct WindColumns {
  int width = 0, height = 0, layers = 0;
  double cell = 1.0;           ///< m, side of a column
  std::vector<double> ground;  ///< m, by column
  double top = 0.0;            ///< m
  std::vector<double> levels;  ///< layers + 1 from 0 to 1
  std::vector<float> solid;    ///< share of a box that models fill

  std::size_t columns() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t boxes() const { return columns() * static_cast<std::size_t>(layers); }
  std::size_t column(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
  }
  double depth(std::size_t c) const { return top - ground[c]; }
  double thickness(std::size_t c, int k) const {
    return (levels[static_cast<std::size_t>(k) + 1] - levels[static_cast<std::size_t>(k)]) * depth(c);
  }
};

/// Flow through the faces of the boxes, m3/s: towards +x, +y, up; and what a unit of potential drives there.
struct WindFaces {
  std::vector<double> x, y, z;  ///< x: (width + 1) a row, y: (height + 1) rows, z: (layers + 1) a column
};

/// Number of the x face west of box (i, j, k), i to width; of the y face south of it, j to height; of the z
/// face below it, k to layers.
std::size_t xFace(const WindColumns& g, int i, int j, int k);
std::size_t yFace(const WindColumns& g, int i, int j, int k);
std::size_t zFace(const WindColumns& g, std::size_t column, int k);

/// Conductances: with what ease the flow through a face changes. 0 at the ground and where models stand.
WindFaces windConductances(const WindColumns& g, double verticalStiffness);
/// The level log profile of a unit wind 10 m above ground along x or y, through the open parts of the faces.
WindFaces levelWind(const WindColumns& g, int axis, double roughness);

struct WindBalance {
  double divergence = 0.0;  ///< see WindField::divergence
  int iterations = 0;
};
/// Changes the flow so that as much enters as leaves every box, by conjugate gradients over a potential that
/// is 0 outside the open sides and the top; preconditioned by the exact solution of every column.
WindBalance balanceWind(const WindColumns& g, const WindFaces& conductance, double tolerance,
                        int mostIterations, CpuBackend& backend, WindFaces& flow,
                        const CancelToken* cancel = nullptr);

}  // namespace spin
