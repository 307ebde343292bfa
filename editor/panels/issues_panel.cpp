// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/issues_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/document/scene_document.h"
#include "editor/models/issue_model.h"

namespace spin {
namespace {

/// As many lines as the text takes in its column: what is wrong and what helps is read without pointing at
/// it.
class WrappedText : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const QSize plain = QStyledItemDelegate::sizeHint(option, index);
    const auto* view = qobject_cast<const QTreeView*>(parent());
    if (!view) return plain;
    const int margin = 2 * (view->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, view) + 1);
    const int width = std::max(view->columnWidth(index.column()) - margin, 40);
    const QString text = index.data(Qt::DisplayRole).toString();
    const QRect needed = option.fontMetrics.boundingRect(QRect(0, 0, width, 100000), Qt::TextWordWrap, text);
    return {plain.width(), std::max(plain.height(), needed.height() + 4)};
  }
};

}  // namespace

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
  m_view->setWordWrap(true);
  m_view->setItemDelegateForColumn(IssueModel::TextColumn, new WrappedText(m_view));
  connect(m_view->header(), &QHeaderView::sectionResized, m_view, &QTreeView::doItemsLayout);
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
