// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <QDir>
#include <QFileInfo>
#include <cmath>
#include <filesystem>

#include "core/nodes/flow_nodes.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/node_registry.h"
#include "core/nodes/painted_kinds.h"
#include "core/scene/asset_file.h"
#include "core/scene/collect_files.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

Status unusable(const SceneNode& node, std::string why) {
  return badInput("The painted layer is unusable", node.id, std::move(why),
                  "Choose another file or paint anew");
}

/// Every cell is blank or holds what the kind can; the first other value goes to `bad`.
template <class T>
bool everyCellGood(const TiledRaster<T>& layer, const PaintedKind& kind, T& bad) {
  const auto good = [&](T v) {
    return std::isnan(static_cast<double>(v)) || static_cast<float>(v) == kind.blank ||
           kind.holds(static_cast<double>(v));
  };
  for (int j = 0; j < layer.height(); ++j)
    for (int i = 0; i < layer.width(); ++i)
      if (bad = layer.at(i, j); !good(bad)) return false;
  return true;
}

Status checkNumbers(const SceneNode& node, const PaintedKind& kind, const TiledRaster<std::uint8_t>& layer) {
  std::uint8_t bad = 0;
  if (everyCellGood(layer, kind, bad)) return {};
  if (node.as<GroundTypeLayerNode>())
    return unusable(node, fmt::format("{} is the number of no ground type", bad));
  return unusable(node, fmt::format("{} is neither {} (released) nor {} (not painted)", bad, kReleasePainted,
                                    kReleaseUnpainted));
}

Status checkReals(const SceneNode& node, const PaintedKind& kind, const TiledRaster<float>& layer) {
  float bad = 0.0f;
  if (everyCellGood(layer, kind, bad)) return {};
  return unusable(node, fmt::format("{} {} is no {}: that lies between {} and {}", bad, kind.fileUnit,
                                    kind.name, kind.least, kind.most));
}

/// The layer as one of its kind: files say NaN for what is not painted, and a layer whose tiles are mostly
/// blank shares them.
PaintedLayer ofKind(const PaintedKind& kind, PaintedLayer layer) {
  const auto* reals = std::get_if<TiledRaster<float>>(&layer);
  if (!reals || std::isnan(kind.blank)) return layer;
  TiledRaster<float> made(reals->width(), reals->height(), kind.blank);
  for (int j = 0; j < made.height(); ++j)
    for (int i = 0; i < made.width(); ++i)
      if (const float v = reals->at(i, j); !std::isnan(v)) made.set(i, j, v);
  return made;
}

/// Writes through a temporary file of the same ending in the same folder.
Status writeSafely(AssetReader& reader, const SceneNode& node, const TerrainData& terrain,
                   const fs::path& path) {
  const fs::path temporary =
      path.parent_path() / fmt::format(".{}.{}{}", path.stem().string(), getpid(), path.extension().string());
  std::error_code code;
  const PaintedKind* kind = paintedKind(*node.type);
  LayerFormat format;
  if (kind) format.name = kind->name, format.unit = kind->fileUnit;
  Status status = reader.writeLayer(node.painted, format, terrain, temporary.string());
  if (status) fs::rename(temporary, path, code);
  if (status && code)
    status = Error{ErrorKind::Failed, "The painted layer could not be saved", path.string(), code.message(),
                   "Check the rights and the free space of the folder"};
  std::error_code ignored;
  if (!status) fs::remove(temporary, ignored);
  return status;
}

}  // namespace

Status checkLayer(const SceneNode& node, const PaintedLayer& layer) {
  if (std::holds_alternative<std::monostate>(layer)) return {};
  const PaintedKind* kind = paintedKind(*node.type);
  if (!kind) return unusable(node, "this node is not painted on");
  if (const auto* numbers = std::get_if<TiledRaster<std::uint8_t>>(&layer))
    return kind->numbers ? checkNumbers(node, *kind, *numbers)
                         : unusable(node, fmt::format("it holds no {}", kind->name));
  if (kind->numbers) return unusable(node, "it has no whole numbers from 0 to 255");
  return checkReals(node, *kind, std::get<TiledRaster<float>>(layer));
}

Status loadPaintedLayers(Scene& scene, const std::string& sceneFile, AssetReader& reader,
                         const PathPolicy& policy, std::vector<AssetLibrary::Issue>& issues,
                         const CancelToken& cancel) {
  for (const SceneNode& listed : scene.nodes()) {
    SceneNode& node = *scene.find(listed.id);
    const std::string source = sourceOf(node);
    if (!isPaintedType(*node.type) || source.empty() || !std::holds_alternative<std::monostate>(node.painted))
      continue;
    const Result<FoundAsset> found = findAsset(sceneFile, source, policy, {});
    Result<PaintedLayer> layer =
        found ? reader.readLayer(found->path, cancel) : Result<PaintedLayer>(found.error());
    if (cancel.cancelled())
      return Error{ErrorKind::Cancelled, "Reading the painted layers was stopped", {}, {}, {}};
    const Status status = layer ? checkLayer(node, *layer) : Status(layer.error());
    if (!status) {
      issues.push_back({node.id, status.error(), false});
      continue;
    }
    if (found->moved) issues.push_back(movedRemark(node.id, source, found->path));
    node.painted = ofKind(*paintedKind(*node.type), std::move(*layer));
  }
  return {};
}

Status savePaintedLayers(Scene& scene, const std::string& sceneFile, const TerrainData& terrain,
                         AssetReader& reader) {
  const QDir folder(QString::fromStdString(assetFolderOf(sceneFile)));
  for (const SceneNode& listed : scene.nodes()) {
    SceneNode& node = *scene.find(listed.id);
    const PropertyInfo* source = node.type->find("source");
    if (std::holds_alternative<std::monostate>(node.painted) || !source) continue;
    if (!folder.mkpath(QStringLiteral(".")))
      return Error{ErrorKind::Failed, "The painted layers could not be saved", folder.path().toStdString(),
                   "the folder cannot be made", "Check the rights of the scene's folder"};
    const bool types = std::holds_alternative<TiledRaster<std::uint8_t>>(node.painted);
    const std::string path =
        folder.filePath(QString::fromStdString(node.id + (types ? ".png" : ".tif"))).toStdString();
    if (Status status = writeSafely(reader, node, terrain, path); !status) return status;
    setPlainValue(node, *source, storedAssetPath(sceneFile, path));
  }
  return {};
}

}  // namespace spin
