// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/scene/asset_library.h"

namespace spin {

/// A node's file as found on disk.
struct FoundAsset {
  std::string path;
  bool moved = false;  ///< not where the node says, but under the same name in the scene's folder
};

/// Resolves a node's file and looks for it where it is missing. The error says what to do.
Result<FoundAsset> findAsset(const std::string& sceneFile, const std::string& assetPath,
                             const PathPolicy& policy, const Hash128& expected);
/// The remark that goes with a moved file.
AssetLibrary::Issue movedRemark(const std::string& node, const std::string& assetPath,
                                const std::string& usedPath);

/// Changes whenever the file, one of its companions (files of the same folder that model formats refer to) or
/// the options change; empty where the file cannot be looked at.
std::string stampOf(const std::string& path, const ImportOptions& options);

}  // namespace spin
