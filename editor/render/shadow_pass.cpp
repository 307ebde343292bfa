// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/shadow_pass.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

/// Smallest half-width of the shadowed square, m; it doubles as the camera draws back.
constexpr double kHalfSize = 48.0;

/// Distance ahead at which shadows matter: that of the nearest model or flow before the camera.
double focusDistance(const std::vector<PlacedModel>& placed, const FlowPass& flow,
                     const RenderCamera& camera) {
  const Vec3d forward = normalized(camera.target - camera.position);
  double nearest = 1e9;
  const auto see = [&](Vec3d centre) {
    const Vec3d to = centre - camera.position;
    if (dot(to, forward) > 0.0) nearest = std::min(nearest, length(to));
  };
  for (const PlacedModel& one : placed) see(one.bounds.centre());
  if (!flow.bounds().empty()) see(flow.bounds().centre());
  return nearest < 1e9 ? nearest : 0.0;
}

bool inside(const Matrix4& light, const Box3d& box) {
  const Vec3d c = box.centre();
  const double radius = 0.5 * length(box.size());
  for (std::size_t r = 0; r < 2; ++r) {
    double v = static_cast<double>(light[12 + r]), scale = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double m = static_cast<double>(light[k * 4 + r]);
      v += m * c[static_cast<int>(k)];
      scale += m * m;
    }
    if (std::abs(v) > 1.0 + radius * std::sqrt(scale)) return false;
  }
  return true;
}

}  // namespace

Status ShadowPass::initialise() {
  m_sun.texels = kSunTexels;
  m_zenith.texels = kZenithTexels;
  for (Map* map : {&m_sun, &m_zenith}) {
    map->depth = GlTexture::make(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(map->depth.id(), 1, GL_DEPTH_COMPONENT32F, map->texels, map->texels);
    setSampling(map->depth, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
    glTextureParameteri(map->depth.id(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(map->depth.id(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    map->framebuffer = GlFramebuffer::make();
    glNamedFramebufferTexture(map->framebuffer.id(), GL_DEPTH_ATTACHMENT, map->depth.id(), 0);
    glNamedFramebufferDrawBuffer(map->framebuffer.id(), GL_NONE);
    const GLenum state = glCheckNamedFramebufferStatus(map->framebuffer.id(), GL_FRAMEBUFFER);
    if (state != GL_FRAMEBUFFER_COMPLETE)
      return Error{ErrorKind::Failed, "Shadow maps cannot be made", "OpenGL",
                   "the driver refuses the depth target", "Update the graphics driver"};
  }
  return {};
}

void ShadowPass::update(const ModelPass& models, const std::vector<PlacedModel>& placed, const FlowPass& flow,
                        const RenderCamera& camera, Vec3d toSun, FrameBlock& block) {
  const bool nothing = placed.empty() && flow.empty();
  block.zenith.w = nothing ? 0.0f : 1.0f;
  if (nothing) return;
  const double focus = focusDistance(placed, flow, camera);
  const double steps = std::max(0.0, std::ceil(std::log2(std::max(1.0, (focus + 16.0) / kHalfSize))));
  const double half = kHalfSize * std::exp2(std::min(steps, 6.0));
  const Vec3d ahead = camera.target - camera.position;
  const Vec3d centre = camera.position + normalized(ahead) * std::min(focus, half);
  block.shadowMatrix = lightMatrix(centre, toSun, half, 2.0 * half, kSunTexels);
  block.zenithMatrix = lightMatrix(centre, {0, 0, 1}, half, 2.0 * half, kZenithTexels);
  if (toSun.z > 0.0) drawMap(m_sun, block.shadowMatrix, half, models, placed, &flow);
  drawMap(m_zenith, block.zenithMatrix, half, models, placed, nullptr);
}

void ShadowPass::drawMap(Map& map, const Matrix4& light, double halfSize, const ModelPass& models,
                         const std::vector<PlacedModel>& placed, const FlowPass* flow) {
  std::vector<double> key(light.begin(), light.end());
  if (flow) key.push_back(flow->revision());
  std::vector<PlacedModel> casting;
  for (const PlacedModel& one : placed) {
    if (!inside(light, one.bounds)) continue;
    casting.push_back(one);
    key.insert(key.end(), one.transform.linear.begin(), one.transform.linear.end());
    for (int k = 0; k < 3; ++k) key.push_back(one.transform.translation[k]);
    key.push_back(static_cast<double>(one.model->vertices.id()));
  }
  if (key == map.key) return;
  map.key = std::move(key);
  ++m_timesDrawn;
  glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer.id());
  glViewport(0, 0, map.texels, map.texels);
  const float far = 1.0f;
  glClearNamedFramebufferfv(map.framebuffer.id(), GL_DEPTH, 0, &far);
  glDepthFunc(GL_LESS);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5f, 2.0f);
  models.drawDepth(light, casting);
  if (flow) flow->drawDepth(light, 0.5 * map.texels / halfSize);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void ShadowPass::bindTextures() const {
  glBindTextureUnit(1, m_sun.depth.id());
  glBindTextureUnit(2, m_zenith.depth.id());
}

}  // namespace spin
