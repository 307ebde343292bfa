// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/fields/raster.h"
#include "core/sim/wind_table.h"

namespace spin {

/// Height of a model's top over a raster's cells, m, NaN where there is none.
using ObstacleTops = Raster<float>;

struct WindSettings {
  double roughness = 0.01;   ///< m, of the ground
  int mostColumns = 128;     ///< along the longer side
  double firstLayer = 4.0;   ///< m, thickness of the lowest layer; more where columns are wide and few
  double layerGrowth = 1.3;  ///< thickness of a layer over that of the one below
  /// How much dearer it is to change the wind's vertical part than its horizontal one. With 1 the change is a
  /// potential flow, which is too slow on crests since it knows no shear; the default meets the speed-up
  /// of 2 h/L on a ridge (Taylor and Lee 1984).
  double verticalStiffness = 1.5;
  double tolerance = 1e-5;  ///< for WindField::divergence()
  int mostIterations = 2000;
  const CancelToken* cancel = nullptr;  ///< asked in every iteration; null = never
};

/// Wind 10 m above level ground: u(z) = u10 ln(z/z0)/ln(10 m/z0), 0 below z0, and no more above 300 m.
double logProfile(double above, double roughness);

/// Mean wind over terrain and models. A log profile over the ground is changed as little as possible so that
/// no air is lost or made (mass-consistent adjustment: Sasaki 1958, Sherman 1978): at the faces of boxes that
/// follow the terrain, sum of (F - F0)^2/c over all faces at the least with the sum of F zero in every box.
/// Two winds are solved, one along x, one along y; every other is made of these, since the adjustment is
/// linear.
///
/// It slows down in front of hills and in valleys across the wind, speeds up on crests and round the sides of
/// obstacles, and leads air through valleys. It cannot do: lee eddies, separation and wakes (see
/// wind_shelter.h), stability, thermal winds, gusts, fronts of obstacles smaller than its boxes.
class WindField {
 public:
  /// ground: heights with NaN holes, which are filled by what lies round them. obstacles: rasters of the tops
  /// of models; may be empty. Fails with ErrorKind::BadInput if there is no ground.
  static Result<WindField> make(const Raster<float>& ground, const std::vector<ObstacleTops>& obstacles,
                                const WindSettings& settings, CpuBackend& backend);

  /// Wind in m/s at a height above the ground, for a wind 10 m above level ground. Beside the field it is
  /// that of its edge.
  Vec3d at(double x, double y, double above, Vec2d wind10) const;
  /// What land and models change of a wind of that strength that does not grow with the height, m/s: where
  /// the ground is level, nothing at any height.
  Vec3d changeAt(double x, double y, double above, Vec2d wind) const;
  /// Horizontal speed over that on level ground at the same height.
  double speedUp(double x, double y, double above, Vec2d wind10) const;

  /// Ground under the columns, m.
  double groundHeight(double x, double y) const;

  /// Winds that were solved before.
  explicit WindField(std::shared_ptr<const WindTable> table) : m_table(std::move(table)) {}
  const std::shared_ptr<const WindTable>& table() const { return m_table; }

  int columns() const { return m_table->width; }
  int rows() const { return m_table->height; }
  int layers() const { return m_table->layers; }
  double cellSize() const { return m_table->cell; }
  /// What the solver left: root mean square of the net flow out of boxes over the flow through a box's side,
  /// for the worse of both winds; and its iterations.
  double divergence() const { return m_divergence; }
  int iterations() const { return m_iterations; }

 private:
  std::array<double, 6> ratiosAt(double x, double y, double above) const;

  std::shared_ptr<const WindTable> m_table;
  double m_divergence = 0.0;
  int m_iterations = 0;
};

}  // namespace spin
