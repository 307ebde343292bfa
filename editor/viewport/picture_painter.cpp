// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/picture_painter.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace spin {
namespace {

constexpr int kSmoothSamples = 4;

double secondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

bool isSoftware(const std::string& rendererName) {
  return rendererName.find("llvmpipe") != std::string::npos ||
         rendererName.find("softpipe") != std::string::npos;
}

}  // namespace

PicturePainter::PicturePainter(std::unique_ptr<EglContext> context)
    : m_context(std::move(context)), m_renderer(std::make_unique<Renderer>()) {
  m_software = isSoftware(m_context->rendererName());
  if (m_software) m_budget.startLow();
}

PicturePainter::~PicturePainter() = default;

Result<std::unique_ptr<PicturePainter>> PicturePainter::create() {
  Result<std::unique_ptr<EglContext>> context = EglContext::create();
  if (!context) return context.error();
  std::unique_ptr<PicturePainter> painter(new PicturePainter(std::move(*context)));
  if (Status status = painter->m_renderer->initialise(); !status) return status.error();
  return painter;
}

Result<PicturePainter::Drawn> PicturePainter::draw(const PictureRequest& request) {
  const auto begin = std::chrono::steady_clock::now();
  const auto terrain = request.scene ? request.scene->terrain : nullptr;
  if (m_software && terrain != m_terrain) m_budget.startLow();
  m_terrain = terrain;
  m_renderer->setScene(request.scene);
  m_renderer->setFrame(request.frame);
  m_renderer->setFlakeAtlas(request.flakeAtlas);
  const auto uploaded = std::chrono::steady_clock::now();
  const DrawBudget::Effort effort = m_budget.effort(request.moving);
  RenderOptions options = request.options;
  options.quality = effort.quality;
  options.samples = m_software ? 1 : kSmoothSamples;
  options.width = std::max(1, static_cast<int>(std::lround(options.width * effort.scale)));
  options.height = std::max(1, static_cast<int>(std::lround(options.height * effort.scale)));
  const int width = request.options.width, height = request.options.height;
  if (Status s = m_shown.prepare(width, height, GL_RGBA8, 1); !s) return s.error();
  if (Status s = m_drawn.prepare(options.width, options.height, GL_RGBA8, 1); !s) return s.error();
  m_renderer->draw(m_drawn.framebuffer(), request.camera, request.filmTime, options);
  Drawn drawn;
  drawn.picture = read(m_drawn, width, height);
  drawn.complete = effort == DrawBudget::Effort{} && !m_software;
  drawn.seconds = secondsSince(begin);
  m_budget.report(request.moving, secondsSince(uploaded));
  return drawn;
}

std::optional<QImage> PicturePainter::refine(const PictureRequest& request,
                                             const std::function<bool()>& interrupted) {
  RenderOptions options = request.options;
  options.samples = kSmoothSamples;
  if (!m_refined.prepare(options.width, options.height, GL_RGBA8, 1)) return std::nullopt;
  if (!m_shown.prepare(options.width, options.height, GL_RGBA8, 1)) return std::nullopt;
  m_bands.restart();
  while (!m_bands.done()) {
    if (interrupted()) return std::nullopt;
    const auto begin = std::chrono::steady_clock::now();
    options.band = m_bands.next();
    m_renderer->draw(m_refined.framebuffer(), request.camera, request.filmTime, options);
    glFinish();
    m_bands.report(secondsSince(begin));
  }
  return read(m_refined, options.width, options.height);
}

QImage PicturePainter::read(const RenderTarget& drawn, int width, int height) {
  // Images begin at the top, framebuffers at the bottom.
  glBlitNamedFramebuffer(drawn.framebuffer(), m_shown.framebuffer(), 0, 0, drawn.width(), drawn.height(), 0,
                         height, width, 0, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  QImage picture(width, height, QImage::Format_RGB32);
  if (picture.isNull()) return picture;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, m_shown.framebuffer());
  glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, picture.bits());
  return picture;
}

}  // namespace spin
