// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/fields/raster.h"
#include "core/fields/tiled_raster.h"
#include "core/property/scene_node.h"

namespace spin {

/// Numbers of two edges (of the corner each begins at) that meet elsewhere than in a shared corner; nothing
/// where an outline does not cross itself.
std::optional<std::pair<std::size_t, std::size_t>> selfCrossing(const PlanPoints& outline);

/// Ground that flow is laid on: the terrain, or level ground at height 0 where there is none.
class FlowGround {
 public:
  /// Keeps the pointer; null = no terrain.
  explicit FlowGround(const Raster<float>* heights) : m_heights(heights) {}
  const Raster<float>* heights() const { return m_heights; }
  /// Nothing outside the terrain or in a hole.
  std::optional<double> heightAt(double x, double y) const;
  Vec3d normalAt(double x, double y) const;

 private:
  const Raster<float>* m_heights;
};

/// The area of a release: within the outline, or on painted cells.
class ReleaseArea {
 public:
  /// Keeps references: node and ground must outlive the area.
  ReleaseArea(const SceneNode& node, const FlowGround& ground);

  bool contains(double x, double y) const;
  /// Points all over the area with ground under them: the painted cells' centres, and a lattice within the
  /// outline of the terrain's cells or a 64th of its size. Corners of the outline are not among them.
  const std::vector<Vec3d>& samples() const { return m_samples; }
  /// Share of the lattice within the outline that has no ground.
  double shareWithoutGround() const { return m_shareWithoutGround; }
  /// Mean of the ground's normals over the samples, unit.
  Vec3d normal() const { return m_normal; }
  /// Side of the square that a sample stands for, m.
  double sampleSize() const { return m_step; }

 private:
  bool inOutline(double x, double y) const;
  bool isPainted(double x, double y) const;
  void sampleOutline();
  void samplePainted();
  bool addSample(double x, double y);

  const PlanPoints& m_outline;
  const TiledRaster<std::uint8_t>* m_painted;
  const FlowGround& m_ground;
  double m_step = 1.0;
  std::vector<Vec3d> m_samples;
  double m_shareWithoutGround = 0.0;
  Vec3d m_normal{0, 0, 1};
};

/// A slab over an area, cut into layers along its mean normal. In every layer the particles stand on a
/// square lattice that is seen along the normal; each has the volume spacing^3, so their number gives the
/// slab's volume.
struct Slab {
  std::vector<Vec3d> positions;  ///< local m
  int layers = 0;
  double depth = 0.0;  ///< m along the mean normal
};
/// depth > 0 along the mean normal, or vertical.
Slab fillSlab(const ReleaseArea& area, const FlowGround& ground, double depth, bool depthIsVertical,
              double spacing);
/// About how many particles the slab will have.
double slabParticles(const ReleaseArea& area, double depth, bool depthIsVertical, double spacing);

}  // namespace spin
