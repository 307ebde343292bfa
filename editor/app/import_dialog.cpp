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
#include <cmath>

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
  m_copy = new QCheckBox(tr("Copy beside the scene"));
  m_copy->setObjectName("copyBeside");
  m_copy->setChecked(true);
  m_copy->setToolTip(
      tr("Copies the file and what it refers to into the scene's folder, so that the scene can be moved. A "
         "scene without a folder gets the copy when it is saved."));
  form->addRow(m_copy);
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
  connect(&m_job, &ImportJob::done, this, &ImportDialog::showFindings);
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

ImportFindings ImportDialog::findings() const {
  const ImportOptions now = options();
  const bool sameHoles = now.noDataValue == m_readWith.noDataValue ||
                         (std::isnan(now.noDataValue) && std::isnan(m_readWith.noDataValue));
  ImportFindings findings = m_findings;
  // The place to look at moves with the size of the cells.
  if (!sameHoles || now.cellSize != m_readWith.cellSize || now.heightScale != m_readWith.heightScale)
    findings.view.reset();
  return findings;
}

bool ImportDialog::copyWanted() const {
  return m_copy->isChecked();
}

void ImportDialog::hideCopy() {
  m_copy->setChecked(false);
  m_copy->hide();
}

void ImportDialog::readAgain() {
  setBusy(true);
  m_readWith = options();
  m_job.read(m_file, m_kind, m_readWith);
}

void ImportDialog::setBusy(bool busy) {
  if (busy) m_ready = false;
  m_progress->setVisible(busy);
  m_again->setEnabled(!busy);
  m_accept->setEnabled(m_ready);
}

void ImportDialog::showFindings(const ImportFindings& findings) {
  m_findings = findings;
  const ImportSummary& summary = findings.summary;
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
