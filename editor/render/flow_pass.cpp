// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/flow_pass.h"

#include <algorithm>
#include <cmath>

#include "core/base/log.h"
#include "core/base/units.h"
#include "editor/render/scissor_limit.h"

namespace spin {
namespace {

constexpr double kRadius = 0.8;          // of the spacing: spheres of a lattice at rest close up
constexpr double kSmallestPixels = 1.1;  // radius
/// Radius in the targets' pixels that suffices for a smooth surface; nearer flows get coarser targets.
constexpr double kEnoughPixels = 9.0;
constexpr double kCoarsest = 0.5;
constexpr float kScatter = 0.3f;  // radii by which drawn particles stand off their places at most
constexpr std::size_t kSample = 2000;
constexpr float kLooseNeighbours = 3.0f;  // up to which water is spray
constexpr float kLeftOut = 2.0f;          // looseness of what flow.vert leaves out
/// Particles that a moving view and shadows draw at most; fewer are drawn larger.
constexpr std::size_t kMostMoving = 60'000, kMostCasting = 100'000;
constexpr double kMovingQuality = 0.8;
constexpr std::size_t kDustShare = 6;  // one of so many particles raises dust for all of them
/// Volume of a particle at rest over that of its drawn sphere.
constexpr double kFilled = 1.0 / (4.0 / 3.0 * 3.14159265358979 * kRadius * kRadius * kRadius);

void upload(GlBuffer& buffer, const void* data, std::size_t bytes) {
  if (!buffer) buffer = GlBuffer::make();
  glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
}

Status buildInto(GlProgram& program, const char* vertex, const char* fragment, const char* defines = "") {
  auto built = GlProgram::build(vertex, fragment, defines);
  if (!built) return built.error();
  program = std::move(*built);
  return {};
}

float rise(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return static_cast<float>(t * t * (3.0 - 2.0 * t));
}

/// One of so many of `count` particles, so that at most `most` are drawn.
std::size_t strideFor(std::size_t count, std::size_t most) {
  return std::max<std::size_t>(1, (count + most - 1) / most);
}

/// Distance of particles of which one of `stride` is left instead of one of `usual`.
double spacingOf(double spacing, std::size_t stride, std::size_t usual) {
  return spacing * std::cbrt(static_cast<double>(stride) / static_cast<double>(usual));
}

struct Traits {
  double density, viscosity, speed, neighbours;  // SI
};

/// How high fast snow raises dust, m: a share of the height that its speed would carry it to.
double dustHeight(double speed) {
  return 0.08 * speed * speed / kStandardGravity;
}

float waterShare(double density, double viscosity) {
  // Thick fluids as dense as water are slurries: they look like snow.
  return rise(850.0, 960.0, density) * (1.0f - rise(0.05, 0.5, viscosity));
}

/// Place on the scale (in the natural look, which needs none: the height of the dust), share of water, foam
/// of water or dust that snow raises, looseness.
Vec4f lookOf(double place, const Traits& t) {
  const float loose = 1.0f - rise(2.0, 10.0, t.neighbours);
  const float water = waterShare(t.density, t.viscosity);
  const float foam = std::max(0.9f * loose, 0.75f * rise(6.0, 20.0, t.speed));
  // Dust comes from the surface only.
  const float dust = (1.0f - rise(12.0, 28.0, t.neighbours)) * rise(4.0, 16.0, t.speed);
  return {static_cast<float>(place), water, water > 0.5f ? foam : dust, loose};
}

/// Density of each particle's material as a whole, kg/m3: single particles of torn water are as thin as snow.
/// The mean of those that are denser than the mean. Empty where the set tells no materials.
std::vector<float> materialDensities(const ParticleSet& set, const std::vector<float>& density) {
  const ParticleAttribute* material = set.find("material");
  if (!material || density.empty()) return density;
  constexpr std::size_t kMost = 256;
  const auto indexOf = [&](std::size_t k) {
    return static_cast<std::size_t>(std::clamp(material->values[k], 0.0f, kMost - 1.0f));
  };
  std::vector<double> mean(kMost, 0.0);
  for (int round = 0; round < 2; ++round) {
    std::vector<double> sum(kMost, 0.0), count(kMost, 0.0);
    for (std::size_t k = 0; k < density.size(); ++k) {
      const std::size_t m = indexOf(k);
      if (static_cast<double>(density[k]) < mean[m]) continue;
      sum[m] += static_cast<double>(density[k]);
      count[m] += 1.0;
    }
    for (std::size_t m = 0; m < kMost; ++m)
      if (count[m] > 0.0) mean[m] = sum[m] / count[m];
  }
  std::vector<float> whole(density.size());
  for (std::size_t k = 0; k < density.size(); ++k) whole[k] = static_cast<float>(mean[indexOf(k)]);
  return whole;
}

/// Clip distance before the eye that a fifth of the particles in sight are nearer than; 0 if none is in
/// sight.
double nearDistance(const std::vector<Vec3f>& positions, const DrawContext& context) {
  const Matrix4& m = context.block.viewProjection;
  const std::size_t stride = std::max<std::size_t>(1, positions.size() / kSample);
  std::vector<float> found;
  for (std::size_t k = 0; k < positions.size(); k += stride) {
    const Vec3f p = positions[k];
    const auto row = [&](std::size_t r) { return m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + m[12 + r]; };
    const float w = row(3);
    if (w > 0.2f && std::abs(row(0)) < w && std::abs(row(1)) < w) found.push_back(w);
  }
  if (found.empty()) return 0.0;
  const auto fifth = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 5);
  std::nth_element(found.begin(), fifth, found.end());
  return static_cast<double>(*fifth);
}

void drawScreen() {
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Counts of neighbours; empty before the first step, when nobody has counted them.
std::vector<float> countedNeighbours(const ParticleSet& set) {
  std::vector<float> neighbours = flowValues(set, FlowDisplay::Neighbours);
  const auto none = [](float n) { return n <= 0.0f; };
  if (std::all_of(neighbours.begin(), neighbours.end(), none)) neighbours.clear();
  return neighbours;
}

}  // namespace

std::vector<bool> looseWater(const ParticleSet& set) {
  const auto density = materialDensities(set, flowValues(set, FlowDisplay::Density));
  const auto neighbours = countedNeighbours(set), viscosity = flowValues(set, FlowDisplay::Viscosity);
  std::vector<bool> loose;
  if (density.empty() || neighbours.empty()) return loose;
  for (std::size_t k = 0; k < density.size(); ++k)
    loose.push_back(neighbours[k] <= kLooseNeighbours &&
                    waterShare(static_cast<double>(density[k]),
                               viscosity.empty() ? 0.0 : static_cast<double>(viscosity[k])) > 0.5f);
  return loose;
}

double estimateSpacing(const std::vector<Vec3f>& positions) {
  constexpr std::size_t kProbes = 24;
  if (positions.size() < 2) return 0.0;
  std::vector<float> nearest;
  const std::size_t stride = std::max<std::size_t>(1, positions.size() / kProbes);
  for (std::size_t k = stride / 2; k < positions.size(); k += stride) {
    float best = 1e30f;
    for (std::size_t j = 0; j < positions.size(); ++j) {
      const Vec3f d = positions[j] - positions[k];
      const float square = dot(d, d);
      if (j != k && square < best) best = square;
    }
    nearest.push_back(best);
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return std::sqrt(static_cast<double>(*middle));
}

Status FlowPass::initialise() {
  if (Status s = buildInto(m_distanceProgram, "flow.vert", "flow_distance.frag"); !s) return s;
  if (Status s = buildInto(m_thicknessProgram, "flow.vert", "flow_thickness.frag"); !s) return s;
  if (Status s = buildInto(m_smoothProgram, "screen.vert", "flow_smooth.frag"); !s) return s;
  if (Status s = buildInto(m_normalProgram, "screen.vert", "flow_normal.frag"); !s) return s;
  if (Status s = buildInto(m_materialProgram, "screen.vert", "flow_surface.frag"); !s) return s;
  if (Status s = buildInto(m_valueProgram, "screen.vert", "flow_surface.frag", "#define VALUES 1"); !s)
    return s;
  if (Status s = buildInto(m_depthProgram, "flow_depth.vert", "depth.frag"); !s) return s;
  if (Status s = buildInto(m_dustProgram, "flow_dust.vert", "flow_dust.frag"); !s) return s;
  if (Status s = buildInto(m_cloudProgram, "screen.vert", "flow_cloud.frag"); !s) return s;
  m_vertexArray = GlVertexArray::make();
  return {};
}

void FlowPass::setFlow(std::shared_ptr<const ParticlePart> flow, std::shared_ptr<const ParticlePart> boundary,
                       double spacing) {
  if (flow == m_flow && boundary == m_boundary) return;
  m_flow = std::move(flow);
  m_boundary = std::move(boundary);
  m_revision += 1.0;
  m_bounds = {};
  m_looksKey.clear();
  std::vector<Vec3f> positions;
  if (m_flow) positions = m_flow->particles.positions;
  m_boundaryCount = m_boundary ? m_boundary->particles.size() : 0;
  for (const Vec3f& p : positions) m_bounds.extend(p.to<double>());
  m_allBounds = m_bounds;
  if (m_boundaryCount > 0)
    for (const Vec3f& p : m_boundary->particles.positions) m_allBounds.extend(p.to<double>());
  if (!(spacing > 0.0)) spacing = estimateSpacing(positions);
  m_spacing = spacing > 1e-6 ? spacing : 0.1;
  if (m_boundaryCount > 0)
    positions.insert(positions.end(), m_boundary->particles.positions.begin(),
                     m_boundary->particles.positions.end());
  m_count = positions.size();
  if (m_count > 0) upload(m_positions, positions.data(), m_count * sizeof(Vec3f));
}

/// What the settings make of each particle.
void FlowPass::uploadLooks(const RenderNode& settings) {
  const std::vector<double> key{static_cast<double>(settings.flowDisplay), settings.flowRangeLow,
                                settings.flowRangeHigh, settings.flowRangeAuto ? 1.0 : 0.0,
                                settings.flowLogarithmic ? 1.0 : 0.0};
  m_boundaryShown = settings.showFlowBoundary;
  if (key == m_looksKey) return;
  m_looksKey = key;
  m_looksRevision += 1.0;
  std::vector<Vec4f> looks(m_count);
  m_dusty = false;
  if (m_flow) {
    const ParticleSet& set = m_flow->particles;
    const std::vector<float> values = flowValues(set, settings.flowDisplay);
    const auto density = materialDensities(set, flowValues(set, FlowDisplay::Density)),
               speed = flowValues(set, FlowDisplay::Speed);
    const auto viscosity = flowValues(set, FlowDisplay::Viscosity);
    const auto neighbours = countedNeighbours(set);
    const std::vector<bool> loose = looseWater(set);
    m_scale = flowScale(settings, values);
    for (std::size_t k = 0; k < set.size(); ++k) {
      const auto of = [k](const std::vector<float>& list, double other) {
        return list.empty() ? other : static_cast<double>(list[k]);
      };
      const double fast = of(speed, 0.0);
      const bool natural = m_scale.shows == FlowDisplay::Material;
      looks[k] = lookOf(natural ? dustHeight(fast) : m_scale.place(of(values, 0.0)),
                        {of(density, 300.0), of(viscosity, 0.0), fast, of(neighbours, 30.0)});
      if (natural && !loose.empty() && loose[k]) looks[k].w = kLeftOut;
      m_dusty = m_dusty || (looks[k].y <= 0.5f && looks[k].z > 0.05f);
    }
  }
  for (std::size_t k = m_count - m_boundaryCount; k < m_count; ++k) looks[k] = {0.0f, 0.0f, 0.0f, 0.6f};
  upload(m_looks, looks.data(), looks.size() * sizeof(Vec4f));
}

void FlowPass::drawParticles(const GlProgram& program, int width, int height, const Points& points,
                             const DrawContext& context) const {
  const double scale = m_targets.scale * width / m_targets.width;
  const double pixels = context.pixelsPerUnit * scale;
  const bool values = m_scale.shows != FlowDisplay::Material;
  program.use();
  program.set("uFlow", static_cast<float>(kRadius * points.spacing), static_cast<float>(pixels),
              static_cast<float>(kSmallestPixels), values ? 0.0f : kScatter);
  const auto inner = [&](int picture, int target) {
    return static_cast<float>(picture * m_targets.scale / target);
  };
  program.set("uStride", static_cast<int>(points.stride));
  program.set("uScale", inner(context.options.width, m_targets.width),
              inner(context.options.height, m_targets.height), 0.0f, 0.0f);
  glViewport(0, 0, width, height);
  glBindVertexArray(m_vertexArray.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, m_positions.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, m_looks.id());
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points.count / points.stride));
  glDisable(GL_PROGRAM_POINT_SIZE);
}

