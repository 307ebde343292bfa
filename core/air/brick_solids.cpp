// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/brick_solids.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

/// Shares below are closed.
constexpr double kLeastShare = 0.02;

/// Of a triangle with these values at its corners.
double positiveShareOf(double a, double b, double c) {
  const int above = (a > 0.0) + (b > 0.0) + (c > 0.0);
  if (above == 0) return 0.0;
  if (above == 3) return 1.0;
  // Turned so that `a` is the one alone on its side.
  const bool lonePositive = above == 1;
  if ((b > 0.0) == lonePositive && (a > 0.0) != lonePositive)
    std::swap(a, b);
  else if ((c > 0.0) == lonePositive && (a > 0.0) != lonePositive)
    std::swap(a, c);
  const double corner = a / (a - b) * (a / (a - c));
  return lonePositive ? corner : 1.0 - corner;
}

/// Distances at the corners of a brick's cells and of those next to it on the lower sides.
class CornerDistances {
 public:
  static constexpr int kX = kBrickX + 2, kY = kBrickY + 2, kZ = kBrickZ + 2;

  CornerDistances(const AirConfig& config, const BrickKey& key) {
    for (int z = 0; z < kZ; ++z)
      for (int y = 0; y < kY; ++y)
        for (int x = 0; x < kX; ++x) {
          const Vec3d at =
              config.origin + config.cell * Vec3d{key[0] * kBrickX + x - 1.0, key[1] * kBrickY + y - 1.0,
                                                  key[2] * kBrickZ + z - 1.0};
          m_values[static_cast<std::size_t>((z * kY + y) * kX + x)] = distanceAt(config, at);
        }
  }
  static double distanceAt(const AirConfig& config, Vec3d at) {
    double least = 1e30;
    for (const AirSolid& solid : config.solids) {
      const bool near = at.x >= solid.low.x && at.y >= solid.low.y && at.z >= solid.low.z &&
                        at.x <= solid.high.x && at.y <= solid.high.y && at.z <= solid.high.z;
      if (near) least = std::min(least, solid.distance(at));
    }
    return least;
  }

  /// Of the lower corner of cell (x, y, z) of the brick, each from -1.
  double at(int x, int y, int z) const {
    return m_values[static_cast<std::size_t>(((z + 1) * kY + y + 1) * kX + x + 1)];
  }
  /// Open share of the cell's lower face along an axis.
  double face(int x, int y, int z, int axis) const {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    std::array<double, 4> corners{};
    for (int k = 0; k < 4; ++k) {
      int p[3] = {x, y, z};
      p[b] += k == 1 || k == 2;
      p[c] += k >= 2;
      corners[static_cast<std::size_t>(k)] = at(p[0], p[1], p[2]);
    }
    return positiveShare(corners);
  }
  double volume(int x, int y, int z) const {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
      sum += face(x, y, z, axis) + face(x + (axis == 0), y + (axis == 1), z + (axis == 2), axis);
    return sum / 6.0;
  }

 private:
  std::array<double, static_cast<std::size_t>(kX) * kY * kZ> m_values{};
};

/// Whether a solid's box, within which alone it is, meets that of a brick: its distance is not known from
/// afar.
bool nearBoxes(const AirConfig& config, Vec3d middle, Vec3d half) {
  const Vec3d more = half + Vec3d{2.0, 2.0, 2.0} * config.cell;
  for (const AirSolid& solid : config.solids) {
    if (solid.low.x < -1e29) continue;
    const bool meets = solid.low.x <= middle.x + more.x && solid.high.x >= middle.x - more.x &&
                       solid.low.y <= middle.y + more.y && solid.high.y >= middle.y - more.y &&
                       solid.low.z <= middle.z + more.z && solid.high.z >= middle.z - more.z;
    if (meets) return true;
  }
  return false;
}

/// Whether a cell lies beyond a closed side of the domain.
bool beyondWall(const AirConfig& config, const std::array<int, 3>& cell) {
  constexpr std::array<int, 3> kBrick{kBrickX, kBrickY, kBrickZ};
  for (std::size_t a = 0; a < 3; ++a) {
    if (config.closed[2 * a] && cell[a] < config.lowBrick[a] * kBrick[a]) return true;
    if (config.closed[2 * a + 1] && cell[a] >= config.highBrick[a] * kBrick[a]) return true;
  }
  return false;
}

/// Shares of cells that are not cut by solids but may lie beyond walls.
void openBrick(BrickSolids& solids) {
  for (auto& area : solids.area) area.fill(1.0f);
  solids.volume.fill(1.0f);
  solids.flux.fill(0.0f);
}

Vec3d cellCentre(const AirConfig& config, const BrickKey& key, int x, int y, int z) {
  return config.origin + config.cell * Vec3d{key[0] * kBrickX + x + 0.5, key[1] * kBrickY + y + 0.5,
                                             key[2] * kBrickZ + z + 0.5};
}

