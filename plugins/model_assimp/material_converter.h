// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/fields/mesh.h"
#include "plugins/model_assimp/model_folder.h"

struct aiScene;

namespace spin {

/// Materials that the model's meshes use, with their textures; renumbers Mesh::material. Colours out of range
/// are clamped.
void convertMaterials(const aiScene& scene, const ModelFolder& folder, ModelData& model,
                      std::vector<std::string>& warnings);

}  // namespace spin
