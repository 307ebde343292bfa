// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/snow/model_parts.h"
#include "core/snow/snow_ground.h"

namespace spin {
namespace {

using Polygon = std::vector<Vec2d>;

/// The part of a convex polygon where coordinate `axis` is at or beyond `limit` (side +1) or at or before it
/// (side -1): Sutherland and Hodgman 1974.
Polygon clip(const Polygon& polygon, int axis, double limit, int side) {
  const auto at = [axis](Vec2d p) { return axis == 0 ? p.x : p.y; };
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2d a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    const double da = side * (at(a) - limit), db = side * (at(b) - limit);
    if (da >= 0.0) kept.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

double areaOf(Vec2d a, Vec2d b, Vec2d c) {
  return 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

struct CellPiece {
  std::uint32_t cell;
  PatchPiece piece;
  double area;
};

Vec2d planOf(Vec3f p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

/// Cuts a triangle along the raster's cell borders.
void cutIntoCells(const PlacedTriangle& triangle, std::uint32_t source, const Raster<float>& raster,
                  std::vector<CellPiece>& pieces) {
  const Polygon whole{planOf(triangle.corners[0]), planOf(triangle.corners[1]), planOf(triangle.corners[2])};
  const auto [x0, x1] = std::minmax({whole[0].x, whole[1].x, whole[2].x});
  const auto [y0, y1] = std::minmax({whole[0].y, whole[1].y, whole[2].y});
  const double half = 0.5 * raster.cellSize;
  // What rounding leaves where a triangle only touches a cell.
  const double least = 1e-12 * raster.cellSize * raster.cellSize;
  const int left = std::max(raster.column(x0), 0), right = std::min(raster.column(x1), raster.width - 1);
  for (int j = std::max(raster.row(y0), 0); j <= std::min(raster.row(y1), raster.height - 1); ++j) {
    const Polygon strip = clip(clip(whole, 1, raster.y(j) - half, 1), 1, raster.y(j) + half, -1);
    for (int i = left; i <= right; ++i) {
      const Polygon part = clip(clip(strip, 0, raster.x(i) - half, 1), 0, raster.x(i) + half, -1);
      for (std::size_t k = 2; k < part.size(); ++k) {
        const double area = areaOf(part[0], part[k - 1], part[k]);
        if (!(area > least)) continue;
        const auto corner = [](Vec2d p) { return Vec2f{static_cast<float>(p.x), static_cast<float>(p.y)}; };
        pieces.push_back({static_cast<std::uint32_t>(raster.index(i, j)),
                          {{corner(part[0]), corner(part[k - 1]), corner(part[k])}, 0.0f, source},
                          area});
      }
    }
  }
}

/// Height of the triangle's plane over a point in plan, held within the triangle's own heights.
double heightOver(const PlacedTriangle& triangle, double x, double y) {
  const Vec3d n = triangle.normal(), a = triangle.corners[0].to<double>();
  const auto [low, high] = std::minmax({triangle.corners[0].z, triangle.corners[1].z, triangle.corners[2].z});
  const double z = a.z - (n.x * (x - a.x) + n.y * (y - a.y)) / n.z;
  return std::clamp(z, static_cast<double>(low), static_cast<double>(high));
}

Raster<float> rasterOver(const Box3d& box, double cell) {
  const double x0 = std::floor(box.min.x / cell) * cell, y0 = std::floor(box.min.y / cell) * cell;
  const auto cells = [cell](double from, double to) {
    return std::max(1, static_cast<int>(std::ceil((to - from) / cell - 1e-9)));
  };
  return {cells(x0, box.max.x),
          cells(y0, box.max.y),
          x0 + 0.5 * cell,
          y0 + 0.5 * cell,
          cell,
          std::numeric_limits<float>::quiet_NaN()};
}

Box3d boxOf(const ModelGround& model, const ModelPart& part) {
  Box3d box;
  for (const std::uint32_t t : part.triangles)
    for (const Vec3f& p : model.triangles[t].corners) box.extend(p.to<double>());
  return box;
}

/// Sorts the pieces by cell and fills areas, base heights and running sums.
void fillPatch(const ModelGround& model, std::vector<CellPiece>& pieces, ModelPatch& patch, CoverGrid& grid) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const CellPiece& a, const CellPiece& b) { return a.cell < b.cell; });
  const int width = grid.base.width;
  patch.cellStart.assign(grid.base.size() + 1, 0);
  patch.pieces.reserve(pieces.size());
  for (std::size_t begin = 0; begin < pieces.size();) {
    const std::uint32_t cell = pieces[begin].cell;
    double sum = 0.0;
    std::size_t largest = begin, end = begin;
    for (; end < pieces.size() && pieces[end].cell == cell; ++end) {
      sum += pieces[end].area;
      if (pieces[end].area > pieces[largest].area) largest = end;
      pieces[end].piece.areaToHere = static_cast<float>(sum);
      patch.pieces.push_back(pieces[end].piece);
    }
    const int i = static_cast<int>(cell) % width, j = static_cast<int>(cell) / width;
    grid.area.at(i, j) = static_cast<float>(sum);
    grid.base.at(i, j) = static_cast<float>(
        heightOver(model.triangles[pieces[largest].piece.source], grid.base.x(i), grid.base.y(j)));
    patch.cellStart[cell + 1] = static_cast<std::uint32_t>(end - begin);
    begin = end;
  }
  for (std::size_t c = 1; c < patch.cellStart.size(); ++c) patch.cellStart[c] += patch.cellStart[c - 1];
}

/// Cell size that keeps all patches of the model within the cap.
double cellWithinCap(const ModelGround& model, const std::vector<ModelPart>& parts, double wanted,
                     std::vector<std::string>& messages) {
  std::vector<Vec3d> sizes;
  for (const ModelPart& part : parts) sizes.push_back(boxOf(model, part).size());
  const auto cellsOf = [&](double cell) {
    double cells = 0.0;
    for (const Vec3d& size : sizes) cells += (size.x / cell + 2.0) * (size.y / cell + 2.0);
    return cells;
  };
  double cell = wanted;
  while (cellsOf(cell) > kMostPatchCells) cell *= 1.3;
  if (cell > wanted)
    messages.push_back(
        fmt::format("The snow cover on model '{}' has cells of {:.2f} m instead of {:.2f} m to stay "
                    "below {:.0f} cells",
                    model.node, cell, wanted, kMostPatchCells));
  return cell;
}

void addBare(ModelGround& model, const ModelSurface& surface, const std::vector<char>& covered) {
  for (std::uint32_t t = 0; t < model.triangles.size(); ++t)
    if (!covered[t] && !surface.doubled[t]) model.bare.push_back({t, surface.outward[t]});
}

}  // namespace

void addModelPatches(ModelGround& model, double cellSize, double minUpward, CoverLayout& layout,
                     std::vector<std::string>& messages) {
  const ModelSurface surface = modelSurface(model.triangles, minUpward);
  std::vector<ModelPart> parts = surface.parts;
  const auto tooSmall = [&](const ModelPart& part) { return part.planArea < 2.0 * cellSize * cellSize; };
  parts.erase(std::find_if(parts.begin(), parts.end(), tooSmall), parts.end());
  if (parts.size() > kMostPatches) parts.resize(kMostPatches);
  const double cell = cellWithinCap(model, parts, cellSize, messages);

  std::vector<char> covered(model.triangles.size(), 0);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    CoverGrid grid;
    grid.id = fmt::format("{}/{}", model.node, p);
    grid.node = model.node;
    grid.base = rasterOver(boxOf(model, parts[p]), cell);
    grid.area = grid.base.sameShape<float>(0.0f);
    std::vector<CellPiece> pieces;
    for (const std::uint32_t t : parts[p].triangles) {
      covered[t] = 1;
      cutIntoCells(model.triangles[t], t, grid.base, pieces);
    }
    ModelPatch patch;
    patch.grid = layout.grids.size();
    fillPatch(model, pieces, patch, grid);
    model.patches.push_back(std::move(patch));
    layout.grids.push_back(std::move(grid));
  }
  addBare(model, surface, covered);
}

void leaveBare(ModelGround& model) {
  addBare(model, modelSurface(model.triangles, 1.0), std::vector<char>(model.triangles.size(), 0));
}

}  // namespace spin
