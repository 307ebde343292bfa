// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/picture_drawer.h"

#include <chrono>
#include <utility>

#include "core/sim/thread_priority.h"

namespace spin {
namespace {

constexpr std::chrono::milliseconds kPicturePeriod{33};
/// So long a view rests before it is drawn in full detail.
constexpr std::chrono::milliseconds kSettle{250};

}  // namespace

void loadGraphicsDriver() {
  // On a thread of low priority, which the driver's own threads inherit.
  std::thread([] {
    lowerThreadPriority(kDrawingNiceness);
    // A failure is told when a picture is wanted.
    static_cast<void>(EglContext::create());
  }).join();
}

PictureDrawer::PictureDrawer(QObject* parent) : QObject(parent), m_thread([this] { work(); }) {}

PictureDrawer::~PictureDrawer() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
  }
  m_wake.notify_one();
  m_thread.join();
}

void PictureDrawer::request(PictureRequest request) {
  {
    const std::lock_guard lock(m_mutex);
    m_request = std::move(request);
  }
  m_wake.notify_one();
}

void PictureDrawer::work() {
  lowerThreadPriority(kDrawingNiceness);
  const auto painter = PicturePainter::create();
  if (!painter) {
    Q_EMIT failed(QString::fromStdString(painter.error().text()));
    return;
  }
  Q_EMIT started(QString::fromStdString((*painter)->rendererName()));
  serve(**painter);
}

void PictureDrawer::serve(PicturePainter& painter) {
  while (std::optional<Task> task = nextTask()) {
    if (!task->refine) {
      m_lastBegin = std::chrono::steady_clock::now();
      if (!draw(painter, task->request)) m_unrefined = std::move(task->request);
    } else if (const auto picture = painter.refine(task->request, [this] { return interrupted(); })) {
      Q_EMIT refined(*picture);
    }
  }
  m_unrefined.reset();
}

std::optional<PictureDrawer::Task> PictureDrawer::nextTask() {
  std::unique_lock lock(m_mutex);
  const auto called = [this] { return m_stop || m_request; };
  if (!m_unrefined)
    m_wake.wait(lock, called);
  else if (!m_wake.wait_for(lock, kSettle, called))
    return Task{*std::exchange(m_unrefined, std::nullopt), true};
  // What comes in while the last picture is fresh is drawn as one.
  m_wake.wait_until(lock, m_lastBegin + kPicturePeriod, [this] { return m_stop; });
  if (m_stop) return std::nullopt;
  m_unrefined.reset();
  return Task{*std::exchange(m_request, std::nullopt), false};
}

bool PictureDrawer::draw(PicturePainter& painter, const PictureRequest& request) {
  const Result<PicturePainter::Drawn> drawn = painter.draw(request);
  if (!drawn) {
    Q_EMIT failed(QString::fromStdString(drawn.error().text()));
    return true;
  }
  Q_EMIT this->drawn(drawn->picture, drawn->seconds);
  return drawn->complete;
}

bool PictureDrawer::interrupted() {
  const std::lock_guard lock(m_mutex);
  return m_stop || m_request;
}

}  // namespace spin
