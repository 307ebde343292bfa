// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/host/import_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

bool inWorld(double v) {
  return std::isfinite(v) && std::abs(v) <= kMaxWorldCoordinate;
}

bool allFinite(const std::vector<Vec3f>& values) {
  return std::all_of(values.begin(), values.end(), [](Vec3f v) { return isFinite(v); });
}

std::string meshProblem(const Mesh& mesh, std::size_t materials) {
  const std::size_t n = mesh.positions.size();
  if (mesh.indices.size() % 3 != 0) return "the corners do not make whole triangles";
  if (std::any_of(mesh.indices.begin(), mesh.indices.end(), [n](std::uint32_t i) { return i >= n; }))
    return "a triangle names a vertex that does not exist";
  if (!mesh.normals.empty() && mesh.normals.size() != n) return "normals and vertices differ in number";
  if (!mesh.uvs.empty() && mesh.uvs.size() != n) return "texture coordinates and vertices differ in number";
  if (!allFinite(mesh.positions) || !allFinite(mesh.normals)) return "a vertex is not a finite number";
  if (std::any_of(mesh.uvs.begin(), mesh.uvs.end(),
                  [](Vec2f v) { return !std::isfinite(v.x) || !std::isfinite(v.y); }))
    return "a texture coordinate is not a finite number";
  if (mesh.material < 0 || static_cast<std::size_t>(mesh.material) >= materials)
    return "it names a material that does not exist";
  return {};
}

std::string materialProblem(const Material& material, std::size_t textures) {
  const Vec4f c = material.baseColour;
  for (const float v : {c.x, c.y, c.z, c.w, material.roughness})
    if (!std::isfinite(v)) return "a colour is not a finite number";
  if (material.texture < -1 || material.texture >= static_cast<int>(textures))
    return "it names a texture that does not exist";
  return {};
}

bool soundImage(const Image8& image) {
  return image.width > 0 && image.height > 0 && image.width <= kMaxTextureEdge &&
         image.height <= kMaxTextureEdge &&
         image.rgba.size() ==
             std::size_t{4} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

std::string instanceProblem(const MeshInstance& instance, std::size_t meshes) {
  if (instance.mesh < 0 || static_cast<std::size_t>(instance.mesh) >= meshes)
    return "it names a mesh that does not exist";
  for (const double v : instance.transform.linear)
    if (!std::isfinite(v)) return "its placement is not a finite number";
  if (!isFinite(instance.transform.translation)) return "its placement is not a finite number";
  if (instance.transform.determinant() == 0.0) return "its placement flattens it";
  return {};
}

template <class T, class Problem>
Status checkEach(const std::vector<T>& items, const char* kind, const std::string& path, Problem problem) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (const std::string why = problem(items[i]); !why.empty())
      return badInput("The model is unusable", path, fmt::format("{} {}: {}", kind, i, why));
  return {};
}

Status checkShape(const Raster<float>& r, const GeoReference& geo, const char* what,
                  const std::string& path) {
  const auto bad = [&](const std::string& why) { return Status(badInput(what, path, why)); };
  if (r.width < 2 || r.height < 2 || r.width > kMaxRasterEdge || r.height > kMaxRasterEdge)
    return bad(fmt::format("{} x {} cells; 2 to {} along each edge are possible", r.width, r.height,
                           kMaxRasterEdge));
  if (r.values.size() != static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height))
    return bad("the number of values does not fit its size");
  if (!(r.cellSize >= kMinCellSize && r.cellSize <= kMaxCellSize))
    return bad(fmt::format("a cell size of {} m", r.cellSize));
  if (!inWorld(r.originX) || !inWorld(r.originY) || !inWorld(geo.origin.x) || !inWorld(geo.origin.y) ||
      !inWorld(geo.origin.z))
    return bad("its place in the world is not a usable number");
  return {};
}

}  // namespace

Status checkRaster(const Raster<float>& r, const GeoReference& geo, const std::string& path) {
  if (Status status = checkShape(r, geo, "The raster is unusable", path); !status) return status;
  for (const float v : r.values)
    if (std::isinf(v)) return badInput("The raster is unusable", path, "it holds an infinite number");
  return {};
}

Status checkTerrain(const TerrainData& terrain, const std::string& path) {
  const Raster<float>& r = terrain.heights;
  if (Status status = checkShape(r, terrain.geo, "The terrain is unusable", path); !status) return status;
  const auto bad = [&](const std::string& why) {
    return Status(badInput("The terrain is unusable", path, why));
  };
  bool any = false;
  for (const float h : r.values) {
    if (std::isnan(h)) continue;
    if (!(std::abs(static_cast<double>(h)) <= 2.0 * kMaxHeight))
      return bad(fmt::format("a height of {} m", h));
    any = true;
  }
  return any ? Status() : bad("it has no height at all");
}

Status checkModel(const ModelData& model, const std::string& path) {
  const auto mesh = [&](const Mesh& m) { return meshProblem(m, model.materials.size()); };
  const auto material = [&](const Material& m) { return materialProblem(m, model.textures.size()); };
  const auto texture = [](const Image8& i) {
    return soundImage(i) ? std::string() : std::string("its size does not fit its texels");
  };
  const auto instance = [&](const MeshInstance& i) { return instanceProblem(i, model.meshes.size()); };
  if (Status s = checkEach(model.textures, "texture", path, texture); !s) return s;
  if (Status s = checkEach(model.materials, "material", path, material); !s) return s;
  if (Status s = checkEach(model.meshes, "mesh", path, mesh); !s) return s;
  if (Status s = checkEach(model.instances, "instance", path, instance); !s) return s;
  const auto bad = [&](const std::string& why, const std::string& advice) {
    return Status(badInput("The model is unusable", path, why, advice));
  };
  if (model.instances.size() > kMaxInstances)
    return bad(
        fmt::format("{} placed meshes; at most {} are possible", model.instances.size(), kMaxInstances),
        "Join meshes before exporting");
  const std::size_t triangles = model.triangleCount();
  if (triangles == 0) return bad("it has no triangles", "Export surfaces, not points or lines");
  if (triangles > kMaxTriangles)
    return bad(fmt::format("{} triangles; at most {} are possible", triangles, kMaxTriangles),
               "Reduce the model before importing it");
  return {};
}

}  // namespace spin
