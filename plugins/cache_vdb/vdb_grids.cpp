// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cache_vdb/vdb_grids.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace spin {
namespace {

using openvdb::Coord;

/// Half floats know nothing above the one, and below the other only steps of 2^-24: then a 2^-15 of the
/// largest value, as fine as their other digits are.
constexpr float kMostHalf = 65504.0f, kLeastLargest = 0x1p-9f;

constexpr std::array<int, 3> kBrickSize{kBrickX, kBrickY, kBrickZ};

openvdb::math::Transform::Ptr placeOf(const AirPart& part) {
  auto place = openvdb::math::Transform::createLinearTransform(part.cell);
  const double half = 0.5 * part.cell;
  place->postTranslate({part.origin.x + half, part.origin.y + half, part.origin.z + half});
  return place;
}

Coord cornerOf(const std::array<std::int32_t, 3>& brick) {
  return {brick[0] * kBrickX, brick[1] * kBrickY, brick[2] * kBrickZ};
}

float largestOf(float v) {
  return std::abs(v);
}
float largestOf(const openvdb::Vec3s& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

/// Cells of a brick lie x fastest; the leaves of a tree are cubes of their own, z fastest.
template <class Grid, class Values>
void putBrick(Grid& grid, const Coord& corner, const Values& values) {
  using Leaf = typename Grid::TreeType::LeafNodeType;
  static_assert(kBrickX % static_cast<int>(Leaf::DIM) == 0 && Leaf::DIM % kBrickY == 0 &&
                Leaf::DIM % kBrickZ == 0);
  std::size_t cell = 0;
  for (int first = 0; first < kBrickX; first += static_cast<int>(Leaf::DIM)) {
    Leaf* leaf = grid.tree().touchLeaf(corner.offsetBy(first, 0, 0));
    for (int k = 0; k < kBrickZ; ++k)
      for (int j = 0; j < kBrickY; ++j) {
        cell = static_cast<std::size_t>((k * kBrickY + j) * kBrickX + first);
        for (int i = 0; i < static_cast<int>(Leaf::DIM); ++i, ++cell)
          leaf->setValueOn(Leaf::coordToOffset(corner.offsetBy(first + i, j, k)), values[cell]);
      }
  }
}

/// valueAt(brick, cell) for the cells of all bricks.
template <class Grid, class ValueAt>
VdbGrid makeGrid(const AirPart& part, const ExportedAttribute& attribute, const ValueAt& valueAt) {
  auto grid = Grid::create();
  float largest = 0.0f;
  std::array<typename Grid::ValueType, kBrickCells> values;
  for (std::size_t brick = 0; brick < part.bricks.size(); ++brick) {
    float here = 0.0f;
    for (std::size_t cell = 0; cell < kBrickCells; ++cell) {
      values[cell] = valueAt(brick, cell);
      here = std::max(here, largestOf(values[cell]));
    }
    if (here > 0.0f) putBrick(*grid, cornerOf(part.bricks[brick]), values);
    largest = std::max(largest, here);
  }
  grid->setName(attribute.name);
  grid->setTransform(placeOf(part));
  grid->setSaveFloatAsHalf(largest >= kLeastLargest && largest <= kMostHalf);
  grid->insertMeta("unit", openvdb::StringMetadata(attribute.unit));
  return {grid, attribute};
}

bool isAmount(const std::string& name) {
  return name == "mist" || name == "snow";
}

VdbGrid densityGrid(const AirPart& part) {
  const AirField* const amounts[] = {part.find("mist"), part.find("snow")};
  const ExportedAttribute attribute{"density", "kg/m3", 1};
  VdbGrid made = makeGrid<openvdb::FloatGrid>(part, attribute, [&](std::size_t brick, std::size_t cell) {
    float sum = 0.0f;
    for (const AirField* field : amounts)
      if (field) sum += field->at(brick, 0, cell);
    return sum;
  });
  made.grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  return made;
}

VdbGrid fieldGrid(const AirPart& part, const AirField& field) {
  const ExportedAttribute attribute{field.name, field.unit, field.components};
  if (field.components == 3) {
    VdbGrid made = makeGrid<openvdb::Vec3SGrid>(part, attribute, [&](std::size_t brick, std::size_t cell) {
      return openvdb::Vec3s(field.at(brick, 0, cell), field.at(brick, 1, cell), field.at(brick, 2, cell));
    });
    made.grid->setVectorType(openvdb::VEC_CONTRAVARIANT_RELATIVE);
    return made;
  }
  VdbGrid made = makeGrid<openvdb::FloatGrid>(
      part, attribute, [&](std::size_t brick, std::size_t cell) { return field.at(brick, 0, cell); });
  if (isAmount(field.name)) made.grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  return made;
}

}  // namespace

bool fitsVdb(const AirPart& part) {
  // The last cell of a brick must be a number too.
  return std::all_of(part.bricks.begin(), part.bricks.end(), [](const std::array<std::int32_t, 3>& brick) {
    for (std::size_t d = 0; d < 3; ++d) {
      const std::int64_t low = std::int64_t{brick[d]} * kBrickSize[d];
      if (low < std::numeric_limits<std::int32_t>::min() ||
          low + kBrickSize[d] - 1 > std::numeric_limits<std::int32_t>::max())
        return false;
    }
    return true;
  });
}

std::vector<VdbGrid> vdbGrids(const AirPart& part) {
  std::vector<VdbGrid> grids{densityGrid(part)};
  for (const AirField& field : part.fields) grids.push_back(fieldGrid(part, field));
  return grids;
}

}  // namespace spin
