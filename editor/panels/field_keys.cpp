// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/field_keys.h"

#include <QAbstractSpinBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace spin {

FieldKeys::FieldKeys(QLineEdit* field) : QObject(field), m_line(field) {
  field->installEventFilter(this);
  // A line edit says so before it has finished editing; listeners of that come first.
  connect(field, &QLineEdit::returnPressed, this, &FieldKeys::entered, Qt::QueuedConnection);
}

FieldKeys::FieldKeys(QAbstractSpinBox* field) : QObject(field), m_line(field->findChild<QLineEdit*>()) {
  field->installEventFilter(this);
  connect(m_line, &QLineEdit::returnPressed, this, &FieldKeys::entered, Qt::QueuedConnection);
  // A value that is taken is the scene's to undo.
  connect(field, &QAbstractSpinBox::editingFinished, m_line, [this] { m_line->setModified(false); });
}

bool FieldKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const bool undoes = key->matches(QKeySequence::Undo) && !m_line->isModified();
  const bool redoes = key->matches(QKeySequence::Redo) && !m_line->isRedoAvailable();
  if (!undoes && !redoes) return QObject::eventFilter(watched, event);
  event->ignore();
  return true;
}

}  // namespace spin
