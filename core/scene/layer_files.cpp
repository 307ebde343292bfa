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
#include "core/scene/asset_file.h"
#include "core/scene/collect_files.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

constexpr float kColdest = 100.0f, kHottest = 400.0f;

Status unusable(const SceneNode& node, std::string why) {
  return badInput("The painted layer is unusable", node.id, std::move(why),
                  "Choose another file or paint anew");
}

template <class T, class Good>
bool everyCell(const TiledRaster<T>& layer, const Good& good, T& bad) {
  for (int j = 0; j < layer.height(); ++j)
    for (int i = 0; i < layer.width(); ++i)
      if (bad = layer.at(i, j); !good(bad)) return false;
  return true;
}

/// Writes through a temporary file of the same ending in the same folder.
Status writeSafely(AssetReader& reader, const PaintedLayer& layer, const TerrainData& terrain,
                   const fs::path& path) {
  const fs::path temporary =
      path.parent_path() / fmt::format(".{}.{}{}", path.stem().string(), getpid(), path.extension().string());
  std::error_code code;
  Status status = reader.writeLayer(layer, terrain, temporary.string());
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
  if (node.as<GroundTypeLayerNode>()) {
    const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&layer);
    if (!types) return unusable(node, "it has no whole numbers from 0 to 255");
    std::uint8_t bad = 0;
    const auto good = [](std::uint8_t v) { return v < kGroundTypeCount || v == kUnpaintedGround; };
    if (!everyCell(*types, good, bad))
      return unusable(node, fmt::format("{} is the number of no ground type", bad));
    return {};
  }
  if (node.as<GroundTemperatureLayerNode>()) {
    const auto* kelvin = std::get_if<TiledRaster<float>>(&layer);
    if (!kelvin) return unusable(node, "it has no temperatures");
    float bad = 0.0f;
    const auto good = [](float v) { return std::isnan(v) || (v >= kColdest && v <= kHottest); };
    if (!everyCell(*kelvin, good, bad))
      return unusable(node, fmt::format("{} K is no temperature of the ground", bad));
    return {};
  }
  if (node.as<AvalancheReleaseNode>()) {
    const auto* area = std::get_if<TiledRaster<std::uint8_t>>(&layer);
    if (!area) return unusable(node, "it has no whole numbers from 0 to 255");
    std::uint8_t bad = 0;
    const auto good = [](std::uint8_t v) { return v == kReleasePainted || v == kReleaseUnpainted; };
    if (!everyCell(*area, good, bad))
      return unusable(node, fmt::format("{} is neither {} (released) nor {} (not painted)", bad,
                                        kReleasePainted, kReleaseUnpainted));
    return {};
  }
  return unusable(node, "this node is not painted on");
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
    node.painted = std::move(*layer);
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
    if (Status status = writeSafely(reader, node.painted, terrain, path); !status) return status;
    setPlainValue(node, *source, storedAssetPath(sceneFile, path));
  }
  return {};
}

}  // namespace spin