/// Velocity of the moving solid that a place is nearest to, if one is within reach.
bool solidVelocity(const AirConfig& config, Vec3d at, double reach, Vec3d& velocity) {
  double least = reach;
  bool found = false;
  for (const AirSolid& solid : config.solids) {
    if (!solid.velocity) continue;
    const bool inBox = at.x >= solid.low.x && at.y >= solid.low.y && at.z >= solid.low.z &&
                       at.x <= solid.high.x && at.y <= solid.high.y && at.z <= solid.high.z;
    const double distance = inBox ? solid.distance(at) : 1e30;
    if (distance >= least) continue;
    least = distance;
    velocity = solid.velocity(at);
    found = true;
  }
  return found;
}

/// A solid that moves with speed s through a cell pushes out what its open faces would let in at that speed:
/// the net outflow is the sum over them of (u - s) times their share.
double motionFlux(const CornerDistances& corners, int x, int y, int z, Vec3d s) {
  const auto difference = [&](int axis) {
    return corners.face(x, y, z, axis) -
           corners.face(x + (axis == 0), y + (axis == 1), z + (axis == 2), axis);
  };
  return s.x * difference(0) + s.y * difference(1) + s.z * difference(2);
}

void cutBySolids(const AirConfig& config, const BrickKey& key, BrickSolids& solids) {
  const CornerDistances corners(config, key);
  solids.open = false;
  std::size_t cell = 0;
  for (int z = 0; z < kBrickZ; ++z)
    for (int y = 0; y < kBrickY; ++y)
      for (int x = 0; x < kBrickX; ++x, ++cell) {
        const double volume = corners.volume(x, y, z);
        solids.volume[cell] =
            volume < kLeastShare ? 0.0f : std::max(static_cast<float>(volume), kLeastVolume);
        for (int axis = 0; axis < 3; ++axis) {
          const double below = corners.volume(x - (axis == 0), y - (axis == 1), z - (axis == 2));
          double share = corners.face(x, y, z, axis);
          if (share < kLeastShare || volume < kLeastShare || below < kLeastShare) share = 0.0;
          solids.area[static_cast<std::size_t>(axis)][cell] = static_cast<float>(share);
        }
        Vec3d speed{};
        if (volume < kLeastShare ||
            !solidVelocity(config, cellCentre(config, key, x, y, z), 1.5 * config.cell, speed))
          continue;
        solids.moves = true;
        solids.flux[cell] = static_cast<float>(motionFlux(corners, x, y, z, speed));
      }
}

/// Sets what lies beyond closed sides, and the walls between.
void cutByWalls(const AirConfig& config, const BrickKey& key, BrickSolids& solids) {
  std::size_t index = 0;
  for (int z = 0; z < kBrickZ; ++z)
    for (int y = 0; y < kBrickY; ++y)
      for (int x = 0; x < kBrickX; ++x, ++index) {
        const std::array<int, 3> cell{key[0] * kBrickX + x, key[1] * kBrickY + y, key[2] * kBrickZ + z};
        const bool beyond = beyondWall(config, cell);
        if (beyond) solids.volume[index] = 0.0f;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::array<int, 3> below = cell;
          --below[axis];
          const bool belowBeyond = beyondWall(config, below);
          if (beyond && belowBeyond)
            solids.area[axis][index] = 0.0f;
          else if (beyond != belowBeyond)
            solids.area[axis][index] = kWallFace;
        }
      }
}

}  // namespace

BrickSolids cutBrick(const AirConfig& config, const BrickKey& key) {
  BrickSolids solids;
  openBrick(solids);
  const Vec3d half = 0.5 * config.cell * Vec3d{kBrickX, kBrickY, kBrickZ};
  const Vec3d middle = config.origin + 2.0 * Vec3d{key[0] * half.x, key[1] * half.y, key[2] * half.z} + half;
  // With the cells next to it.
  const double reach = length(half) + 2.0 * config.cell;
  if (CornerDistances::distanceAt(config, middle) < reach || nearBoxes(config, middle, half))
    cutBySolids(config, key, solids);
  bool atWall = false;
  for (std::size_t a = 0; a < 3; ++a)
    atWall = atWall || (config.closed[2 * a] && key[a] <= config.lowBrick[a]) ||
             (config.closed[2 * a + 1] && key[a] >= config.highBrick[a] - 1);
  if (atWall) {
    solids.open = false;
    cutByWalls(config, key, solids);
  }
  return solids;
}

double positiveShare(const std::array<double, 4>& c) {
  const double middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) sum += positiveShareOf(c[k], c[(k + 1) % 4], middle);
  return 0.25 * sum;
}

}  // namespace spin
