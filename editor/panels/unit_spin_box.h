// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDoubleSpinBox>

#include "core/property/property_table.h"

namespace spin {

class FieldKeys;

/// Number of a property in display units with the unit behind it. Shows no needless zeros and takes a decimal
/// point as well where the locale has a comma.
class UnitSpinBox : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit UnitSpinBox(const PropertyInfo& property, QWidget* parent = nullptr);

  /// Shows an SI number; does not tell valueChanged().
  void showSi(double si);
  /// The shown number in SI, within the property's range.
  double si() const;

  /// Undo and Return in this field.
  const FieldKeys* keys() const { return m_keys; }

  QString textFromValue(double value) const override;
  QValidator::State validate(QString& input, int& position) const override;

 protected:
  void wheelEvent(QWheelEvent* event) override;

 private:
  const PropertyInfo& m_property;
  FieldKeys* m_keys;
  double m_si = 0.0;     ///< as last shown: what was not edited keeps all its digits
  double m_shown = 0.0;  ///< the spin box's number for m_si
};

}  // namespace spin
