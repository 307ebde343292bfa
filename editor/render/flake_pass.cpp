// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/flake_pass.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/physics/snow_visibility.h"

namespace spin {
namespace {

/// Half of a film frame at 24 pictures a second: a shutter of 180 degrees.
constexpr float kExposureSeconds = 1.0f / 48.0f;
constexpr float kSmallestWidth = 1.4f;  // px
constexpr double kFrustumMargin = 1.05;
constexpr double kDiscCover = 0.5;  // of the soft disc that stands in for shapes

/// Share of the flakes' circles that the pictures cover: the last mip level of a layer is its mean.
double coverOf(const FlakeAtlas& atlas) {
  double sum = 0.0;
  for (const std::uint8_t mean : atlas.levels.back()) sum += mean / 255.0;
  const double circle = 0.25 * kPi * std::pow(1.0 - 2.0 / atlas.size, 2);
  return std::clamp(sum / (static_cast<double>(atlas.levels.back().size()) * circle), 0.02, 1.0);
}

}  // namespace

Status FlakePass::initialise() {
  auto program = GlProgram::build("flake.vert", "flake.frag");
  if (!program) return program.error();
  m_program = std::move(*program);
  auto inCloud = GlProgram::build("flake.vert", "flake.frag", "#define AIR_KEPT 1\n");
  if (!inCloud) return inCloud.error();
  m_cloudProgram = std::move(*inCloud);
  m_vertexArray = GlVertexArray::make();
  m_records = GlBuffer::make();
  return {};
}

void FlakePass::setAtlas(std::shared_ptr<const FlakeAtlas> atlas) {
  if (atlas == m_atlas) return;
  m_atlas = std::move(atlas);
  m_shapes.reset();
  m_atlasCover = kDiscCover;
  if (!m_atlas) return;
  m_atlasCover = coverOf(*m_atlas);
  m_shapes = GlTexture::make(GLenum{GL_TEXTURE_2D_ARRAY});
  const auto levels = static_cast<GLsizei>(m_atlas->levels.size());
  glTextureStorage3D(m_shapes.id(), levels, GL_R8, m_atlas->size, m_atlas->size, m_atlas->layers());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (GLsizei level = 0; level < levels; ++level) {
    const auto l = static_cast<std::size_t>(level);
    const int n = m_atlas->sizeOf(l);
    glTextureSubImage3D(m_shapes.id(), level, 0, 0, 0, n, n, m_atlas->layers(), GL_RED, GL_UNSIGNED_BYTE,
                        m_atlas->levels[l].data());
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  setSampling(m_shapes, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_CLAMP_TO_EDGE);
}

void FlakePass::growIndices(std::size_t flakes) {
  if (flakes <= m_indexedFlakes) return;
  std::vector<std::uint32_t> indices;
  indices.reserve(flakes * 6);
  for (std::uint32_t k = 0; k < flakes; ++k)
    for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) indices.push_back(4 * k + corner);
  if (!m_indices) m_indices = GlBuffer::make();
  glNamedBufferData(m_indices.id(), static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                    indices.data(), GL_DYNAMIC_DRAW);
  glVertexArrayElementBuffer(m_vertexArray.id(), m_indices.id());
  m_indexedFlakes = flakes;
}

bool FlakePass::look(const DrawContext& context, const SnowfallNode& snowfall) {
  if (!m_flakes || !(m_flakes->flakes.numberDensity > 0.0)) return false;
  const FallingFlakes& flakes = m_flakes->flakes;
  std::vector<FlakeGroup> groups = flakeGroups(snowfall, flakes.numberDensity);
  if (groups.empty()) return false;
  FlakeView view;
  view.eye = context.camera.position;
  const FrameBlock& b = context.block;
  view.forward = Vec3f{b.forward.x, b.forward.y, b.forward.z}.to<double>();
  view.right = Vec3f{b.right.x, b.right.y, b.right.z}.to<double>();
  view.up = cross(view.right, view.forward);
  view.tangentY = kFrustumMargin * static_cast<double>(b.forward.w);
  view.tangentX = view.tangentY * static_cast<double>(b.right.w);
  view.share = std::clamp(context.options.quality, 0.05, 1.0);
  if (!m_wind || !m_wind->holdsFor(flakes)) m_wind = FallWind::of(flakes, m_backend);
  view.wind = m_wind.get();
  if (m_looked == m_flakes && groups == m_groups && view == m_view) return m_seen.count > 0;
  if (!m_field || !m_field->fits(flakes.seed, groups))
    m_field = std::make_unique<FlakeField>(flakes.seed, groups);
  m_field->look(flakes, groups, view, m_backend, m_seen);
  m_looked = m_flakes;
  m_groups = std::move(groups);
  m_view = view;
  uploadSeen();
  return m_seen.count > 0;
}

void FlakePass::uploadSeen() {
  if (m_room < m_seen.count) {
    m_room = m_seen.count + m_seen.count / 2;
    glNamedBufferData(m_records.id(), static_cast<GLsizeiptr>(m_room * kFlakeRecord * sizeof(float)), nullptr,
                      GL_DYNAMIC_DRAW);
  }
  const std::size_t bytes = m_seen.count * sizeof(float);
  for (std::size_t k = 0; k < kFlakeRecord; ++k)
    glNamedBufferSubData(m_records.id(), static_cast<GLintptr>(k * bytes), static_cast<GLsizeiptr>(bytes),
                         m_seen.values[k]);
  growIndices(m_seen.count);
}

void FlakePass::draw(const DrawContext& context, bool inCloud) {
  const auto snowfall = context.scene.settings<SnowfallNode>(context.filmTime);
  if (!look(context, snowfall)) return;
  const auto at = [](double v) { return static_cast<float>(v); };
  const SpriteSizeLaw pinhole = pinholeSizeLaw(2.0 * std::atan(static_cast<double>(context.block.forward.w)));
  const GlProgram& program = inCloud ? m_cloudProgram : m_program;
  program.use();
  program.set("uCount", static_cast<int>(m_seen.count));
  program.set("uLook", kExposureSeconds, kSmallestWidth, at(m_flakes->flakes.cover), at(m_atlasCover));
  program.set("uSizeLaw", at(snowfall.sizeLawA), at(snowfall.sizeLawB), at(pinhole.c), 0.0f);
  program.set("uShapeCount", m_atlas ? m_atlas->flakes() : 0);
  glBindVertexArray(m_vertexArray.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, m_records.id());
  if (m_shapes) glBindTextureUnit(7, m_shapes.id());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(m_seen.count) * 6, GL_UNSIGNED_INT, nullptr);
}

}  // namespace spin
