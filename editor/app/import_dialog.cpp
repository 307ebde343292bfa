// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace spin {
namespace {

QDoubleSpinBox* realBox(const char* name, double low, double high, double value, int decimals,
                        const QString& suffix) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setDecimals(decimals);
  box->setRange(low, high);
  box->setValue(value);
  box->setSuffix(suffix);
  return box;
}

}  // namespace

ImportDialog::ImportDialog(std::shared_ptr<AssetReader> reader, const QString& file, ImportKind kind,
                           QWidget* parent)
    : QDialog(parent), m_file(file), m_kind(kind), m_job(std::move(reader)) {
  setObjectName("importDialog");
  setWindowTitle(kind == ImportKind::Terrain ? tr("Import terrain") : tr("Import model"));
  setMinimumWidth(520);
  auto* column = new QVBoxLayout(this);
  auto* title =
      new QLabel(QStringLiteral("<b>") + QFileInfo(file).fileName().toHtmlEscaped() + QStringLiteral("</b>"));
  title->setToolTip(file);
  column->addWidget(title);
  m_table = new QTableWidget(0, 2);
  m_table->setObjectName("importSummary");
  m_table->horizontalHeader()->hide();
  m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  m_table->horizontalHeader()->setStretchLastSection(true);
  m_table->verticalHeader()->hide();
  m_table->setShowGrid(false);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setSelectionMode(QAbstractItemView::NoSelection);
  column->addWidget(m_table, 1);
  m_warnings = new QLabel;
  m_warnings->setObjectName("importWarnings");
  m_warnings->setWordWrap(true);
  m_warnings->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(m_warnings);
  auto* form = new QFormLayout;
  column->addLayout(form);
  if (kind == ImportKind::Terrain)
    addTerrainOptions(form);
  else
    addModelOptions(form);
  m_progress = new QProgressBar;
  m_progress->setRange(0, 0);
  m_progress->setFormat(tr("Reading..."));
  column->addWidget(m_progress);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  m_accept = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
  m_accept->setObjectName("importAccept");
  m_again = buttons->addButton(tr("Read again"), QDialogButtonBox::ActionRole);
  m_again->setObjectName("importAgain");
  m_again->setToolTip(tr("Reads the file with the options above"));
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, [this] {
    m_job.cancel();
    reject();
  });
  connect(m_again, &QPushButton::clicked, this, &ImportDialog::readAgain);
  connect(&m_job, &ImportJob::done, this, &ImportDialog::showSummary);
  connect(&m_job, &ImportJob::failed, this, &ImportDialog::showError);
  readAgain();
}

void ImportDialog::addTerrainOptions(QFormLayout* form) {
  m_epsg = new QSpinBox;
  m_epsg->setObjectName("epsg");
  m_epsg->setRange(0, 999999);
  m_epsg->setSpecialValueText(tr("From the file"));
  form->addRow(tr("EPSG code"), m_epsg);
  m_cellSize = realBox("cellSize", 0.0, 10000.0, 0.0, 3, tr(" m"));
  m_cellSize->setSpecialValueText(tr("From the file, or 1 m"));
  form->addRow(tr("Cell size"), m_cellSize);
  m_heightUnit = realBox("heightUnit", 1e-6, 1000.0, 1.0, 6, tr(" m"));
  form->addRow(tr("Height unit"), m_heightUnit);
  m_hasNoData = new QCheckBox(tr("Cells with this value are holes:"));
  m_hasNoData->setObjectName("hasNoData");
  m_noData = realBox("noData", -1e9, 1e9, 0.0, 3, {});
  m_noData->setEnabled(false);
  connect(m_hasNoData, &QCheckBox::toggled, m_noData, &QWidget::setEnabled);
  form->addRow(m_hasNoData, m_noData);
}

void ImportDialog::addModelOptions(QFormLayout* form) {
  m_upAxis = new QComboBox;
  m_upAxis->setObjectName("upAxis");
  m_upAxis->addItems({tr("As the file says"), tr("Y is up"), tr("Z is up")});
  form->addRow(tr("Up axis"), m_upAxis);
  m_unit = realBox("unit", 0.0, 1000.0, 0.0, 4, tr(" m"));
  m_unit->setSpecialValueText(tr("From the file"));
  form->addRow(tr("Unit of the file"), m_unit);
}

ImportOptions ImportDialog::options() const {
  ImportOptions options;
  if (m_kind == ImportKind::Terrain) {
    options.epsg = m_epsg->value();
    options.cellSize = m_cellSize->value();
    options.heightScale = m_heightUnit->value();
    if (m_hasNoData->isChecked()) options.noDataValue = m_noData->value();
  } else {
    options.upAxis = m_upAxis->currentIndex();
    options.unitScale = m_unit->value();
  }
  return options;
}

edit::PropertyValues ImportDialog::values() const {
  edit::PropertyValues values;
  if (m_kind == ImportKind::Terrain) {
    if (m_epsg->value() != 0) values.emplace_back("epsg", static_cast<std::int64_t>(m_epsg->value()));
    if (m_cellSize->value() > 0.0) values.emplace_back("cell_size_m", m_cellSize->value());
    if (m_heightUnit->value() != 1.0) values.emplace_back("height_unit_m", m_heightUnit->value());
    if (m_hasNoData->isChecked()) {
      values.emplace_back("has_no_data", true);
      values.emplace_back("no_data", m_noData->value());
    }
    return values;
  }
  if (m_upAxis->currentIndex() != 0)
    values.emplace_back("up_axis", static_cast<std::int64_t>(m_upAxis->currentIndex()));
  if (m_unit->value() > 0.0) values.emplace_back("unit_m", m_unit->value());
  return values;
}

void ImportDialog::readAgain() {
  setBusy(true);
  m_job.read(m_file, m_kind, options());
}

void ImportDialog::setBusy(bool busy) {
  if (busy) m_ready = false;
  m_progress->setVisible(busy);
  m_again->setEnabled(!busy);
  m_accept->setEnabled(m_ready);
}

void ImportDialog::showSummary(const ImportSummary& summary) {
  m_table->setRowCount(static_cast<int>(summary.lines.size()));
  for (int row = 0; row < m_table->rowCount(); ++row) {
    const SummaryLine& line = summary.lines[static_cast<std::size_t>(row)];
    m_table->setItem(row, 0,
                     new QTableWidgetItem(QCoreApplication::translate("Properties", line.label.c_str())));
    m_table->setItem(row, 1, new QTableWidgetItem(QString::fromStdString(line.value)));
  }
  m_table->resizeRowsToContents();
  QStringList warnings;
  for (const std::string& warning : summary.warnings)
    warnings << QString::fromUtf8("\u26a0 ") + QString::fromStdString(warning);
  m_warnings->setText(warnings.join(u'\n'));
  m_warnings->setVisible(!warnings.isEmpty());
  m_ready = true;
  setBusy(false);
}

void ImportDialog::showError(const QString& message) {
  m_table->setRowCount(0);
  m_warnings->setText(message);
  m_warnings->show();
  m_ready = false;
  setBusy(false);
}

}  // namespace spin
