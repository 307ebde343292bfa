// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/flake_shapes.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/log.h"
#include "core/sim/checked_file.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKind = "flakes";

FlakeSymmetry symmetryOf(FlakeGrowth growth) {
  if (growth == FlakeGrowth::Free) return FlakeSymmetry::Free;
  return growth == FlakeGrowth::EightArms ? FlakeSymmetry::Eight : FlakeSymmetry::Six;
}

int pixelsOf(FlakeDetail detail) {
  return 32 << static_cast<int>(detail);
}

}  // namespace

FlakeSettings flakeSettingsOf(const FlakeNode& node) {
  FlakeSettings settings;
  settings.symmetry = symmetryOf(node.growth);
  settings.seed = static_cast<std::uint64_t>(node.seed);
  settings.radius = node.largest;
  settings.particleDiameter = node.particleDiameter;
  settings.particles = node.particles;
  settings.alignment = node.alignment;
  settings.landings = node.growth == FlakeGrowth::Free ? 1 : node.landings;
  return settings;
}

CrystalSettings crystalSettingsOf(const FlakeNode& node) {
  static_assert(static_cast<int>(CrystalForm::Plate) == static_cast<int>(CrystalHabit::Plate));
  CrystalSettings settings;
  settings.law = crystalLaw(static_cast<CrystalHabit>(node.form));
  settings.seed = static_cast<std::uint64_t>(node.seed);
  settings.cells = node.cells;
  settings.weather = node.variety;
  return settings;
}

FlakeAtlasSettings atlasSettingsOf(const FlakeNode& node) {
  FlakeAtlasSettings settings;
  settings.flake = flakeSettingsOf(node);
  if (node.growth == FlakeGrowth::Crystal) settings.crystal = crystalSettingsOf(node);
  settings.smallest = node.smallest;
  settings.largest = node.largest;
  settings.flakes = node.shapes;
  settings.size = pixelsOf(node.detail);
  settings.seed = static_cast<std::uint64_t>(node.seed);
  return settings;
}

FlakeAtlasSettings atlasSettingsOf(const SceneSnapshot& scene) {
  return atlasSettingsOf(scene.settings<FlakeNode>(0.0));
}

std::string flakeAtlasFile(const std::string& cacheFolder, const Hash128& key) {
  return fmt::format("{}/flakes/{}.flakes", cacheFolder, key.hex());
}

Status writeFlakeAtlas(const FlakeAtlas& atlas, const Hash128& key, const std::string& cacheFolder) {
  const std::string path = flakeAtlasFile(cacheFolder, key);
  std::error_code error;
  fs::create_directories(fs::path(path).parent_path(), error);
  if (error)
    return Error{ErrorKind::Failed, "The grown flakes could not be kept", path, error.message(),
                 "Check the permissions of the cache folder"};
  ByteWriter out;
  saveFlakeAtlas(atlas, out);
  return writeCheckedFile(path, {kKind, 0, key, {}}, out.bytes());
}

Result<FlakeAtlas> readFlakeAtlas(const std::string& cacheFolder, const Hash128& key) {
  const std::string path = flakeAtlasFile(cacheFolder, key);
  const Result<CheckedFile> file = readCheckedFile(path);
  if (!file) return file.error();
  if (file->header.kind != kKind || file->header.key != key)
    return badInput("The cache file is damaged", path, "its content is not what its name says");
  ByteReader in(file->payload.data(), file->payload.size());
  Result<FlakeAtlas> atlas = loadFlakeAtlas(in);
  if (atlas && !in.atEnd()) return badInput("The cache file is damaged", path, "it is longer than its atlas");
  return atlas;
}

Result<std::shared_ptr<const FlakeAtlas>> obtainFlakeAtlas(const FlakeAtlasSettings& settings,
                                                           const std::string& cacheFolder,
                                                           const CancelToken& cancel,
                                                           const std::function<void(double)>& progress,
                                                           int threads) {
  using Kept = std::shared_ptr<const FlakeAtlas>;
  const Hash128 key = flakeAtlasKey(settings);
  std::error_code error;
  if (!cacheFolder.empty() && fs::exists(flakeAtlasFile(cacheFolder, key), error)) {
    Result<FlakeAtlas> read = readFlakeAtlas(cacheFolder, key);
    if (read) return Kept(std::make_shared<const FlakeAtlas>(std::move(*read)));
    logWarning(read.error().text());
  }
  Result<FlakeAtlas> grown = growFlakeAtlas(settings, cancel, progress, threads);
  if (!grown) return grown.error();
  if (!cacheFolder.empty())
    if (const Status kept = writeFlakeAtlas(*grown, key, cacheFolder); !kept) logWarning(kept.error().text());
  return Kept(std::make_shared<const FlakeAtlas>(std::move(*grown)));
}

}  // namespace spin
