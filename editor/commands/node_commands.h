// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>
#include <string>

#include "core/property/scene_node.h"
#include "editor/document/scene_document.h"

namespace spin {

/// Adds a node at a position, and takes it away on undo.
class AddNode : public QUndoCommand {
 public:
  AddNode(SceneDocument& document, SceneNode node, std::size_t position, const QString& text);
  void undo() override;
  void redo() override;

 private:
  SceneDocument& m_document;
  SceneNode m_node;
  std::size_t m_position;
};

/// Takes a node away; undo brings it back with everything it held.
class RemoveNode : public QUndoCommand {
 public:
  RemoveNode(SceneDocument& document, const std::string& node, const QString& text);
  void undo() override;
  void redo() override;

 private:
  SceneDocument& m_document;
  SceneNode m_node;
  std::size_t m_position;
};

class MoveNode : public QUndoCommand {
 public:
  MoveNode(SceneDocument& document, std::size_t from, std::size_t to, const QString& text);
  void undo() override;
  void redo() override;

 private:
  void move(std::size_t from, std::size_t to);

  SceneDocument& m_document;
  std::size_t m_from, m_to;
};

/// Changes what a node carries besides its properties: the name or whether it is enabled.
template <class T>
class ChangeMember : public QUndoCommand {
 public:
  ChangeMember(SceneDocument& document, std::string node, T SceneNode::*member, T after, ChangeKind kind,
               const QString& text);
  void undo() override { swap(); }
  void redo() override { swap(); }

 private:
  void swap();

  SceneDocument& m_document;
  std::string m_node;
  T SceneNode::*m_member;
  T m_other;  ///< the value the node does not have at the moment
  ChangeKind m_kind;
};
extern template class ChangeMember<std::string>;
extern template class ChangeMember<bool>;

}  // namespace spin
