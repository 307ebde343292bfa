// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>

#include "editor/commands/edits.h"

class QLabel;
class QToolButton;

namespace spin {

class TimeContext;
class ValueEditor;

/// One row of the property panel: key button, label, editor and revert button. Edits of one drag become one
/// undo step.
class PropertyRowEditor : public QWidget {
  Q_OBJECT
 public:
  enum class KeyState { NotAnimatable, NoKeys, BetweenKeys, AtKey };

  PropertyRowEditor(SceneDocument* document, TimeContext* time, std::string node,
                    const PropertyInfo& property, QWidget* parent);

  const PropertyInfo& property() const { return m_property; }
  KeyState keyState() const { return m_keyState; }
  /// Shows the value at the current frame.
  void refresh();

 Q_SIGNALS:
  void editRefused(const QString& message);
  /// Return in a field: the user is done with it.
  void entered();

 private:
  void edit(const Value& value, bool dragging);
  void endDrag();
  void toggleKey();
  void showKeyMenu(const QPoint& position);
  void showKeyState(const SceneNode& node);
  void report(const Status& status);
  QToolButton* makeButton(const char* name);

  SceneDocument* m_document;
  TimeContext* m_time;
  std::string m_node;
  const PropertyInfo& m_property;
  QToolButton* m_key;
  QLabel* m_label;
  ValueEditor* m_editor;
  QToolButton* m_revert;
  KeyState m_keyState = KeyState::NotAnimatable;
  edit::Session m_session = 0;
  QTimer m_dragEnd;
};

}  // namespace spin
