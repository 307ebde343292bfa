// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/snow/snow_scene.h"
#include "core/snow/snow_weather.h"

namespace spin {

/// Direction of fall uniform in the cone, by a map and random numbers of its own: nothing in common with the
/// cover's.
Vec3d referenceDirection(const FallCone& cone, const CounterRandom& random, std::uint64_t index);

/// A point of a bare surface and its unit normal on the upper side.
struct ReferencePoint {
  Vec3d position{}, normal{0, 0, 1};
};

/// The surface that one cover cell stands for, found apart from the cover's own samplers: a place in the
/// cell's square is drawn, and whatever surface of the cell's kind lies above or below it there is taken.
class ReferenceSurface {
 public:
  /// All references must outlive it; the cell accounts for some area.
  ReferenceSurface(const SceneSnapshot& snapshot, const SnowGround& ground, const SnowScene& scene,
                   std::size_t grid, std::size_t cell);
  /// Points over a random place of the cell's square; none where it has no surface there.
  void pointsAt(const CounterRandom& random, std::uint64_t index, std::vector<ReferencePoint>& points) const;

 private:
  void addPart(const ModelGround& model, const ModelPatch& patch);
  bool fineGridCovers(double x, double y) const;
  void terrainPoint(double x, double y, std::vector<ReferencePoint>& points) const;
  void modelPoints(double x, double y, std::vector<ReferencePoint>& points) const;

  const SceneSnapshot* m_snapshot;
  const SnowGround* m_ground;
  Vec2d m_low, m_high;  ///< the cell's square, m; of a model's cell the part that its triangles' boxes reach
  bool m_coarse = false;  ///< fine grids take their part of the terrain
  bool m_terrain = false;
  Vec3d m_place{};                          ///< of the model
  std::vector<PlacedTriangle> m_triangles;  ///< of the model's part, near the cell
};

}  // namespace spin
