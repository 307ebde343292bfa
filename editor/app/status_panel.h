// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>

#include "editor/app/simulation_controller.h"

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace spin {

class FlakeShapesMaker;
class Viewport;

/// Fills the status bar: progress of the run with time left and a stop button, stage times, cache, picture
/// time, device.
class StatusPanel : public QObject {
  Q_OBJECT
 public:
  StatusPanel(QStatusBar* bar, SimulationController* simulation, Viewport* viewport,
              FlakeShapesMaker* flakes);

 private:
  void showState(SimulationController::State state);
  void showProgress(const SimulationProgress& progress);
  void showStages(const SimulationProgress& progress);
  void showCache();
  void showVisibility(const FramePointer& frame);
  void joinFlakes(QStatusBar* bar, FlakeShapesMaker* flakes);
  void showEstimate(const RunEstimate& need);
  void showDrawn(double seconds);

  SimulationController* m_simulation;
  QProgressBar* m_progress;
  QToolButton* m_stop;
  QLabel* m_estimate;
  QLabel* m_stages;
  QLabel* m_visibility;
  QLabel* m_cache;
  QLabel* m_drawn;
  QLabel* m_device;
  QElapsedTimer m_sinceDrawn;
};

/// "Sight 800 m" or "Sight 2.5 km", as precise as snow allows.
QString visibilityText(double metres);
/// Total and slowest stage: "0.42 s per frame, cover 61 %". Empty without stages or frames.
QString stageSummary(const std::vector<StageTime>& stages, int frames);
/// What a run will take: "12 frames: 34,000 particles, about 3 min, 1.2 GB of memory, 340 MB on disk"; empty
/// where nothing is missing.
QString estimateText(const RunEstimate& need);
/// All stages as a table in rich text, slowest first.
QString stageTable(const std::vector<StageTime>& stages);

}  // namespace spin
