// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/nodes/weather_nodes.h"
#include "core/sim/snapshot.h"
#include "editor/render/renderer.h"

namespace spin {

using Matrix4 = std::array<float, 16>;  ///< column-major

/// View and projection of a camera; z up. Depth runs from 1 (near) to 0 (infinitely far).
Matrix4 viewProjection(const RenderCamera& camera, double aspect, double nearPlane);
/// Looks along -`toLight` at a square of half-width `halfSize` about `centre`; depth 0..1 over
/// 2 `depthRange`. `texels` > 0 snaps the centre to whole texels, so that a moving camera does not make
/// shadows crawl.
Matrix4 lightMatrix(Vec3d centre, Vec3d toLight, double halfSize, double depthRange, int texels);

/// Light of sun, sky and air, scaled to the exposure of a picture in which level snow is nearly white.
struct LightModel {
  Vec3d toSun{0, 0, 1};
  Vec3d sun{};                  ///< irradiance across the beam, exposed
  Vec3d sky{};                  ///< irradiance of the open sky on level ground
  Vec3d bounce{};               ///< irradiance from the surroundings below
  Vec3d zenith{};               ///< colour of the sky overhead
  Vec3d horizon{};              ///< colour of sky and haze at the horizon
  double hazeExtinction = 0.0;  ///< 1/m
  double cloud = 0.0;
};

/// `snowShare`: share of the ground that is white, rules the light from below.
LightModel lightModel(const SceneSnapshot& scene, double filmTime, double snowShare);

/// Share of an extinction, 1/m, through which one still sees something at a distance, m: at most 1, and the
/// optical depth up to there at most 0.7, so that half of the contrast remains.
double readableHaze(double extinction, double distance);

/// The block FrameBlock of common.glsl (std140).
struct FrameBlock {
  Matrix4 viewProjection{};
  Matrix4 shadowMatrix{};
  Matrix4 zenithMatrix{};
  Vec4f eye;          ///< xyz, w = 1
  Vec4f forward;      ///< unit, w = tan(fov/2)
  Vec4f right;        ///< unit, w = aspect
  Vec4f toSun;        ///< w = share of the direct light that casts shadows
  Vec4f sun;          ///< w = cloud cover
  Vec4f sky;          ///< w = exposed share of snow in the surroundings
  Vec4f bounce;       ///< w = film time, s
  Vec4f zenith;       ///< w = 1 if the shadow maps hold something
  Vec4f horizon;      ///< w = extinction, 1/m
  Vec4f terrainGrid;  ///< origin x, y, 1 / cell size, 1 if there is terrain
  Vec4f terrainSize;  ///< columns, rows, 1 if there is cover, 1 for false colours
  Vec4f viewport;     ///< width, height, pixels per unit of x/z, shown share of detail
  Vec4f snowPhong;    ///< K_a, K_d, K_s, n of the published shading of snow
};

}  // namespace spin