void FlowPass::prepare(const DrawContext& context) {
  if (empty()) return;
  uploadLooks(context.scene.settings<RenderNode>(context.filmTime));
  std::vector<double> key(context.block.viewProjection.begin(), context.block.viewProjection.end());
  key.insert(key.end(),
             {m_revision, m_looksRevision, static_cast<double>(context.options.quality < kMovingQuality),
              static_cast<double>(context.options.width), static_cast<double>(context.options.height),
              m_boundaryShown ? 1.0 : 0.0, m_dustShown ? 1.0 : 0.0});
  if (key == m_preparedKey) return;
  m_preparedKey = std::move(key);
  m_pixels = pixelsOf(m_allBounds, context.block.viewProjection, context.options.width,
                      context.options.height, 32.0);
  if (m_pixels[0] == m_pixels[2]) return;
  const double near = m_flow ? nearDistance(m_flow->particles.positions, context) : 0.0;
  const double radius = near > 0.0 ? kRadius * m_spacing * context.pixelsPerUnit / near : 0.0;
  const double scale = radius > kEnoughPixels ? std::max(kEnoughPixels / radius, kCoarsest) : 1.0;
  if (Status made = m_targets.prepare(context.options.width, context.options.height, scale); made) {
    drawSurface(context);
  } else {
    logWarning(made.error().text());
    m_pixels = {};
  }
}

