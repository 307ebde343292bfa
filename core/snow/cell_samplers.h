// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "core/fields/terrain_surface.h"
#include "core/snow/snow_ground.h"

namespace spin {

/// A point of the bare surface and its unit normal, n_z > 0.
struct SurfacePoint {
  Vec3d position{};
  Vec3d normal{0, 0, 1};
};

/// Maps the unit square to points uniform over the part of the terrain's surface that a cover cell stands
/// for, by horizontal area.
class TerrainCellSampler {
 public:
  /// superseded: 1 for quads that fine grids account for, by quad. All references must outlive the sampler.
  TerrainCellSampler(const TerrainSurface& surface, const TerrainGrid& grid, const CoverGrid& cover,
                     const Raster<std::uint8_t>& superseded)
      : m_surface(&surface), m_grid(grid), m_cover(&cover), m_superseded(&superseded) {}
  /// False where the cell has no surface.
  bool enter(std::size_t cell) {
    m_parts = 0;
    const auto width = static_cast<std::size_t>(m_cover->base.width);
    const int i = static_cast<int>(cell % width), j = static_cast<int>(cell / width);
    if (m_grid.refinement > 0) {
      const int k = m_grid.refinement;
      addPart(m_grid.firstQuadI + i / k, m_grid.firstQuadJ + j / k, (i % k) / double(k), (j % k) / double(k),
              1.0 / k);
    } else {
      addQuarters(i, j);
    }
    return m_parts > 0;
  }
  SurfacePoint at(double u, double v) const {
    const double along = u * m_parts;
    const int k = std::min(static_cast<int>(along), m_parts - 1);
    const Part& part = m_part[static_cast<std::size_t>(k)];
    const double pu = part.u0 + part.size * (along - k), pv = part.v0 + part.size * v;
    const bool lower = pu >= pv;
    const double du = lower ? part.lowerU : part.upperU, dv = lower ? part.lowerV : part.upperV;
    const double cell = m_surface->heights().cellSize;
    return {{part.x + pu * cell, part.y + pv * cell, part.z + du * pu + dv * pv},
            normalized(Vec3d{-du, -dv, cell})};
  }

 private:
  /// A square piece of a quad: position in it, and the slopes of its two triangles per quad.
  struct Part {
    double u0, v0, size, x, y, z, lowerU, lowerV, upperU, upperV;
  };

  void addPart(int qi, int qj, double u0, double v0, double size) {
    if (!m_surface->quadExists(qi, qj)) return;
    const Raster<float>& h = m_surface->heights();
    const double z00 = h.at(qi, qj), z10 = h.at(qi + 1, qj), z01 = h.at(qi, qj + 1),
                 z11 = h.at(qi + 1, qj + 1);
    m_part[static_cast<std::size_t>(m_parts++)] = {u0,  v0,        size,      h.x(qi),   h.y(qj),
                                                   z00, z10 - z00, z11 - z10, z11 - z01, z01 - z00};
  }
  /// The quarters of the quads round a coarse cell that no fine grid accounts for; all of them where fine
  /// grids account for the whole cell, so that it too has values to draw.
  void addQuarters(int i, int j) {
    const bool owns = m_cover->area.at(i, j) > 0.0f;
    for (int corner = 0; corner < 4; ++corner) {
      const int qi = i - 1 + (corner & 1), qj = j - 1 + (corner >> 1);
      if (owns && m_superseded->contains(qi, qj) && m_superseded->at(qi, qj)) continue;
      addPart(qi, qj, corner & 1 ? 0.0 : 0.5, corner >> 1 ? 0.0 : 0.5, 0.5);
    }
  }

  const TerrainSurface* m_surface;
  TerrainGrid m_grid;
  const CoverGrid* m_cover;
  const Raster<std::uint8_t>* m_superseded;
  std::array<Part, 4> m_part{};
  int m_parts = 0;
};

/// The same for a patch of a model that stands somewhere.
class PatchCellSampler {
 public:
  PatchCellSampler(const ModelGround& model, const ModelPatch& patch, Vec3d position)
      : m_model(&model), m_patch(&patch), m_position(position) {}
  bool enter(std::size_t cell) {
    m_begin = m_patch->cellStart[cell];
    m_end = m_patch->cellStart[cell + 1];
    return m_begin < m_end;
  }
  SurfacePoint at(double u, double v) const {
    const auto first = m_patch->pieces.begin() + m_begin, last = m_patch->pieces.begin() + m_end;
    const double area = u * static_cast<double>((last - 1)->areaToHere);
    auto piece = std::upper_bound(first, last, area, [](double a, const PatchPiece& p) {
      return a < static_cast<double>(p.areaToHere);
    });
    piece = std::min(piece, last - 1);
    const double before = piece == first ? 0.0 : static_cast<double>((piece - 1)->areaToHere);
    const double own = static_cast<double>(piece->areaToHere) - before;
    return pointOn(*piece, own > 0.0 ? std::clamp((area - before) / own, 0.0, 1.0) : 0.5, v);
  }

 private:
  SurfacePoint pointOn(const PatchPiece& piece, double u, double v) const {
    const auto corner = [&](std::size_t k) {
      return Vec2d{static_cast<double>(piece.plan[k].x), static_cast<double>(piece.plan[k].y)};
    };
    const double root = std::sqrt(u);
    const Vec2d p = corner(0) * (1.0 - root) + corner(1) * (root * (1.0 - v)) + corner(2) * (root * v);
    const PlacedTriangle& triangle = m_model->triangles[piece.source];
    Vec3d n = normalized(triangle.normal());
    if (n.z < 0.0) n = -n;
    const Vec3d a = triangle.corners[0].to<double>();
    // On steep triangles rounding in plan would lift the point off them.
    const auto [low, high] =
        std::minmax({triangle.corners[0].z, triangle.corners[1].z, triangle.corners[2].z});
    const double z = std::clamp(a.z - (n.x * (p.x - a.x) + n.y * (p.y - a.y)) / n.z, static_cast<double>(low),
                                static_cast<double>(high));
    return {m_position + Vec3d{p.x, p.y, z}, n};
  }

  const ModelGround* m_model;
  const ModelPatch* m_patch;
  Vec3d m_position;
  std::ptrdiff_t m_begin = 0, m_end = 0;
};

}  // namespace spin
