// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "plugins/sdk/importer.h"

namespace spin {

/// Models by Assimp: glTF, OBJ, PLY, STL, FBX; textures by OpenCV.
class ModelAssimpPlugin final : public QObject, public ModelImporter {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID SPIN_MODEL_IMPORTER_IID FILE "model_assimp.json")
  Q_INTERFACES(spin::ModelImporter)

 public:
  std::vector<std::string> extensions() const override { return {"gltf", "glb", "obj", "ply", "stl", "fbx"}; }
  Result<ModelImport> read(const std::string& path, const ImportOptions& options) override;
};

}  // namespace spin
