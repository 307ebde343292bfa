// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/flow_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

void makeColour(GlTexture& texture, GlFramebuffer& framebuffer, GLenum format, int width, int height,
                GLint filter) {
  texture = GlTexture::make(GLenum{GL_TEXTURE_2D});
  glTextureStorage2D(texture.id(), 1, format, width, height);
  setSampling(texture, filter, filter, GL_CLAMP_TO_EDGE);
  framebuffer = GlFramebuffer::make();
  glNamedFramebufferTexture(framebuffer.id(), GL_COLOR_ATTACHMENT0, texture.id(), 0);
}

}  // namespace

Status FlowTargets::prepare(int pictureWidth, int pictureHeight, double newScale) {
  const auto sized = [&](int pixels) {
    return std::max(1, static_cast<int>(std::ceil(pixels * newScale))) + 2 * kMargin;
  };
  const int w = sized(pictureWidth), h = sized(pictureHeight);
  scale = newScale;
  if (w == width && h == height && rawFramebuffer) return {};
  width = w;
  height = h;
  makeColour(raw, rawFramebuffer, GL_RG32F, w, h, GL_NEAREST);
  depth = GlRenderbuffer::make();
  glNamedRenderbufferStorage(depth.id(), GL_DEPTH_COMPONENT32F, w, h);
  glNamedFramebufferRenderbuffer(rawFramebuffer.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());
  for (std::size_t k = 0; k < 2; ++k) makeColour(smooth[k], smoothFramebuffer[k], GL_R32F, w, h, GL_NEAREST);
  makeColour(normal, normalFramebuffer, GL_RGBA16F, w, h, GL_LINEAR);
  makeColour(thickness, thicknessFramebuffer, GL_RGBA16F, halfWidth(), halfHeight(), GL_LINEAR);
  makeColour(dust, dustFramebuffer, GL_RG16F, halfWidth(), halfHeight(), GL_LINEAR);
  for (const GlFramebuffer* made : {&rawFramebuffer, &smoothFramebuffer[0], &smoothFramebuffer[1],
                                    &normalFramebuffer, &thicknessFramebuffer, &dustFramebuffer}) {
    const GLenum state = glCheckNamedFramebufferStatus(made->id(), GL_FRAMEBUFFER);
    if (state == GL_FRAMEBUFFER_COMPLETE) continue;
    rawFramebuffer.reset();
    return Error{ErrorKind::OutOfResources, "The flow cannot be drawn", fmt::format("{} x {} pixels", w, h),
                 fmt::format("the driver refuses the target (0x{:04x})", state), "Choose a smaller picture"};
  }
  return {};
}

}  // namespace spin
