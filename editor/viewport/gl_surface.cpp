// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/gl_surface.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QPainter>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace spin {
namespace {

constexpr int kMillisecondsPerPicture = 33;
constexpr int kSettleMilliseconds = 250;

QSurfaceFormat coreFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  return format;
}

bool probeOpenGl() {
  QOpenGLContext context;
  context.setFormat(coreFormat());
  if (!context.create()) return false;
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!context.makeCurrent(&surface)) return false;
  const bool enough = context.format().version() >= qMakePair(4, 5);
  context.doneCurrent();
  return enough;
}

/// What QPainter expects of a context that others drew in.
void resetState(QOpenGLExtraFunctions& gl) {
  gl.glUseProgram(0);
  gl.glBindVertexArray(0);
  gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
  gl.glDisable(GL_DEPTH_TEST);
  gl.glDisable(GL_CULL_FACE);
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glDisable(GL_STENCIL_TEST);
  gl.glDisable(GL_BLEND);
  gl.glDepthMask(GL_TRUE);
  gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.glActiveTexture(GL_TEXTURE0);
}

}  // namespace

void setDefaultGlFormat() {
  // Docks that float and come back get a new context: shared ones keep their textures.
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QSurfaceFormat::setDefaultFormat(coreFormat());
}

bool openGlAvailable() {
  static const bool available = probeOpenGl();
  return available;
}

GlSurface::GlSurface(QWidget* parent) : QOpenGLWidget(parent) {
  setFormat(coreFormat());
  setObjectName("glSurface");
  m_repaint.setSingleShot(true);
  connect(&m_repaint, &QTimer::timeout, this, qOverload<>(&QWidget::update));
  m_settle.setSingleShot(true);
  m_settle.setInterval(kSettleMilliseconds);
  connect(&m_settle, &QTimer::timeout, this, &GlSurface::settled);
  m_sincePaint.start();
}

GlSurface::~GlSurface() {
  // The base class destroys the context, when nothing of this class is left to answer its last signal.
  if (context()) disconnect(context(), nullptr, this, nullptr);
  releaseGl();
}

void GlSurface::setScene(SnapshotPointer scene) {
  if (scene == m_scene) return;
  const bool otherTerrain = !m_scene || !scene || m_scene->terrain != scene->terrain;
  if (m_samples == 0 && otherTerrain) m_budget.startLow();
  m_scene = std::move(scene);
  m_sceneIsNew = true;
  sceneChanged();
}

void GlSurface::setFrame(FramePointer frame) {
  if (frame == m_frame) return;
  m_frame = std::move(frame);
  m_frameIsNew = true;
  sceneChanged();
}

void GlSurface::setView(const RenderCamera& camera, double filmTime, const RenderOptions& options) {
  m_camera = camera;
  m_filmTime = filmTime;
  m_options = options;
  sceneChanged();
}

void GlSurface::setMoving(bool moving) {
  if (moving) {
    m_moving = true;
    m_settle.start();
  } else if (m_moving) {
    m_settle.start(0);
  }
}

void GlSurface::settled() {
  m_moving = false;
  if (m_dirty || m_drawnEffort == DrawBudget::Effort{}) return;
  if (m_samples > 0) return sceneChanged();
  m_bands.restart();
  m_refining = true;
  scheduleUpdate();
}

void GlSurface::sceneChanged() {
  m_dirty = true;
  m_refining = false;
  scheduleUpdate();
}

void GlSurface::updateOverlay() {
  scheduleUpdate();
}

void GlSurface::scheduleUpdate() {
  if (m_repaint.isActive()) return;
  const auto wait = kMillisecondsPerPicture - m_sincePaint.elapsed();
  m_repaint.start(static_cast<int>(std::max<qint64>(0, wait)));
}

void GlSurface::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlSurface::releaseGl, Qt::DirectConnection);
  QOpenGLExtraFunctions& gl = *context()->extraFunctions();
  m_rendererName = QString::fromUtf8(reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER)));
  const bool software = m_rendererName.contains(QStringLiteral("llvmpipe")) ||
                        m_rendererName.contains(QStringLiteral("softpipe"));
  m_samples = software ? 0 : 4;
  if (software) m_budget.startLow();
  m_renderer = std::make_unique<Renderer>();
  const Status status = m_renderer->initialise();
  m_usable = status.ok();
  if (!m_usable) {
    Q_EMIT failed(QString::fromStdString(status.error().text()));
    return;
  }
  m_sceneIsNew = m_frameIsNew = m_dirty = true;
}

void GlSurface::releaseGl() {
  if (!m_renderer && !m_target && !m_resolved) return;
  makeCurrent();
  m_renderer.reset();
  m_target.reset();
  m_resolved.reset();
  m_refined.reset();
  m_refining = m_showRefined = false;
  doneCurrent();
  m_usable = false;
}

