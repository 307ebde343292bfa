// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/parallel.h"
#include "core/sim/air_part.h"
#include "editor/render/air_optics.h"

namespace spin {

/// What lights a cloud; irradiances as those of LightModel.
struct AirSky {
  Vec3d toSun{0, 0, 1};
  Vec3d sun{}, sky{}, bounce{};
  /// Share of the sun that land lets through to a place; empty = all.
  std::function<double(Vec3d)> sunShare;
};

/// Light within a cloud, on voxels round all of it. Per voxel RGB: what is scattered there alike to all sides
/// after more than one scattering, and the light of sky and ground, as the colour (pi times the radiance) of
/// a thick cloud of it; A: share of the sun that comes through land and cloud, straight or deflected.
struct AirLight {
  Vec3d origin{};                     ///< local m, lower corner
  double voxel = 1.0;                 ///< m
  std::array<int, 3> size{};          ///< voxels along x, y, z
  std::vector<std::uint16_t> texels;  ///< binary16, RGBA, x fastest
  std::vector<std::uint8_t> through;  ///< by voxel: share of the sun that the cloud lets through, 255 = all

  bool empty() const { return texels.empty(); }
  Vec3d high() const { return origin + Vec3d{1.0 * size[0], 1.0 * size[1], 1.0 * size[2]} * voxel; }
};

/// Solves for it without a step in time: particles absorb nothing, so what enters a place leaves it, and how
/// much comes and goes by each of 14 directions is told by two-stream theory, 1 / (1 + 3/4 t), t the optical
/// depth along it times (1 - mean cosine). See decisions.md for what this leaves out. Voxels are whole cells,
/// at most `mostVoxels`. Empty where nothing hangs.
AirLight lightAir(const AirPart& air, const AirOptics& optics, const AirSky& sky, std::size_t mostVoxels,
                  CpuBackend& backend);

}  // namespace spin
