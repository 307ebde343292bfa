// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <functional>

#include "core/property/scene_node.h"

class QMenu;
class QToolButton;
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
  /// Fills a menu with "add" actions for all types of nodes; also for the main window's menu.
  void fillAddMenu(QMenu* menu);
  void removeSelected();
  /// Adds a node where the user asked for one; null = with defaults.
  std::function<void(const NodeType& type)> addNode;
  /// Adds to the menu of a node what else can be done with it; may be null. The node is selected.
  std::function<void(QMenu* menu, const SceneNode& node)> extendMenu;
  /// Fills the menu of a node.
  void fillNodeMenu(QMenu* menu, const std::string& id);

 Q_SIGNALS:
  /// An edit was refused; for the status bar.
  void editRefused(const QString& message);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showMenu(const QPoint& position);
  void followDocument();
  void followView();
  void retranslate();

  SceneDocument* m_document;
  NodeListModel* m_model;
  QTreeView* m_view;
  QToolButton* m_add;
};

}  // namespace spin
