// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>

#include "editor/viewport/picture_drawer.h"

namespace spin {

/// Shows the newest picture of the scene with the overlay on top. Pictures come from a PictureDrawer: this
/// widget only copies them, so it repaints in a few milliseconds whatever the scene and the driver. A hidden
/// view asks for no pictures.
class PictureView : public QWidget {
  Q_OBJECT
 public:
  explicit PictureView(QWidget* parent = nullptr);

  void setScene(SnapshotPointer scene);
  void setFrame(FramePointer frame);
  void setFlakeAtlas(std::shared_ptr<const FlakeAtlas> atlas);
  /// Everything else that the picture depends on. Width, height and detail of the options are filled in here.
  void setView(const RenderCamera& camera, double filmTime, const RenderOptions& options);
  /// The change that is coming is part of a movement: speed counts more than detail. False ends it.
  void setMoving(bool moving);
  void setOverlay(std::function<void(QPainter&)> overlay) { m_overlay = std::move(overlay); }
  /// The overlay changed, the scene did not.
  void updateOverlay() { update(); }

  /// The newest picture in pixels of the screen; null before the first.
  const QImage& picture() const { return m_picture; }
  /// GL_RENDERER once the driver is ready.
  QString rendererName() const { return m_rendererName; }

 Q_SIGNALS:
  /// After each picture of the scene; wall time, s.
  void drawn(double seconds);
  /// The resting view is now shown in full detail.
  void refined();
  void failed(const QString& message);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void changed();
  void send();
  void startDrawer();
  void take(const QImage& picture);

  PictureDrawer* m_drawer = nullptr;
  PictureRequest m_request;
  QImage m_picture;
  QString m_rendererName;
  QString m_notice;  ///< why there is no picture
  std::function<void(QPainter&)> m_overlay;
  bool m_dirty = true;
  bool m_wasMoving = false;
  QTimer m_send;
};

/// False on platforms without a screen (offscreen, minimal), where nobody would see a picture.
bool screenIsThere();

}  // namespace spin
