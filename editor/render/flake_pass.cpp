// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/flake_pass.h"

#include <algorithm>

#include "editor/render/noise_texture.h"

namespace spin {
namespace {

/// Half of a film frame at 24 pictures a second: a shutter of 180 degrees.
constexpr float kExposureSeconds = 1.0f / 48.0f;
constexpr float kSmallestWidth = 1.4f;      // px
constexpr float kDefaultDiameter = 0.004f;  // m, where the particles carry none

void upload(GlBuffer& buffer, const void* data, std::size_t bytes) {
  if (!buffer) buffer = GlBuffer::make();
  glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
}

/// Values of an attribute if it has the wanted width and length.
const std::vector<float>* valuesOf(const ParticleSet& set, const char* name, int components) {
  const ParticleAttribute* a = set.find(name);
  const bool fits = a && a->components == components &&
                    a->values.size() == set.size() * static_cast<std::size_t>(components);
  return fits ? &a->values : nullptr;
}

}  // namespace

Status FlakePass::initialise() {
  auto program = GlProgram::build("flake.vert", "flake.frag");
  if (!program) return program.error();
  m_program = std::move(*program);
  m_vertexArray = GlVertexArray::make();
  m_shapes = GlTexture::make(GLenum{GL_TEXTURE_2D_ARRAY});
  const std::vector<std::uint8_t> atlas = makeFlakeAtlas();
  glTextureStorage3D(m_shapes.id(), 5, GL_R8, kFlakeTexels, kFlakeTexels, kFlakeShapes);
  glTextureSubImage3D(m_shapes.id(), 0, 0, 0, 0, kFlakeTexels, kFlakeTexels, kFlakeShapes, GL_RED,
                      GL_UNSIGNED_BYTE, atlas.data());
  glGenerateTextureMipmap(m_shapes.id());
  setSampling(m_shapes, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_CLAMP_TO_EDGE);
  return {};
}

void FlakePass::setFlakes(std::shared_ptr<const ParticlePart> flakes) {
  if (flakes == m_flakes) return;
  m_flakes = std::move(flakes);
  if (!m_flakes || m_flakes->particles.size() == 0) {
    m_flakes.reset();
    return;
  }
  const ParticleSet& set = m_flakes->particles;
  const auto* diameters = valuesOf(set, "diameter", 1);
  const auto* velocities = valuesOf(set, "velocity", 3);
  m_hasDiameters = diameters != nullptr;
  m_hasVelocities = velocities != nullptr;
  upload(m_positions, set.positions.data(), set.positions.size() * sizeof(Vec3f));
  // Shader buffers must exist even where they are not read.
  const float nothing[3] = {};
  upload(m_diameters, diameters ? diameters->data() : nothing,
         diameters ? diameters->size() * sizeof(float) : sizeof nothing);
  upload(m_velocities, velocities ? velocities->data() : nothing,
         velocities ? velocities->size() * sizeof(float) : sizeof nothing);
  growIndices(set.size());
}

void FlakePass::growIndices(std::size_t flakes) {
  if (flakes <= m_indexedFlakes) return;
  std::vector<std::uint32_t> indices;
  indices.reserve(flakes * 6);
  for (std::uint32_t k = 0; k < flakes; ++k)
    for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) indices.push_back(4 * k + corner);
  upload(m_indices, indices.data(), indices.size() * sizeof(std::uint32_t));
  glVertexArrayElementBuffer(m_vertexArray.id(), m_indices.id());
  m_indexedFlakes = flakes;
}

void FlakePass::draw(const DrawContext& context) const {
  if (!m_flakes) return;
  const ParticleSet& set = m_flakes->particles;
  const double share = std::clamp(context.options.quality, 0.05, 1.0);
  const auto count = static_cast<GLsizei>(static_cast<double>(set.size()) * share);
  m_program.use();
  m_program.set("uBox", static_cast<float>(set.wrapBox), static_cast<float>(std::max(set.weight, 1.0)),
                kExposureSeconds, kSmallestWidth);
  m_program.set("uFlake", kDefaultDiameter, m_hasDiameters ? 1.0f : 0.0f, m_hasVelocities ? 1.0f : 0.0f,
                0.0f);
  glBindVertexArray(m_vertexArray.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, m_positions.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, m_diameters.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, m_velocities.id());
  glBindTextureUnit(7, m_shapes.id());
  glDrawElements(GL_TRIANGLES, count * 6, GL_UNSIGNED_INT, nullptr);
}

}  // namespace spin
