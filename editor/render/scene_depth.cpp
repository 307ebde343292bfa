// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/scene_depth.h"

#include <fmt/format.h>

namespace spin {

Status SceneDepth::copy(GLuint framebuffer, int width, int height) {
  if (!m_framebuffer || width != m_width || height != m_height) {
    m_depth = GlTexture::make(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(m_depth.id(), 1, GL_DEPTH_COMPONENT32F, width, height);
    setSampling(m_depth, GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
    m_framebuffer = GlFramebuffer::make();
    glNamedFramebufferTexture(m_framebuffer.id(), GL_DEPTH_ATTACHMENT, m_depth.id(), 0);
    glNamedFramebufferDrawBuffer(m_framebuffer.id(), GL_NONE);
    glNamedFramebufferReadBuffer(m_framebuffer.id(), GL_NONE);
    const GLenum state = glCheckNamedFramebufferStatus(m_framebuffer.id(), GL_FRAMEBUFFER);
    if (state != GL_FRAMEBUFFER_COMPLETE) {
      m_framebuffer.reset();
      return Error{ErrorKind::OutOfResources, "What hangs in the air cannot be drawn",
                   fmt::format("{} x {} pixels", width, height),
                   fmt::format("the driver refuses the depth copy (0x{:04x})", state),
                   "Choose a smaller picture"};
    }
    m_width = width;
    m_height = height;
  }
  glBlitNamedFramebuffer(framebuffer, m_framebuffer.id(), 0, 0, width, height, 0, 0, width, height,
                         GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  return {};
}

}  // namespace spin
