// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QTreeView;

namespace spin {

class NodeListModel;
class SceneDocument;

/// The scene's nodes: select, rename, switch on and off, drag to another place, add and remove.
class OutlinerPanel : public QWidget {
  Q_OBJECT
 public:
  explicit OutlinerPanel(SceneDocument* document, QWidget* parent = nullptr);

  QTreeView* view() const { return m_view; }

 Q_SIGNALS:
  /// Double click on a node: the viewport may frame it.
  void nodeActivated(const std::string& id);

 private:
  void showMenu(const QPoint& position);
  void removeSelected();
  void followDocument();
  void followView();

  SceneDocument* m_document;
  NodeListModel* m_model;
  QTreeView* m_view;
};

}  // namespace spin