bool GlSurface::ensureTarget(std::unique_ptr<QOpenGLFramebufferObject>& target, QSize size, int samples) {
  if (target && target->size() == size) return target->isValid();
  QOpenGLFramebufferObjectFormat format;
  format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
  format.setInternalTextureFormat(GL_RGBA8);
  format.setSamples(samples);
  target = std::make_unique<QOpenGLFramebufferObject>(size, format);
  return target->isValid();
}

bool GlSurface::ensureTargets(int width, int height) {
  const QSize size(width, height);
  return ensureTarget(m_resolved, size, 0) && (m_samples == 0 || ensureTarget(m_target, size, m_samples));
}

void GlSurface::paintGL() {
  m_sincePaint.restart();
  QOpenGLExtraFunctions& gl = *context()->extraFunctions();
  const double ratio = devicePixelRatioF();
  const int width = std::max(1, static_cast<int>(std::lround(this->width() * ratio)));
  const int height = std::max(1, static_cast<int>(std::lround(this->height() * ratio)));
  if (m_options.width != width || m_options.height != height) sceneChanged();
  m_options.width = width;
  m_options.height = height;
  if (m_usable && (m_dirty || !m_resolved))
    drawScene();
  else if (m_usable && m_refining)
    drawBand();
  gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  gl.glViewport(0, 0, width, height);
  if (m_usable && m_resolved) {
    showScene();
  } else {
    gl.glClearColor(0.12f, 0.13f, 0.15f, 1.0f);
    gl.glClear(GL_COLOR_BUFFER_BIT);
  }
  resetState(gl);
  if (m_overlay) {
    QPainter painter(this);
    m_overlay(painter);
  }
}

void GlSurface::drawScene() {
  const auto begin = std::chrono::steady_clock::now();
  // Taken over here, so that a hidden view costs nothing and only the newest frame is uploaded.
  if (std::exchange(m_sceneIsNew, false)) {
    m_renderer->setScene(m_scene);
    // On a slow driver the upload has a turn of its own, so that upload and picture together do not hold up
    // the window.
    if (m_samples == 0) return scheduleUpdate();
  }
  if (std::exchange(m_frameIsNew, false)) m_renderer->setFrame(m_frame);
  const auto uploaded = std::chrono::steady_clock::now();
  const DrawBudget::Effort effort = m_budget.effort(m_moving);
  RenderOptions options = m_options;
  options.quality = effort.quality;
  options.width = std::max(1, static_cast<int>(std::lround(m_options.width * effort.scale)));
  options.height = std::max(1, static_cast<int>(std::lround(m_options.height * effort.scale)));
  if (!ensureTargets(options.width, options.height)) return;
  QOpenGLFramebufferObject& target = m_target ? *m_target : *m_resolved;
  m_renderer->draw(target.handle(), m_camera, m_filmTime, options);
  if (m_target) QOpenGLFramebufferObject::blitFramebuffer(m_resolved.get(), m_target.get());
  context()->functions()->glFinish();
  const auto end = std::chrono::steady_clock::now();
  m_lastSeconds = std::chrono::duration<double>(end - begin).count();
  m_budget.report(m_moving, std::chrono::duration<double>(end - uploaded).count());
  m_drawnEffort = effort;
  m_dirty = m_showRefined = false;
  // The detail that was left out comes once the view rests.
  if (effort != DrawBudget::Effort{}) m_settle.start();
  Q_EMIT drawn(m_lastSeconds);
}

void GlSurface::drawBand() {
  const auto begin = std::chrono::steady_clock::now();
  if (!ensureTarget(m_refined, QSize(m_options.width, m_options.height), 0)) {
    m_refining = false;
    return;
  }
  RenderOptions options = m_options;
  options.band = m_bands.next();
  m_renderer->draw(m_refined->handle(), m_camera, m_filmTime, options);
  context()->functions()->glFinish();
  m_bands.report(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  if (!m_bands.done()) return scheduleUpdate();
  m_refining = false;
  m_showRefined = true;
  Q_EMIT refined();
}

void GlSurface::showScene() {
  QOpenGLExtraFunctions& gl = *context()->extraFunctions();
  const QOpenGLFramebufferObject& shown = m_showRefined ? *m_refined : *m_resolved;
  gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, shown.handle());
  gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl.glDisable(GL_SCISSOR_TEST);
  gl.glBlitFramebuffer(0, 0, shown.width(), shown.height(), 0, 0, m_options.width, m_options.height,
                       GL_COLOR_BUFFER_BIT, GL_LINEAR);
  gl.glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

}  // namespace spin
