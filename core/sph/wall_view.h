// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/fields/height_distance.h"
#include "core/fields/signed_distance_view.h"
#include "core/math/scalar_ops.h"

namespace spin {

/// How a surface holds what flows along it.
enum class WallFriction : std::uint8_t { FreeSlip, NoSlip, Coulomb };

struct WallSurface {
  WallFriction friction = WallFriction::NoSlip;
  float tangent = 0.0f;     ///< Coulomb: friction coefficient
  float turbulence = 0.0f;  ///< Coulomb: g / xi of Voellmy's law, adds rho turbulence v^2 to the shear stress
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

/// Where the ground is nearest to a point.
struct GroundContact {
  float distance = INFINITY;  ///< m, below 0 under the ground; infinite where it is out of reach
  float nx = 0, ny = 0, nz = 1;
  std::uint32_t surface = 0;
};

/// A static mesh by its signed distance.
struct WallMesh {
  SignedDistanceView field;
  std::uint8_t surface = 0;
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
  const WallMesh* meshes = nullptr;
  std::int32_t meshCount = 0;
  WallSurface surface[kMostSurfaces];

  SPIN_HD_INLINE GroundContact nearGround(float x, float y, float z, float reach) const {
    HeightContact<float> near;
    if (!ground.heights || !nearestGround(ground, x, y, z, reach, near)) return {};
    const std::uint8_t kind = ground.surfaces ? ground.surfaces[near.quad] : std::uint8_t{0};
    return {near.distance, near.normal.x, near.normal.y, near.normal.z, kind};
  }

  /// Calls visit(WallContact) for every solid nearer than `reach`, m; `under` is what nearGround() gives
  /// there.
  template <class Visit>
  SPIN_HD_INLINE void near(float x, float y, float z, float reach, const GroundContact& under,
                           const Visit& visit) const {
    for (std::int32_t k = 0; k < planeCount; ++k) {
      const WallPlane& p = planes[k];
      const float distance = p.nx * x + p.ny * y + p.nz * z - p.offset;
      if (distance < reach) visit(WallContact{distance, p.nx, p.ny, p.nz, p.vx, p.vy, p.vz, p.surface});
    }
    if (under.distance < reach)
      visit(WallContact{under.distance, under.nx, under.ny, under.nz, 0.0f, 0.0f, 0.0f,
                        static_cast<std::uint8_t>(under.surface)});
    for (std::int32_t k = 0; k < meshCount; ++k) nearMesh(meshes[k], x, y, z, reach, visit);
  }
  template <class Visit>
  SPIN_HD_INLINE void near(float x, float y, float z, float reach, const Visit& visit) const {
    near(x, y, z, reach, nearGround(x, y, z, reach), visit);
  }

 private:
  template <class Visit>
  SPIN_HD_INLINE static void nearMesh(const WallMesh& mesh, float x, float y, float z, float reach,
                                      const Visit& visit) {
    SignedDistanceView::Value at;
    if (!mesh.field.sample(x, y, z, at) || !(at.distance < reach)) return;
    const float size = squareRoot(at.x * at.x + at.y * at.y + at.z * at.z);
    // Deep inside, and on the middle of a thin solid, there is no direction: any leads out.
    const float scale = size > 1e-3f ? 1.0f / size : 0.0f;
    visit(WallContact{at.distance, at.x * scale, at.y * scale, scale > 0.0f ? at.z * scale : 1.0f, 0.0f, 0.0f,
                      0.0f, mesh.surface});
  }
};

}  // namespace spin
