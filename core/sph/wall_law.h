// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/kernels.h"
#include "core/sph/pair_law.h"
#include "core/sph/wall_view.h"

/// What a solid half-space does to a particle at distance s h of its plane: for density and pressure the sums
/// over layers of it, for what flows along it the integrals over the half-space. P(s) is the kernel's
/// integral over the plane (times h), lambda(s) that over the half-space. The wall's velocity is extrapolated
/// linearly through the solid: v(z) = v_w + (v_i - v_w) (1 + z/d) at height z above the particle, so that a
/// linear profile feels no force beyond its own.
namespace spin {

/// Distance that quotients by it are held to, spacings: particles that touch the wall, or are pressed into
/// it.
inline constexpr float kLeastWallDistance = 0.25f;
/// No step brings a particle nearer to a solid than this, spacings: fields round edges and corners off by as
/// much.
inline constexpr float kClosestToWall = 0.1f;

/// Depth below a particle of the first layer of a solid, and how fast that grows with the particle's distance
/// from the plane; all in spacings. A particle of the layer that touches sees its own mirror image, which
/// comes towards it as fast as it goes there; farther off, the first layer lies half a spacing below the
/// plane.
struct FirstLayer {
  float depth, rise;
};
SPIN_HD_INLINE FirstLayer firstLayer(float distance) {
  if (distance < kClosestToWall) return {distance + kClosestToWall, 1.0f};
  if (distance < 0.75f) return {2.0f * distance, 2.0f};
  if (distance < 1.5f) return {1.5f + (distance - 0.75f) * (2.0f / 3.0f), 2.0f / 3.0f};
  return {distance + 0.5f, 1.0f};
}

/// What a solid half-space counts for at distance s h of its plane: its share of the density, and how much
/// that loses per support away from the plane.
struct SolidShare {
  float density = 0.0f, slope = 0.0f;
};

/// The solid as layers a spacing apart, each smeared evenly: what a lattice of particles that mirrors the
/// flow would give there, without its bumps along the plane. Pressure pushes by the slope, the exact adjoint
/// of the density, so that a solid takes no energy and gives none, and carries a column with the pressure
/// that the column has. Two other forms were left: the integral over a continuum has the first layer of fluid
/// 3 to 4 % too dense, and the pressure of a wall of its own, beside a density that does not follow it, makes
/// a tank at rest gain energy without end. `layer` is the spacing over the support.
SPIN_HD_INLINE SolidShare solidShare(float s, float layer) {
  constexpr float kSlope = static_cast<float>(2.0 * kPi * CubicSpline::kNorm);
  const FirstLayer first = firstLayer(maximum(s, -1.0f) / layer);
  SolidShare sum;
  for (float at = first.depth * layer; at < 1.0f; at += layer) {
    sum.density += layer * CubicSpline::planeIntegral(at);
    sum.slope += first.rise * layer * kSlope * at * CubicSpline::shape(maximum(at, -at));
  }
  return sum;
}

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

/// What weight adds to the particle's pressure in pushing, Pa: half of rho g times the depth of the solid's
/// first layer below it, the mean of the pressures of both. It depends on the distance alone, so it has a
/// potential. A wall does not pull by it.
SPIN_HD_INLINE float wallHead(float pressure, float restDensity, float gravityAlongNormal, float distance,
                              float spacing) {
  const float depth = firstLayer(distance / spacing).depth * spacing;
  return maximum(-0.5f * restDensity * gravityAlongNormal * depth, -maximum(pressure, 0.0f));
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

/// Adds a no-slip wall's part to the velocity gradient (rate `relative`/d along the normal, times s P(s) +
/// lambda(s)) and to the correction matrix (the same along the normal, lambda along the plane). Both with
/// their factors, in 1/s and 1.
SPIN_HD_INLINE void addWallGradient(const WallContact& wall, float s, float distance,
                                    const PairVector<float>& relative, GradientSums<float>& sums) {
  const float lambda = CubicSpline::halfSpaceIntegral(s);
  const float normal = maximum(s, 0.0f) * CubicSpline::planeIntegral(s) + lambda;
  const float n[3] = {wall.nx, wall.ny, wall.nz}, v[3] = {relative.x, relative.y, relative.z};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) sums.g[3 * a + b] += v[a] / distance * n[b] * normal;
  const float extra = normal - lambda;
  sums.m[0] += lambda + extra * n[0] * n[0];
  sums.m[1] += lambda + extra * n[1] * n[1];
  sums.m[2] += lambda + extra * n[2] * n[2];
  sums.m[3] += extra * n[0] * n[1];
  sums.m[4] += extra * n[0] * n[2];
  sums.m[5] += extra * n[1] * n[2];
}

/// How far above the particle the gradient lies that neighbours and a no-slip wall give together, m: the
/// mean, by their weights in the gradient, of the middles between the particle and each neighbour, and of the
/// middle between it and the wall, over a continuum to one side of the wall.
SPIN_HD_INLINE float gradientHeight(float s, float support) {
  const float at = maximum(s, 0.0f);
  return 0.5f * support * (at * CubicSpline::halfSpaceIntegral(at) + 2.0f * CubicSpline::halfSpaceMoment(at));
}

/// Velocity gradient along a no-slip wall's normal: by its slope at gradientHeight() and the secant to the
/// wall, which is the slope half way down, at the particle and at the wall. First order, where the slope
/// alone would be off by the wall's distance: a fluid whose viscosity depends on the shear rate feels that.
struct WallSlopes {
  PairVector<float> change;  ///< at the particle against the slope that was given, 1/s
  float shearAtWall;         ///< of the part along the wall, 1/s
};
SPIN_HD_INLINE WallSlopes slopesAtWall(const WallContact& wall, float distance, float support,
                                       const PairVector<float>& relative, const PairVector<float>& slope) {
  const float height = gradientHeight(wall.distance / support, support), half = 0.5f * distance;
  const float perMetre = 1.0f / distance, bend = 1.0f / (height + half);
  const PairVector<float> secant{relative.x * perMetre, relative.y * perMetre, relative.z * perMetre};
  const PairVector<float> curve{bend * (slope.x - secant.x), bend * (slope.y - secant.y),
                                bend * (slope.z - secant.z)};
  PairVector<float> atWall{secant.x - half * curve.x, secant.y - half * curve.y, secant.z - half * curve.z};
  const float normal = atWall.x * wall.nx + atWall.y * wall.ny + atWall.z * wall.nz;
  atWall.x -= normal * wall.nx, atWall.y -= normal * wall.ny, atWall.z -= normal * wall.nz;
  return {{-height * curve.x, -height * curve.y, -height * curve.z},
          squareRoot(atWall.x * atWall.x + atWall.y * atWall.y + atWall.z * atWall.z)};
}

}  // namespace spin
