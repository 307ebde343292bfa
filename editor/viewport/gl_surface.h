// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <functional>
#include <memory>

#include "editor/render/renderer.h"
#include "editor/viewport/band_plan.h"
#include "editor/viewport/draw_budget.h"

class QOpenGLFramebufferObject;

namespace spin {

/// Draws the scene by the Renderer into a picture of its own and shows that with the overlay on top; a change
/// of the overlay alone does not draw the scene again. At most 30 pictures a second. On a software driver, a
/// view that rests is drawn again in full detail, band by band.
class GlSurface : public QOpenGLWidget {
  Q_OBJECT
 public:
  explicit GlSurface(QWidget* parent = nullptr);
  ~GlSurface() override;

  void setScene(SnapshotPointer scene);
  void setFrame(FramePointer frame);
  /// Everything else that the picture depends on. Width, height and quality of the options are filled in
  /// here.
  void setView(const RenderCamera& camera, double filmTime, const RenderOptions& options);
  /// Draws with less detail until it has been still for a moment.
  void setMoving(bool moving);
  void setOverlay(std::function<void(QPainter&)> overlay) { m_overlay = std::move(overlay); }
  /// The overlay changed, the scene did not.
  void updateOverlay();

  /// Wall time of the last picture of the scene, s.
  double lastDrawSeconds() const { return m_lastSeconds; }
  /// GL_RENDERER once the context is there.
  QString rendererName() const { return m_rendererName; }

 Q_SIGNALS:
  /// After each picture of the scene.
  void drawn(double seconds);
  /// The resting view is now shown in full detail.
  void refined();
  /// The driver lacks something; the view stays empty.
  void failed(const QString& message);

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void releaseGl();
  void sceneChanged();
  void scheduleUpdate();
  void drawScene();
  void settled();
  void drawBand();
  void showScene();
  bool ensureTargets(int width, int height);
  /// Colour and depth of a size; false where the driver has no room.
  static bool ensureTarget(std::unique_ptr<QOpenGLFramebufferObject>& target, QSize size, int samples);

  std::unique_ptr<Renderer> m_renderer;
  std::unique_ptr<QOpenGLFramebufferObject> m_target;    ///< multisampled where the driver is fast
  std::unique_ptr<QOpenGLFramebufferObject> m_resolved;  ///< what is shown
  std::unique_ptr<QOpenGLFramebufferObject> m_refined;   ///< full detail, band by band
  BandPlan m_bands;
  bool m_refining = false;
  bool m_showRefined = false;
  int m_samples = 0;
  SnapshotPointer m_scene;
  FramePointer m_frame;
  RenderCamera m_camera;
  double m_filmTime = 0.0;
  RenderOptions m_options;
  std::function<void(QPainter&)> m_overlay;
  DrawBudget m_budget;
  DrawBudget::Effort m_drawnEffort;
  bool m_moving = false;
  bool m_dirty = true;
  bool m_sceneIsNew = true;
  bool m_frameIsNew = true;
  bool m_usable = false;
  double m_lastSeconds = 0.0;
  QString m_rendererName;
  QTimer m_repaint;
  QTimer m_settle;
  QElapsedTimer m_sincePaint;
};

/// OpenGL 4.5 core for the whole program; to be called before QApplication is made.
void setDefaultGlFormat();
/// True where the platform gives an OpenGL 4.5 core context; asked once.
bool openGlAvailable();

}  // namespace spin
