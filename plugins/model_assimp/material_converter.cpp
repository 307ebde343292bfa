// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/model_assimp/material_converter.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "plugins/model_assimp/texture_reader.h"

namespace spin {
namespace {

float unit(float v, float otherwise) {
  return std::isfinite(v) ? std::clamp(v, 0.0f, 1.0f) : otherwise;
}

std::string textureName(const aiMaterial& from) {
  aiString name;
  if (from.GetTexture(aiTextureType_BASE_COLOR, 0, &name) == aiReturn_SUCCESS && name.length > 0)
    return name.C_Str();
  if (from.GetTexture(aiTextureType_DIFFUSE, 0, &name) == aiReturn_SUCCESS && name.length > 0)
    return name.C_Str();
  return {};
}

Material convertMaterial(const aiMaterial& from, TextureReader& textures) {
  Material to;
  to.name = from.GetName().C_Str();
  aiColor4D colour;
  if (from.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS ||
      from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS)
    to.baseColour = {unit(colour.r, 0.8f), unit(colour.g, 0.8f), unit(colour.b, 0.8f), unit(colour.a, 1.0f)};
  float number = 1.0f;
  if (from.Get(AI_MATKEY_OPACITY, number) == aiReturn_SUCCESS)
    to.baseColour.w = std::min(to.baseColour.w, unit(number, 1.0f));
  if (from.Get(AI_MATKEY_ROUGHNESS_FACTOR, number) == aiReturn_SUCCESS) to.roughness = unit(number, 0.9f);
  int flag = 0;
  if (from.Get(AI_MATKEY_TWOSIDED, flag) == aiReturn_SUCCESS) to.doubleSided = flag != 0;
  to.texture = textures.indexOf(textureName(from));
  aiString mode;
  if (from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS)
    to.alphaCutout = std::string(mode.C_Str()) != "OPAQUE";
  else if (to.texture >= 0)
    to.alphaCutout = hasHoles(textures.textures()[static_cast<std::size_t>(to.texture)]);
  return to;
}

}  // namespace

void convertMaterials(const aiScene& scene, const ModelFolder& folder, ModelData& model,
                      std::vector<std::string>& warnings) {
  TextureReader textures(scene, folder, warnings);
  std::map<int, int> used;
  for (Mesh& mesh : model.meshes) {
    const auto known = used.find(mesh.material);
    if (known != used.end()) {
      mesh.material = known->second;
      continue;
    }
    const int number = static_cast<int>(model.materials.size());
    const auto index = static_cast<unsigned>(mesh.material);
    model.materials.push_back(
        index < scene.mNumMaterials ? convertMaterial(*scene.mMaterials[index], textures) : Material{});
    used[mesh.material] = number;
    mesh.material = number;
  }
  model.textures = textures.take();
}

}  // namespace spin
