// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "editor/document/document_issue.h"

namespace spin {

class SceneDocument;

/// The document's issues, gravest first: node and text.
class IssueModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { NodeColumn, TextColumn, ColumnCount };

  explicit IssueModel(SceneDocument* document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  /// nullptr for an invalid index.
  const DocumentIssue* issueAt(const QModelIndex& index) const;

 private:
  void takeOver();

  SceneDocument* m_document;
  std::vector<DocumentIssue> m_issues;
};

}  // namespace spin
