// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/math/scalar_ops.h"

namespace spin {

/// How a surface holds what flows along it.
enum class WallFriction : std::uint8_t { FreeSlip, NoSlip, Coulomb };

struct WallSurface {
  WallFriction friction = WallFriction::NoSlip;
  float tangent = 0.0f;  ///< Coulomb: friction coefficient
};
inline constexpr std::size_t kMostSurfaces = 16;
inline constexpr std::size_t kMostPlanes = 8;

/// A solid half-space; it may slide along itself.
struct WallPlane {
  float nx = 0, ny = 0, nz = 1;  ///< unit normal, into the fluid
  float offset = 0;              ///< n . x on the plane, solver's metres
  float vx = 0, vy = 0, vz = 0;  ///< m/s
  std::uint8_t surface = 0;
};

/// A height field: the triangulated surface of core/fields/terrain_surface.h, solid below. Values stand at
/// (originX + i cell, originY + j cell); where a corner of a quad is NaN there is no ground.
struct WallHeights {
  const float* heights = nullptr;          ///< null = none
  const std::uint8_t* surfaces = nullptr;  ///< by cell; null = surface 0
  std::int32_t width = 0, height = 0;
  float originX = 0, originY = 0, cell = 1;
};

/// A plane that stands for the solid near a point.
struct WallContact {
  float distance = 0;  ///< m along the normal, below 0 inside the solid
  float nx = 0, ny = 0, nz = 1;
  float vx = 0, vy = 0, vz = 0;
  std::uint8_t surface = 0;
};

/// All solids of a solver, in the solver's metres (from domainMin).
struct WallView {
  WallPlane planes[kMostPlanes];
  std::int32_t planeCount = 0;
  WallHeights ground;
  WallSurface surface[kMostSurfaces];

  /// Calls visit(WallContact) for every solid nearer than `reach`, m.
  template <class Visit>
  SPIN_HD_INLINE void near(float x, float y, float z, float reach, const Visit& visit) const {
    for (std::int32_t k = 0; k < planeCount; ++k) {
      const WallPlane& p = planes[k];
      const float distance = p.nx * x + p.ny * y + p.nz * z - p.offset;
      if (distance < reach) visit(WallContact{distance, p.nx, p.ny, p.nz, p.vx, p.vy, p.vz, p.surface});
    }
    if (ground.heights) nearGround(x, y, z, reach, visit);
  }

 private:
  template <class Visit>
  SPIN_HD_INLINE void nearGround(float x, float y, float z, float reach, const Visit& visit) const {
    const float gx = (x - ground.originX) / ground.cell, gy = (y - ground.originY) / ground.cell;
    if (!(gx >= 0.0f && gy >= 0.0f)) return;
    const std::int32_t i = static_cast<std::int32_t>(gx), j = static_cast<std::int32_t>(gy);
    if (i + 1 >= ground.width || j + 1 >= ground.height) return;
    const float* row =
        ground.heights + static_cast<std::size_t>(j) * static_cast<std::size_t>(ground.width) + i;
    const float z00 = row[0], z10 = row[1], z01 = row[ground.width], z11 = row[ground.width + 1];
    const float u = gx - static_cast<float>(i), v = gy - static_cast<float>(j);
    const float du = u >= v ? z10 - z00 : z11 - z01, dv = u >= v ? z11 - z10 : z01 - z00;
    const float sx = du / ground.cell, sy = dv / ground.cell;
    const float nz = 1.0f / squareRoot(1.0f + sx * sx + sy * sy);
    const float distance = (z - (z00 + du * u + dv * v)) * nz;
    // A NaN height fails the comparison: there is no ground.
    if (!(distance < reach)) return;
    const std::uint8_t kind = ground.surfaces ? ground.surfaces[row - ground.heights] : std::uint8_t{0};
    visit(WallContact{distance, -sx * nz, -sy * nz, nz, 0.0f, 0.0f, 0.0f, kind});
  }
};

}  // namespace spin
