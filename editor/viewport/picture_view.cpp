// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/picture_view.h"

#include <QGuiApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace spin {
namespace {

constexpr QColor kEmpty(31, 33, 38);
constexpr QColor kNoticeText(200, 204, 210);

}  // namespace

bool screenIsThere() {
  const QString platform = QGuiApplication::platformName();
  return platform != QLatin1String("offscreen") && platform != QLatin1String("minimal");
}

PictureView::PictureView(QWidget* parent) : QWidget(parent) {
  setObjectName("pictureView");
  setAttribute(Qt::WA_OpaquePaintEvent);
  if (!screenIsThere()) m_notice = tr("There is no screen here. Everything but the picture works.");
  // Several changes in one turn of the event loop are one request.
  m_send.setSingleShot(true);
  m_send.setInterval(0);
  connect(&m_send, &QTimer::timeout, this, &PictureView::send);
}

void PictureView::setScene(SnapshotPointer scene) {
  if (scene == m_request.scene) return;
  m_request.scene = std::move(scene);
  changed();
}

void PictureView::setFrame(FramePointer frame) {
  if (frame == m_request.frame) return;
  m_request.frame = std::move(frame);
  changed();
}

void PictureView::setFlakeAtlas(std::shared_ptr<const FlakeAtlas> atlas) {
  if (atlas == m_request.flakeAtlas) return;
  m_request.flakeAtlas = std::move(atlas);
  changed();
}

void PictureView::setView(const RenderCamera& camera, double filmTime, const RenderOptions& options) {
  m_request.camera = camera;
  m_request.filmTime = filmTime;
  m_request.options = options;
  changed();
}

void PictureView::setMoving(bool moving) {
  m_request.moving = moving;
  if (!moving && std::exchange(m_wasMoving, false)) changed();
}

void PictureView::changed() {
  m_dirty = true;
  if (!m_send.isActive()) m_send.start();
}

void PictureView::send() {
  // A hidden view catches up when it is painted again.
  const bool broken = !m_notice.isEmpty() && m_rendererName.isEmpty();
  if (!m_dirty || broken || !isVisible() || window()->isMinimized()) return;
  if (!m_drawer) startDrawer();
  m_dirty = false;
  const double ratio = devicePixelRatioF();
  m_request.options.width = std::max(1, static_cast<int>(std::lround(width() * ratio)));
  m_request.options.height = std::max(1, static_cast<int>(std::lround(height() * ratio)));
  m_drawer->request(m_request);
  m_wasMoving = std::exchange(m_request.moving, false);
}

void PictureView::startDrawer() {
  m_drawer = new PictureDrawer(this);
  connect(m_drawer, &PictureDrawer::started, this, [this](const QString& name) { m_rendererName = name; });
  connect(m_drawer, &PictureDrawer::drawn, this, [this](const QImage& picture, double seconds) {
    take(picture);
    Q_EMIT drawn(seconds);
  });
  connect(m_drawer, &PictureDrawer::refined, this, [this](const QImage& picture) {
    take(picture);
    Q_EMIT refined();
  });
  connect(m_drawer, &PictureDrawer::failed, this, [this](const QString& message) {
    m_notice = tr("The scene cannot be drawn here. Everything else works.\n%1").arg(message);
    m_picture = QImage();
    update();
    Q_EMIT failed(message);
  });
}

void PictureView::take(const QImage& picture) {
  m_picture = picture;
  m_notice.clear();
  update();
}

void PictureView::paintEvent(QPaintEvent*) {
  if (m_dirty && !m_send.isActive()) m_send.start();
  QPainter painter(this);
  if (m_picture.isNull()) {
    painter.fillRect(rect(), kEmpty);
    painter.setPen(kNoticeText);
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, m_notice);
  } else {
    painter.drawImage(rect(), m_picture);
  }
  if (m_overlay) m_overlay(painter);
}

void PictureView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  changed();
}

}  // namespace spin
