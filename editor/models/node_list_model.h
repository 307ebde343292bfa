// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractListModel>
#include <string>
#include <vector>

#include "editor/document/scene_document.h"

namespace spin {

/// The scene's nodes in their order. The name is editable, the check box switches the node on and off, rows
/// can be dragged to another place; every change goes through an undo step.
class NodeListModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { IdRole = Qt::UserRole + 1, TypeRole };

  explicit NodeListModel(SceneDocument* document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
  QStringList mimeTypes() const override;
  QMimeData* mimeData(const QModelIndexList& indexes) const override;
  bool dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                    const QModelIndex& parent) override;

  /// Invalid where there is no such node.
  QModelIndex indexOf(const std::string& id) const;
  std::string idAt(const QModelIndex& index) const;

 private:
  void follow(const ChangeEvent& event);
  void insertId(const std::string& id);
  void removeId(const std::string& id);
  void moveId();

  SceneDocument* m_document;
  std::vector<std::string> m_ids;  ///< as last told to the views
};

}  // namespace spin
