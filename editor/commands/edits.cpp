// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/commands/edits.h"

#include <QCoreApplication>
#include <atomic>

#include "core/property/text_check.h"
#include "editor/commands/node_commands.h"

namespace spin::edit {
namespace {

constexpr qsizetype kMaxNameBytes = 256;

QString tr(const char* text) {
  return QCoreApplication::translate("Edits", text);
}

Error noNode(const std::string& node) {
  return Error{ErrorKind::Failed, "The node cannot be changed", node, "it is not in the scene", {}};
}

SceneNode copyOf(const Scene& scene, const NodeType& type, const QString& name, const std::string& idWish) {
  const std::string shown = name.isEmpty() ? type.label : name.toStdString();
  return makeNode(type, scene.freeId(idWish.empty() ? type.id : idWish), shown);
}

Status checkName(const QString& name) {
  const std::string text = name.toStdString();
  if (name.trimmed().isEmpty() || text.size() > kMaxNameBytes || !isCleanText(text))
    return Error{ErrorKind::Usage,
                 "The name is not usable",
                 {},
                 "it is empty, too long or has control characters",
                 {}};
  return {};
}

Status push(SceneDocument& document, const SceneNode& node) {
  const SceneNode* taken = node.type->single ? document.scene().firstOf(*node.type) : nullptr;
  if (taken)
    return Error{ErrorKind::Failed, "The node cannot be added", taken->id,
                 "a scene has only one of this type", "Change the one that is there"};
  const QString text = QCoreApplication::translate("Edits", "Add %1").arg(QString::fromStdString(node.name));
  document.undoStack()->push(new AddNode(document, node, document.scene().nodes().size(), text));
  document.select(node.id);
  return {};
}

}  // namespace

Session newSession() {
  static std::atomic<Session> last{0};
  return ++last;
}

Result<std::string> addNode(SceneDocument& document, const NodeType& type, const QString& name,
                            const std::string& idWish) {
  const SceneNode node = copyOf(document.scene(), type, name, idWish);
  if (Status status = checkName(QString::fromStdString(node.name)); !status) return status.error();
  if (Status status = push(document, node); !status) return status.error();
  return node.id;
}

Result<std::string> duplicateNode(SceneDocument& document, const std::string& id) {
  const SceneNode* original = document.node(id);
  if (!original) return noNode(id);
  SceneNode copy = *original;
  copy.id = document.scene().freeId(id);
  if (Status status = push(document, copy); !status) return status.error();
  return copy.id;
}

Status removeNode(SceneDocument& document, const std::string& id) {
  const SceneNode* node = document.node(id);
  if (!node) return noNode(id);
  const QString text =
      QCoreApplication::translate("Edits", "Remove %1").arg(QString::fromStdString(node->name));
  document.undoStack()->push(new RemoveNode(document, id, text));
  return {};
}

Status moveNode(SceneDocument& document, std::size_t from, std::size_t to) {
  const std::size_t count = document.scene().nodes().size();
  if (from >= count || to >= count)
    return Error{ErrorKind::Usage, "The node cannot be moved", {}, "there is no such place", {}};
  if (from == to) return {};
  document.undoStack()->push(
      new MoveNode(document, from, to, QCoreApplication::translate("Edits", "Reorder nodes")));
  return {};
}

Status renameNode(SceneDocument& document, const std::string& id, const QString& name) {
  const SceneNode* node = document.node(id);
  if (!node) return noNode(id);
  if (Status status = checkName(name); !status) return status;
  if (name.toStdString() == node->name) return {};
  const QString text =
      QCoreApplication::translate("Edits", "Rename %1").arg(QString::fromStdString(node->name));
  document.undoStack()->push(new ChangeMember<std::string>(document, id, &SceneNode::name, name.toStdString(),
                                                           ChangeKind::Renamed, text));
  return {};
}

Status setNodeEnabled(SceneDocument& document, const std::string& id, bool enabled) {
  const SceneNode* node = document.node(id);
  if (!node) return noNode(id);
  if (enabled == node->enabled) return {};
  const char* const words =
      enabled ? QT_TRANSLATE_NOOP("Edits", "Switch on %1") : QT_TRANSLATE_NOOP("Edits", "Switch off %1");
  document.undoStack()->push(new ChangeMember<bool>(document, id, &SceneNode::enabled, enabled,
                                                    ChangeKind::Enabled,
                                                    tr(words).arg(QString::fromStdString(node->name))));
  return {};
}

}  // namespace spin::edit
