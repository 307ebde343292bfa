// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/property_row_editor.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <array>

#include "editor/document/time_context.h"
#include "editor/panels/value_editor.h"

namespace spin {
namespace {

/// Edits nearer together than this, such as steps of the mouse wheel, are one drag.
constexpr int kDragPauseMs = 700;

const AnimationCurve* curveOf(const SceneNode& node, const PropertyInfo& property) {
  const auto found = node.curves.find(property.id);
  return found != node.curves.end() && !found->second.empty() ? &found->second : nullptr;
}

}  // namespace

PropertyRowEditor::PropertyRowEditor(SceneDocument* document, TimeContext* time, std::string node,
                                     const PropertyInfo& property, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_time(time),
      m_node(std::move(node)),
      m_property(property),
      m_key(makeButton("key")),
      m_label(new QLabel(QCoreApplication::translate("Properties", property.label), this)),
      m_editor(makeValueEditor(property, document, this)),
      m_revert(makeButton("revert")) {
  setObjectName(QString::fromUtf8(property.id));
  setToolTip(QCoreApplication::translate("Properties", property.doc));
  m_label->setMinimumWidth(fontMetrics().averageCharWidth() * 18);
  m_label->setBuddy(m_editor);
  m_editor->setObjectName(QStringLiteral("editor"));
  m_revert->setText(QStringLiteral("\u21ba"));
  m_revert->setToolTip(tr("Back to the default"));
  m_key->setContextMenuPolicy(Qt::CustomContextMenu);
  m_dragEnd.setSingleShot(true);
  m_dragEnd.setInterval(kDragPauseMs);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addWidget(m_key);
  layout->addWidget(m_label);
  layout->addWidget(m_editor, 1);
  layout->addWidget(m_revert);
  connect(m_editor, &ValueEditor::edited, this, &PropertyRowEditor::edit);
  connect(m_editor, &ValueEditor::released, this, &PropertyRowEditor::endDrag);
  connect(m_editor, &ValueEditor::entered, this, &PropertyRowEditor::entered);
  connect(&m_dragEnd, &QTimer::timeout, this, &PropertyRowEditor::endDrag);
  connect(m_key, &QToolButton::clicked, this, &PropertyRowEditor::toggleKey);
  connect(m_key, &QWidget::customContextMenuRequested, this, &PropertyRowEditor::showKeyMenu);
  connect(m_revert, &QToolButton::clicked, this,
          [this] { report(edit::revert(*m_document, m_node, m_property.id)); });
  refresh();
}

/// Keeps its place while hidden, so that the editors of all rows stand in one column.
QToolButton* PropertyRowEditor::makeButton(const char* name) {
  auto* button = new QToolButton(this);
  button->setObjectName(QString::fromUtf8(name));
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  QSizePolicy policy = button->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  button->setSizePolicy(policy);
  return button;
}

void PropertyRowEditor::refresh() {
  const SceneNode* node = m_document->node(m_node);
  if (!node || !node->type->find(m_property.id)) return;
  m_editor->show(valueAt(*node, m_property, m_time->filmTime()));
  const bool isDefault =
      !curveOf(*node, m_property) && plainValue(*node, m_property) == defaultValue(*node->type, m_property);
  m_revert->setVisible(!isDefault);
  showKeyState(*node);
}

void PropertyRowEditor::showKeyState(const SceneNode& node) {
  const AnimationCurve* curve = curveOf(node, m_property);
  if (!m_property.animatable)
    m_keyState = KeyState::NotAnimatable;
  else if (!curve)
    m_keyState = KeyState::NoKeys;
  else
    m_keyState = curve->keyAt(m_time->filmTime()) ? KeyState::AtKey : KeyState::BetweenKeys;
  m_key->setVisible(m_keyState != KeyState::NotAnimatable);
  switch (m_keyState) {
    case KeyState::NotAnimatable:
      break;
    case KeyState::NoKeys:
      m_key->setText(QStringLiteral("\u25c7"));
      m_key->setToolTip(tr("Set a key: animate this property"));
      break;
    case KeyState::BetweenKeys:
      m_key->setText(QStringLiteral("\u25c8"));
      m_key->setToolTip(tr("Animated; set a key at this frame"));
      break;
    case KeyState::AtKey:
      m_key->setText(QStringLiteral("\u25c6"));
      m_key->setToolTip(tr("Remove the key at this frame"));
      break;
  }
}

void PropertyRowEditor::edit(const Value& value, bool dragging) {
  if (dragging && m_session == 0) m_session = edit::newSession();
  const edit::Session session = dragging ? m_session : 0;
  const Status status =
      edit::setValueAt(*m_document, m_node, {{m_property.id, value}}, m_time->filmTime(), session);
  if (dragging) m_dragEnd.start();
  report(status);
}

void PropertyRowEditor::endDrag() {
  m_dragEnd.stop();
  m_session = 0;
}

void PropertyRowEditor::toggleKey() {
  const SceneNode* node = m_document->node(m_node);
  if (!node) return;
  const double time = m_time->filmTime();
  if (m_keyState == KeyState::AtKey)
    report(edit::removeKey(*m_document, m_node, m_property.id, time));
  else
    report(edit::setKey(*m_document, m_node, m_property.id, time, valueAt(*node, m_property, time)));
}

void PropertyRowEditor::showKeyMenu(const QPoint& position) {
  const SceneNode* node = m_document->node(m_node);
  const AnimationCurve* curve = node ? curveOf(*node, m_property) : nullptr;
  const Key* key = curve ? curve->keyAt(m_time->filmTime()) : nullptr;
  if (!key) return;
  QMenu menu(this);
  const std::array<QString, 3> names{tr("Step"), tr("Linear"), tr("Smooth")};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto interpolation = static_cast<Interpolation>(i);
    QAction* action =
        menu.addAction(names[i], this, [this, interpolation, value = key->value, time = key->time] {
          report(edit::setKey(*m_document, m_node, m_property.id, time, value, interpolation));
        });
    action->setCheckable(true);
    action->setChecked(key->interpolation == interpolation);
  }
  menu.exec(m_key->mapToGlobal(position));
}

/// A refused edit shows the value that still holds.
void PropertyRowEditor::report(const Status& status) {
  if (status) return;
  refresh();
  Q_EMIT editRefused(QString::fromStdString(status.error().text()));
}

}  // namespace spin
