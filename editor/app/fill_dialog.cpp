// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/fill_dialog.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "editor/panels/layer_value_editor.h"

namespace spin {
namespace {

QDoubleSpinBox* numberBox(const QString& name, double least, double most, double value, const QString& suffix,
                          const QString& tip) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(least, most);
  box->setDecimals(0);
  box->setSingleStep(most - least > 400.0 ? 10.0 : 1.0);
  box->setSuffix(suffix);
  box->setValue(value);
  box->setToolTip(tip);
  box->setAccelerated(true);
  return box;
}

}  // namespace

SoftRange FillDialog::RangeFields::range() const {
  return {box->isChecked(), low->value(), high->value(), soft->value()};
}

FillDialog::FillDialog(const PaintedKind& kind, double value, double lowest, double highest, QWidget* parent)
    : QDialog(parent) {
  setObjectName(QStringLiteral("fillDialog"));
  setWindowTitle(tr("Fill: %1").arg(QCoreApplication::translate("Properties", kind.label)));
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  m_value = new LayerValueEditor;
  m_value->setObjectName(QStringLiteral("fillValue"));
  m_value->setToolTip(tr("What the layer is filled with"));
  m_value->showKind(kind, value);
  connect(m_value, &LayerValueEditor::edited, this, &FillDialog::changed);
  m_combine = new QComboBox;
  m_combine->setObjectName(QStringLiteral("fillCombine"));
  m_combine->setToolTip(tr("How the value joins what is painted there"));
  m_combine->addItem(tr("Replaces what is there"));
  if (!kind.numbers) {
    m_combine->addItem(tr("The larger of both"));
    m_combine->addItem(tr("Is added"));
  }
  connect(m_combine, &QComboBox::currentIndexChanged, this, &FillDialog::changed);
  form->addRow(tr("Value"), m_value);
  form->addRow(tr("Combine"), m_combine);
  column->addLayout(form);
  m_altitude = addRange(column, "Altitude", tr("Altitude"), tr("Height above sea"), tr(" m"),
                        std::floor(lowest), std::ceil(highest));
  m_slope = addRange(column, "Slope", tr("Slope"), tr("Steepness from level ground"), tr("\u00b0"), 0, 90);
  m_aspect = addRange(column, "Aspect", tr("Aspect"),
                      tr("The way the ground faces, clockwise: 0 north, 90 east"), tr("\u00b0"), 0, 360);
  m_extent = new QLabel;
  m_extent->setObjectName(QStringLiteral("fillExtent"));
  m_extent->setWordWrap(true);
  column->addWidget(m_extent);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  QPushButton* fill = buttons->addButton(tr("Fill"), QDialogButtonBox::AcceptRole);
  fill->setObjectName(QStringLiteral("fillAccept"));
  fill->setToolTip(tr("Fill as the view shows it; one undo step"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

FillDialog::RangeFields FillDialog::addRange(QVBoxLayout* column, const char* name, const QString& title,
                                             const QString& tip, const QString& suffix, double least,
                                             double most) {
  const QString base = QStringLiteral("fill") + QLatin1String(name);
  RangeFields fields;
  fields.box = new QGroupBox(title);
  fields.box->setObjectName(base);
  fields.box->setCheckable(true);
  fields.box->setChecked(false);
  fields.box->setToolTip(tip);
  const double soft = (most - least) / 18.0;
  fields.low =
      numberBox(base + QStringLiteral("From"), least, most, least, suffix, tr("Where the range begins"));
  fields.high = numberBox(base + QStringLiteral("To"), least, most, most, suffix, tr("Where the range ends"));
  fields.soft = numberBox(base + QStringLiteral("Soft"), 0.0, std::max(1.0, 0.5 * (most - least)),
                          std::round(soft), suffix, tr("Width of the soft edge on either side"));
  auto* form = new QFormLayout(fields.box);
  auto* row = new QHBoxLayout;
  row->addWidget(fields.low);
  row->addWidget(new QLabel(tr("to")));
  row->addWidget(fields.high);
  if (QLatin1String(name) == QLatin1String("Aspect")) {
    m_aspect = fields;
    addFacings(form);
  }
  form->addRow(tr("From"), row);
  form->addRow(tr("Soft edge"), fields.soft);
  column->addWidget(fields.box);
  connect(fields.box, &QGroupBox::toggled, this, &FillDialog::changed);
  for (QDoubleSpinBox* box : {fields.low, fields.high, fields.soft})
    connect(box, &QDoubleSpinBox::valueChanged, this, &FillDialog::changed);
  return fields;
}

/// Ranges of 90 degrees by name.
void FillDialog::addFacings(QFormLayout* form) {
  auto* facing = new QComboBox;
  facing->setObjectName(QStringLiteral("fillFacing"));
  facing->setToolTip(tr("A quarter of the horizon by name"));
  const std::array<QString, 8> names{tr("North"), tr("North-east"), tr("East"), tr("South-east"),
                                     tr("South"), tr("South-west"), tr("West"), tr("North-west")};
  facing->addItem(tr("Own range"));
  for (const QString& name : names) facing->addItem(name);
  connect(facing, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index == 0) return;
    const int middle = 45 * (index - 1);
    m_aspect.low->setValue((middle + 315) % 360);
    m_aspect.high->setValue((middle + 45) % 360);
  });
  form->addRow(tr("Faces"), facing);
}

FillDialog::Choice FillDialog::choice() const {
  Choice choice;
  choice.rule = {m_altitude.range(), m_slope.range(), m_aspect.range()};
  choice.value = m_value->si();
  choice.combine = static_cast<FillCombine>(m_combine->currentIndex());
  return choice;
}

void FillDialog::showExtent(double share, double area) {
  const bool large = area >= 1e5;
  m_extent->setText(tr("Fills %1 % of the terrain, %2.")
                        .arg(locale().toString(100.0 * share, 'f', 1),
                             large ? tr("%1 km\u00b2").arg(locale().toString(area * 1e-6, 'f', 2))
                                   : tr("%1 m\u00b2").arg(locale().toString(area, 'f', 0))));
}

void FillDialog::showProblem(const QString& text) {
  m_extent->setText(text);
}

}  // namespace spin
