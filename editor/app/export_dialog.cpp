// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/export_dialog.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>
#include <cmath>

#include "plugins/host/plugin_host.h"

namespace spin {
namespace {

QSpinBox* intBox(const char* name, int low, int high, int value) {
  auto* box = new QSpinBox;
  box->setObjectName(name);
  box->setRange(low, high);
  box->setValue(value);
  return box;
}

/// Typical bytes of one file. Pictures: measured share of the raw size; caches: bytes per element.
double bytesPerFrame(const QString& id, double pixels, double particles, double cells) {
  if (id == QStringLiteral("png8")) return pixels * 3 * 0.45;
  if (id == QStringLiteral("png16")) return pixels * 6 * 0.8;
  if (id == QStringLiteral("exr")) return pixels * 8 * 0.7;
  if (id == QStringLiteral("cover_tif")) return cells * 12;
  // How much hangs in the air is known only once it was simulated.
  if (id == QStringLiteral("vdb")) return 0.0;
  return particles * 44;
}

QString stoppedText() {
  return ExportDialog::tr("Stopped. Files written so far stay in the folder.");
}

}  // namespace

QString durationText(double seconds) {
  if (seconds < 0.0) return {};
  const auto total = static_cast<qint64>(std::llround(std::min(seconds, 1e15)));
  if (total < 60) return ExportDialog::tr("%1 s").arg(total);
  if (total < 3600) return ExportDialog::tr("%1 min %2 s").arg(total / 60).arg(total % 60);
  constexpr qint64 kDay = 86400, kYear = 365 * kDay;
  if (total < 2 * kDay) return ExportDialog::tr("%1 h %2 min").arg(total / 3600).arg(total / 60 % 60);
  if (total < 2 * kYear) return ExportDialog::tr("%1 days").arg(total / kDay);
  return ExportDialog::tr("%1 years").arg(QLocale().toString(total / kYear));
}

QString bytesText(double bytes) {
  return QLocale().formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

std::vector<ExportFormat> exportFormats(const PluginHost& host) {
  const auto words = [](const std::string& label) {
    return QCoreApplication::translate("Properties", label.c_str());
  };
  std::vector<ExportFormat> formats;
  for (const ImageFormat& format : host.imageFormats())
    formats.push_back({QString::fromStdString(format.id), words(format.label), true});
  for (const std::string& id : host.exporterIds())
    formats.push_back({QString::fromStdString(id), words(host.exporterLabel(id)), false});
  return formats;
}

ExportDialog::ExportDialog(std::vector<ExportFormat> formats, const Defaults& defaults, QWidget* parent)
    : QDialog(parent), m_formats(std::move(formats)), m_defaults(defaults) {
  setObjectName("exportDialog");
  setWindowTitle(tr("Export"));
  setMinimumWidth(560);
  auto* column = new QVBoxLayout(this);
  m_settings = new QWidget;
  column->addWidget(m_settings);
  auto* inner = new QVBoxLayout(m_settings);
  inner->setContentsMargins(0, 0, 0, 0);
  addFormats(inner);
  addRange(inner);
  addProgress(column);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  m_start = buttons->addButton(tr("Export"), QDialogButtonBox::ActionRole);
  m_start->setObjectName("exportStart");
  m_start->setDefault(true);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QWidget::close);
  connect(m_start, &QPushButton::clicked, this, &ExportDialog::startOrCancel);
  connect(&m_job, &ExportJob::progressed, this, &ExportDialog::showProgress);
  connect(&m_job, &ExportJob::finished, this, &ExportDialog::showEnd);
  askStop = [this] {
    QMessageBox box(QMessageBox::Question, tr("Export"), tr("The export is still running."),
                    QMessageBox::NoButton, this);
    const QPushButton* stop = box.addButton(tr("Stop it"), QMessageBox::DestructiveRole);
    QPushButton* goOn = box.addButton(tr("Keep exporting"), QMessageBox::RejectRole);
    box.setDefaultButton(goOn);
    box.exec();
    return box.clickedButton() == stop;
  };
  refresh();
}

void ExportDialog::addFormats(QVBoxLayout* column) {
  column->addWidget(new QLabel(QStringLiteral("<b>") + tr("What to write") + QStringLiteral("</b>")));
  for (const ExportFormat& format : m_formats) {
    auto* box = new QCheckBox(format.label);
    box->setObjectName(QStringLiteral("format_") + format.id);
    box->setChecked(format.id == QStringLiteral("png8") || !format.picture);
    connect(box, &QCheckBox::toggled, this, &ExportDialog::refresh);
    m_boxes.push_back(box);
    column->addWidget(box);
  }
}

void ExportDialog::addRange(QVBoxLayout* column) {
  auto* form = new QFormLayout;
  column->addLayout(form);
  m_first = intBox("exportFirst", 0, 1000000, m_defaults.firstFrame);
  m_last = intBox("exportLast", 0, 1000000, m_defaults.lastFrame);
  m_width = intBox("exportWidth", 16, 16384, m_defaults.width);
  m_height = intBox("exportHeight", 16, 16384, m_defaults.height);
  m_width->setEnabled(!m_defaults.pictureNode.isEmpty());
  m_height->setEnabled(!m_defaults.pictureNode.isEmpty());
  const auto pair = [](QWidget* a, const QString& between, QWidget* b) {
    auto* row = new QHBoxLayout;
    row->addWidget(a);
    row->addWidget(new QLabel(between));
    row->addWidget(b);
    row->addStretch();
    return row;
  };
  form->addRow(tr("Frames"), pair(m_first, tr("to"), m_last));
  form->addRow(tr("Picture size"), pair(m_width, QString::fromUtf8("\u00d7"), m_height));
  m_folder = new QLineEdit(
      QDir::toNativeSeparators(QFileInfo(m_defaults.scene).absoluteDir().filePath(QStringLiteral("out"))));
  m_folder->setObjectName("exportFolder");
  auto* browse = new QPushButton(tr("Choose..."));
  connect(browse, &QPushButton::clicked, this, &ExportDialog::chooseFolder);
  auto* row = new QHBoxLayout;
  row->addWidget(m_folder);
  row->addWidget(browse);
  form->addRow(tr("Folder"), row);
  m_estimate = new QLabel;
  m_estimate->setObjectName("exportEstimate");
  m_estimate->setWordWrap(true);
  form->addRow(tr("Estimate"), m_estimate);
  m_command = new QPlainTextEdit;
  m_command->setObjectName("exportCommand");
  m_command->setReadOnly(true);
  m_command->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  m_command->setMaximumHeight(72);
  m_command->setToolTip(tr("The same export on the command line"));
  form->addRow(tr("Command"), m_command);
  for (QSpinBox* box : {m_first, m_last, m_width, m_height})
    connect(box, &QSpinBox::valueChanged, this, &ExportDialog::refresh);
  connect(m_folder, &QLineEdit::textChanged, this, &ExportDialog::refresh);
}

void ExportDialog::addProgress(QVBoxLayout* column) {
  m_progress = new QProgressBar;
  m_progress->setObjectName("exportProgress");
  m_progress->setRange(0, 1000);
  m_progress->hide();
  column->addWidget(m_progress);
  m_result = new QLabel;
  m_result->setObjectName("exportResult");
  m_result->setWordWrap(true);
  m_result->setOpenExternalLinks(true);
  m_result->setTextInteractionFlags(Qt::TextBrowserInteraction);
  m_result->hide();
  column->addWidget(m_result);
}

ExportPlan ExportDialog::plan() const {
  ExportPlan plan;
  plan.scene = m_defaults.scene;
  plan.pictureNode = m_defaults.pictureNode;
  plan.allowedFolders = m_defaults.allowedFolders;
  for (std::size_t k = 0; k < m_boxes.size(); ++k)
    if (m_boxes[k]->isChecked()) plan.formats << m_formats[k].id;
  plan.firstFrame = m_first->value();
  plan.lastFrame = m_last->value();
  plan.folder = QDir::fromNativeSeparators(m_folder->text());
  if (m_width->value() != m_defaults.width) plan.width = m_width->value();
  if (m_height->value() != m_defaults.height) plan.height = m_height->value();
  return plan;
}

double ExportDialog::estimatedBytes() const {
  const double pixels = static_cast<double>(m_width->value()) * m_height->value();
  double bytes = 0.0;
  for (const QString& id : plan().formats)
    bytes += bytesPerFrame(id, pixels, m_defaults.particlesPerFrame, m_defaults.coverCells);
  return bytes * std::max(0, m_last->value() - m_first->value() + 1);
}

void ExportDialog::chooseFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder for the export"), m_folder->text());
  if (!folder.isEmpty()) m_folder->setText(QDir::toNativeSeparators(folder));
}

