// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/layer_dialogs.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/panels/layer_value_editor.h"

namespace spin {
namespace {

QString words(const std::string& marked) {
  return QCoreApplication::translate("Properties", marked.c_str());
}

QDialogButtonBox* buttonsOf(QDialog* dialog, const QString& accept, const char* name, const QString& tip) {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  QPushButton* button = buttons->addButton(accept, QDialogButtonBox::AcceptRole);
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  return buttons;
}

void showRow(QFormLayout* form, QWidget* field, bool on) {
  form->setRowVisible(field, on);
}

}  // namespace

FilterDialog::FilterDialog(const PaintedKind& kind, std::vector<LayerFilterInfo> filters, QWidget* parent)
    : QDialog(parent),
      m_filter(new QComboBox),
      m_radius(new QDoubleSpinBox),
      m_threshold(new LayerValueEditor),
      m_about(new QLabel) {
  setObjectName(QStringLiteral("filterDialog"));
  setWindowTitle(tr("Filter: %1").arg(words(kind.label)));
  const bool shares = kind.unit == Unit::Factor;
  for (LayerFilterInfo& info : filters)
    if (shares || !info.masksOnly) m_filters.push_back(std::move(info));
  m_filter->setObjectName(QStringLiteral("filterKind"));
  m_filter->setToolTip(tr("What the filter does"));
  for (const LayerFilterInfo& info : m_filters) m_filter->addItem(words(info.label));
  m_radius->setObjectName(QStringLiteral("filterRadius"));
  m_radius->setToolTip(tr("How far the filter reaches"));
  m_radius->setRange(0.5, 500.0);
  m_radius->setDecimals(1);
  m_radius->setSuffix(tr(" m"));
  m_radius->setValue(10.0);
  m_threshold->setToolTip(tr("What is less is taken away"));
  m_threshold->showKind(kind, kind.low + 0.5 * (kind.high - kind.low));
  m_about->setWordWrap(true);
  m_about->setMinimumHeight(2 * fontMetrics().lineSpacing());
  m_about->setAlignment(Qt::AlignTop);
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  form->setObjectName(QStringLiteral("filterForm"));
  form->addRow(tr("Filter"), m_filter);
  form->addRow(tr("Radius"), m_radius);
  form->addRow(tr("Threshold"), m_threshold);
  column->addLayout(form);
  column->addWidget(m_about);
  column->addWidget(
      buttonsOf(this, tr("Filter"), "filterAccept", tr("Filter as the view shows it; one undo step")));
  connect(m_filter, &QComboBox::currentIndexChanged, this, [this, form] {
    follow();
    Q_EMIT changed();
  });
  connect(m_radius, &QDoubleSpinBox::valueChanged, this, &FilterDialog::changed);
  connect(m_threshold, &LayerValueEditor::edited, this, &FilterDialog::changed);
  follow();
}

void FilterDialog::follow() {
  const auto index = static_cast<std::size_t>(std::max(0, m_filter->currentIndex()));
  if (index >= m_filters.size()) return;
  auto* form = findChild<QFormLayout*>(QStringLiteral("filterForm"));
  showRow(form, m_radius, m_filters[index].wantsRadius);
  showRow(form, m_threshold, m_filters[index].wantsThreshold);
  m_about->setText(words(m_filters[index].doc));
}

std::string FilterDialog::filter() const {
  const int index = m_filter->currentIndex();
  return index < 0 ? std::string() : m_filters[static_cast<std::size_t>(index)].id;
}

double FilterDialog::radius() const {
  return m_radius->value();
}

double FilterDialog::threshold() const {
  return m_threshold->si();
}

void FilterDialog::showProblem(const QString& text) {
  m_about->setText(text);
}

LayerFileDialog::LayerFileDialog(const PaintedKind& kind, Way way, QWidget* parent)
    : QDialog(parent),
      m_kind(kind),
      m_format(new QComboBox),
      m_black(new LayerValueEditor),
      m_white(new LayerValueEditor),
      m_about(new QLabel) {
  setObjectName(QStringLiteral("layerFileDialog"));
  const QString name = words(kind.label);
  const bool goesOut = way == Way::Export;
  setWindowTitle(goesOut ? tr("Export: %1").arg(name) : tr("Import: %1").arg(name));
  m_format->setObjectName(QStringLiteral("layerFormat"));
  m_format->setToolTip(tr("GeoTIFF keeps the values and where nothing is painted; a PNG is a grey picture"));
  m_format->addItem(tr("GeoTIFF"), 0);
  m_format->addItem(tr("PNG, 8 bit"), 8);
  if (!kind.numbers) m_format->addItem(tr("PNG, 16 bit"), 16);
  m_black->setObjectName(QStringLiteral("layerBlack"));
  m_black->setToolTip(tr("What black stands for"));
  m_black->showKind(kind, kind.low);
  m_white->setObjectName(QStringLiteral("layerWhite"));
  m_white->setToolTip(tr("What white stands for"));
  m_white->showKind(kind, kind.high);
  m_about->setObjectName(QStringLiteral("layerAbout"));
  m_about->setWordWrap(true);
  m_about->setMinimumWidth(320);
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  form->setObjectName(QStringLiteral("layerForm"));
  form->addRow(tr("Format"), m_format);
  form->addRow(tr("Black"), m_black);
  form->addRow(tr("White"), m_white);
  column->addLayout(form);
  column->addWidget(m_about);
  column->addWidget(goesOut
                        ? buttonsOf(this, tr("Choose file..."), "layerAccept", tr("Choose where to write"))
                        : buttonsOf(this, tr("Import"), "layerAccept",
                                    tr("Take the file as the view shows it; one undo step")));
  form->setRowVisible(m_format, goesOut);
  connect(m_format, &QComboBox::currentIndexChanged, this, &LayerFileDialog::follow);
  for (LayerValueEditor* editor : {m_black, m_white})
    connect(editor, &LayerValueEditor::edited, this, &LayerFileDialog::changed);
  follow();
}

void LayerFileDialog::follow() {
  m_ranged = !m_kind.numbers && m_format->currentData().toInt() != 0;
  auto* form = findChild<QFormLayout*>(QStringLiteral("layerForm"));
  form->setRowVisible(m_black, m_ranged);
  form->setRowVisible(m_white, m_ranged);
  if (m_ranged) m_about->setText(tr("What is not painted becomes black."));
  if (!m_ranged) m_about->clear();
}

QString LayerFileDialog::ending() const {
  return m_format->currentData().toInt() == 0 ? QStringLiteral("tif") : QStringLiteral("png");
}

LayerFormat LayerFileDialog::format() const {
  LayerFormat format;
  format.name = m_kind.name;
  format.bits = std::max(8, m_format->currentData().toInt());
  format.low = m_black->si();
  format.high = m_white->si();
  return format;
}

void LayerFileDialog::showFindings(const RasterImport& raster, const std::vector<std::string>& remarks) {
  m_ranged = !m_kind.numbers && raster.bits != 0;
  auto* form = findChild<QFormLayout*>(QStringLiteral("layerForm"));
  form->setRowVisible(m_black, m_ranged);
  form->setRowVisible(m_white, m_ranged);
  QString text = tr("%1 x %2 cells").arg(raster.values.width).arg(raster.values.height);
  text += QStringLiteral(", ") + (raster.bits == 0 ? tr("real numbers") : tr("%1 bit").arg(raster.bits));
  text += QStringLiteral(", ") +
          (raster.georeferenced ? tr("with its place in the world") : tr("laid over the whole terrain"));
  text += QLatin1Char('.');
  for (const std::string& remark : remarks) text += QLatin1Char('\n') + QString::fromStdString(remark);
  m_about->setText(text);
}

void LayerFileDialog::showProblem(const QString& text) {
  m_about->setText(text);
}

}  // namespace spin