/// All particles, or fewer and larger ones while the view moves.
FlowPass::Points FlowPass::drawnPoints(double quality) const {
  const std::size_t count = m_boundaryShown ? m_count : m_count - m_boundaryCount;
  const std::size_t stride = quality < kMovingQuality ? strideFor(count, kMostMoving) : 1;
  return {count, stride, spacingOf(m_spacing, stride, 1)};
}

/// Distances and thickness of the particles, then the smooth surface.
void FlowPass::drawSurface(const DrawContext& context) {
  const float nothing[4] = {}, far = 0.0f;
  glClearNamedFramebufferfv(m_targets.rawFramebuffer.id(), GL_COLOR, 0, nothing);
  glClearNamedFramebufferfv(m_targets.rawFramebuffer.id(), GL_DEPTH, 0, &far);
  glDepthFunc(GL_GEQUAL);
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.rawFramebuffer.id());
  const Points points = drawnPoints(context.options.quality);
  drawParticles(m_distanceProgram, m_targets.width, m_targets.height, points, context);
  glDisable(GL_DEPTH_TEST);
  if (m_scale.shows == FlowDisplay::Material) {
    m_thicknessProgram.set("uFilled", static_cast<float>(kFilled));
    gather(m_thicknessProgram, m_targets.thicknessFramebuffer, points, context);
    const std::size_t share = std::max(kDustShare, 2 * points.stride);
    if (m_dusty && m_dustShown)
      gather(m_dustProgram, m_targets.dustFramebuffer,
             {m_flow->particles.size(), share, spacingOf(m_spacing, share, kDustShare)}, context);
  }
  smooth(context);
  glEnable(GL_DEPTH_TEST);
}

