// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/stage_panel.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace spin {
namespace {

QTableWidget* makeTable(const char* name, int columns, QWidget* parent) {
  auto* table = new QTableWidget(0, columns, parent);
  table->setObjectName(QLatin1String(name));
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->verticalHeader()->hide();
  table->verticalHeader()->setDefaultSectionSize(20);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setStretchLastSection(true);
  table->setShowGrid(false);
  table->setAlternatingRowColors(true);
  return table;
}

void addRow(QTableWidget* table, const QStringList& cells) {
  const int row = table->rowCount();
  table->insertRow(row);
  for (int column = 0; column < cells.size(); ++column) {
    auto* item = new QTableWidgetItem(cells[column]);
    item->setTextAlignment(Qt::AlignVCenter | (column == 0 ? Qt::AlignLeft : Qt::AlignRight));
    table->setItem(row, column, item);
  }
}

QString tableText(const QTableWidget* table) {
  QString text;
  for (int row = -1; row < table->rowCount(); ++row)
    for (int column = 0; column < table->columnCount(); ++column) {
      const QTableWidgetItem* item = row < 0 ? table->horizontalHeaderItem(column) : table->item(row, column);
      text += item ? item->text() : QString();
      text += column + 1 < table->columnCount() ? u'\t' : u'\n';
    }
  return text;
}

}  // namespace

StagePanel::StagePanel(QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_stages(makeTable("stages", 4, this)),
      m_figures(makeTable("figures", 2, this)),
      m_copy(new QToolButton(this)) {
  setObjectName(QStringLiteral("stagePanel"));
  m_title->setObjectName(QStringLiteral("stageTitle"));
  m_copy->setObjectName(QStringLiteral("copyStages"));
  auto* top = new QHBoxLayout;
  top->addWidget(m_title, 1);
  top->addWidget(m_copy);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addLayout(top);
  layout->addWidget(m_stages, 3);
  layout->addWidget(m_figures, 2);
  connect(m_copy, &QToolButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
  showTexts();
  fill();
}

void StagePanel::setFrame(const FramePointer& frame) {
  if (frame == m_frame) return;
  m_frame = frame;
  fill();
}

QString StagePanel::text() const {
  return m_title->text() + u'\n' + tableText(m_stages) + u'\n' + tableText(m_figures);
}

void StagePanel::fill() {
  m_title->setText(m_frame ? tr("Frame %1").arg(m_frame->info.time.frame) : tr("No frame is simulated yet"));
  m_copy->setEnabled(m_frame != nullptr);
  fillStages();
  fillFigures();
}

void StagePanel::fillStages() {
  m_stages->setRowCount(0);
  if (!m_frame) return;
  const std::vector<StageTime> table = m_frame->info.timings.table();
  double total = 0.0;
  for (const StageTime& stage : table) total += stage.seconds;
  const auto row = [&](const QString& name, double seconds, const QString& calls) {
    addRow(m_stages,
           {name, tr("%1 ms").arg(locale().toString(1000.0 * seconds, 'f', 2)),
            tr("%1 %").arg(locale().toString(total > 0.0 ? 100.0 * seconds / total : 0.0, 'f', 1)), calls});
  };
  for (const StageTime& stage : table)
    row(QString::fromStdString(stage.name), stage.seconds,
        locale().toString(static_cast<qint64>(stage.calls)));
  if (!table.empty()) row(tr("All stages"), total, {});
}

void StagePanel::fillFigures() {
  m_figures->setRowCount(0);
  if (!m_frame) return;
  addRow(m_figures, {tr("Computed on"), QString::fromStdString(m_frame->info.backend)});
  for (const auto& [name, value] : m_frame->info.figures)
    addRow(m_figures, {QString::fromStdString(name), locale().toString(value, 'g', 6)});
  for (const BudgetTerm& term : m_frame->info.budget.terms)
    addRow(m_figures, {tr("Mass: %1").arg(QString::fromStdString(term.name)),
                       tr("%1 kg").arg(locale().toString(term.kilograms, 'g', 7))});
}

void StagePanel::showTexts() {
  m_stages->setHorizontalHeaderLabels({tr("Stage"), tr("Time"), tr("Share"), tr("Calls")});
  m_figures->setHorizontalHeaderLabels({tr("Figure"), tr("Value")});
  m_copy->setText(tr("Copy"));
  m_copy->setToolTip(tr("Copy both tables as text"));
}

void StagePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    showTexts();
    fill();
  }
  QWidget::changeEvent(event);
}

}  // namespace spin
