// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/issues_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeView>
#include <QVBoxLayout>

#include "editor/document/scene_document.h"
#include "editor/models/issue_model.h"

namespace spin {

IssuesPanel::IssuesPanel(SceneDocument* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new IssueModel(document, this)),
      m_view(new QTreeView(this)),
      m_empty(new QLabel(tr("No issues"))) {
  setObjectName(QStringLiteral("issues"));
  m_view->setObjectName(QStringLiteral("issuesView"));
  m_view->setModel(m_model);
  m_view->setRootIsDecorated(false);
  m_view->setUniformRowHeights(true);
  m_view->header()->setSectionResizeMode(IssueModel::NodeColumn, QHeaderView::ResizeToContents);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_view);
  m_empty->setObjectName(QStringLiteral("noIssues"));
  m_empty->setEnabled(false);
  m_empty->setAlignment(Qt::AlignCenter);
  auto* inside = new QVBoxLayout(m_view->viewport());
  inside->addWidget(m_empty);
  connect(m_model, &QAbstractItemModel::modelReset, this, &IssuesPanel::showWhetherEmpty);
  showWhetherEmpty();
  connect(m_view, &QTreeView::activated, this, &IssuesPanel::jumpTo);
  connect(m_view, &QTreeView::doubleClicked, this, &IssuesPanel::jumpTo);
}

void IssuesPanel::showWhetherEmpty() {
  m_empty->setVisible(m_model->rowCount() == 0);
}

void IssuesPanel::jumpTo(const QModelIndex& index) {
  const DocumentIssue* issue = m_model->issueAt(index);
  if (issue && !issue->node.empty())
    m_document->reveal(std::string(issue->node), std::string(issue->property));
}

}  // namespace spin
