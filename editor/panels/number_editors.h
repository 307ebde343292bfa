// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "editor/panels/value_editor.h"

class QSlider;

namespace spin {

class UnitSpinBox;

/// Int and Real: a spin box, and a slider where the range is small enough to be dragged through.
class NumberEditor : public ValueEditor {
  Q_OBJECT
 public:
  NumberEditor(const PropertyInfo& property, QWidget* parent);
  void show(const Value& value) override;

 private:
  Value valueOf(double si) const;
  void slide(int position);
  void showOnSlider(double si);

  const PropertyInfo& m_property;
  UnitSpinBox* m_spin;
  QSlider* m_slider = nullptr;
};

/// Vector: three spin boxes.
class VectorEditor : public ValueEditor {
  Q_OBJECT
 public:
  VectorEditor(const PropertyInfo& property, QWidget* parent);
  void show(const Value& value) override;

 private:
  std::array<UnitSpinBox*, 3> m_spins{};
};

/// True where a slider makes sense: at most 1000 steps from end to end, or a range of several decades.
bool wantsSlider(const PropertyInfo& property);
/// True where equal ways on the slider are equal ratios: real numbers from 0 or more over several decades.
bool slidesByRatio(const PropertyInfo& property);
/// Places of a slider and values in SI.
int slot(const PropertyInfo& property, double si);
double valueAtSlot(const PropertyInfo& property, int place);

}  // namespace spin
