// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/air_pass.h"

#include <algorithm>
#include <cmath>

#include "core/base/log.h"
#include "editor/render/scissor_limit.h"

namespace spin {
namespace {

constexpr std::size_t kMostVoxels = 1'500'000;  // of the light
constexpr std::size_t kMostSliceCells = 16'000'000;
constexpr float kLeastExtinction = 1e-6f;                   // 1/m
constexpr double kValueDepth = 4.0;                         // optical, through the smallest side of the cloud
constexpr float kFinestStep = 0.15f, kCoarsestStep = 4.0f;  // cells
constexpr double kLongestShadow = 6.0;                      // heights of the cloud

float at(double v) {
  return static_cast<float>(v);
}

Status buildInto(GlProgram& program, const char* vertex, const char* fragment, const char* defines = "") {
  auto built = GlProgram::build(vertex, fragment, defines);
  if (!built) return built.error();
  program = std::move(*built);
  return {};
}

GlTexture volume(GLenum format, int x, int y, int z, GLint filter) {
  GlTexture texture = GlTexture::make(GLenum{GL_TEXTURE_3D});
  glTextureStorage3D(texture.id(), 1, format, x, y, z);
  setSampling(texture, filter, filter, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
  return texture;
}

Box3d boxOf(const AirBlocks& blocks) {
  Box3d box;
  const double side = AirBlocks::kSide * blocks.cell;
  box.extend(blocks.origin);
  box.extend(blocks.origin + Vec3d{1.0 * blocks.size[0], 1.0 * blocks.size[1], 1.0 * blocks.size[2]} * side);
  return box;
}

void setColours(const GlProgram& program, const ValueScale& scale) {
  std::vector<Vec4f> colours;
  for (const Vec3d& c : scaleColours(scale)) colours.push_back({at(c.x), at(c.y), at(c.z), 1.0f});
  program.setArray("uColours", &colours.front().x, static_cast<int>(colours.size()));
}

}  // namespace

Status AirPass::initialise() {
  if (Status s = buildInto(m_march, "screen.vert", "air_march.frag"); !s) return s;
  if (Status s = buildInto(m_valueMarch, "screen.vert", "air_march.frag", "#define VALUES 1"); !s) return s;
  if (Status s = buildInto(m_smooth, "screen.vert", "air_smooth.frag"); !s) return s;
  if (Status s = buildInto(m_blend, "screen.vert", "air_blend.frag"); !s) return s;
  if (Status s = buildInto(m_sliceProgram, "air_slice.vert", "air_slice.frag"); !s) return s;
  m_vertexArray = GlVertexArray::make();
  m_clear = GlTexture::make(GLenum{GL_TEXTURE_2D});
  glTextureStorage2D(m_clear.id(), 1, GL_RGBA8, 1, 1);
  const std::uint8_t clear[4] = {0, 0, 0, 255};
  glTextureSubImage2D(m_clear.id(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, clear);
  setSampling(m_clear, GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
  return {};
}

void AirPass::setAir(std::shared_ptr<const AirPart> air) {
  if (air && air->cells() == 0) air = nullptr;
  if (air == m_air) return;
  m_air = std::move(air);
  m_revision += 1.0;
  m_optics = m_air ? airOptics(*m_air) : AirOptics{};
}

bool AirPass::hasSnow() const {
  const AirField* snow = m_air ? m_air->find("snow") : nullptr;
  return snow && std::any_of(snow->halves.begin(), snow->halves.end(), [](auto half) { return half != 0; });
}

void AirPass::uploadBlocks(const AirBlocks& b) {
  m_index = volume(GL_R16UI, b.size[0], b.size[1], b.size[2], GL_NEAREST);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage3D(m_index.id(), 0, 0, 0, 0, b.size[0], b.size[1], b.size[2], GL_RED_INTEGER,
                      GL_UNSIGNED_SHORT, b.index.data());
  const int side = AirBlocks::kPadded;
  const std::array<int, 4> size{b.slots[0] * side, b.slots[1] * side, b.slots[2] * side, b.channels};
  if (size != m_densitySize)
    m_density = volume(b.channels == 1 ? GL_R16F : GL_RG16F, size[0], size[1], size[2], GL_LINEAR);
  m_densitySize = size;
  glTextureSubImage3D(m_density.id(), 0, 0, 0, 0, size[0], size[1], size[2], b.channels == 1 ? GL_RED : GL_RG,
                      GL_HALF_FLOAT, b.texels.data());
}

void AirPass::uploadLight(const AirLight& light) {
  if (light.empty()) return;
  m_lightTexture = volume(GL_RGBA16F, light.size[0], light.size[1], light.size[2], GL_LINEAR);
  glTextureSubImage3D(m_lightTexture.id(), 0, 0, 0, 0, light.size[0], light.size[1], light.size[2], GL_RGBA,
                      GL_HALF_FLOAT, light.texels.data());
  m_throughTexture = volume(GL_R8, light.size[0], light.size[1], light.size[2], GL_LINEAR);
  glTextureSubImage3D(m_throughTexture.id(), 0, 0, 0, 0, light.size[0], light.size[1], light.size[2], GL_RED,
                      GL_UNSIGNED_BYTE, light.through.data());
}

void AirPass::buildNatural(const AirSky& sky) {
  if (m_optics.extinction.empty()) return;
  m_blocks = packAir(*m_air, {&m_optics.extinction}, kLeastExtinction, {}, m_backend);
  if (m_blocks.empty()) {
    logWarning("The cloud in the air spreads too far to be drawn");
    return;
  }
  m_light = lightAir(*m_air, m_optics, sky, kMostVoxels, m_backend);
  m_ambient = (sky.sky + sky.bounce) * 0.5;
  uploadBlocks(m_blocks);
  uploadLight(m_light);
}

void AirPass::buildValues(const RenderNode& settings) {
  std::vector<float> values = airValues(*m_air, settings.airDisplay);
  if (values.empty()) return;
  m_scale = airScale(settings, *m_air, values);
  const std::vector<float> presence = airPresence(*m_air);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = at(m_scale.place(static_cast<double>(values[k]))) * presence[k];
  m_blocks = packAir(*m_air, {&values, &presence}, 1e-3f, {}, m_backend);
  if (m_blocks.empty()) return;
  uploadBlocks(m_blocks);
  const Vec3d size = boxOf(m_blocks).max - boxOf(m_blocks).min;
  m_valueExtinction = kValueDepth / std::min({size.x, size.y, size.z});
}

void AirPass::buildSlice(const RenderNode& settings) {
  const std::vector<float> values = airValues(*m_air, settings.airDisplay);
  if (values.empty()) return;
  m_scale = airScale(settings, *m_air, values);
  const int axis = static_cast<int>(settings.airSlice) - static_cast<int>(AirSlice::AcrossX);
  m_slice = sliceAir(*m_air, values, m_scale, axis, settings.airSlicePosition, kMostSliceCells);
  if (m_slice.empty()) return;
  m_sliceTexture = GlTexture::make(GLenum{GL_TEXTURE_2D});
  glTextureStorage2D(m_sliceTexture.id(), 1, GL_RG16F, m_slice.width, m_slice.height);
  glTextureSubImage2D(m_sliceTexture.id(), 0, 0, 0, m_slice.width, m_slice.height, GL_RG, GL_FLOAT,
                      m_slice.texels.data());
  setSampling(m_sliceTexture, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
}

void AirPass::prepare(const DrawContext& context, const AirSky& sky, double landRevision) {
  m_drawn = false;
  m_pixels = m_shownPixels = {};
  if (!m_air) return;
  const auto settings = context.scene.settings<RenderNode>(context.filmTime);
  m_values = settings.airDisplay != AirDisplay::Natural;
  m_sliced = m_values && settings.airSlice != AirSlice::Off;
  std::vector<double> key{m_revision, static_cast<double>(settings.airDisplay),
                          m_sliced ? static_cast<double>(settings.airSlice) : 0.0};
  if (m_sliced) key.push_back(settings.airSlicePosition);
  if (m_values) {
    key.insert(key.end(), {settings.airRangeAuto ? 1.0 : 0.0, settings.airRangeLow, settings.airRangeHigh});
  } else {
    for (const Vec3d& v : {sky.toSun, sky.sun, sky.sky, sky.bounce}) key.insert(key.end(), {v.x, v.y, v.z});
    key.push_back(landRevision);
  }
  if (key != m_key) {
    m_key = std::move(key);
    m_blocks = {};
    m_light = {};
    m_slice = {};
    if (m_sliced)
      buildSlice(settings);
    else if (m_values)
      buildValues(settings);
    else
      buildNatural(sky);
    m_blocks.texels = m_blocks.index = {};
    m_light.texels = {};
    m_light.through = {};
    m_slice.texels = {};
  }
  findPixels(context, sky.toSun);
}

/// Where the cloud is in the picture, and where its shadow may fall.
void AirPass::findPixels(const DrawContext& context, Vec3d toSun) {
  const auto pixels = [&](const Box3d& box) {
    return pixelsOf(box, context.block.viewProjection, context.options.width, context.options.height, 4.0);
  };
  if (m_sliced) {
    // Its pixels are found by drawing it.
    if (m_slice.width > 0) m_shownPixels = {0, 0, context.options.width, context.options.height};
    return;
  }
  if (m_blocks.size[0] == 0) return;
  Box3d box = boxOf(m_blocks);
  m_pixels = m_shownPixels = pixels(box);
  if (m_values || !(toSun.z > 0.0)) return;
  const double high = box.max.z - box.min.z;
  box.extend(box.min - toSun * (kLongestShadow * high));
  box.extend(box.max - toSun * (kLongestShadow * high));
  m_shownPixels = pixels(box);
}

void AirPass::draw(GLuint framebuffer, GLuint depth, const DrawContext& context) {
  if (m_sliced) return drawSlice(context);
  if (Status made = m_targets.prepare(context.options.width, context.options.height); !made) {
    logWarning(made.error().text());
    return;
  }
  const ScissorLimit whole({0, 0, context.options.width, context.options.height});
  GLint band[4];
  glGetIntegerv(GL_SCISSOR_BOX, band);
  glDisable(GL_SCISSOR_TEST);
  m_targets.clear();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  // Water leaves factors of two sources behind, which drivers refuse for two targets even where nothing is
  // blended.
  glBlendFunc(GL_ONE, GL_ZERO);
  glBindVertexArray(m_vertexArray.id());
  const auto x0 = std::max(m_pixels[0], band[0]) / 2, y0 = std::max(m_pixels[1], band[1]) / 2;
  const auto x1 = (std::min(m_pixels[2], band[0] + band[2]) + 1) / 2,
             y1 = (std::min(m_pixels[3], band[1] + band[3]) + 1) / 2;
  if (x0 < x1 && y0 < y1) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(x0, y0, x1 - x0, y1 - y0);
    glViewport(0, 0, m_targets.width, m_targets.height);
    march(depth, context);
    smooth(context);
  }
  m_drawn = true;
  glEnable(GL_SCISSOR_TEST);
  glScissor(band[0], band[1], band[2], band[3]);
  glViewport(0, 0, context.options.width, context.options.height);
  glEnable(GL_BLEND);
  blend(framebuffer, depth, context);
  glEnable(GL_DEPTH_TEST);
}

void AirPass::march(GLuint depth, const DrawContext& context) {
  const GlProgram& program = m_values ? m_valueMarch : m_march;
  const Vec3d corner = (m_blocks.origin - context.camera.position) * (1.0 / m_blocks.cell);
  program.set("uAir", at(corner.x), at(corner.y), at(corner.z), at(1.0 / m_blocks.cell));
  program.set("uBlocks", m_blocks.size[0], m_blocks.size[1], m_blocks.size[2], 0);
  program.set("uSlots", m_blocks.slots[0], m_blocks.slots[1], 0, 0);
  program.set("uTexel", 1.0f / at(m_densitySize[0]), 1.0f / at(m_densitySize[1]), 1.0f / at(m_densitySize[2]),
              0.0f);
  const double quality = std::clamp(context.options.quality, 0.3, 1.0);
  program.set("uMarch", at(1.0 / quality), kFinestStep, kCoarsestStep, at(2.0 / context.pixelsPerUnit));
  if (m_values) {
    program.set("uValue", at(m_valueExtinction), 0.0f, 0.0f, 0.0f);
    setColours(program, m_scale);
  } else {
    const AirPhase& phase = m_optics.phase;
    program.set("uPhase", at(phase.peak), at(phase.broad), at(phase.alpha), at(phase.broadShare));
    const double ahead = phase.meanCosine() * phase.meanCosine();
    program.set("uBehind", at(m_ambient.x), at(m_ambient.y), at(m_ambient.z), at(ahead));
    // From cells of the blocks to the light's texture.
    const Vec3d shift = m_blocks.origin - m_light.origin;
    const auto share = [&](int a) {
      return 1.0 / (m_light.voxel * m_light.size[static_cast<std::size_t>(a)]);
    };
    program.set("uLightShift", at(shift.x * share(0)), at(shift.y * share(1)), at(shift.z * share(2)), 0.0f);
    program.set("uLightScale", at(m_blocks.cell * share(0)), at(m_blocks.cell * share(1)),
                at(m_blocks.cell * share(2)), 0.0f);
    glBindTextureUnit(10, m_lightTexture.id());
  }
  glBindTextureUnit(7, depth);
  glBindTextureUnit(8, m_index.id());
  glBindTextureUnit(9, m_density.id());
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.raw.framebuffer.id());
  program.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void AirPass::smooth(const DrawContext&) {
  m_smooth.set("uNatural", m_values ? 0.0f : 1.0f);
  glBindTextureUnit(7, m_targets.raw.look.id());
  glBindTextureUnit(8, m_targets.raw.place.id());
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.smooth.framebuffer.id());
  m_smooth.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void AirPass::blend(GLuint framebuffer, GLuint depth, const DrawContext&) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const bool shades = !m_values && m_light.voxel > 0.0 && m_light.size[0] > 0;
  const Vec3d low = m_light.origin, size = m_light.high() - m_light.origin;
  m_blend.set("uShade", at(low.x), at(low.y), at(low.z), shades ? 1.0f : 0.0f);
  m_blend.set("uShadeSize", at(size.x), at(size.y), at(size.z), at(0.5 * m_light.voxel));
  glBindTextureUnit(7, m_targets.smooth.look.id());
  glBindTextureUnit(8, m_targets.smooth.place.id());
  glBindTextureUnit(9, depth);
  glBindTextureUnit(10, shades ? m_throughTexture.id() : 0);
  glBlendFuncSeparate(GL_ONE, GL_SRC1_COLOR, GL_ZERO, GL_ONE);
  const ScissorLimit limit(m_shownPixels);
  m_blend.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void AirPass::drawSlice(const DrawContext&) const {
  const int u = (m_slice.axis + 1) % 3, v = (m_slice.axis + 2) % 3;
  const auto side = [&](int axis, int cells) {
    const double length = cells * m_slice.cell;
    return Vec3d{axis == 0 ? length : 0.0, axis == 1 ? length : 0.0, axis == 2 ? length : 0.0};
  };
  const Vec3d along = side(u, m_slice.width), up = side(v, m_slice.height);
  m_sliceProgram.set("uCorner", at(m_slice.corner.x), at(m_slice.corner.y), at(m_slice.corner.z), 1.0f);
  m_sliceProgram.set("uAlong", at(along.x), at(along.y), at(along.z), 0.0f);
  m_sliceProgram.set("uUp", at(up.x), at(up.y), at(up.z), 0.0f);
  setColours(m_sliceProgram, m_scale);
  glBindTextureUnit(7, m_sliceTexture.id());
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glBindVertexArray(m_vertexArray.id());
  m_sliceProgram.use();
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void AirPass::bindKept() const {
  glBindTextureUnit(11, m_drawn ? m_targets.smooth.look.id() : m_clear.id());
  glBindTextureUnit(12, m_drawn ? m_targets.smooth.place.id() : m_clear.id());
}

}  // namespace spin
