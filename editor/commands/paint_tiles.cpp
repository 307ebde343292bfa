// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/commands/paint_tiles.h"

#include <cstring>

#include "editor/commands/command_ids.h"
#include "editor/document/edit_access.h"

namespace spin {
namespace {

/// By bytes, so that NaN (not painted) equals NaN.
template <class T>
bool sameTile(const T& a, const T& b) {
  return a == b || std::memcmp(a->data(), b->data(), sizeof *a) == 0;
}

}  // namespace

template <class T>
TileDiff<T> TileDiff<T>::between(const TiledRaster<T>* before, const TiledRaster<T>& after) {
  TileDiff diff;
  diff.blank = TiledRaster<T>(after.width(), after.height(), before ? before->fill() : after.fill());
  diff.created = before == nullptr;
  const TiledRaster<T>& old = before ? *before : diff.blank;
  for (std::size_t t = 0; t < after.tileCount(); ++t)
    if (!sameTile(old.tile(t), after.tile(t))) diff.tiles[t] = {old.tile(t), after.tile(t)};
  return diff;
}

template <class T>
void TileDiff<T>::merge(const TileDiff& next) {
  for (const auto& [index, change] : next.tiles) {
    const auto [known, fresh] = tiles.try_emplace(index, change);
    if (!fresh) known->second.second = change.second;
  }
}

template <class T>
PaintedLayer TileDiff<T>::undone(const PaintedLayer& layer) const {
  if (created) return std::monostate{};
  TiledRaster<T> raster = std::get<TiledRaster<T>>(layer);
  for (const auto& [index, change] : tiles) raster.setTile(index, change.first);
  return raster;
}

template <class T>
PaintedLayer TileDiff<T>::redone(const PaintedLayer& layer) const {
  TiledRaster<T> raster = created ? blank : std::get<TiledRaster<T>>(layer);
  for (const auto& [index, change] : tiles) raster.setTile(index, change.second);
  return raster;
}

template struct TileDiff<std::uint8_t>;
template struct TileDiff<float>;

PaintTiles::PaintTiles(SceneDocument& document, std::string node, Diff diff, edit::Session session,
                       const QString& text)
    : QUndoCommand(text),
      m_document(document),
      m_node(std::move(node)),
      m_diff(std::move(diff)),
      m_session(session) {}

int PaintTiles::id() const {
  return m_session != 0 ? kPaintTilesId : -1;
}

bool PaintTiles::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const PaintTiles*>(other);
  if (!next || next->m_session != m_session || next->m_node != m_node) return false;
  if (next->m_diff.index() != m_diff.index()) return false;
  std::visit([&](auto& diff) { diff.merge(std::get<std::decay_t<decltype(diff)>>(next->m_diff)); }, m_diff);
  return true;
}

void PaintTiles::undo() {
  apply(false);
}

void PaintTiles::redo() {
  apply(true);
}

std::size_t PaintTiles::tileCount() const {
  return std::visit([](const auto& diff) { return diff.tiles.size(); }, m_diff);
}

void PaintTiles::apply(bool redo) {
  SceneNode* node = EditAccess::scene(m_document).find(m_node);
  SPIN_CHECK(node, "stroke on a node that is not there: " + m_node);
  node->painted = std::visit(
      [&](const auto& diff) { return redo ? diff.redone(node->painted) : diff.undone(node->painted); },
      m_diff);
  EditAccess::notify(m_document, {ChangeKind::Painted, m_node, {}, Affects::Both});
}

}  // namespace spin
