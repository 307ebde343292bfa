// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/fields/terrain_surface.h"
#include "core/nodes/terrain_node.h"
#include "core/sim/model_copies.h"
#include "core/snow/snow_ground.h"

namespace spin {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Block of quads [i0, i1) x [j0, j1).
struct QuadBlock {
  int i0, j0, i1, j1;

  bool meets(const QuadBlock& o) const { return i0 <= o.i1 && o.i0 <= i1 && j0 <= o.j1 && o.j0 <= j1; }
  double quads() const { return static_cast<double>(i1 - i0) * (j1 - j0); }
  bool holds(int i, int j) const { return i >= i0 && i < i1 && j >= j0 && j < j1; }
};

/// Boxes of a model and its copies where they stand at film time 0. Later places do not count: an edit of a
/// later key must keep the frames before it.
std::vector<Box3d> standingBoxes(const SceneSnapshot& scene, const SceneNode& node, const ModelData& model) {
  const Transform placement = scene.modelTransform(node, 0.0);
  std::vector<Box3d> meshes;
  for (const Mesh& mesh : model.meshes) {
    Box3d box;
    for (const Vec3f& p : mesh.positions) box.extend(p.to<double>());
    meshes.push_back(box);
  }
  const std::size_t each = instancesOfACopy(node, model);
  std::vector<Box3d> boxes;
  for (std::size_t k = 0; k < model.instances.size(); ++k) {
    if (k % each == 0) boxes.emplace_back();
    const Box3d& box = meshes[static_cast<std::size_t>(model.instances[k].mesh)];
    const Transform place = placement * model.instances[k].transform;
    for (int corner = 0; corner < 8 && !box.empty(); ++corner)
      boxes.back().extend(place.point({corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                                       corner & 4 ? box.max.z : box.min.z}));
  }
  return boxes;
}

/// Quads within a margin of the box, cut to the raster; empty (i0 >= i1) if there are none.
QuadBlock blockRound(const Box3d& plan, double margin, const Raster<float>& h) {
  const auto quad = [&](double v, double origin, int last) {
    return static_cast<int>(
        std::floor(std::clamp((v - origin) / h.cellSize, 0.0, static_cast<double>(last))));
  };
  const double right = h.x(h.width - 1), top = h.y(h.height - 1);
  if (plan.empty() || plan.max.x + margin < h.originX || plan.max.y + margin < h.originY ||
      plan.min.x - margin > right || plan.min.y - margin > top)
    return {0, 0, 0, 0};
  return {quad(plan.min.x - margin, h.originX, h.width - 2),
          quad(plan.min.y - margin, h.originY, h.height - 2),
          quad(plan.max.x + margin, h.originX, h.width - 2) + 1,
          quad(plan.max.y + margin, h.originY, h.height - 2) + 1};
}

/// Joins blocks that overlap or touch into their common rectangle until none do.
std::vector<QuadBlock> disjoint(std::vector<QuadBlock> blocks) {
  for (std::size_t a = 0; a < blocks.size(); ++a)
    for (std::size_t b = a + 1; b < blocks.size(); ++b) {
      if (!blocks[a].meets(blocks[b])) continue;
      QuadBlock& joined = blocks[a];
      const QuadBlock& other = blocks[b];
      joined = {std::min(joined.i0, other.i0), std::min(joined.j0, other.j0), std::max(joined.i1, other.i1),
                std::max(joined.j1, other.j1)};
      blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(b));
      a = static_cast<std::size_t>(-1);
      break;
    }
  return blocks;
}

std::vector<QuadBlock> fineBlocks(const SceneSnapshot& scene, double margin) {
  std::vector<QuadBlock> blocks;
  for (const SceneNode* node : scene.all<ModelNode>()) {
    const auto model = scene.models.find(node->id);
    if (model == scene.models.end() || !model->second) continue;
    if (!static_cast<const ModelNode&>(*evaluate(*node, 0.0)).fineCover) continue;
    for (const Box3d& box : standingBoxes(scene, *node, *model->second)) {
      const QuadBlock block = blockRound(box, margin, scene.terrain->heights);
      if (block.i0 < block.i1 && block.j0 < block.j1) blocks.push_back(block);
    }
  }
  return disjoint(std::move(blocks));
}

