// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

class QAbstractSpinBox;
class QLineEdit;

namespace spin {

/// Keys of a field that belong to the window: undo and redo reach the scene where the field has nothing of
/// its own to take back, and Return tells that the user is done with the field.
class FieldKeys : public QObject {
  Q_OBJECT
 public:
  explicit FieldKeys(QLineEdit* field);
  explicit FieldKeys(QAbstractSpinBox* field);

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  /// After Return: the value is taken, the keys may go back to the view.
  void entered();

 private:
  QLineEdit* m_line;
};

}  // namespace spin
