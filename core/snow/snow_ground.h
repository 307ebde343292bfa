// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/sim/frame.h"
#include "core/sim/snapshot.h"

namespace spin {

/// A terrain grid of the cover: the coarse one (refinement 0, cells round the raster's points) or a fine one
/// whose cells divide each quad of a block of quads.
struct TerrainGrid {
  std::size_t grid = 0;  ///< index in the layout
  int refinement = 0;    ///< fine cells along a quad; 0 = the coarse grid
  int firstQuadI = 0, firstQuadJ = 0;
};

/// Triangle of a model in its scaled, rotated axes relative to the node's position, m.
struct PlacedTriangle {
  std::array<Vec3f, 3> corners{};

  /// Not normalised: twice the area long, by the winding.
  Vec3d normal() const {
    const Vec3d a = corners[0].to<double>();
    return cross(corners[1].to<double>() - a, corners[2].to<double>() - a);
  }
};

/// Part of a patch cell: a triangle in plan, cut from one triangle of the model.
struct PatchPiece {
  std::array<Vec2f, 3> plan{};
  float areaToHere = 0.0f;   ///< m2, sum over the cell's pieces up to and with this one
  std::uint32_t source = 0;  ///< index into the model's triangles
};

/// Cover patch over one connected up-facing part of a model.
struct ModelPatch {
  std::size_t grid = 0;                  ///< index in the layout
  std::vector<std::uint32_t> cellStart;  ///< pieces of cell c: [cellStart[c], cellStart[c + 1])
  std::vector<PatchPiece> pieces;
};

/// A triangle of a model that belongs to no patch.
struct BareTriangle {
  std::uint32_t triangle = 0;  ///< index into the model's triangles
  signed char outward = 0;     ///< the side of its winding that snow can reach; 0 = both
};

struct ModelGround {
  std::string node;
  bool turns = false;                     ///< rotation or scale changes during the film: keeps no snow
  std::vector<PlacedTriangle> triangles;  ///< at film time 0
  std::vector<BareTriangle> bare;
  std::vector<ModelPatch> patches;
};

/// Where snow can lie in a scene: the cover's grids and how their cells stand on the surfaces. Made once per
/// run from the scene at film time 0; a pure function of the scene.
struct SnowGround {
  std::shared_ptr<const CoverLayout> layout;
  std::vector<TerrainGrid> terrain;   ///< empty without terrain
  std::vector<ModelGround> models;    ///< enabled models with data
  std::vector<std::string> messages;  ///< what was made coarser than asked for, and what keeps no snow
};
using SnowGroundPointer = std::shared_ptr<const SnowGround>;

SnowGroundPointer makeSnowGround(const SceneSnapshot& scene);

/// The node of a ground's model; the scene must be the one that the ground was made of, or an edit of it that
/// keeps its models.
const SceneNode& nodeOf(const SceneSnapshot& scene, const ModelGround& model);

/// All triangles of a model under the linear part of a placement.
std::vector<PlacedTriangle> placedTriangles(const ModelData& model, const Transform& placement);

inline constexpr double kLeastUpward = 0.01;  ///< n_z below which a surface is a wall

/// Cells of all fine terrain grids together; above it their cells are made larger, with a message.
inline constexpr double kMostFineCells = 4e6;
/// Cells of all patches of one model; above it they are made larger, with a message.
inline constexpr double kMostPatchCells = 1e6;
/// Patches of one model, the largest first; snow on smaller parts is booked as shed.
inline constexpr std::size_t kMostPatches = 256;

/// Appends the coarse grid and the fine grids near models to the ground and its layout.
void addTerrainGrids(const SceneSnapshot& scene, CoverLayout& layout, SnowGround& ground);
/// 1 for the quads of the terrain that fine grids account for, by quad.
Raster<std::uint8_t> supersededQuads(const Raster<float>& heights, const SnowGround& ground);
/// Appends the patches of a model's up-facing parts: those whose upward normal's z is above minUpward.
void addModelPatches(ModelGround& model, double cellSize, double minUpward, CoverLayout& layout,
                     std::vector<std::string>& messages);
/// All of a model is bare.
void leaveBare(ModelGround& model);

}  // namespace spin
