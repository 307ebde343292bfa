// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/commands/node_commands.h"

#include "editor/document/edit_access.h"

namespace spin {
namespace {

std::size_t positionOf(const Scene& scene, const std::string& id) {
  for (std::size_t i = 0; i < scene.nodes().size(); ++i)
    if (scene.nodes()[i].id == id) return i;
  SPIN_CHECK(false, "no node " + id);
}

void insert(SceneDocument& document, const SceneNode& node, std::size_t position) {
  const Status status = EditAccess::scene(document).insert(node, position);
  SPIN_CHECK(status.ok(), status.error().text());
  EditAccess::notify(document, {ChangeKind::Added, node.id, {}, Affects::Both});
}

void remove(SceneDocument& document, const std::string& id) {
  const bool removed = EditAccess::scene(document).remove(id);
  SPIN_CHECK(removed, "no node " + id);
  EditAccess::notify(document, {ChangeKind::Removed, id, {}, Affects::Both});
}

}  // namespace

AddNode::AddNode(SceneDocument& document, SceneNode node, std::size_t position, const QString& text)
    : QUndoCommand(text), m_document(document), m_node(std::move(node)), m_position(position) {}

void AddNode::undo() {
  remove(m_document, m_node.id);
}

void AddNode::redo() {
  insert(m_document, m_node, m_position);
}

RemoveNode::RemoveNode(SceneDocument& document, const std::string& node, const QString& text)
    : QUndoCommand(text),
      m_document(document),
      m_node(*document.node(node)),
      m_position(positionOf(document.scene(), node)) {}

void RemoveNode::undo() {
  insert(m_document, m_node, m_position);
}

void RemoveNode::redo() {
  // Painted layers arrive from a thread without an undo step, so the node is taken as it is now.
  m_node = *m_document.node(m_node.id);
  remove(m_document, m_node.id);
}

MoveNode::MoveNode(SceneDocument& document, std::size_t from, std::size_t to, const QString& text)
    : QUndoCommand(text), m_document(document), m_from(from), m_to(to) {}

void MoveNode::undo() {
  move(m_to, m_from);
}

void MoveNode::redo() {
  move(m_from, m_to);
}

void MoveNode::move(std::size_t from, std::size_t to) {
  EditAccess::scene(m_document).move(from, to);
  EditAccess::notify(m_document, {ChangeKind::Moved, {}, {}, Affects::Both});
}

template <class T>
ChangeMember<T>::ChangeMember(SceneDocument& document, std::string node, T SceneNode::*member, T after,
                              ChangeKind kind, const QString& text)
    : QUndoCommand(text),
      m_document(document),
      m_node(std::move(node)),
      m_member(member),
      m_other(std::move(after)),
      m_kind(kind) {}

template <class T>
void ChangeMember<T>::swap() {
  SceneNode* node = EditAccess::scene(m_document).find(m_node);
  SPIN_CHECK(node, "no node " + m_node);
  std::swap(node->*m_member, m_other);
  const Affects affects = m_kind == ChangeKind::Renamed ? Affects::Nothing : Affects::Both;
  EditAccess::notify(m_document, {m_kind, m_node, {}, affects});
}

template class ChangeMember<std::string>;
template class ChangeMember<bool>;

}  // namespace spin
