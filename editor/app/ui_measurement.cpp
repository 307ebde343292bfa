// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/ui_measurement.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "editor/app/main_window.h"
#include "editor/timeline/timeline_panel.h"
#include "editor/viewport/orbit_camera.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"

namespace spin {
namespace {

constexpr int kStartMilliseconds = 1500;
constexpr int kPlayMilliseconds = 6000;
constexpr int kTurnMilliseconds = 100;
constexpr int kPaintMilliseconds = 16;
constexpr int kStrokeSteps = 60;
constexpr std::size_t kPaintStrokes = 8;
constexpr double kPaintRadius = 50.0;
constexpr double kTurnPixels = 3.0;
constexpr int kViewWidth = 1280, kViewHeight = 720;

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

UiMeasurement::UiMeasurement(MainWindow* window, const QString& scene, const QString& reportFile)
    : QObject(window), m_window(window), m_scene(scene), m_reportFile(reportFile) {
  m_turn.setInterval(kTurnMilliseconds);
  m_play.setSingleShot(true);
  m_play.setInterval(kPlayMilliseconds);
  connect(&m_turn, &QTimer::timeout, this, &UiMeasurement::turnView);
  connect(&m_play, &QTimer::timeout, this, [this] {
    m_window->timeline().setPlaying(false);
    endPhase();
    begin(Phase::Paint);
  });
  m_paint.setInterval(kPaintMilliseconds);
  m_paint.setTimerType(Qt::PreciseTimer);
  connect(&m_paint, &QTimer::timeout, this, &UiMeasurement::paintStep);
  connect(&window->viewport(), &Viewport::drawn, this, [this](double seconds) {
    if (!m_figures.empty()) m_figures.back().drawSeconds.push_back(seconds);
  });
  connect(&window->simulation(), &SimulationController::finished, this, [this](const QString& problem) {
    if (m_phase != Phase::Simulate) return;
    endPhase();
    if (!problem.isEmpty()) return finish(false);
    begin(Phase::Play);
  });
  connect(&m_export, &ExportJob::finished, this, [this](bool ok, bool, const QString& message) {
    endPhase();
    if (!ok) qWarning("%s", qPrintable(message));
    finish(ok);
  });
}

void UiMeasurement::start() {
  // The viewport gets the size that figures are compared at.
  const QSize around = m_window->size() - m_window->viewport().size();
  m_window->resize(around + QSize(kViewWidth, kViewHeight));
  // The window's own start is no part of any phase.
  QTimer::singleShot(kStartMilliseconds, this, [this] {
    begin(Phase::Simulate);
    m_window->openOrImport(m_scene);
  });
}

void UiMeasurement::begin(Phase phase) {
  static const char* const kNames[] = {"simulate", "play", "paint", "export"};
  m_phase = phase;
  m_figures.push_back({QString::fromLatin1(kNames[static_cast<int>(phase)]), 0.0, 0.0, {}});
  m_elapsed.start();
  m_watchdog.restart();
  if (phase != Phase::Paint) m_turn.start();
  if (phase == Phase::Paint) {
    m_paintSteps = 0;
    m_undoBefore = m_window->document().undoStack()->index();
    m_window->viewport().setTool(Viewport::Tool::Brush);
    m_window->viewport().setBrushTip({kPaintRadius, 0.5, 0.7});
    m_paint.start();
  }
  if (phase == Phase::Play) {
    m_window->timeline().setPlaying(true);
    m_play.start();
  }
  if (phase == Phase::Export) startExport();
}

/// A stroke of each kind of layer, winding over the view; then all is taken back.
void UiMeasurement::paintStep() {
  Viewport& view = m_window->viewport();
  const int step = m_paintSteps % kStrokeSteps;
  const auto stroke = static_cast<std::size_t>(m_paintSteps / kStrokeSteps);
  if (stroke >= kPaintStrokes) return endPaint();
  if (step == 0) {
    view.setBrushLayer(paintedKinds()[stroke % 4]);
    view.setBrushMode(stroke < 4 ? BrushMode::Paint : BrushMode::Smooth);
  }
  const double turn = 6.283 * m_paintSteps / kStrokeSteps;
  const QSizeF size = view.surface()->size();
  const QPointF at(size.width() * (0.5 + 0.35 * std::cos(1.3 * turn)),
                   size.height() * (0.62 + 0.25 * std::sin(turn)));
  const bool begins = step == 0, ends = step == kStrokeSteps - 1;
  const QEvent::Type type =
      begins ? QEvent::MouseButtonPress : (ends ? QEvent::MouseButtonRelease : QEvent::MouseMove);
  QMouseEvent event(type, at, view.surface()->mapToGlobal(at), begins || ends ? Qt::LeftButton : Qt::NoButton,
                    ends ? Qt::NoButton : Qt::LeftButton, {});
  QCoreApplication::sendEvent(view.surface(), &event);
  ++m_paintSteps;
}

void UiMeasurement::endPaint() {
  m_paint.stop();
  m_window->document().undoStack()->setIndex(m_undoBefore);
  m_window->viewport().setTool(Viewport::Tool::Select);
  endPhase();
  begin(Phase::Export);
}

void UiMeasurement::startExport() {
  ExportPlan plan;
  plan.scene = m_window->document().path();
  plan.formats = QStringList{QStringLiteral("png8"), QStringLiteral("ply"), QStringLiteral("vtp"),
                             QStringLiteral("cover_tif")};
  plan.firstFrame = m_window->timeline().bar()->first();
  plan.lastFrame = m_window->timeline().bar()->last();
  plan.folder = m_folder.path();
  m_export.start(plan);
}

void UiMeasurement::endPhase() {
  m_figures.back().seconds = static_cast<double>(m_elapsed.nsecsElapsed()) * 1e-9;
  m_figures.back().longestBlock = m_watchdog.longestBlockSeconds();
  m_turn.stop();
  save(false);
}

void UiMeasurement::turnView() {
  OrbitCamera camera = OrbitCamera::from(m_window->viewport().camera());
  camera.orbit(kTurnPixels, 0.0);
  m_window->viewport().setCamera(camera.camera());
}

void UiMeasurement::finish(bool ok) {
  m_phase = Phase::Done;
  const bool saved = save(ok);
  Q_EMIT done(ok && saved);
}

bool UiMeasurement::save(bool ok) const {
  QJsonArray phases;
  for (const Figures& figures : m_figures) {
    const auto& drawn = figures.drawSeconds;
    const double sum = std::accumulate(drawn.begin(), drawn.end(), 0.0);
    phases.append(QJsonObject{
        {QStringLiteral("phase"), figures.name},
        {QStringLiteral("seconds"), figures.seconds},
        {QStringLiteral("longest_block_ms"), figures.longestBlock * 1e3},
        {QStringLiteral("pictures"), static_cast<qint64>(drawn.size())},
        {QStringLiteral("picture_mean_ms"),
         drawn.empty() ? 0.0 : sum / static_cast<double>(drawn.size()) * 1e3},
        {QStringLiteral("picture_median_ms"), percentile(drawn, 0.5) * 1e3},
        {QStringLiteral("picture_95_ms"), percentile(drawn, 0.95) * 1e3},
    });
  }
  const QSize size = m_window->viewport().size();
  const QJsonObject report{{QStringLiteral("ok"), ok},
                           {QStringLiteral("width_px"), size.width()},
                           {QStringLiteral("height_px"), size.height()},
                           {QStringLiteral("renderer"), m_window->viewport().surface()->rendererName()},
                           {QStringLiteral("device"), m_window->simulation().deviceName()},
                           {QStringLiteral("phases"), phases}};
  QFile file(m_reportFile);
  return file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(report).toJson()) > 0;
}

}  // namespace spin