/// Adds up what all particles lay over a pixel.
void FlowPass::gather(const GlProgram& program, const GlFramebuffer& target, const Points& points,
                      const DrawContext& context) const {
  const float nothing[4] = {};
  glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, nothing);
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  drawParticles(program, m_targets.halfWidth(), m_targets.halfHeight(), points, context);
  glDisable(GL_BLEND);
}

/// From the raw distances to smooth ones and their normals.
void FlowPass::smooth(const DrawContext& context) {
  const auto spacing = static_cast<float>(m_spacing);
  const auto pixels = static_cast<float>(context.pixelsPerUnit * m_targets.scale);
  glViewport(0, 0, m_targets.width, m_targets.height);
  const auto target = [this](int pixel) {
    return static_cast<int>(pixel * m_targets.scale) + FlowTargets::kMargin;
  };
  const int x = target(m_pixels[0]), y = target(m_pixels[1]);
  glEnable(GL_SCISSOR_TEST);
  // At the picture's rims the margin is smoothed too.
  glScissor(x - FlowTargets::kMargin, y - FlowTargets::kMargin,
            target(m_pixels[2]) - x + 2 * FlowTargets::kMargin,
            target(m_pixels[3]) - y + 2 * FlowTargets::kMargin);
  m_smoothProgram.use();
  m_smoothProgram.set("uRange", 1.2f * spacing, 0.5f * spacing, pixels, 0.0f);
  GLuint from = m_targets.raw.id();
  // Reach in spacings and most taps; the last one closes the gaps between the taps of those before.
  const std::pair<float, float> rounds[] = {{2.6f, 10.0f}, {1.3f, 8.0f}, {0.0f, 3.0f}};
  for (const auto& [reach, taps] : rounds)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      m_smoothProgram.set("uStep", axis == 0 ? 1.0f : 0.0f, axis == 0 ? 0.0f : 1.0f, reach * spacing, taps);
      glBindFramebuffer(GL_FRAMEBUFFER, m_targets.smoothFramebuffer[axis].id());
      glBindTextureUnit(7, from);
      drawScreen();
      from = m_targets.smooth[axis].id();
    }
  m_normalProgram.use();
  m_normalProgram.set("uTarget", static_cast<float>(context.options.width * m_targets.scale),
                      static_cast<float>(context.options.height * m_targets.scale),
                      static_cast<float>(FlowTargets::kMargin), 0.0f);
  m_normalProgram.set("uRange", 2.0f * spacing, pixels, 0.0f, 0.0f);
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.normalFramebuffer.id());
  glBindTextureUnit(7, from);
  drawScreen();
  glDisable(GL_SCISSOR_TEST);
}

