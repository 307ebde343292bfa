// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/snow/cover_graph_builder.h"

namespace spin {
namespace {

constexpr double kClearance = 0.1;  ///< m above rim and cell at which a wall is looked for
/// Sheets that snow may fall through on its way: parts of models that hold none.
constexpr int kMostSheets = 16;

/// Finds what lies below a point.
class Landing {
 public:
  Landing(const SnowGround& ground, const SnowScene& scene, const CoverGraphBuilder& builder)
      : m_ground(&ground), m_scene(&scene), m_builder(&builder) {}

  bool wallBetween(Vec3d from, Vec3d step, double way) const {
    Ray ray{(from - m_scene->centre).to<float>(), step.to<float>(), 0.0f, static_cast<float>(way)};
    return m_scene->rays->occluded(ray);
  }

  /// The cell that snow lands on from a point, if there is one.
  std::optional<std::uint32_t> below(Vec3d point) const {
    for (int sheet = 0; sheet < kMostSheets; ++sheet) {
      const Ray down{
          (point - m_scene->centre).to<float>(), {0, 0, -1}, 0.0f, std::numeric_limits<float>::infinity()};
      const auto hit = m_scene->rays->closest(down);
      if (!hit) return std::nullopt;
      point.z -= static_cast<double>(hit->t);
      if (m_scene->hasTerrain && hit->geometry == m_scene->terrainGeometry) return terrainCell(point);
      if (const auto cell = patchCell(hit->geometry, point)) return cell;
      point.z -= 10.0 * SnowScene::standOff(point - m_scene->centre);
    }
    return std::nullopt;
  }

 private:
  std::optional<std::uint32_t> cellAt(std::size_t g, Vec3d point) const {
    const CoverGraph::Grid& grid = m_builder->grid(g);
    const double u = (point.x - grid.originX) / grid.cellSize, v = (point.y - grid.originY) / grid.cellSize;
    if (!(u > -0.5 && v > -0.5 && u < grid.width - 0.5 && v < grid.height - 0.5)) return std::nullopt;
    const int i = static_cast<int>(std::lround(u)), j = static_cast<int>(std::lround(v));
    if (!m_builder->isCell(grid, i, j)) return std::nullopt;
    return CoverGraphBuilder::numberOf(grid, i, j);
  }

  std::optional<std::uint32_t> terrainCell(Vec3d point) const {
    for (auto grid = m_ground->terrain.rbegin(); grid != m_ground->terrain.rend(); ++grid)
      if (const auto cell = cellAt(grid->grid, point)) return cell;
    return std::nullopt;
  }

  /// Of patches that lie over each other the one whose surface is the point's.
  std::optional<std::uint32_t> patchCell(std::uint32_t geometry, Vec3d point) const {
    std::optional<std::uint32_t> best;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < m_scene->models.size(); ++m) {
      if (m_scene->models[m].geometry != geometry) continue;
      for (const ModelPatch& patch : m_ground->models[m].patches) {
        const auto cell = cellAt(patch.grid, point);
        if (!cell) continue;
        const double off = std::abs(static_cast<double>(m_builder->graph().bed(*cell)) - point.z);
        if (off > 2.0 * m_builder->grid(patch.grid).cellSize || off >= nearest) continue;
        nearest = off;
        best = cell;
      }
    }
    return best;
  }

  const SnowGround* m_ground;
  const SnowScene* m_scene;
  const CoverGraphBuilder* m_builder;
};

void addRim(const CoverGraph::Grid& grid, int i, int j, std::uint8_t side, const Landing* landing,
            CoverGraphBuilder& builder) {
  const std::uint32_t cell = CoverGraphBuilder::numberOf(grid, i, j);
  const double bed = static_cast<double>(builder.graph().bed(cell));
  const double sill = bed - 0.5 * static_cast<double>(builder.fallTowards(grid, i, j, side));
  CoverLink link;
  link.target = CoverLink::kFalls;
  link.distance = static_cast<float>(0.5 * grid.cellSize);
  link.width = static_cast<float>(grid.cellSize);
  link.sill = static_cast<float>(sill);
  link.side = side;
  link.falls = true;
  if (landing) {
    const Vec3d step{static_cast<double>(kCellSteps[side][0]), static_cast<double>(kCellSteps[side][1]), 0};
    const Vec3d from{grid.originX + i * grid.cellSize, grid.originY + j * grid.cellSize,
                     std::max(bed, sill) + kClearance};
    if (landing->wallBetween(from, step, grid.cellSize)) return;
    if (const auto cellBelow = landing->below(from + step * grid.cellSize)) link.target = *cellBelow;
    if (link.target == cell) return;
  }
  builder.addLink(cell, link);
}

}  // namespace

void addRims(const SnowGround& ground, const SnowScene* scene, CoverGraphBuilder& builder) {
  std::optional<Landing> landing;
  if (scene) landing.emplace(ground, *scene, builder);
  for (const ModelGround& model : ground.models)
    for (const ModelPatch& patch : model.patches) {
      const CoverGraph::Grid& grid = builder.grid(patch.grid);
      for (int j = 0; j < grid.height; ++j)
        for (int i = 0; i < grid.width; ++i) {
          if (!builder.isCell(grid, i, j)) continue;
          for (std::uint8_t side = 0; side < 8; side = static_cast<std::uint8_t>(side + 2))
            if (!builder.isCell(grid, i + kCellSteps[side][0], j + kCellSteps[side][1]))
              addRim(grid, i, j, side, landing ? &*landing : nullptr, builder);
        }
    }
}

}  // namespace spin
