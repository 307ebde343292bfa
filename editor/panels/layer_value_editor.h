// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "core/nodes/painted_kinds.h"

class QComboBox;
class QHBoxLayout;

namespace spin {

class UnitSpinBox;

/// A value of a painted layer: a ground type to choose, or a number in the unit in which the project shows
/// it. Nothing for layers that know only painted and not painted.
class LayerValueEditor : public QWidget {
  Q_OBJECT
 public:
  explicit LayerValueEditor(QWidget* parent = nullptr);

  /// Shows another kind or value; does not tell edited().
  void showKind(const PaintedKind& kind, double si);
  double si() const;
  const QWidget* field() const;

 Q_SIGNALS:
  void edited();
  /// Return was pressed in the field.
  void entered();

 private:
  QHBoxLayout* m_row;
  const PaintedKind* m_kind = nullptr;
  QComboBox* m_types;
  UnitSpinBox* m_number = nullptr;
  double m_si = 0.0;
};

}  // namespace spin
