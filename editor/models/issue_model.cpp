// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/models/issue_model.h"

#include <QApplication>
#include <QStyle>

#include "editor/document/scene_document.h"

namespace spin {
namespace {

QIcon severityIcon(Severity severity) {
  switch (severity) {
    case Severity::Information:
      return QApplication::style()->standardIcon(QStyle::SP_MessageBoxInformation);
    case Severity::Warning:
      return QApplication::style()->standardIcon(QStyle::SP_MessageBoxWarning);
    case Severity::Error:
      return QApplication::style()->standardIcon(QStyle::SP_MessageBoxCritical);
  }
  return {};
}

}  // namespace

IssueModel::IssueModel(SceneDocument* document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document), m_issues(document->issues()) {
  connect(document, &SceneDocument::issuesChanged, this, &IssueModel::takeOver);
}

int IssueModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_issues.size());
}

int IssueModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(ColumnCount);
}

const DocumentIssue* IssueModel::issueAt(const QModelIndex& index) const {
  const bool known = index.isValid() && index.row() < rowCount();
  return known ? &m_issues[static_cast<std::size_t>(index.row())] : nullptr;
}

QVariant IssueModel::data(const QModelIndex& index, int role) const {
  const DocumentIssue* issue = issueAt(index);
  if (!issue) return {};
  if (role == Qt::ToolTipRole) return issue->text;
  if (index.column() == NodeColumn && role == Qt::DecorationRole) return severityIcon(issue->severity);
  if (role != Qt::DisplayRole) return {};
  if (index.column() == TextColumn) return issue->text;
  const SceneNode* node = m_document->node(issue->node);
  return node ? QString::fromStdString(node->name) : tr("Scene");
}

QVariant IssueModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return section == NodeColumn ? tr("Node") : tr("Issue");
}

void IssueModel::takeOver() {
  beginResetModel();
  m_issues = m_document->issues();
  endResetModel();
}

}  // namespace spin
