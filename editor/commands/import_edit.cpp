// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>
#include <QFileInfo>

#include "core/nodes/terrain_node.h"
#include "editor/commands/edits.h"
#include "editor/commands/node_commands.h"

namespace spin::edit {
namespace {

/// Makes the file usable in this scene; an Error where that cannot be.
Status permit(SceneDocument& document, const QFileInfo& file, const std::string& stored, bool copyOnSave) {
  const std::string scene = document.path().toStdString();
  if (resolveAssetPath(scene, stored, {})) return {};
  if (copyOnSave)
    document.copyOnSave(file.absoluteFilePath());
  else if (!resolveAssetPath(scene, stored, document.pathPolicy()))
    document.allowFolder(file.absolutePath());
  const Result<std::string> usable = resolveAssetPath(scene, stored, document.pathPolicy());
  return usable ? Status() : Status(usable.error());
}

/// The settings of the cover are none of the file's.
bool staysWithTheTerrain(const std::string& property) {
  return property == "cover_detail_cell_m" || property == "cover_detail_margin_m";
}

Status replaceTerrain(SceneDocument& document, const std::string& id, const SceneNode& fresh) {
  PropertyValues values;
  for (const PropertyRow& row : fresh.type->properties)
    if (!staysWithTheTerrain(row.id)) values.emplace_back(row.id, plainValue(fresh, row));
  if (Status status = setValues(document, id, values); !status) return status;
  if (Status status = setNodeEnabled(document, id, true); !status) return status;
  return renameNode(document, id, QString::fromStdString(fresh.name));
}

void addNodeAsItIs(SceneDocument& document, const SceneNode& node) {
  const QString text = QCoreApplication::translate("Edits", "Add %1").arg(QString::fromStdString(node.name));
  document.undoStack()->push(new AddNode(document, node, document.scene().nodes().size(), text));
}

Status setUp(SceneDocument& document, const SceneSetUp& wanted) {
  for (const SceneSetUp::Change& change : wanted.changes)
    if (Status status = setValue(document, change.node, change.property, change.value); !status)
      return status;
  for (SceneNode node : wanted.added) {
    node.name = QCoreApplication::translate("Properties", node.type->label).toStdString();
    addNodeAsItIs(document, node);
  }
  return {};
}

Status addImported(SceneDocument& document, const SceneNode& node, const AssetDetails& details) {
  if (node.as<TerrainNode>()) {
    if (Status status = setUp(document, snowSetUp(document.scene())); !status) return status;
    const SceneSetUp camera = details.view ? cameraSetUp(document.scene(), *details.view) : SceneSetUp();
    if (Status status = setUp(document, camera); !status) return status;
  }
  addNodeAsItIs(document, node);
  return {};
}

}  // namespace

Result<std::string> addAssetNode(SceneDocument& document, const NodeType& type, const QString& file,
                                 const AssetDetails& details) {
  const QFileInfo info(file);
  const std::string stored = document.storedPath(info.absoluteFilePath());
  SceneNode node = importedNode(document.scene(), type, stored, {}, details.options);
  setProperty(node, "source", stored);
  if (node.as<TerrainNode>()) setProperty(node, "credit", details.credit);
  if (node.as<ModelNode>() && details.position) setProperty(node, "position_m", *details.position);
  if (Status valid = checkProperties(node); !valid) return valid.error();
  if (Status usable = permit(document, info, stored, details.copyOnSave); !usable) return usable.error();
  const SceneNode* taken = type.single ? document.scene().firstOf(type) : nullptr;
  const std::string id = taken ? taken->id : node.id;
  document.undoStack()->beginMacro(
      QCoreApplication::translate("Edits", "Import %1").arg(QString::fromStdString(node.name)));
  const Status status = taken ? replaceTerrain(document, id, node) : addImported(document, node, details);
  document.undoStack()->endMacro();
  if (!status) return status.error();
  document.select(id);
  return id;
}

}  // namespace spin::edit
