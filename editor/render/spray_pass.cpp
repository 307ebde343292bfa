// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/spray_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/log.h"
#include "core/base/random.h"
#include "core/base/units.h"
#include "core/nodes/settings_nodes.h"
#include "editor/render/flow_pass.h"
#include "editor/render/scissor_limit.h"

namespace spin {
namespace {

constexpr double kWater = 1000.0;                          // kg/m3
constexpr double kFirstRadius = 2.0;                       // of the radius of the parcel's water
constexpr double kSpreading = 0.4;                         // m/s
constexpr double kLargestRadius = 1.5;                     // m
constexpr double kLongest = 4.0;                           // m that a parcel is drawn out at most
constexpr int kMostPieces = 9;                             // that a parcel is shown as
constexpr std::size_t kMostPuffs = 200000;                 // of all parcels
constexpr double kPieceSpread = 0.65, kPieceRadius = 0.5;  // of the parcel's radius
constexpr std::uint32_t kPieceStream = 0x5055;
constexpr float kExposureSeconds = 1.0f / 48.0f;  // as flakes have it
constexpr double kTornDrop = 6e-3;                // m, of water that has come apart
constexpr double kTornRadius = 2.2;               // of the spacing
constexpr float kSmallestWidth = 1.4f;            // px

const std::vector<float>* valuesOf(const ParticleSet& set, const char* name, int components) {
  const ParticleAttribute* a = set.find(name);
  const bool whole = a && a->components == components &&
                     a->values.size() == set.size() * static_cast<std::size_t>(components);
  return whole ? &a->values : nullptr;
}

}  // namespace

namespace {

/// A parcel as a whole.
struct Parcel {
  SprayPuff puff;
  double length = 0.0;  ///< m, along its velocity
  std::uint32_t id = 0;
};

/// Water that falls freely is drawn out as it gets faster: what left the crest together is as long as both
/// speeds differ.
double drawnOut(double size, Vec3f velocity, double seconds) {
  const Vec3d now = velocity.to<double>(), then = now + Vec3d{0, 0, kStandardGravity * seconds};
  const double speed = length(now);
  return std::min(size * std::max(speed / std::max(length(then), 1.0), 1.0), kLongest);
}

void addPieces(const Parcel& parcel, int pieces, std::vector<SprayPuff>& puffs) {
  const CounterRandom random{parcel.id, kPieceStream};
  const Vec3d way = parcel.puff.velocity.to<double>();
  const double speed = length(way), radius = static_cast<double>(parcel.puff.radius);
  for (int k = 0; k < pieces; ++k) {
    const auto draw = [&](std::uint32_t n) {
      return 2.0 * random.uniformDouble(static_cast<std::uint64_t>(k), n) - 1.0;
    };
    Vec3d offset = Vec3d{draw(0), draw(1), draw(2)} * (kPieceSpread * radius);
    if (speed > 0.0) offset += way * (0.5 * parcel.length / speed * draw(3));
    SprayPuff piece = parcel.puff;
    piece.position = (piece.position.to<double>() + offset).to<float>();
    piece.area /= static_cast<float>(pieces);
    piece.radius *= static_cast<float>(kPieceRadius * (1.0 + 0.4 * draw(4)));
    puffs.push_back(piece);
  }
}

}  // namespace

std::vector<SprayPuff> sprayPuffs(const ParticleSet& set) {
  const std::vector<float>*velocity = valuesOf(set, "velocity", 3), *diameter = valuesOf(set, "diameter", 1),
        *mass = valuesOf(set, "mass", 1), *age = valuesOf(set, "age", 1);
  std::vector<SprayPuff> puffs;
  if (!diameter || !mass) return puffs;
  const int pieces =
      std::clamp(static_cast<int>(kMostPuffs / std::max<std::size_t>(set.size(), 1)), 1, kMostPieces);
  puffs.reserve(set.size() * static_cast<std::size_t>(pieces));
  for (std::size_t k = 0; k < set.size(); ++k) {
    const double m = static_cast<double>((*mass)[k]), d = static_cast<double>((*diameter)[k]);
    if (!(m > 0.0) || !(d > 0.0) || !std::isfinite(m / d)) continue;
    const double seconds = age ? std::max(static_cast<double>((*age)[k]), 0.0) : 0.0;
    const double radius = kFirstRadius * std::cbrt(m / kWater * 0.75 / kPi) + kSpreading * seconds;
    Parcel parcel;
    parcel.puff = {set.positions[k],
                   static_cast<float>(1.5 * m / (kWater * d)),
                   {},
                   static_cast<float>(std::min(radius, kLargestRadius))};
    if (velocity) parcel.puff.velocity = {(*velocity)[3 * k], (*velocity)[3 * k + 1], (*velocity)[3 * k + 2]};
    parcel.length = drawnOut(std::cbrt(m / kWater), parcel.puff.velocity, seconds);
    parcel.id = k < set.ids.size() ? set.ids[k] : static_cast<std::uint32_t>(k);
    addPieces(parcel, pieces, puffs);
  }
  return puffs;
}

std::vector<SprayPuff> loosePuffs(const ParticleSet& flow, double spacing) {
  std::vector<SprayPuff> puffs;
  const std::vector<bool> loose = looseWater(flow);
  const std::vector<float>* velocity = valuesOf(flow, "velocity", 3);
  for (std::size_t k = 0; k < loose.size(); ++k) {
    if (!loose[k]) continue;
    SprayPuff puff{flow.positions[k],
                   static_cast<float>(1.5 * std::pow(spacing, 3) / kTornDrop),
                   {},
                   static_cast<float>(std::min(kTornRadius * spacing, kLargestRadius))};
    if (velocity) puff.velocity = {(*velocity)[3 * k], (*velocity)[3 * k + 1], (*velocity)[3 * k + 2]};
    puffs.push_back(puff);
  }
  return puffs;
}

Status SprayPass::initialise() {
  auto program = GlProgram::build("spray.vert", "spray.frag", "#define AIR_KEPT 1\n");
  if (!program) return program.error();
  m_program = std::move(*program);
  auto blend = GlProgram::build("screen.vert", "spray_blend.frag");
  if (!blend) return blend.error();
  m_blend = std::move(*blend);
  m_vertexArray = GlVertexArray::make();
  return {};
}

void SprayPass::setSpray(std::shared_ptr<const ParticlePart> spray, std::shared_ptr<const ParticlePart> flow,
                         double spacing) {
  if (spray == m_spray && flow == m_flow) return;
  m_spray = std::move(spray);
  m_flow = std::move(flow);
  m_bounds = {};
  std::vector<SprayPuff> puffs;
  if (m_spray) puffs = sprayPuffs(m_spray->particles);
  m_count = puffs.size();
  if (m_flow) {
    const std::vector<SprayPuff> loose = loosePuffs(m_flow->particles, spacing);
    puffs.insert(puffs.end(), loose.begin(), loose.end());
  }
  m_looseCount = puffs.size() - m_count;
  if (puffs.empty()) return;
  for (const SprayPuff& puff : puffs) m_bounds.extend(puff.position.to<double>());
  const Vec3d margin{kLargestRadius, kLargestRadius, kLargestRadius};
  m_bounds.extend(m_bounds.min - margin);
  m_bounds.extend(m_bounds.max + margin);
  if (!m_puffs) m_puffs = GlBuffer::make();
  glNamedBufferData(m_puffs.id(), static_cast<GLsizeiptr>(puffs.size() * sizeof(SprayPuff)), puffs.data(),
                    GL_DYNAMIC_DRAW);
}

Status SprayPass::prepareTargets(int width, int height) {
  if (m_framebuffer && width == m_width && height == m_height) return {};
  m_width = width;
  m_height = height;
  m_framebuffer = GlFramebuffer::make();
  const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  for (GlTexture* texture : {&m_sum, &m_through}) {
    *texture = GlTexture::make(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(texture->id(), 1, texture == &m_sum ? GL_RGBA16F : GL_R16F, width, height);
    setSampling(*texture, GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
    glNamedFramebufferTexture(m_framebuffer.id(), attachments[texture == &m_sum ? 0 : 1], texture->id(), 0);
  }
  glNamedFramebufferDrawBuffers(m_framebuffer.id(), 2, attachments);
  const GLenum state = glCheckNamedFramebufferStatus(m_framebuffer.id(), GL_FRAMEBUFFER);
  if (state == GL_FRAMEBUFFER_COMPLETE) return {};
  m_framebuffer.reset();
  return Error{ErrorKind::OutOfResources, "Spray cannot be drawn",
               fmt::format("{} x {} pixels", width, height),
               fmt::format("the driver refuses the target (0x{:04x})", state), "Choose a smaller picture"};
}

void SprayPass::draw(GLuint framebuffer, GLuint depth, const DrawContext& context) {
  const auto shown = context.scene.settings<RenderNode>(context.filmTime).flowDisplay;
  const std::size_t count = m_count + (shown == FlowDisplay::Material ? m_looseCount : 0);
  if (count == 0) return;
  const std::array<int, 4> pixels =
      pixelsOf(m_bounds, context.block.viewProjection, context.options.width, context.options.height, 8.0);
  if (pixels[0] == pixels[2]) return;
  if (Status made = prepareTargets(context.options.width, context.options.height); !made) {
    logWarning(made.error().text());
    return;
  }
  const ScissorLimit limit(pixels);
  const float nothing[4] = {}, all[4] = {1.0f, 1.0f, 1.0f, 1.0f};
  glDisable(GL_SCISSOR_TEST);
  glClearNamedFramebufferfv(m_framebuffer.id(), GL_COLOR, 0, nothing);
  glClearNamedFramebufferfv(m_framebuffer.id(), GL_COLOR, 1, all);
  glEnable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
  glDisable(GL_DEPTH_TEST);
  glBlendFunci(0, GL_ONE, GL_ONE);
  glBlendFunci(1, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
  m_program.set("uSpray", kExposureSeconds, kSmallestWidth, static_cast<float>(context.pixelsPerUnit), 0.0f);
  glBindVertexArray(m_vertexArray.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, m_puffs.id());
  glBindTextureUnit(7, depth);
  m_program.use();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glBindTextureUnit(7, m_sum.id());
  glBindTextureUnit(8, m_through.id());
  m_blend.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace spin
