// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;
class QTreeView;

namespace spin {

class IssueModel;
class SceneDocument;

/// What is wrong with the scene; a double click jumps to the node and its property.
class IssuesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit IssuesPanel(SceneDocument* document, QWidget* parent = nullptr);

  QTreeView* view() const { return m_view; }

 private:
  void jumpTo(const QModelIndex& index);
  void showWhetherEmpty();

  SceneDocument* m_document;
  IssueModel* m_model;
  QTreeView* m_view;
  QLabel* m_empty;  ///< in place of rows
};

}  // namespace spin