/// Fine cells along a quad, within the cap; 0 or 1 means that the coarse cells are fine enough.
int refinementFor(const std::vector<QuadBlock>& blocks, double quadSize, double wanted,
                  std::vector<std::string>& messages) {
  double quads = 0.0;
  for (const QuadBlock& block : blocks) quads += block.quads();
  const double asked = std::ceil(quadSize / wanted - 1e-9);
  const double most = quads > 0.0 ? std::floor(std::sqrt(kMostFineCells / quads)) : 0.0;
  if (asked > most && quads > 0.0)
    messages.push_back(
        fmt::format("The fine snow cover near models would need {:.0f} cells; its cells are {:.2f} m "
                    "instead of {:.2f} m to stay below {:.0f}",
                    quads * asked * asked, quadSize / std::max(most, 1.0), wanted, kMostFineCells));
  return static_cast<int>(std::min(asked, most));
}

CoverGrid coarseGrid(const TerrainSurface& surface, const std::string& node,
                     const std::vector<QuadBlock>& fine) {
  const Raster<float>& h = surface.heights();
  CoverGrid grid{"terrain", node, h.sameShape<float>(kNan), h.sameShape<float>(0.0f)};
  const double quarter = 0.25 * h.cellSize * h.cellSize;
  const auto superseded = [&](int i, int j) {
    return std::any_of(fine.begin(), fine.end(), [&](const QuadBlock& b) { return b.holds(i, j); });
  };
  for (int j = 0; j + 1 < h.height; ++j)
    for (int i = 0; i + 1 < h.width; ++i) {
      if (!surface.quadExists(i, j)) continue;
      const float share = superseded(i, j) ? 0.0f : static_cast<float>(quarter);
      for (int corner = 0; corner < 4; ++corner) {
        const int ci = i + (corner & 1), cj = j + (corner >> 1);
        grid.base.at(ci, cj) = h.at(ci, cj);
        grid.area.at(ci, cj) += share;
      }
    }
  return grid;
}

CoverGrid fineGrid(const TerrainSurface& surface, const std::string& node, const QuadBlock& block,
                   int divisions, std::size_t number) {
  const Raster<float>& h = surface.heights();
  const double cell = h.cellSize / divisions;
  CoverGrid grid;
  grid.id = fmt::format("terrain/fine{}", number);
  grid.node = node;
  grid.base = Raster<float>((block.i1 - block.i0) * divisions, (block.j1 - block.j0) * divisions,
                            h.x(block.i0) + 0.5 * cell, h.y(block.j0) + 0.5 * cell, cell, kNan);
  grid.area = grid.base.sameShape<float>(0.0f);
  for (int j = 0; j < grid.base.height; ++j)
    for (int i = 0; i < grid.base.width; ++i) {
      if (!surface.quadExists(block.i0 + i / divisions, block.j0 + j / divisions)) continue;
      const auto z = surface.heightAt(grid.base.x(i), grid.base.y(j));
      grid.base.at(i, j) = static_cast<float>(z.value_or(0.0));
      grid.area.at(i, j) = static_cast<float>(cell * cell);
    }
  return grid;
}

}  // namespace

void addTerrainGrids(const SceneSnapshot& scene, CoverLayout& layout, SnowGround& ground) {
  if (!scene.terrain || scene.terrain->heights.empty()) return;
  const SceneNode* node = scene.first<TerrainNode>();
  const auto settings = scene.settings<TerrainNode>(0.0);
  const std::string id = node ? node->id : "terrain";
  const TerrainSurface surface(scene.terrain->heights);
  std::vector<QuadBlock> blocks;
  const Raster<float>& h = surface.heights();
  if (h.width > 1 && h.height > 1) blocks = fineBlocks(scene, settings.coverDetailMargin);
  const int divisions = refinementFor(blocks, h.cellSize, settings.coverDetailCell, ground.messages);
  if (divisions <= 1) blocks.clear();

  std::vector<TerrainGrid>& terrain = ground.terrain;
  terrain.push_back({layout.grids.size(), 0, 0, 0});
  layout.grids.push_back(coarseGrid(surface, id, blocks));
  for (const QuadBlock& block : blocks) {
    terrain.push_back({layout.grids.size(), divisions, block.i0, block.j0});
    layout.grids.push_back(fineGrid(surface, id, block, divisions, terrain.size() - 2));
  }
}

Raster<std::uint8_t> supersededQuads(const Raster<float>& heights, const SnowGround& ground) {
  auto marks = heights.sameShape<std::uint8_t>(0);
  for (const TerrainGrid& terrain : ground.terrain) {
    if (terrain.refinement == 0) continue;
    const Raster<float>& base = ground.layout->grids[terrain.grid].base;
    for (int j = 0; j < base.height / terrain.refinement; ++j)
      for (int i = 0; i < base.width / terrain.refinement; ++i)
        marks.at(terrain.firstQuadI + i, terrain.firstQuadJ + j) = 1;
  }
  return marks;
}

}  // namespace spin
