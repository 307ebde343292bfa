// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/number_editors.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "editor/panels/field_keys.h"
#include "editor/panels/unit_spin_box.h"
#include "editor/panels/wheel_guard.h"

namespace spin {
namespace {

constexpr int kSliderSteps = 1000;

/// More than this from the least to the largest value: equal ways on the slider are equal ratios.
constexpr double kLinearRatio = 250.0;
constexpr double kMostRatio = 1e8;

/// What a slider by ratios begins with; a range from 0 on has 0 before it.
double leastOfSlider(const PropertyInfo& property) {
  return property.min > 0.0 ? property.min : property.step;
}

/// Two figures, as somebody would write them.
double tidied(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / unit) * unit;
}

}  // namespace

bool slidesByRatio(const PropertyInfo& property) {
  if (property.kind != PropertyKind::Real || property.min < 0.0 || property.step <= 0.0) return false;
  const double ratio = property.max / leastOfSlider(property);
  return property.unit != Unit::Degree && ratio > kLinearRatio && ratio <= kMostRatio;
}

bool wantsSlider(const PropertyInfo& property) {
  if (slidesByRatio(property)) return true;
  const bool number = property.kind == PropertyKind::Int || property.kind == PropertyKind::Real;
  return number && property.step > 0.0 && (property.max - property.min) / property.step <= kSliderSteps;
}

int slot(const PropertyInfo& property, double si) {
  if (!slidesByRatio(property)) return static_cast<int>(std::lround((si - property.min) / property.step));
  const double least = leastOfSlider(property);
  if (si < least) return 0;
  const int first = property.min > 0.0 ? 0 : 1;
  const double share = std::log(si / least) / std::log(property.max / least);
  return first + static_cast<int>(std::lround(share * (kSliderSteps - first)));
}

double valueAtSlot(const PropertyInfo& property, int place) {
  if (!slidesByRatio(property)) return std::min(property.max, property.min + place * property.step);
  const int first = property.min > 0.0 ? 0 : 1;
  if (place < first) return property.min;
  const double least = leastOfSlider(property);
  const double share = static_cast<double>(place - first) / (kSliderSteps - first);
  // Tidy in the unit that is shown.
  const double scale = unitInfo(property.unit).scale;
  const double value = tidied(least * std::pow(property.max / least, share) * scale) / scale;
  return std::clamp(value, property.min, property.max);
}

NumberEditor::NumberEditor(const PropertyInfo& property, QWidget* parent)
    : ValueEditor(parent), m_property(property), m_spin(new UnitSpinBox(property, this)) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (wantsSlider(property)) {
    m_slider = new QSlider(Qt::Horizontal, this);
    m_slider->setObjectName(QStringLiteral("slider"));
    m_slider->setRange(0, slot(property, property.max));
    m_slider->setFocusPolicy(Qt::StrongFocus);
    new WheelGuard(m_slider);
    layout->addWidget(m_slider, 1);
    connect(m_slider, &QSlider::valueChanged, this, &NumberEditor::slide);
    connect(m_slider, &QSlider::sliderReleased, this, &ValueEditor::released);
  }
  m_spin->setObjectName(QStringLiteral("number"));
  layout->addWidget(m_spin, m_slider ? 0 : 1);
  setFocusProxy(m_spin);
  connect(m_spin, &UnitSpinBox::valueChanged, this, [this] { Q_EMIT edited(valueOf(m_spin->si()), true); });
  connect(m_spin, &UnitSpinBox::editingFinished, this, &ValueEditor::released);
  connect(m_spin->keys(), &FieldKeys::entered, this, &ValueEditor::entered);
}

void NumberEditor::show(const Value& value) {
  const auto* integer = std::get_if<std::int64_t>(&value);
  const double si = integer ? static_cast<double>(*integer) : std::get<double>(value);
  m_spin->showSi(si);
  showOnSlider(si);
}

void NumberEditor::showOnSlider(double si) {
  if (!m_slider || m_slider->isSliderDown()) return;
  const QSignalBlocker quiet(m_slider);
  m_slider->setValue(slot(m_property, si));
}

void NumberEditor::slide(int position) {
  const double si = valueAtSlot(m_property, position);
  m_spin->showSi(si);
  Q_EMIT edited(valueOf(si), true);
}

Value NumberEditor::valueOf(double si) const {
  if (m_property.kind == PropertyKind::Int) return static_cast<std::int64_t>(std::llround(si));
  return si;
}

VectorEditor::VectorEditor(const PropertyInfo& property, QWidget* parent) : ValueEditor(parent) {
  static constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    UnitSpinBox* spin = m_spins[axis] = new UnitSpinBox(property, this);
    spin->setObjectName(QString::fromUtf8(kAxes[axis]));
    spin->setAccessibleName(QString::fromUtf8(kAxes[axis]));
    spin->setButtonSymbols(QAbstractSpinBox::NoButtons);
    // Three stand in a row, so each may be narrower than one alone.
    spin->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("00000 m")));
    layout->addWidget(spin, 1);
    connect(spin, &UnitSpinBox::valueChanged, this, [this] {
      Q_EMIT edited(Vec3d{m_spins[0]->si(), m_spins[1]->si(), m_spins[2]->si()}, true);
    });
    connect(spin, &UnitSpinBox::editingFinished, this, &ValueEditor::released);
    connect(spin->keys(), &FieldKeys::entered, this, &ValueEditor::entered);
  }
  setFocusProxy(m_spins[0]);
}

void VectorEditor::show(const Value& value) {
  const Vec3d& vector = std::get<Vec3d>(value);
  for (int axis = 0; axis < 3; ++axis) m_spins[static_cast<std::size_t>(axis)]->showSi(vector[axis]);
}

}  // namespace spin
