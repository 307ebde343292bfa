// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "editor/app/import_job.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace spin {

/// Shows what is in a file before it is imported: size, coordinates, warnings. Options that the file does not
/// tell can be given and the file is read again with them.
class ImportDialog : public QDialog {
  Q_OBJECT
 public:
  ImportDialog(std::shared_ptr<AssetReader> reader, const QString& file, ImportKind kind,
               QWidget* parent = nullptr);

  ImportOptions options() const;
  /// What was found in the file; without the view where the options have changed since it was read.
  ImportFindings findings() const;
  bool ready() const { return m_ready; }
  /// Whether the file is to be copied beside the scene.
  bool copyWanted() const;
  /// Takes the question for a copy away: the file lies beside the scene already.
  void hideCopy();

 private:
  void addTerrainOptions(QFormLayout* form);
  void addModelOptions(QFormLayout* form);
  void readAgain();
  void showFindings(const ImportFindings& findings);
  void showError(const QString& message);
  void setBusy(bool busy);

  QString m_file;
  ImportKind m_kind;
  ImportJob m_job;
  bool m_ready = false;
  ImportOptions m_readWith;
  ImportFindings m_findings;
  QTableWidget* m_table;
  QLabel* m_warnings;
  QProgressBar* m_progress;
  QCheckBox* m_copy;
  QPushButton* m_accept;
  QPushButton* m_again;
  QSpinBox* m_epsg = nullptr;
  QDoubleSpinBox* m_cellSize = nullptr;
  QDoubleSpinBox* m_heightUnit = nullptr;
  QCheckBox* m_hasNoData = nullptr;
  QDoubleSpinBox* m_noData = nullptr;
  QComboBox* m_upAxis = nullptr;
  QDoubleSpinBox* m_unit = nullptr;
};

}  // namespace spin
