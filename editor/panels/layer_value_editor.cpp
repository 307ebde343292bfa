// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/layer_value_editor.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <map>

#include "core/nodes/ground_nodes.h"
#include "editor/panels/field_keys.h"
#include "editor/panels/unit_spin_box.h"

namespace spin {
namespace {

/// As a property of a node would be, for the spin box.
const PropertyInfo& propertyOf(const PaintedKind& kind) {
  static std::map<const PaintedKind*, PropertyInfo> known;
  const auto [at, fresh] = known.try_emplace(&kind);
  if (fresh) {
    PropertyInfo& info = at->second;
    info.id = "value";
    info.unit = kind.unit;
    info.min = kind.least;
    info.max = kind.most;
    info.step = kind.unit == Unit::Kelvin ? 1.0 : 0.05;
  }
  return at->second;
}

}  // namespace

LayerValueEditor::LayerValueEditor(QWidget* parent)
    : QWidget(parent), m_row(new QHBoxLayout(this)), m_types(new QComboBox) {
  m_row->setContentsMargins(0, 0, 0, 0);
  m_types->setObjectName(QStringLiteral("layerType"));
  for (int k = 0; k < kGroundTypeCount; ++k)
    m_types->addItem(
        QCoreApplication::translate("Properties", kGroundTypeChoices[static_cast<std::size_t>(k)].label), k);
  m_row->addWidget(m_types);
  connect(m_types, &QComboBox::currentIndexChanged, this, [this](int index) {
    m_si = index;
    Q_EMIT edited();
  });
}

void LayerValueEditor::showKind(const PaintedKind& kind, double si) {
  m_si = si;
  if (&kind != m_kind) {
    m_kind = &kind;
    delete m_number;
    m_number = nullptr;
    if (!kind.numbers) {
      m_number = new UnitSpinBox(propertyOf(kind));
      m_number->setObjectName(QStringLiteral("layerNumber"));
      m_number->setToolTip(toolTip());
      m_row->addWidget(m_number);
      connect(m_number, &QDoubleSpinBox::valueChanged, this, [this] {
        m_si = m_number->si();
        Q_EMIT edited();
      });
      connect(m_number->keys(), &FieldKeys::entered, this, &LayerValueEditor::entered);
    }
    m_types->setVisible(kind.type == &kGroundTypeLayerType);
  }
  m_types->setToolTip(toolTip());
  if (m_number) m_number->showSi(si);
  if (kind.type == &kGroundTypeLayerType) {
    const QSignalBlocker quiet(m_types);
    m_types->setCurrentIndex(static_cast<int>(si));
  }
}

double LayerValueEditor::si() const {
  return m_si;
}

const QWidget* LayerValueEditor::field() const {
  if (m_number) return m_number;
  return m_types;
}

}  // namespace spin
