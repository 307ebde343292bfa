// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/asset_file.h"

#include <fmt/format.h>

#include <QDir>
#include <QFileInfo>

#include "core/property/text_check.h"

namespace spin {
namespace {

/// Folders with more files are no model folders; their companions are not looked at.
constexpr qsizetype kMaxCompanions = 2000;

void addStamp(const QFileInfo& info, std::string& stamp) {
  stamp += fmt::format("|{}:{}:{}", info.fileName().toStdString(), info.size(),
                       info.lastModified().toMSecsSinceEpoch());
}

}  // namespace

Result<FoundAsset> findAsset(const std::string& sceneFile, const std::string& assetPath,
                             const PathPolicy& policy, const Hash128& expected) {
  Result<std::string> path = resolveAssetPath(sceneFile, assetPath, policy);
  if (!path) return path.error();
  if (QFileInfo::exists(QString::fromStdString(*path))) return FoundAsset{*path, false};
  if (const auto moved = findMovedAsset(sceneFile, assetPath, expected)) return FoundAsset{*moved, true};
  return badInput("The file is missing", printable(assetPath),
                  "it is neither where the scene says nor under its name in the scene's folder",
                  "Put it back, or name another file");
}

AssetLibrary::Issue movedRemark(const std::string& node, const std::string& assetPath,
                                const std::string& usedPath) {
  return {
      node,
      badInput("The file is not where the scene says", printable(assetPath),
               fmt::format("{} is used instead", printable(usedPath)), "Name the file again to keep this"),
      true};
}

std::string stampOf(const std::string& path, const ImportOptions& options) {
  const QFileInfo info(QString::fromStdString(path));
  if (!info.exists()) return {};
  std::string stamp = fmt::format("{}|{}|{}|{}|{}|{}|{}", path, options.epsg, options.noDataValue,
                                  options.heightScale, options.cellSize, options.upAxis, options.unitScale);
  addStamp(info, stamp);
  static const QStringList kCompanions{
      QStringLiteral("*.bin"), QStringLiteral("*.mtl"), QStringLiteral("*.png"), QStringLiteral("*.jpg"),
      QStringLiteral("*.jpeg"), QStringLiteral("*.prj"), QStringLiteral("*.aux.xml"),
      // World files and masks, which GDAL takes for the raster beside them.
      QStringLiteral("*.?fw"), QStringLiteral("*.?gw"), QStringLiteral("*.tifw"), QStringLiteral("*.tiffw"),
      QStringLiteral("*.pngw"), QStringLiteral("*.wld"), QStringLiteral("*.msk")};
  const QFileInfoList companions = info.dir().entryInfoList(kCompanions, QDir::Files, QDir::Name);
  if (companions.size() > kMaxCompanions) return stamp;
  for (const QFileInfo& companion : companions) addStamp(companion, stamp);
  return stamp;
}

}  // namespace spin
