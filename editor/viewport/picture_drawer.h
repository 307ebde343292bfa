// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "editor/viewport/picture_painter.h"

namespace spin {

/// Loads the graphics driver now. While a program loads a large library no thread can be started, so this is
/// to be done before the window is there.
void loadGraphicsDriver();

/// Draws on a thread of its own, so that no scene and no driver holds up the window. Only the newest request
/// counts; at most 30 pictures a second. A view that rests is drawn again in full detail.
class PictureDrawer : public QObject {
  Q_OBJECT
 public:
  explicit PictureDrawer(QObject* parent = nullptr);
  /// Waits for the picture in work.
  ~PictureDrawer() override;
  void request(PictureRequest request);

 Q_SIGNALS:
  /// GL_RENDERER, once the driver is ready.
  void started(const QString& rendererName);
  /// After each picture; wall time, s.
  void drawn(const QImage& picture, double seconds);
  /// The last picture again, in full detail.
  void refined(const QImage& picture);
  /// The driver lacks something or has no room for the size.
  void failed(const QString& message);

 private:
  void work();
  void serve(PicturePainter& painter);
  /// The next thing to do; nullopt = end.
  struct Task {
    PictureRequest request;
    bool refine = false;
  };
  std::optional<Task> nextTask();
  bool draw(PicturePainter& painter, const PictureRequest& request);
  bool interrupted();

  std::mutex m_mutex;
  std::condition_variable m_wake;
  std::optional<PictureRequest> m_request;
  bool m_stop = false;
  // Only the drawing thread touches these.
  std::optional<PictureRequest> m_unrefined;
  std::chrono::steady_clock::time_point m_lastBegin{};
  std::thread m_thread;  ///< last: starts when all else is there
};

}  // namespace spin
