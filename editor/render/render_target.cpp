// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/render_target.h"

#include <fmt/format.h>

#include <algorithm>

namespace spin {

Status RenderTarget::prepare(int width, int height, GLenum colourFormat, int samples) {
  GLint maxSamples = 1, maxSize = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &maxSamples);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &maxSize);
  if (width < 1 || height < 1 || width > maxSize || height > maxSize)
    return Error{ErrorKind::Usage, "The picture cannot be drawn",
                 fmt::format("{} x {} pixels", width, height),
                 fmt::format("the driver takes 1 to {} pixels a side", maxSize), "Choose another size"};
  // One sample means no multisampling.
  samples = samples <= 1 ? 0 : std::min(samples, maxSamples);
  if (m_framebuffer && width == m_width && height == m_height && samples == m_samples &&
      colourFormat == m_format)
    return {};
  m_colour = GlRenderbuffer::make();
  m_depth = GlRenderbuffer::make();
  m_framebuffer = GlFramebuffer::make();
  glNamedRenderbufferStorageMultisample(m_colour.id(), samples, colourFormat, width, height);
  glNamedRenderbufferStorageMultisample(m_depth.id(), samples, GL_DEPTH_COMPONENT32F, width, height);
  glNamedFramebufferRenderbuffer(m_framebuffer.id(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_colour.id());
  glNamedFramebufferRenderbuffer(m_framebuffer.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth.id());
  const GLenum state = glCheckNamedFramebufferStatus(m_framebuffer.id(), GL_FRAMEBUFFER);
  if (state != GL_FRAMEBUFFER_COMPLETE) {
    m_framebuffer.reset();
    return Error{ErrorKind::OutOfResources, "The picture cannot be drawn",
                 fmt::format("{} x {} pixels, {} samples", width, height, samples),
                 fmt::format("the driver refuses the target (0x{:04x})", state), "Choose a smaller picture"};
  }
  m_width = width;
  m_height = height;
  m_samples = samples;
  m_format = colourFormat;
  return {};
}

}  // namespace spin
