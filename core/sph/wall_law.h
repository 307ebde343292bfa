// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/kernels.h"
#include "core/sph/pair_law.h"
#include "core/sph/wall_view.h"

/// What a solid half-space does to a particle at distance s h of its plane: the same sums as over particles,
/// as integrals over the half-space. P(s) is the kernel's integral over the plane (times h), lambda(s) that
/// over the half-space. The wall's velocity is extrapolated linearly through the solid: v(z) = v_w + (v_i -
/// v_w) (1 + z/d) at height z above the particle, so that a linear profile feels no force beyond its own.
namespace spin {

/// Distance that quotients by it are held to, spacings: particles that touch the wall, or are pressed into
/// it.
inline constexpr float kLeastWallDistance = 0.25f;
/// No step brings a particle nearer to a solid than this, spacings: fields round edges and corners off by as
/// much.
inline constexpr float kClosestToWall = 0.1f;

/// Shares of a particle's surroundings that several solids take together: 1 - prod(1 - lambda_k), exact for
/// planes at right angles up to the kernel's corner, and how much each counts in the sum's gradient.
struct WallShares {
  float open = 1.0f;  ///< prod(1 - lambda_k)
  SPIN_HD_INLINE void add(float lambda) { open *= maximum(1.0f - lambda, 0.0f); }
  SPIN_HD_INLINE float solid() const { return 1.0f - open; }
  /// Factor of grad lambda_k: the product over the others.
  SPIN_HD_INLINE float weight(float lambda) const {
    const float own = 1.0f - lambda;
    return own > 1e-3f ? open / own : 1.0f;
  }
};

/// Pressure of the wall, continued hydrostatically from the particle: p_w = max(0, p_i + rho g . (x_w -
/// x_i)).
SPIN_HD_INLINE float wallPressure(float pressure, float restDensity, float gravityAlongNormal,
                                  float distance) {
  return maximum(pressure - restDensity * gravityAlongNormal * distance, 0.0f);
}

/// Acceleration along the normal by a wall: (P_i + p_w) P(s) / (rho0 h). Both terms: a column at rest errs by
/// 24 % and more without the second.
SPIN_HD_INLINE float wallPush(float s, float pressureTerm, float wallPressure, float restDensity,
                              float support) {
  return (pressureTerm + wallPressure) * CubicSpline::planeIntegral(s) / (restDensity * support);
}

/// Rate at which a no-slip wall takes up the velocity relative to it, 1/s: 2 nu P(s) / (h d), from the
/// pairwise viscosity 2 nu (v_i - v) (grad W . x / r^2) integrated over the half-space with the extrapolated
/// velocity.
SPIN_HD_INLINE float wallDragRate(float s, float distance, float kinematicViscosity, float support) {
  return 2.0f * kinematicViscosity * CubicSpline::planeIntegral(s) / (support * distance);
}

/// Rate at which a rough wall takes up the velocity along it by the stress rho k v^2 (Voellmy 1955, with k =
/// g / xi), 1/s: 2 k v P(s) / h. Summed over the layers in reach it gives the stress, because the integral of
/// P over s is 1/2.
SPIN_HD_INLINE float wallTurbulentRate(float s, float turbulenceTimesSpeed, float support) {
  return 2.0f * turbulenceTimesSpeed * CubicSpline::planeIntegral(s) / support;
}

/// Divergence by a wall per speed away from it, 1/m: (s P(s) + lambda(s)) / d, from sum V (v_i - v) . grad W
/// over the half-space with the extrapolated velocity.
SPIN_HD_INLINE float wallDilation(float s, float distance) {
  return (maximum(s, 0.0f) * CubicSpline::planeIntegral(s) + CubicSpline::halfSpaceIntegral(s)) / distance;
}

/// Adds a no-slip wall's part to the velocity gradient (rate `relative`/d along the normal, times s P(s) +
/// lambda(s)) and to the correction matrix (the same along the normal, lambda along the plane). Both with
/// their factors, in 1/s and 1.
SPIN_HD_INLINE void addWallGradient(const WallContact& wall, float s, float distance,
                                    const PairVector<float>& relative, bool sticks,
                                    GradientSums<float>& sums) {
  const float lambda = CubicSpline::halfSpaceIntegral(s);
  const float normal = maximum(s, 0.0f) * CubicSpline::planeIntegral(s) + lambda;
  const float n[3] = {wall.nx, wall.ny, wall.nz}, v[3] = {relative.x, relative.y, relative.z};
  for (int a = 0; a < 3 && sticks; ++a)
    for (int b = 0; b < 3; ++b) sums.g[3 * a + b] += v[a] / distance * n[b] * normal;
  const float extra = normal - lambda;
  sums.m[0] += lambda + extra * n[0] * n[0];
  sums.m[1] += lambda + extra * n[1] * n[1];
  sums.m[2] += lambda + extra * n[2] * n[2];
  sums.m[3] += extra * n[0] * n[1];
  sums.m[4] += extra * n[0] * n[2];
  sums.m[5] += extra * n[1] * n[2];
}

}  // namespace spin
