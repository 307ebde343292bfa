// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>

#include "editor/commands/edits.h"
#include "editor/commands/paint_tiles.h"

namespace spin::edit {
namespace {

Error notPainted(const std::string& node, const char* why) {
  return Error{ErrorKind::Failed, "The layer cannot be painted", node, why, {}};
}

template <class T>
Result<PaintTiles::Diff> diffOf(const SceneNode& node, const TiledRaster<T>& after) {
  const auto* before = std::get_if<TiledRaster<T>>(&node.painted);
  if (!before && !std::holds_alternative<std::monostate>(node.painted))
    return notPainted(node.id, "the node holds another kind of layer");
  if (before && (before->width() != after.width() || before->height() != after.height()))
    return notPainted(node.id, "its size differs from the one there is");
  // A blank layer has no tiles to look at, but may be of the wrong kind.
  if (Status status = checkLayer(node, TiledRaster<T>(1, 1, after.fill())); !status) return status.error();
  auto diff = TileDiff<T>::between(before, after);
  // Only what changed is looked at: a stroke calls this for every move of the pointer.
  for (const auto& [index, change] : diff.tiles) {
    TiledRaster<T> tile(TiledRaster<T>::kTile, TiledRaster<T>::kTile, T{});
    tile.setTile(0, change.second);
    if (Status status = checkLayer(node, tile); !status) return status.error();
  }
  return PaintTiles::Diff(std::move(diff));
}

}  // namespace

Status paint(SceneDocument& document, const std::string& id, const PaintedLayer& layer, Session session) {
  const SceneNode* node = document.node(id);
  if (!node) return notPainted(id, "the node is not in the scene");
  if (document.isLoadingLayers()) return notPainted(id, "its painted file is still being read");
  Result<PaintTiles::Diff> diff = notPainted(id, "nothing is painted");
  if (const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&layer)) diff = diffOf(*node, *types);
  if (const auto* kelvin = std::get_if<TiledRaster<float>>(&layer)) diff = diffOf(*node, *kelvin);
  if (!diff) return diff.error();
  if (std::visit([](const auto& d) { return d.empty(); }, *diff)) return {};
  const QString text =
      QCoreApplication::translate("Edits", "Paint %1").arg(QString::fromStdString(node->name));
  document.undoStack()->push(new PaintTiles(document, id, std::move(*diff), session, text));
  return {};
}

}  // namespace spin::edit
