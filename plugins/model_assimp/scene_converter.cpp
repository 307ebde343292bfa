// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/model_assimp/scene_converter.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plugins/model_assimp/material_converter.h"
#include "plugins/sdk/import_limits.h"

namespace spin {
namespace {

constexpr const char* kWhat = "The model could not be read";

Vec3d toVec(const aiVector3D& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// The mesh in metres and z up; nothing if it has no triangles. Assimp has already split it by material.
Result<Mesh> convertMesh(const aiMesh& from, const ModelFrame& frame, const std::string& path) {
  Mesh mesh;
  mesh.name = from.mName.C_Str();
  mesh.material = static_cast<int>(from.mMaterialIndex);
  const auto bad = [&](const std::string& why) {
    return badInput(kWhat, path, fmt::format("mesh \"{}\": {}", mesh.name, why),
                    "Open it in the program that made it and export it again");
  };
  mesh.positions.reserve(from.mNumVertices);
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    const Vec3d p = frame.turned(toVec(from.mVertices[i])) * frame.scale;
    if (!isFinite(p)) return bad(fmt::format("vertex {} is not a finite number", i));
    mesh.positions.push_back(p.to<float>());
    if (!isFinite(mesh.positions.back())) return bad(fmt::format("vertex {} is too far away", i));
  }
  for (unsigned i = 0; from.mNormals && i < from.mNumVertices; ++i)
    mesh.normals.push_back(frame.turned(toVec(from.mNormals[i])).to<float>());
  if (const aiVector3D* uv = from.mTextureCoords[0]) {
    for (unsigned i = 0; i < from.mNumVertices; ++i) {
      if (!std::isfinite(uv[i].x) || !std::isfinite(uv[i].y))
        return bad(fmt::format("texture coordinate {} is not a finite number", i));
      // Assimp's origin is the lower left, ours the upper left.
      mesh.uvs.push_back({uv[i].x, 1.0f - uv[i].y});
    }
  }
  for (unsigned f = 0; f < from.mNumFaces; ++f) {
    const aiFace& face = from.mFaces[f];
    if (face.mNumIndices != 3) continue;
    for (unsigned k = 0; k < 3; ++k) {
      if (face.mIndices[k] >= from.mNumVertices) return bad("a triangle names a vertex that does not exist");
      mesh.indices.push_back(face.mIndices[k]);
    }
  }
  return mesh;
}

/// Placement of a node in our axes: the same change of base on both sides, so an unplaced mesh keeps the
/// identity.
Transform toTransform(const aiMatrix4x4& m, const ModelFrame& frame) {
  const double rows[3][4] = {{double{m.a1}, double{m.a2}, double{m.a3}, double{m.a4}},
                             {double{m.b1}, double{m.b2}, double{m.b3}, double{m.b4}},
                             {double{m.c1}, double{m.c2}, double{m.c3}, double{m.c4}}};
  const auto column = [&](int k) { return Vec3d{rows[0][k], rows[1][k], rows[2][k]}; };
  Vec3d x = frame.turned(column(0)), y = frame.turned(column(1)), z = frame.turned(column(2));
  if (frame.yUp) {
    // Our y is the file's -z, our z its y.
    const Vec3d fileY = y;
    y = -z;
    z = fileY;
  }
  Transform t;
  t.linear = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
  t.translation = frame.turned(column(3)) * frame.scale;
  return t;
}

bool isUsable(const Transform& t) {
  double size = 0.0;
  for (const double v : t.linear) {
    if (!std::isfinite(v)) return false;
    size = std::max(size, std::abs(v));
  }
  return std::abs(t.determinant()) > 1e-12 * size * size * size;
}

bool isFiniteMatrix(const aiMatrix4x4& m) {
  for (unsigned r = 0; r < 3; ++r)
    for (unsigned c = 0; c < 4; ++c)
      if (!std::isfinite(m[r][c])) return false;
  return true;
}

/// Collects the placed meshes of the node tree.
class InstanceCollector {
 public:
  InstanceCollector(const ModelFrame& frame, const std::map<unsigned, int>& meshes, const std::string& path)
      : m_frame(frame), m_meshes(meshes), m_path(path) {}

  /// An explicit stack: a hostile file may nest nodes deeper than ours.
  Status collect(const aiNode& root) {
    std::vector<std::pair<const aiNode*, aiMatrix4x4>> open{{&root, aiMatrix4x4()}};
    while (!open.empty()) {
      const auto [node, parent] = open.back();
      open.pop_back();
      const aiMatrix4x4 world = parent * node->mTransformation;
      if (Status status = place(*node, world); !status) return status;
      for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], world);
    }
    return {};
  }

