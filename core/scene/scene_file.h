// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/scene/scene.h"

namespace spin {

inline constexpr int kSceneSchema = 2;     ///< what this program writes
inline constexpr int kSceneMinReader = 2;  ///< oldest schema whose readers understand what it writes

/// What else came with a scene file: kept so that saving loses nothing.
struct SceneFileExtras {
  int schema = kSceneSchema;        ///< of the file; an older one was migrated
  int minReader = kSceneMinReader;  ///< of the file, for newer minor versions
  std::string unknownJson;  ///< keys, properties and nodes of a newer minor version, written back on save
  std::map<std::string, Hash128> assetHashes;  ///< content of the nodes' files when last read, by node id
  std::vector<std::string> messages;           ///< migrations done
};

/// Where node files may lie besides the scene's own folder (allowed by the user).
struct PathPolicy {
  std::vector<std::string> allowedFolders;
};

struct LoadedScene {
  Scene scene;
  SceneFileExtras extras;
};

/// Text of a scene file: format, schema, min_reader, generator first, then keys sorted; non-default values
/// only. Same scene, same text.
std::string writeSceneText(const Scene& scene, const SceneFileExtras& extras = {});
/// Largest scene file that is read, bytes.
inline constexpr std::size_t kMaxSceneBytes = std::size_t{32} << 20;

/// Parses and migrates. Errors name line or key, the reason and the nearest known name.
Result<LoadedScene> readSceneText(const std::string& text, const std::string& nameForMessages);

/// Saves through a temporary file and a rename. Painted layers are saved apart, see LayerFiles in
/// asset_library.h.
Status saveScene(const Scene& scene, const SceneFileExtras& extras, const std::string& path);
/// Loads; an old schema is migrated step by step and the old file is kept beside it as NAME.schemaN.bak when
/// saved over.
Result<LoadedScene> loadScene(const std::string& path);

/// Absolute path of a node's file relative to the scene's folder, refused if it leaves it without permission
/// or names a device.
Result<std::string> resolveAssetPath(const std::string& sceneFile, const std::string& assetPath,
                                     const PathPolicy& policy);
/// Looks for a file that is not where the node says: by its name in the scene's folder and below (bounded in
/// depth and number), the one with the hash first where that is known.
std::optional<std::string> findMovedAsset(const std::string& sceneFile, const std::string& assetPath,
                                          const Hash128& expected);
/// Hash of a file's bytes; null where it cannot be read.
Hash128 hashFile(const std::string& path);
/// The form stored in the scene: relative to its folder with '/', absolute only where there is no relative
/// way.
std::string storedAssetPath(const std::string& sceneFile, const std::string& absolutePath);

}  // namespace spin
