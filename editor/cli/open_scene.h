// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/cancel.h"
#include "core/scene/asset_library.h"

namespace spin {

/// A scene as the command line names it.
struct SceneRequest {
  std::string file;
  std::vector<std::string> assignments;     ///< "node.property=value", applied in order, not saved
  std::vector<std::string> allowedFolders;  ///< where files may lie besides the scene's folder
};

struct OpenedScene {
  std::string file;  ///< absolute
  Scene scene;
  SceneFileExtras extras;
  SnapshotPointer snapshot;
  std::vector<AssetLibrary::Issue> issues;  ///< about the nodes' files
};

/// Reads the scene file, applies the assignments, reads painted layers, terrain and models.
Result<OpenedScene> openScene(const SceneRequest& request, std::shared_ptr<AssetReader> reader,
                              const CancelToken& cancel);

/// Names all problems of files in the log; the first one that leaves a node without data is the error.
Status requireFiles(const OpenedScene& opened);

/// Reads and applies one "node.property=value".
Status assign(Scene& scene, const std::string& assignment);

}  // namespace spin
