// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <functional>
#include <vector>

#include "editor/app/export_job.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace spin {

class PluginHost;

/// One thing that can be written.
struct ExportFormat {
  QString id;
  QString label;
  bool picture = false;
};
/// Formats of all plugins: pictures first.
std::vector<ExportFormat> exportFormats(const PluginHost& host);

/// What, which frames, where to; then the progress of the export. The scene must be saved.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  struct Defaults {
    QString scene;
    int firstFrame = 0;
    int lastFrame = 0;
    int width = 1280;
    int height = 720;
    double particlesPerFrame = 0.0;  ///< for the estimate
    double coverCells = 0.0;
    QString pictureNode;  ///< id; empty = the scene has none and the size cannot be changed
    QStringList allowedFolders;
  };

  ExportDialog(std::vector<ExportFormat> formats, const Defaults& defaults, QWidget* parent = nullptr);

  ExportPlan plan() const;
  ExportJob& job() { return m_job; }
  /// Rough size of the files, bytes.
  double estimatedBytes() const;

  /// Whether an export under way may be given up; a function, so that tests answer without a dialog.
  std::function<bool()> askStop;
  /// Closes the dialog; a running export only after a question.
  void reject() override;

 Q_SIGNALS:
  /// How the export ended, a sentence.
  void ended(const QString& text);

 private:
  void addFormats(QVBoxLayout* column);
  void addRange(QVBoxLayout* column);
  void addProgress(QVBoxLayout* column);
  void chooseFolder();
  void refresh();
  void startOrCancel();
  void showProgress(double fraction, double secondsLeft, const QString& stage);
  void showEnd(bool ok, bool cancelled, const QString& message);
  QString unusable() const;

  std::vector<ExportFormat> m_formats;
  Defaults m_defaults;
  ExportJob m_job;
  std::vector<QCheckBox*> m_boxes;
  QSpinBox* m_first;
  QSpinBox* m_last;
  QSpinBox* m_width;
  QSpinBox* m_height;
  QLineEdit* m_folder;
  QLabel* m_estimate;
  QPlainTextEdit* m_command;
  QProgressBar* m_progress;
  QLabel* m_result;
  QPushButton* m_start;
  QWidget* m_settings;
};

/// "2 min 5 s", for progress; empty for negative times.
QString durationText(double seconds);
/// "1.4 GB".
QString bytesText(double bytes);

}  // namespace spin
