// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/flake_watch.h"

#include <QMetaObject>
#include <chrono>
#include <thread>
#include <utility>

#include "core/flake/flake_grower.h"
#include "core/flake/flake_measure.h"
#include "core/flake/flake_picture.h"
#include "core/scene/flake_shapes.h"
#include "core/sim/thread_priority.h"

namespace spin {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPeriod{66};
/// Growth that one could not follow is slowed down to last about as long.
constexpr std::chrono::milliseconds kShortestGrowth{2500};
constexpr int kStages = 60;

QImage imageOf(const FlakePicture& picture) {
  QImage image(picture.size, picture.size, QImage::Format_Grayscale8);
  for (int y = 0; y < picture.size; ++y) {
    uchar* line = image.scanLine(picture.size - 1 - y);
    for (int x = 0; x < picture.size; ++x) line[x] = static_cast<uchar>(255.0f * picture.at(x, y) + 0.5f);
  }
  return image;
}

/// Lets time pass between two stages, so that the eye can follow.
void pace(Clock::time_point& next, const CancelToken& cancel) {
  constexpr std::chrono::milliseconds kNap{10};
  while (Clock::now() < next && !cancel.cancelled()) std::this_thread::sleep_for(kNap);
  next = Clock::now() + kShortestGrowth / kStages;
}

template <class Tell>
Status growCluster(const FlakeNode& node, const CancelToken& cancel, const Tell& tell) {
  const FlakeSettings settings = flakeSettingsOf(node);
  if (Status fits = checkFlakeSettings(settings); !fits) return fits;
  FlakeGrower grower(settings);
  const double wanted = settings.radius / settings.particleDiameter;
  auto next = Clock::now(), shown = next - kPeriod;
  for (double goal = 0.0; !grower.done();) {
    goal = grower.progress() + 1.0 / kStages;
    while (!grower.done() && grower.progress() < goal)
      if (Status status = grower.grow(64, cancel); !status) return status;
    pace(next, cancel);
    if (!grower.done() && Clock::now() - shown < kPeriod) continue;
    shown = Clock::now();
    const auto picture = drawFlake(grower.centres(), FlakeWatch::kPictureSize, wanted);
    if (!picture) return picture.error();
    tell(FlakeStage{imageOf(*picture), grower.progress(), grower.radius(),
                    static_cast<int>(grower.centres().size()), gyrationDimension(grower.centres())});
  }
  return {};
}

template <class Tell>
Status growCrystal(const FlakeNode& node, const CancelToken& cancel, const Tell& tell) {
  const CrystalSettings settings = crystalSettingsOf(node);
  if (Status fits = checkCrystalSettings(settings); !fits) return fits;
  CrystalGrower grower(settings);
  auto next = Clock::now(), shown = next - kPeriod;
  for (double goal = 0.0; !grower.done();) {
    goal = grower.progress() + 1.0 / kStages;
    while (!grower.done() && grower.progress() < goal)
      if (Status status = grower.grow(20, cancel); !status) return status;
    pace(next, cancel);
    if (!grower.done() && Clock::now() - shown < kPeriod) continue;
    shown = Clock::now();
    const auto picture = drawCrystal(grower, FlakeWatch::kPictureSize, settings.cells);
    if (!picture) return picture.error();
    tell(FlakeStage{imageOf(*picture), grower.progress(), node.largest * grower.reach() / settings.cells,
                    grower.iceCells(), 0.0});
  }
  return {};
}

}  // namespace

FlakeWatch::FlakeWatch(QObject* parent) : QObject(parent) {
  m_pool.setMaxThreadCount(1);
}

FlakeWatch::~FlakeWatch() {
  m_cancel.cancel();
  m_pool.waitForDone();
}

void FlakeWatch::start(const FlakeNode& node) {
  m_cancel.cancel();
  m_cancel = CancelToken();
  m_running = true;
  m_pool.start([this, node, number = ++m_number, cancel = m_cancel] {
    lowerThreadPriority(kSimulationNiceness);
    const auto tellStage = [&](const FlakeStage& stage) {
      QMetaObject::invokeMethod(this, [this, number, stage] { tell(number, stage); });
    };
    const Status status = node.growth == FlakeGrowth::Crystal ? growCrystal(node, cancel, tellStage)
                                                              : growCluster(node, cancel, tellStage);
    QMetaObject::invokeMethod(this, [this, number, status] { end(number, status); });
  });
}

void FlakeWatch::stop() {
  m_cancel.cancel();
}

void FlakeWatch::tell(quint64 number, const FlakeStage& stage) {
  if (number == m_number) Q_EMIT grown(stage);
}

void FlakeWatch::end(quint64 number, const Status& status) {
  if (number != m_number) return;
  m_running = false;
  const bool failed = !status && status.error().kind != ErrorKind::Cancelled;
  Q_EMIT finished(failed ? QString::fromStdString(status.error().text()) : QString());
}

}  // namespace spin
