// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/unit_spin_box.h"

#include <QSignalBlocker>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "editor/panels/field_keys.h"

namespace spin {
namespace {

constexpr int kDecimals = 6;

/// 0.138889 kg/(m2 s) per hour is no step a user wants; the unit's own decimal steps are.
double tidy(double step) {
  return std::round(step * 1e9) / 1e9;
}

}  // namespace

UnitSpinBox::UnitSpinBox(const PropertyInfo& property, QWidget* parent)
    : QDoubleSpinBox(parent), m_property(property), m_keys(new FieldKeys(this)) {
  const UnitInfo unit = unitInfo(property.unit);
  setDecimals(property.kind == PropertyKind::Int ? 0 : kDecimals);
  if (property.min < property.max)
    setRange(toDisplay(property.unit, property.min), toDisplay(property.unit, property.max));
  else
    setRange(-1e12, 1e12);
  setSingleStep(property.step > 0.0 ? tidy(property.step * unit.scale) : 1.0);
  if (*unit.suffix != '\0') setSuffix(QLatin1Char(' ') + QString::fromUtf8(unit.suffix));
  setKeyboardTracking(false);
  setAccelerated(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000000")));
}

void UnitSpinBox::showSi(double si) {
  const QSignalBlocker quiet(this);
  setValue(toDisplay(m_property.unit, si));
  m_si = si;
  m_shown = value();
}

double UnitSpinBox::si() const {
  if (value() == m_shown) return m_si;
  const double si = fromDisplay(m_property.unit, value());
  return m_property.min < m_property.max ? std::clamp(si, m_property.min, m_property.max) : si;
}

QString UnitSpinBox::textFromValue(double value) const {
  QLocale plain = locale();
  plain.setNumberOptions(plain.numberOptions() | QLocale::OmitGroupSeparator);
  QString text = plain.toString(value, 'f', decimals());
  const QString point = plain.decimalPoint();
  if (!text.contains(point)) return text;
  while (text.endsWith(plain.zeroDigit())) text.chop(1);
  if (text.endsWith(point)) text.chop(point.size());
  return text;
}

QValidator::State UnitSpinBox::validate(QString& input, int& position) const {
  const QString point = locale().decimalPoint();
  if (point != QLatin1String(".") && !input.contains(point)) input.replace(QLatin1Char('.'), point);
  return QDoubleSpinBox::validate(input, position);
}

/// Scrolling the panel must not change the numbers under the pointer.
void UnitSpinBox::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore();
}

}  // namespace spin
