// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTemporaryDir>
#include <QTimer>
#include <vector>

#include "editor/app/export_job.h"
#include "editor/app/ui_watchdog.h"

namespace spin {

class MainWindow;

/// Measures the window while it works: the scene is read and simulated with the view turning, then played,
/// then painted on with all layers of the brush at 60 Hz, then exported. Writes the longest stand-still of
/// the event loop and the times of the pictures per phase as JSON.
class UiMeasurement : public QObject {
  Q_OBJECT
 public:
  UiMeasurement(MainWindow* window, const QString& scene, const QString& reportFile);

  void start();

 Q_SIGNALS:
  void done(bool ok);

 private:
  enum class Phase { Simulate, Play, Paint, Export, Done };
  struct Figures {
    QString name;
    double seconds = 0.0;
    double longestBlock = 0.0;
    std::vector<double> drawSeconds;
  };

  void begin(Phase phase);
  void endPhase();
  void turnView();
  void paintStep();
  void endPaint();
  void startExport();
  void finish(bool ok);
  /// Writes what is measured so far, so that an interrupted run is not lost.
  bool save(bool ok) const;

  MainWindow* m_window;
  QString m_scene;
  QString m_reportFile;
  Phase m_phase = Phase::Done;
  UiWatchdog m_watchdog;
  QElapsedTimer m_elapsed;
  QTimer m_turn;
  QTimer m_play;
  QTimer m_paint;
  int m_paintSteps = 0;
  int m_undoBefore = 0;
  ExportJob m_export;
  QTemporaryDir m_folder;
  std::vector<Figures> m_figures;
};

}  // namespace spin
