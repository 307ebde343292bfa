// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/property_panel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "core/nodes/terrain_node.h"
#include "editor/document/scene_document.h"
#include "editor/document/time_context.h"
#include "editor/models/node_icons.h"
#include "editor/panels/property_row_editor.h"

namespace spin {

PropertyPanel::PropertyPanel(SceneDocument* document, TimeContext* time, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_time(time),
      m_title(new QLabel(this)),
      m_scroll(new QScrollArea(this)) {
  setObjectName(QStringLiteral("properties"));
  m_title->setObjectName(QStringLiteral("title"));
  m_title->setTextFormat(Qt::PlainText);
  m_scroll->setWidgetResizable(true);
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_title);
  layout->addWidget(m_scroll, 1);
  connect(document, &SceneDocument::selectionChanged, this, &PropertyPanel::showNode);
  connect(document, &SceneDocument::changed, this, &PropertyPanel::follow);
  connect(document, &SceneDocument::revealRequested, this, &PropertyPanel::revealProperty);
  connect(time, &TimeContext::frameChanged, this, &PropertyPanel::refreshRows);
  showNode(document->selected());
}

PropertyPanel::~PropertyPanel() = default;

PropertyRowEditor* PropertyPanel::row(const std::string& property) const {
  for (PropertyRowEditor* row : m_rows)
    if (property == row->property().id) return row;
  return nullptr;
}

void PropertyPanel::showNode(const std::string& id) {
  m_node = id;
  m_rows.clear();
  auto* page = new QWidget;
  auto* layout = new QVBoxLayout(page);
  const SceneNode* node = m_document->node(id);
  if (node) {
    for (const PropertyRow& property : node->type->properties) {
      auto* row = new PropertyRowEditor(m_document, m_time, id, property, page);
      connect(row, &PropertyRowEditor::editRefused, this, &PropertyPanel::editRefused);
      connect(row, &PropertyRowEditor::entered, this, &PropertyPanel::entered);
      layout->addWidget(row);
      m_rows.push_back(row);
    }
  }
  if (node && node->as<ModelNode>()) {
    auto* body = new QPushButton(tr("Make rigid body"), page);
    body->setObjectName(QStringLiteral("makeRigidBody"));
    body->setToolTip(tr("Make this model solid for avalanches and water, or show the body that does so"));
    // A copy: what answers selects another node.
    connect(body, &QPushButton::clicked, this, [this] { Q_EMIT bodyWanted(std::string(m_node)); });
    layout->addWidget(body);
  }
  layout->addStretch(1);
  // An edit may come from one of the rows that go now (undo by a shortcut in a spin box).
  if (QWidget* old = m_scroll->takeWidget()) old->deleteLater();
  m_scroll->setWidget(page);
  // Rows are read across, so the panel never gets narrower than they are; and it does not change its width,
  // and with it the view's, when another node is selected.
  const int wanted = page->minimumSizeHint().width() + style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  m_scroll->setMinimumWidth(
      std::max({m_scroll->minimumWidth(), wanted, fontMetrics().averageCharWidth() * 60}));
  showTitle();
}

void PropertyPanel::showTitle() {
  const SceneNode* node = m_document->node(m_node);
  m_title->setText(node ? QString::fromStdString(node->name) : tr("Nothing is selected"));
  m_title->setToolTip(node ? QCoreApplication::translate("Properties", node->type->doc) : QString());
}

void PropertyPanel::follow(const ChangeEvent& event) {
  if (event.kind == ChangeKind::Property && event.node == m_node) {
    if (PropertyRowEditor* changed = row(event.property)) changed->refresh();
  } else if (event.kind == ChangeKind::Renamed && event.node == m_node) {
    showTitle();
  } else if (event.kind == ChangeKind::Property) {
    // Another frame rate shows other times at the same frame.
    refreshRows();
  }
}

void PropertyPanel::refreshRows() {
  for (PropertyRowEditor* row : m_rows)
    if (row->keyState() > PropertyRowEditor::KeyState::NoKeys) row->refresh();
}

void PropertyPanel::revealProperty(const std::string& node, const std::string& property) {
  if (node != m_node) return;
  PropertyRowEditor* shown = row(property);
  if (!shown) return;
  m_scroll->ensureWidgetVisible(shown);
  if (auto* editor = shown->findChild<QWidget*>(QStringLiteral("editor"))) editor->setFocus();
}

void PropertyPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) showNode(std::string(m_node));
  QWidget::changeEvent(event);
}

}  // namespace spin
