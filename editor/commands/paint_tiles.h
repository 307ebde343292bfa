// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include "core/property/scene_node.h"
#include "editor/commands/edits.h"

namespace spin {

/// What a stroke changed of a painted raster: the touched tiles, before and after.
template <class T>
struct TileDiff {
  using TilePointer = typename TiledRaster<T>::TilePointer;

  TiledRaster<T> blank;  ///< size and fill, all tiles shared
  bool created = false;  ///< nothing was painted before
  std::map<std::size_t, std::pair<TilePointer, TilePointer>> tiles;

  /// `before` is null where nothing was painted; otherwise both have one size.
  static TileDiff between(const TiledRaster<T>* before, const TiledRaster<T>& after);
  void merge(const TileDiff& next);
  bool empty() const { return tiles.empty(); }
  PaintedLayer undone(const PaintedLayer& layer) const;
  PaintedLayer redone(const PaintedLayer& layer) const;
};

extern template struct TileDiff<std::uint8_t>;
extern template struct TileDiff<float>;

/// One stroke of a brush. Keeps only the tiles that changed; the steps of one stroke merge.
class PaintTiles : public QUndoCommand {
 public:
  using Diff = std::variant<TileDiff<std::uint8_t>, TileDiff<float>>;

  PaintTiles(SceneDocument& document, std::string node, Diff diff, edit::Session session,
             const QString& text);

  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override;
  void redo() override;
  std::size_t tileCount() const;

 private:
  void apply(bool redo);

  SceneDocument& m_document;
  std::string m_node;
  Diff m_diff;
  edit::Session m_session;
};

}  // namespace spin
