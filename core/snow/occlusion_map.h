// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/parallel.h"
#include "core/math/sampling.h"
#include "core/snow/map_drawing.h"
#include "core/snow/map_raster.h"
#include "core/snow/snow_scene.h"

namespace spin {

/// Triangles that snow can hit, in local m less the snow scene's centre, in blocks with bounds.
class Occluders {
 public:
  static constexpr std::size_t kBlock = 256;
  using Triangle = std::array<Vec3f, 3>;
  struct Block {
    Vec3f low, high;
  };

  /// The terrain and all models where they stand. Unfinished when cancelled.
  Occluders(const SceneSnapshot& snapshot, const SnowScene& scene, const CancelToken& cancel = {});

  std::size_t size() const { return m_triangles.size(); }
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  const std::vector<Block>& blocks() const { return m_blocks; }

 private:
  void addTerrain(const SceneSnapshot& snapshot, const SnowScene& scene, const CancelToken& cancel);
  void bound();

  std::vector<Triangle> m_triangles;
  std::vector<Block> m_blocks;
};

/// What an occlusion map shows: looking along a direction of fall, a rectangle across it.
struct MapView {
  Frame3d frame;  ///< n: direction of fall; s and t span the map
  double low[2] = {0.0, 0.0};
  double texel = 1.0;  ///< m
  int columns = 0, rows = 0;
  DrawnTexels drawn;  ///< all, or what keep() asks for; a texel holds the same in either case

  /// Smallest map round points, at most `most` texels along a side, of the texel wanted or larger.
  static MapView round(const std::vector<Vec3d>& points, Vec3d fall, double wantedTexel, int most);
  /// Draws only what is needed to ask at the points, and between them.
  void keep(const std::vector<Vec3d>& points);
  MapProjection projection() const;
  /// Where a point is seen, in texels whose centres are at whole numbers.
  Vec2d texelOf(Vec3d point) const {
    return {(dot(point, frame.s) - low[0]) / texel - 0.5, (dot(point, frame.t) - low[1]) / texel - 0.5};
  }
};

/// Depth along a direction of fall of the first surface in every texel: a point is sheltered if something
/// lies before it (Williams 1978). Comparing the four texels round a point, each with the receiver's own
/// plane, gives a share (percentage-closer filtering: Reeves, Salesin and Cook 1987).
class OcclusionMap {
 public:
  /// Texels that openness() looks away from a point at most, beside it and, by its plane's steepest slope
  /// along both axes, in depth.
  static constexpr double kReachInTexels = 18.0;

  /// Draws the triangles that lie in the view; the same bits whatever the number of threads.
  OcclusionMap(const Occluders& occluders, const MapView& view, CpuBackend& backend,
               const CancelToken& cancel = {});
  /// The same drawn elsewhere.
  OcclusionMap(MapRaster& raster, const MapView& view) : m_view(view), m_depth(raster.draw(view)) {}

  const MapView& view() const { return m_view; }
  /// Depth in a texel, infinite where nothing is.
  float depth(int column, int row) const {
    return m_depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_view.columns) +
                   static_cast<std::size_t>(column)];
  }
  /// Share 0..1 of the snow falling along the view that reaches a point of a surface with a unit normal.
  /// Outside the map nothing is in the way.
  double openness(Vec3d point, Vec3d normal) const;

 private:
  MapView m_view;
  std::vector<float> m_depth;
};

}  // namespace spin
