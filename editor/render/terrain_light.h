// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/fields/raster.h"

namespace spin {

/// Per cell: x and y of the unit normal, share of the sky seen (0..1), 1 where the cell has data (else 0).
/// The normal is that of central differences, one-sided at holes. The sky share is the mean of cos^2 of the
/// horizon angle over 8 directions, up to 64 cells away.
std::vector<Vec4f> terrainNormalsAndSky(const Raster<float>& heights);

/// Per cell: height in m below which the terrain's own shadow lies over the cell, for a sun in direction
/// `toSun` (unit, z > 0). Very low where nothing shades. One sweep from the sun's side over the raster.
std::vector<float> terrainShadowHeights(const Raster<float>& heights, Vec3d toSun);

/// Both as bytes for a texture, RGBA per cell: 128 + 127 x and y of the normal, sky share and the share of
/// the sun that the terrain lets through, 255 = all. That share grows from the shadow's top over `edge` m;
/// half of what the sun's ray climbs in a cell keeps lit ground lit and softens the shadow's outline.
std::vector<std::uint8_t> packTerrainLight(const Raster<float>& heights,
                                           const std::vector<Vec4f>& normalsAndSky,
                                           const std::vector<float>& shadowHeights, float edge);

}  // namespace spin
