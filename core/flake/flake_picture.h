// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/flake/crystal_grower.h"
#include "core/math/vec.h"

namespace spin {

/// How much of each pixel a flake covers, 0..1: a square picture, rows from the bottom, x to the right. The
/// flake's nucleus is at the centre and the circle of radius `radius` pixels round it holds all of it.
struct FlakePicture {
  int size = 0;
  double radius = 0.0;
  std::vector<float> cover;

  float at(int x, int y) const {
    return cover[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)];
  }
  double total() const;
};

inline constexpr int kSmallestPicture = 8, kLargestPicture = 2048;

/// Draws discs of diameter 1 at the centres, a little fatter, and what lies between discs that touch: they
/// have grown together. Where the flake reaches less than `reach` diameters, that fills the picture. Fails
/// where there is nothing to draw or the size is outside kSmallestPicture..kLargestPicture.
Result<FlakePicture> drawFlake(const std::vector<Vec2d>& centres, int size, double reach = 0.0);
/// Draws a crystal; the thinner the ice, the clearer. `cells`: reach that fills the picture, at least the
/// crystal's own.
Result<FlakePicture> drawCrystal(const CrystalGrower& crystal, int size, int cells = 0);

/// The picture at half the size: means of 2 x 2 pixels, so the total cover per area stays. size must be even.
FlakePicture halved(const FlakePicture& picture);

}  // namespace spin