  std::vector<MeshInstance> instances;
  std::size_t flattened = 0;

 private:
  Status place(const aiNode& node, const aiMatrix4x4& world) {
    if (node.mNumMeshes == 0) return {};
    if (!isFiniteMatrix(world))
      return badInput(kWhat, m_path,
                      fmt::format("the placement of \"{}\" is not a finite number", node.mName.C_Str()),
                      "Open it in the program that made it and export it again");
    const Transform transform = toTransform(world, m_frame);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const auto mesh = m_meshes.find(node.mMeshes[i]);
      if (mesh == m_meshes.end()) continue;
      if (!isUsable(transform))
        ++flattened;
      else
        instances.push_back({mesh->second, transform});
    }
    if (instances.size() > kMaxInstances)
      return badInput(kWhat, m_path, fmt::format("it places more than {} meshes", kMaxInstances),
                      "Join meshes before exporting");
    return {};
  }

  const ModelFrame& m_frame;
  const std::map<unsigned, int>& m_meshes;
  const std::string& m_path;
};

Status checkSize(const ModelData& model, const std::string& path) {
  const std::size_t triangles = model.triangleCount();
  if (triangles == 0)
    return badInput(kWhat, path, "it has no triangles", "Export surfaces, not points or lines");
  if (triangles > kMaxTriangles)
    return badInput(kWhat, path,
                    fmt::format("{} triangles; at most {} are possible", triangles, kMaxTriangles),
                    "Reduce the model before importing it");
  const Box3d box = model.bounds();
  for (const Vec3d& corner : {box.min, box.max})
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(corner[axis]) <= kMaxModelSize))
        return badInput(kWhat, path, fmt::format("it reaches {:g} m from its origin", std::abs(corner[axis])),
                        "Give its unit at import (metres per unit), or move it to its origin");
  return {};
}

}  // namespace

ModelFrame modelFrameOf(const aiScene& scene, const std::string& extension, const ImportOptions& options) {
  ModelFrame frame;
  frame.yUp = extension == "gltf" || extension == "glb" || extension == "obj" || extension == "fbx";
  frame.reason = extension == "gltf" || extension == "glb" ? "as glTF defines" : "assumed for " + extension;
  if (extension == "fbx" && scene.mMetaData) {
    int up = 1;
    if (scene.mMetaData->Get("UpAxis", up)) {
      frame.yUp = up != 2;
      frame.reason = "as the file says";
    }
    // Centimetres per unit: Assimp leaves the numbers as they are in the file.
    double centimetres = 1.0;
    float single = 1.0f;
    if (!scene.mMetaData->Get("UnitScaleFactor", centimetres) &&
        scene.mMetaData->Get("UnitScaleFactor", single))
      centimetres = static_cast<double>(single);
    frame.scale = std::isfinite(centimetres) && centimetres > 0.0 ? 0.01 * centimetres : 0.01;
  }
  if (options.upAxis != 0) {
    frame.yUp = options.upAxis == 1;
    frame.reason = "as chosen";
  }
  if (options.unitScale > 0.0) frame.scale = options.unitScale;
  return frame;
}

Result<ConvertedModel> convertScene(const aiScene& scene, const ModelFrame& frame, const ModelFolder& folder,
                                    const std::string& path) {
  ConvertedModel out;
  std::map<unsigned, int> meshes;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    Result<Mesh> mesh = convertMesh(*scene.mMeshes[i], frame, path);
    if (!mesh) return mesh.error();
    if (mesh->material < 0 || static_cast<unsigned>(mesh->material) >= std::max(1u, scene.mNumMaterials))
      return badInput(kWhat, path,
                      fmt::format("mesh \"{}\" names a material that does not exist", mesh->name));
    cleanMesh(*mesh, out.repairs);
    if (mesh->indices.empty()) continue;
    meshes[i] = static_cast<int>(out.model.meshes.size());
    out.model.meshes.push_back(std::move(*mesh));
  }
  InstanceCollector collector(frame, meshes, path);
  if (!scene.mRootNode) return badInput(kWhat, path, "it places no mesh");
  if (Status status = collector.collect(*scene.mRootNode); !status) return status.error();
  out.model.instances = std::move(collector.instances);
  if (collector.flattened > 0)
    out.warnings.push_back(
        fmt::format("{} placed meshes are scaled to nothing: left out", collector.flattened));
  if (Status status = checkSize(out.model, path); !status) return status.error();
  convertMaterials(scene, folder, out.model, out.warnings);
  return out;
}

}  // namespace spin