void FlowPass::draw(const DrawContext& context) const {
  if (empty() || m_pixels[0] == m_pixels[2]) return;
  const bool values = m_scale.shows != FlowDisplay::Material;
  const GlProgram& program = values ? m_valueProgram : m_materialProgram;
  program.use();
  program.set("uTarget", static_cast<float>(m_targets.scale), static_cast<float>(FlowTargets::kMargin),
              1.0f / static_cast<float>(m_targets.width), 1.0f / static_cast<float>(m_targets.height));
  program.set("uFlow", static_cast<float>(m_spacing),
              static_cast<float>(context.pixelsPerUnit * m_targets.scale), 0.0f, 0.0f);
  if (values) {
    std::vector<Vec4f> colours;
    for (const Vec3d& c : scaleColours(m_scale))
      colours.push_back({static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 1.0f});
    program.setArray("uColours", &colours.front().x, static_cast<int>(colours.size()));
  }
  glBindTextureUnit(7, m_targets.smooth[1].id());
  glBindTextureUnit(8, m_targets.normal.id());
  glBindTextureUnit(9, m_targets.raw.id());
  glBindTextureUnit(10, m_targets.thickness.id());
  glBlendFuncSeparate(GL_ONE, GL_SRC1_COLOR, GL_ZERO, GL_ONE);
  glBindVertexArray(m_vertexArray.id());
  const ScissorLimit limit(m_pixels);
  drawScreen();
  if (!values && m_dusty && m_dustShown) drawDust();
}

/// The cloud that fast snow raises, over the surface.
void FlowPass::drawDust() const {
  m_cloudProgram.use();
  m_cloudProgram.set("uTarget", static_cast<float>(m_targets.scale), static_cast<float>(FlowTargets::kMargin),
                     1.0f / static_cast<float>(m_targets.width), 1.0f / static_cast<float>(m_targets.height));
  m_cloudProgram.set("uFlow", static_cast<float>(m_spacing), 0.0f, 0.0f, 0.0f);
  glBindTextureUnit(7, m_targets.dust.id());
  glBindTextureUnit(9, m_targets.smooth[1].id());
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDepthMask(GL_FALSE);
  drawScreen();
  glDepthMask(GL_TRUE);
}

void FlowPass::drawDepth(const Matrix4& light, double texelsPerMetre) const {
  if (!m_flow || m_flow->particles.size() == 0) return;
  m_depthProgram.use();
  m_depthProgram.setMatrix("uLightModel", light);
  m_depthProgram.set("uCutout", 0.0f);
  const std::size_t stride = strideFor(m_flow->particles.size(), kMostCasting);
  const double texels = texelsPerMetre * spacingOf(m_spacing, stride, 1);
  m_depthProgram.set("uSize", static_cast<float>(std::clamp(texels, 1.0, 64.0)));
  m_depthProgram.set("uStride", static_cast<int>(stride));
  glBindVertexArray(m_vertexArray.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, m_positions.id());
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(m_flow->particles.size() / stride));
  glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace spin
