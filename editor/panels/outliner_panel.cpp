// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/outliner_panel.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QShortcut>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/nodes/node_registry.h"
#include "editor/commands/edits.h"
#include "editor/models/node_icons.h"
#include "editor/models/node_list_model.h"

namespace spin {

OutlinerPanel::OutlinerPanel(SceneDocument* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new NodeListModel(document, this)),
      m_view(new QTreeView(this)),
      m_add(new QToolButton(this)) {
  setObjectName(QStringLiteral("outliner"));
  m_view->setObjectName(QStringLiteral("outlinerView"));
  m_view->setModel(m_model);
  m_view->setHeaderHidden(true);
  m_view->setRootIsDecorated(false);
  m_view->setUniformRowHeights(true);
  m_view->setDragDropMode(QAbstractItemView::InternalMove);
  m_view->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  m_view->setContextMenuPolicy(Qt::CustomContextMenu);
  m_add->setObjectName(QStringLiteral("addNode"));
  m_add->setPopupMode(QToolButton::InstantPopup);
  m_add->setMenu(new QMenu(m_add));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_add);
  layout->addWidget(m_view);

  auto* remove = new QShortcut(QKeySequence::Delete, m_view);
  remove->setContext(Qt::WidgetShortcut);
  connect(remove, &QShortcut::activated, this, &OutlinerPanel::removeSelected);
  connect(m_add->menu(), &QMenu::aboutToShow, this, [this] { fillAddMenu(m_add->menu()); });
  connect(m_view, &QWidget::customContextMenuRequested, this, &OutlinerPanel::showMenu);
  connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, &OutlinerPanel::followView);
  connect(m_document, &SceneDocument::selectionChanged, this, &OutlinerPanel::followDocument);
  followDocument();
  retranslate();
}

void OutlinerPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void OutlinerPanel::retranslate() {
  m_add->setText(tr("Add"));
  m_add->setToolTip(tr("Add a node to the scene"));
}

/// A type of which a scene has one at most is offered only while there is none.
void OutlinerPanel::fillAddMenu(QMenu* menu) {
  menu->clear();
  menu->setToolTipsVisible(true);
  for (const NodeType* type : nodeTypes()) {
    QAction* action =
        menu->addAction(nodeIcon(*type), QCoreApplication::translate("Properties", type->label));
    action->setObjectName(QStringLiteral("add_") + QString::fromUtf8(type->id));
    action->setToolTip(QCoreApplication::translate("Properties", type->doc));
    action->setEnabled(!type->single || !m_document->scene().firstOf(*type));
    if (!action->isEnabled()) action->setToolTip(tr("The scene has one already"));
    connect(action, &QAction::triggered, this, [this, type] {
      if (addNode) return addNode(*type);
      if (auto added = edit::addNode(*m_document, *type, {}); !added)
        Q_EMIT editRefused(QString::fromStdString(added.error().text()));
    });
  }
}

void OutlinerPanel::showMenu(const QPoint& position) {
  const std::string id = m_model->idAt(m_view->indexAt(position));
  if (!id.empty()) m_document->select(id);
  QMenu menu(this);
  menu.setObjectName(QStringLiteral("outlinerMenu"));
  fillNodeMenu(&menu, id);
  fillAddMenu(menu.addMenu(tr("Add")));
  menu.exec(m_view->viewport()->mapToGlobal(position));
}

void OutlinerPanel::fillNodeMenu(QMenu* menu, const std::string& id) {
  const SceneNode* node = m_document->node(id);
  if (!node) return;
  menu->addAction(tr("Rename"), this, [this, id] { m_view->edit(m_model->indexOf(id)); });
  QAction* copy = menu->addAction(tr("Duplicate"), this, [this, id] {
    if (auto copied = edit::duplicateNode(*m_document, id); !copied)
      Q_EMIT editRefused(QString::fromStdString(copied.error().text()));
  });
  copy->setEnabled(!node->type->single);
  menu->addAction(tr("Remove"), this, &OutlinerPanel::removeSelected);
  menu->addSeparator();
  if (extendMenu) extendMenu(menu, *node);
}

void OutlinerPanel::removeSelected() {
  const std::string id = m_document->selected();
  if (id.empty()) return;
  if (Status status = edit::removeNode(*m_document, id); !status)
    Q_EMIT editRefused(QString::fromStdString(status.error().text()));
}

void OutlinerPanel::followDocument() {
  const QModelIndex index = m_model->indexOf(m_document->selected());
  if (m_view->currentIndex() != index) m_view->setCurrentIndex(index);
}

void OutlinerPanel::followView() {
  m_document->select(m_model->idAt(m_view->currentIndex()));
}

}  // namespace spin
