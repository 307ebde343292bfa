// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/asset_library.h"
#include "plugins/model_assimp/mesh_cleaning.h"
#include "plugins/model_assimp/model_folder.h"

struct aiScene;

namespace spin {

/// How the file's coordinates become ours (z up, metres).
struct ModelFrame {
  bool yUp = false;
  double scale = 1.0;  ///< m per unit
  std::string reason;  ///< "as glTF defines", "assumed for OBJ", "as chosen", "as the file says"

  /// y up: x stays, y becomes z, z becomes -y.
  Vec3d turned(Vec3d p) const { return yUp ? Vec3d{p.x, -p.z, p.y} : p; }
};

ModelFrame modelFrameOf(const aiScene& scene, const std::string& extension, const ImportOptions& options);

/// A model made from Assimp's scene, with every number checked.
struct ConvertedModel {
  ModelData model;
  MeshRepairs repairs;
  std::vector<std::string> warnings;
};
Result<ConvertedModel> convertScene(const aiScene& scene, const ModelFrame& frame, const ModelFolder& folder,
                                    const std::string& path);

}  // namespace spin