QString ExportDialog::unusable() const {
  const ExportPlan wanted = plan();
  if (wanted.formats.isEmpty()) return tr("Choose at least one thing to write.");
  if (wanted.lastFrame < wanted.firstFrame) return tr("The last frame lies before the first.");
  if (wanted.folder.isEmpty()) return tr("Choose a folder.");
  return {};
}

void ExportDialog::refresh() {
  const QString problem = unusable();
  m_start->setEnabled(problem.isEmpty() || m_job.running());
  m_command->setPlainText(commandText(plan()));
  if (!problem.isEmpty()) {
    m_estimate->setText(problem);
    return;
  }
  const int frames = m_last->value() - m_first->value() + 1;
  m_estimate->setText(tr("%n frame(s), about %1 on disk", nullptr, frames).arg(bytesText(estimatedBytes())));
}

void ExportDialog::startOrCancel() {
  if (m_job.running()) {
    m_start->setEnabled(false);
    m_job.cancel();
    return;
  }
  m_settings->setEnabled(false);
  m_result->hide();
  m_progress->setValue(0);
  m_progress->setFormat(tr("Starting..."));
  m_progress->show();
  m_start->setText(tr("Stop"));
  m_job.start(plan());
}

void ExportDialog::showProgress(double fraction, double secondsLeft, const QString&) {
  m_progress->setValue(static_cast<int>(fraction * 1000.0));
  const QString left = durationText(secondsLeft);
  m_progress->setFormat(left.isEmpty() ? QStringLiteral("%p %") : tr("%p %, %1 left").arg(left));
}

void ExportDialog::showEnd(bool ok, bool cancelled, const QString& message) {
  m_settings->setEnabled(true);
  m_progress->setVisible(ok);
  m_start->setText(tr("Export"));
  const QString folder = m_folder->text();
  QString text;
  if (ok) {
    m_progress->setValue(1000);
    m_progress->setFormat(QStringLiteral("100 %"));
    text = tr("Written to <a href=\"%1\">%2</a>.")
               .arg(QUrl::fromLocalFile(folder).toString(), folder.toHtmlEscaped());
  } else if (cancelled) {
    text = stoppedText();
  } else {
    text = tr("The export failed.") + QStringLiteral("<br>") +
           message.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
  }
  m_result->setText(text);
  m_result->show();
  refresh();
  Q_EMIT ended(ok ? tr("Exported to %1.").arg(folder) : cancelled ? stoppedText() : tr("The export failed."));
}

/// Escape, the button and the window's own cross all come here.
void ExportDialog::reject() {
  if (m_job.running()) {
    if (!askStop()) return;
    // It may have ended while the question stood there. Else the dialog does not live to see its end.
    if (m_job.running()) {
      m_job.cancel();
      Q_EMIT ended(stoppedText());
    }
  }
  QDialog::reject();
}

}  // namespace spin
