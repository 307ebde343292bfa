// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/status_panel.h"

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "editor/app/export_dialog.h"
#include "editor/app/flake_shapes_maker.h"
#include "editor/viewport/viewport.h"

namespace spin {
namespace {

constexpr qint64 kDrawnMilliseconds = 250;

double totalSeconds(const std::vector<StageTime>& stages) {
  return std::accumulate(stages.begin(), stages.end(), 0.0,
                         [](double sum, const StageTime& stage) { return sum + stage.seconds; });
}

}  // namespace

QString stageSummary(const std::vector<StageTime>& stages, int frames) {
  const double total = totalSeconds(stages);
  if (stages.empty() || frames < 1 || total <= 0.0) return {};
  const auto slowest = std::max_element(stages.begin(), stages.end(),
                                        [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
  return StatusPanel::tr("%1 s per frame, %2 %3 %")
      .arg(QLocale().toString(total / frames, 'f', 2), QString::fromStdString(slowest->name))
      .arg(std::lround(100.0 * slowest->seconds / total));
}

QString estimateText(const RunEstimate& need) {
  if (need.framesToCompute < 1) return {};
  QStringList parts;
  if (need.particles >= 1.0)
    parts << StatusPanel::tr("%1 particles").arg(QLocale().toString(need.particles, 'f', 0));
  if (need.seconds >= 1.0) parts << StatusPanel::tr("about %1").arg(durationText(need.seconds));
  parts << StatusPanel::tr("%1 of memory").arg(bytesText(need.memoryBytes));
  if (need.diskBytes > 0.0) parts << StatusPanel::tr("%1 on disk").arg(bytesText(need.diskBytes));
  return StatusPanel::tr("%n frame(s): %1", nullptr, need.framesToCompute)
      .arg(parts.join(QStringLiteral(", ")));
}

QString stageTable(const std::vector<StageTime>& stages) {
  std::vector<StageTime> sorted = stages;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.seconds > b.seconds; });
  QString rows;
  for (const StageTime& stage : sorted)
    rows += QString(QStringLiteral("<tr><td>%1</td><td align=right>&nbsp;&nbsp;%2 s</td><td "
                                   "align=right>&nbsp;&nbsp;%3 x</td></tr>"))
                .arg(QString::fromStdString(stage.name).toHtmlEscaped(),
                     QLocale().toString(stage.seconds, 'f', 3),
                     QLocale().toString(static_cast<qint64>(stage.calls)));
  return QStringLiteral("<table>") + rows + QStringLiteral("</table>");
}

StatusPanel::StatusPanel(QStatusBar* bar, SimulationController* simulation, Viewport* viewport,
                         FlakeShapesMaker* flakes)
    : QObject(bar), m_simulation(simulation) {
  const auto label = [bar](const char* name, const QString& tip) {
    auto* made = new QLabel;
    made->setObjectName(name);
    made->setToolTip(tip);
    made->setMargin(3);
    bar->addPermanentWidget(made);
    return made;
  };
  joinFlakes(bar, flakes);
  m_progress = new QProgressBar;
  m_progress->setObjectName("runProgress");
  m_progress->setMaximumWidth(230);
  m_progress->setMinimumWidth(160);
  m_progress->setRange(0, 1000);
  m_stop = new QToolButton;
  m_stop->setObjectName("runStop");
  m_stop->setAutoRaise(true);
  m_stop->setText(QString::fromUtf8("\u25a0"));
  m_stop->setToolTip(tr("Stop the simulation"));
  bar->addPermanentWidget(m_progress);
  bar->addPermanentWidget(m_stop);
  m_estimate = label("runEstimate", tr("What the frames that are not simulated yet will take"));
  m_stages = label("stageTimes", {});
  m_visibility =
      label("visibility", tr("How far one sees through the falling snow: there a dark object keeps "
                             "2 % of its contrast"));
  m_cache = label("cacheUsage", tr("Simulated frames in memory and on disk"));
  m_drawn = label("drawTime", tr("Time to draw the last picture of the view"));
  m_device = label("device", tr("What simulates: instruction set of the processor, or graphics card"));
  m_device->setText(simulation->deviceName());
  connect(m_stop, &QToolButton::clicked, simulation, &SimulationController::stop);
  connect(simulation, &SimulationController::stateChanged, this, &StatusPanel::showState);
  connect(simulation, &SimulationController::progressed, this, &StatusPanel::showProgress);
  connect(simulation, &SimulationController::statesChanged, this, &StatusPanel::showCache);
  connect(simulation, &SimulationController::estimated, this, &StatusPanel::showEstimate);
  connect(simulation, &SimulationController::frameShown, this, &StatusPanel::showVisibility);
  connect(simulation, &SimulationController::pausedChanged, this,
          [this] { showState(m_simulation->state()); });
  connect(simulation, &SimulationController::message, bar,
          [bar](const QString& text) { bar->showMessage(text, 6000); });
  connect(simulation, &SimulationController::finished, bar, [bar](const QString& text) {
    if (!text.isEmpty()) bar->showMessage(text, 10000);
  });
  connect(viewport, &Viewport::drawn, this, &StatusPanel::showDrawn);
  m_sinceDrawn.start();
  showState(simulation->state());
  showCache();
}

void StatusPanel::joinFlakes(QStatusBar* bar, FlakeShapesMaker* flakes) {
  auto* grow = new QToolButton;
  grow->setObjectName("growingFlakes");
  grow->setAutoRaise(true);
  grow->setToolTip(tr("Growing the shapes of the flakes; a click stops it"));
  grow->hide();
  bar->addPermanentWidget(grow);
  grow->hide();
  connect(flakes, &FlakeShapesMaker::growingChanged, grow, &QToolButton::setVisible);
  connect(flakes, &FlakeShapesMaker::progressed, grow,
          [grow](double share) { grow->setText(tr("Growing flakes %1 %").arg(std::lround(100.0 * share))); });
  connect(flakes, &FlakeShapesMaker::message, bar,
          [bar](const QString& text) { bar->showMessage(text, 10000); });
  connect(grow, &QToolButton::clicked, flakes, &FlakeShapesMaker::cancel);
}

void StatusPanel::showState(SimulationController::State state) {
  const bool reading = state == SimulationController::State::Reading;
  const bool running = state == SimulationController::State::Running;
  m_progress->setVisible(reading || running);
  m_stop->setVisible(running);
  m_estimate->setVisible(!running && !m_estimate->text().isEmpty());
  // Without a known length the bar only moves.
  m_progress->setRange(0, reading ? 0 : 1000);
  m_progress->setFormat(reading ? tr("Reading files...") : tr("Simulating..."));
  if (!running) return;
  m_progress->setValue(0);
  m_stages->clear();
}

void StatusPanel::showProgress(const SimulationProgress& progress) {
  m_progress->setValue(static_cast<int>(progress.fractionDone * 1000.0));
  const QString left = durationText(progress.secondsLeft);
  m_progress->setFormat(
      left.isEmpty() ? tr("Frame %1 of %2").arg(progress.frame).arg(progress.lastFrame)
                     : tr("Frame %1 of %2, %3 left").arg(progress.frame).arg(progress.lastFrame).arg(left));
  showStages(progress);
}

void StatusPanel::showStages(const SimulationProgress& progress) {
  // Before its first frame is done a run has no figure of its own, and that of another scene says nothing.
  m_stages->setText(stageSummary(progress.timings, progress.framesDone));
  m_stages->setToolTip(progress.timings.empty() ? QString() : stageTable(progress.timings));
}

void StatusPanel::showEstimate(const RunEstimate& need) {
  m_estimate->setText(estimateText(need));
  showState(m_simulation->state());
}

QString visibilityText(double metres) {
  if (metres >= 10e3) return StatusPanel::tr("Sight %1 km").arg(QLocale().toString(metres / 1e3, 'f', 0));
  if (metres >= 1e3) return StatusPanel::tr("Sight %1 km").arg(QLocale().toString(metres / 1e3, 'f', 1));
  return StatusPanel::tr("Sight %1 m").arg(QLocale().toString(10.0 * std::round(metres / 10.0), 'f', 0));
}

void StatusPanel::showVisibility(const FramePointer& frame) {
  const auto* figures = frame ? &frame->info.figures : nullptr;
  const bool snows = figures && figures->count("visibility_m") == 1;
  m_visibility->setText(snows ? visibilityText(figures->at("visibility_m")) : QString());
  m_visibility->setVisible(snows);
}

void StatusPanel::showCache() {
  const FrameStore::Usage usage = m_simulation->usage();
  m_cache->setText(tr("Cache %1").arg(bytesText(static_cast<double>(usage.memoryBytes))));
  m_cache->setToolTip(tr("Simulated frames: %1 in memory, %2 on disk, of these %3 out of date")
                          .arg(bytesText(static_cast<double>(usage.memoryBytes)),
                               bytesText(static_cast<double>(usage.diskBytes)),
                               bytesText(static_cast<double>(usage.staleDiskBytes))));
}

void StatusPanel::showDrawn(double seconds) {
  if (!m_drawn->text().isEmpty() && m_sinceDrawn.elapsed() < kDrawnMilliseconds) return;
  m_sinceDrawn.restart();
  m_drawn->setText(tr("%1 ms").arg(QLocale().toString(seconds * 1000.0, 'f', 0)));
}

}  // namespace spin
