// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/save_job.h"

#include <QDir>
#include <QFileInfo>

#include "core/scene/collect_files.h"

namespace spin {
namespace {

bool isPainted(const SceneNode& node) {
  return !std::holds_alternative<std::monostate>(node.painted);
}

/// Georeference for painted layers; where the terrain's file is missing, the layer keeps its size at least.
TerrainData terrainFor(const SceneNode& node, const SnapshotPointer& snapshot) {
  if (snapshot && snapshot->terrain) return *snapshot->terrain;
  TerrainData terrain;
  if (const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&node.painted))
    terrain.heights = Raster<float>(types->width(), types->height(), 0, 0, 1);
  if (const auto* kelvin = std::get_if<TiledRaster<float>>(&node.painted))
    terrain.heights = Raster<float>(kelvin->width(), kelvin->height(), 0, 0, 1);
  return terrain;
}

}  // namespace

std::string contentOf(const QString& path) {
  const Hash128 hash = hashFile(path.toStdString());
  return hash.isNull() ? std::string() : hash.hex();
}

void SceneDocument::SaveJob::run(AssetLibrary& assets) {
  rebaseSources();
  copyFiles();
  status = saveLayers(assets);
  if (!status) return;
  for (const auto& [node, hash] : assets.fileHashes())
    if (!hash.isNull()) extras.assetHashes[node] = hash;
  status = saveScene(scene, extras, path.toStdString());
  if (status) hashOnDisk = contentOf(path);
  if (extras.schema < kSceneSchema) extras.schema = kSceneSchema;
  extras.messages.clear();
}

void SceneDocument::SaveJob::rebaseSources() {
  const QFileInfo before(oldPath), after(path);
  if (!oldPath.isEmpty() && before.absolutePath() == after.absolutePath()) return;
  for (const SceneNode& listed : original.nodes()) {
    const PropertyInfo* source = listed.type->find("source");
    const QString stored = QString::fromStdString(sourceOf(listed));
    const bool relative = QDir::isRelativePath(stored);
    if (!source || stored.isEmpty() || (relative && oldPath.isEmpty())) continue;
    const QString absolute = relative ? before.absoluteDir().absoluteFilePath(stored) : stored;
    setPlainValue(*scene.find(listed.id), *source,
                  storedAssetPath(path.toStdString(), absolute.toStdString()));
  }
}

void SceneDocument::SaveJob::copyFiles() {
  const std::string sceneFile = path.toStdString();
  const QDir before = QFileInfo(oldPath.isEmpty() ? path : oldPath).absoluteDir();
  for (const SceneNode& listed : original.nodes()) {
    const QString stored = QString::fromStdString(sourceOf(listed));
    if (!copied.contains(QDir::cleanPath(before.absoluteFilePath(stored)))) continue;
    SceneNode& node = *scene.find(listed.id);
    if (resolveAssetPath(sceneFile, sourceOf(node), {})) continue;
    const QDir folder = QFileInfo(path).absoluteDir();
    const QString file = folder.absoluteFilePath(QString::fromStdString(sourceOf(node)));
    const Result<std::string> copy = copyBeside(QDir::cleanPath(file).toStdString(), sceneFile);
    if (copy)
      setPlainValue(node, *node.type->find("source"), storedAssetPath(sceneFile, *copy));
    else
      issues.push_back(issueOf(copy.error(), node.id, Severity::Warning));
  }
}

Status SceneDocument::SaveJob::saveLayers(AssetLibrary& assets) {
  const bool samePlace = path == oldPath;
  Scene changedLayers = scene;
  bool any = false;
  for (const SceneNode& listed : scene.nodes()) {
    const auto onDisk = layersOnDisk.find(listed.id);
    const bool kept = samePlace && onDisk != layersOnDisk.end() && onDisk->second == listed.painted;
    if (kept || !isPainted(listed)) changedLayers.find(listed.id)->painted = std::monostate{};
    any |= isPainted(*changedLayers.find(listed.id));
  }
  if (!any) return {};
  std::vector<AssetLibrary::Issue> ignored;
  const Result<SnapshotPointer> snapshot = assets.snapshot(scene, path.toStdString(), ignored);
  if (!snapshot) return snapshot.error();
  for (const SceneNode& listed : changedLayers.nodes()) {
    if (!isPainted(listed)) continue;
    Scene one;
    if (Status status_ = one.append(listed); !status_) return status_;
    const TerrainData terrain = terrainFor(listed, *snapshot);
    if (Status saved = savePaintedLayers(one, path.toStdString(), terrain, assets.reader()); !saved)
      return saved;
    const PropertyInfo* source = listed.type->find("source");
    setPlainValue(*scene.find(listed.id), *source, plainValue(one.nodes().front(), *source));
  }
  return {};
}

}  // namespace spin
