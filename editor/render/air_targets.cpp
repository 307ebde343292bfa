// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/air_targets.h"

#include <fmt/format.h>

namespace spin {
namespace {

GLenum makeLayer(AirTargets::Layer& layer, int width, int height) {
  layer.framebuffer = GlFramebuffer::make();
  const GlTexture* const made[] = {&(layer.look = GlTexture::make(GLenum{GL_TEXTURE_2D})),
                                   &(layer.place = GlTexture::make(GLenum{GL_TEXTURE_2D}))};
  const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  for (int k = 0; k < 2; ++k) {
    glTextureStorage2D(made[k]->id(), 1, k == 0 ? GL_RGBA16F : GL_RGBA32F, width, height);
    setSampling(*made[k], GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
    glNamedFramebufferTexture(layer.framebuffer.id(), attachments[k], made[k]->id(), 0);
  }
  glNamedFramebufferDrawBuffers(layer.framebuffer.id(), 2, attachments);
  return glCheckNamedFramebufferStatus(layer.framebuffer.id(), GL_FRAMEBUFFER);
}

}  // namespace

Status AirTargets::prepare(int pictureWidth, int pictureHeight) {
  const int w = (pictureWidth + 1) / 2, h = (pictureHeight + 1) / 2;
  if (w == width && h == height && raw.framebuffer) return {};
  width = w;
  height = h;
  for (Layer* layer : {&raw, &smooth}) {
    const GLenum state = makeLayer(*layer, w, h);
    if (state == GL_FRAMEBUFFER_COMPLETE) continue;
    raw.framebuffer.reset();
    return Error{ErrorKind::OutOfResources, "What hangs in the air cannot be drawn",
                 fmt::format("{} x {} pixels", w, h),
                 fmt::format("the driver refuses the target (0x{:04x})", state), "Choose a smaller picture"};
  }
  return {};
}

void AirTargets::clear() const {
  const float look[4] = {0.0f, 0.0f, 0.0f, 1.0f}, place[4] = {1e6f, 1e6f, 0.0f, 0.0f};
  for (const Layer* layer : {&raw, &smooth}) {
    glClearNamedFramebufferfv(layer->framebuffer.id(), GL_COLOR, 0, look);
    glClearNamedFramebufferfv(layer->framebuffer.id(), GL_COLOR, 1, place);
  }
}

}  // namespace spin
