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

double distanceTo(const AirSolid& solid, Vec3d at) {
  const bool near = at.x >= solid.low.x && at.y >= solid.low.y && at.z >= solid.low.z &&
                    at.x <= solid.high.x && at.y <= solid.high.y && at.z <= solid.high.z;
  return near ? solid.distance(at) : 1e30;
}

/// Distances at the corners of a brick's cells and of those next to it on the lower sides.
class CornerDistances {
 public:
  enum class Of { All, Standing };
  static constexpr int kX = kBrickX + 2, kY = kBrickY + 2, kZ = kBrickZ + 2;

  CornerDistances(const AirConfig& config, const BrickKey& key, Of of) {
    // A surface between two corners of a face is no farther from either: what is more is no true distance,
    // and would put the surface beside the wrong one.
    const double most = std::sqrt(2.0) * config.cell;
    for (int z = 0; z < kZ; ++z)
      for (int y = 0; y < kY; ++y)
        for (int x = 0; x < kX; ++x) {
          const Vec3d at =
              config.origin + config.cell * Vec3d{key[0] * kBrickX + x - 1.0, key[1] * kBrickY + y - 1.0,
                                                  key[2] * kBrickZ + z - 1.0};
          m_values[static_cast<std::size_t>((z * kY + y) * kX + x)] =
              std::clamp(distanceAt(config, at, of), -most, most);
        }
  }

  /// Whether no cell is cut.
  bool open() const {
    return std::all_of(m_values.begin(), m_values.end(), [](double v) { return v > 0.0; });
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
  /// Sum over a cell's faces of their open share times their direction, against it.
  Vec3d opening(int x, int y, int z) const {
    return {face(x, y, z, 0) - face(x + 1, y, z, 0), face(x, y, z, 1) - face(x, y + 1, z, 1),
            face(x, y, z, 2) - face(x, y, z + 1, 2)};
  }

 private:
  static double distanceAt(const AirConfig& config, Vec3d at, Of of) {
    double least = 1e30;
    for (const AirSolid& solid : config.solids)
      if (of == Of::All || !solid.velocity) least = std::min(least, distanceTo(solid, at));
    return least;
  }

  std::array<double, static_cast<std::size_t>(kX) * kY * kZ> m_values{};
};

/// Whether some of it may be in the cells of a brick or in those next to them.
bool mayTouch(const AirConfig& config, const AirSolid& solid, const BrickKey& key) {
  const Vec3d low = config.origin + config.cell * Vec3d{key[0] * kBrickX - 1.0, key[1] * kBrickY - 1.0,
                                                        key[2] * kBrickZ - 1.0};
  const Vec3d high = low + config.cell * Vec3d{kBrickX + 2.0, kBrickY + 2.0, kBrickZ + 2.0};
  const bool meets = solid.low.x <= high.x && solid.high.x >= low.x && solid.low.y <= high.y &&
                     solid.high.y >= low.y && solid.low.z <= high.z && solid.high.z >= low.z;
  return meets && (!solid.mayTouch || solid.mayTouch(low, high));
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

/// Velocity at a cell's centre of the moving solid that comes nearest to its centre and corners.
Vec3d solidVelocity(const AirConfig& config, Vec3d centre) {
  double least = 1e30;
  Vec3d velocity{};
  for (const AirSolid& solid : config.solids) {
    if (!solid.velocity) continue;
    double distance = distanceTo(solid, centre);
    for (int k = 0; k < 8; ++k) {
      const Vec3d corner{k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5};
      distance = std::min(distance, distanceTo(solid, centre + config.cell * corner));
    }
    if (distance >= least) continue;
    least = distance;
    velocity = solid.velocity(centre);
  }
  return velocity;
}

/// A solid that moves with speed s through a cell pushes out what its open faces would let in at that speed:
/// the net outflow is the sum over them of (u - s) times their share. What standing solids take of the faces
/// has no part in that.
void pushBySolids(const AirConfig& config, const BrickKey& key, const CornerDistances& corners,
                  BrickSolids& solids) {
  const CornerDistances standing(config, key, CornerDistances::Of::Standing);
  std::size_t cell = 0;
  for (int z = 0; z < kBrickZ; ++z)
    for (int y = 0; y < kBrickY; ++y)
      for (int x = 0; x < kBrickX; ++x, ++cell) {
        if (solids.volume[cell] <= 0.0f) continue;
        const Vec3d cut = corners.opening(x, y, z) - standing.opening(x, y, z);
        if (cut == Vec3d{}) continue;
        solids.flux[cell] =
            static_cast<float>(dot(cut, solidVelocity(config, cellCentre(config, key, x, y, z))));
      }
}

void cutBySolids(const AirConfig& config, const BrickKey& key, BrickSolids& solids) {
  const CornerDistances corners(config, key, CornerDistances::Of::All);
  if (corners.open()) return;
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
      }
  if (solids.moves) pushBySolids(config, key, corners, solids);
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
  bool near = false;
  for (const AirSolid& solid : config.solids) {
    if (!mayTouch(config, solid, key)) continue;
    near = true;
    solids.moves = solids.moves || solid.velocity;
  }
  if (near) cutBySolids(config, key, solids);
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

Vec3d nearestSolidVelocity(const AirConfig& config, Vec3d place) {
  double least = 1e30;
  const AirSolid* nearest = nullptr;
  for (const AirSolid& solid : config.solids) {
    const double distance = distanceTo(solid, place);
    if (distance >= least) continue;
    least = distance;
    nearest = &solid;
  }
  return nearest && nearest->velocity ? nearest->velocity(place) : Vec3d{};
}

double positiveShare(const std::array<double, 4>& c) {
  const double middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) sum += positiveShareOf(c[k], c[(k + 1) % 4], middle);
  return 0.25 * sum;
}

}  // namespace spin
