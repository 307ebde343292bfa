// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/flake/flake_atlas.h"
#include "core/nodes/flake_node.h"
#include "core/sim/snapshot.h"

namespace spin {

FlakeSettings flakeSettingsOf(const FlakeNode& node);
CrystalSettings crystalSettingsOf(const FlakeNode& node);
FlakeAtlasSettings atlasSettingsOf(const FlakeNode& node);
/// The shapes that a scene's flakes have: those of its flake node, else the default ones.
FlakeAtlasSettings atlasSettingsOf(const SceneSnapshot& scene);

/// The file that keeps an atlas: flakes/KEY.flakes in the cache folder.
std::string flakeAtlasFile(const std::string& cacheFolder, const Hash128& key);
/// Through a temporary file; makes the folder.
Status writeFlakeAtlas(const FlakeAtlas& atlas, const Hash128& key, const std::string& cacheFolder);
/// Every byte is checked; a file of another key is refused.
Result<FlakeAtlas> readFlakeAtlas(const std::string& cacheFolder, const Hash128& key);

/// Reads the atlas from the cache folder, or grows it and keeps it there. A damaged file is named in the log
/// and grown again; where nothing can be written the log says so. An empty folder keeps nothing.
Result<std::shared_ptr<const FlakeAtlas>> obtainFlakeAtlas(const FlakeAtlasSettings& settings,
                                                           const std::string& cacheFolder,
                                                           const CancelToken& cancel,
                                                           const std::function<void(double)>& progress,
                                                           int threads = 0);

}  // namespace spin
