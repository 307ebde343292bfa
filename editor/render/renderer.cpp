// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/renderer.h"

#include <algorithm>
#include <cmath>

#include "core/base/log.h"
#include "core/base/units.h"
#include "core/nodes/camera_node.h"
#include "editor/render/air_pass.h"
#include "editor/render/area_pass.h"
#include "editor/render/cover_pass.h"
#include "editor/render/flake_pass.h"
#include "editor/render/flow_pass.h"
#include "editor/render/gl_state.h"
#include "editor/render/model_pass.h"
#include "editor/render/noise_texture.h"
#include "editor/render/render_target.h"
#include "editor/render/scene_depth.h"
#include "editor/render/shadow_pass.h"
#include "editor/render/spray_pass.h"
#include "editor/render/tank.h"
#include "editor/render/terrain_pass.h"

namespace spin {
namespace {

constexpr double kNearPlane = 0.1;  // m

Vec4f withW(Vec3d v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

Status checkDriver() {
  if (epoxy_is_desktop_gl() && epoxy_gl_version() >= 45) return {};
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  return Error{
      ErrorKind::Failed, "The renderer cannot start", "OpenGL",
      std::string("the driver offers ") + (version ? version : "no OpenGL") + ", needed is OpenGL 4.5",
      "Update the graphics driver or use Mesa's software renderer (LIBGL_ALWAYS_SOFTWARE=1)"};
}

}  // namespace

RenderCamera cameraOf(const SceneSnapshot& scene, double filmTime) {
  const auto node = scene.settings<CameraNode>(filmTime);
  return {node.position, node.target, node.fovDegrees};
}

struct Renderer::State {
  SnapshotPointer given;  ///< as it was set
  SnapshotPointer scene;  ///< with what is only drawn
  FramePointer frame;
  bool coverStale = true;
  TerrainPass terrain;
  ModelPass models;
  ShadowPass shadows;
  CoverPass cover;
  FlakePass flakes;
  FlowPass flow;
  AirPass air;
  SprayPass spray;
  SceneDepth depth;
  AreaPass area;
  GlProgram sky;
  GlVertexArray screenArray;
  GlTexture noise;
  GlBuffer block;
  RenderTarget display, smooth, linear, resolved;
  bool measuring = false;
  StageTimings timings;

  void updateCover();
  FrameBlock makeBlock(const RenderCamera& camera, double filmTime, const RenderOptions& options);
  void drawPasses(GLuint framebuffer, const RenderCamera& camera, double filmTime,
                  const RenderOptions& options);
  void prepareAir(const DrawContext& context);
  void drawInAir(GLuint framebuffer, const DrawContext& context);
  void bindTextures() const;
  template <class Pass>
  void timed(const char* name, const Pass& pass);
};

namespace {

struct RowRange {
  int begin = 0, end = 0;
};

/// Rows of the picture that the band covers; bands that meet leave no row out and draw none twice.
RowRange rowsOf(const RenderOptions& options) {
  const auto row = [&](double share) {
    return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * options.height));
  };
  return {row(options.band.x), row(options.band.y)};
}

/// `margin`: rows beyond the band that are drawn with it.
void limitToBand(const RenderOptions& options, int margin) {
  RowRange rows = rowsOf(options);
  rows = {std::max(rows.begin - margin, 0), std::min(rows.end + margin, options.height)};
  if (rows.begin == 0 && rows.end == options.height) return;
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, rows.begin, options.width, rows.end - rows.begin);
}

}  // namespace

template <class Pass>
void Renderer::State::timed(const char* name, const Pass& pass) {
  if (!measuring) return pass();
  glFinish();
  const ScopedStage stage(timings, name);
  pass();
  glFinish();
}

Renderer::Renderer() : m_state(std::make_unique<State>()) {}
Renderer::~Renderer() = default;

Status Renderer::initialise() {
  if (Status s = checkDriver(); !s) return s;
  State& st = *m_state;
  if (Status s = st.terrain.initialise(); !s) return s;
  if (Status s = st.models.initialise(); !s) return s;
  if (Status s = st.shadows.initialise(); !s) return s;
  if (Status s = st.cover.initialise(); !s) return s;
  if (Status s = st.flakes.initialise(); !s) return s;
  if (Status s = st.flow.initialise(); !s) return s;
  if (Status s = st.air.initialise(); !s) return s;
  if (Status s = st.spray.initialise(); !s) return s;
  if (Status s = st.area.initialise(); !s) return s;
  auto sky = GlProgram::build("screen.vert", "sky.frag");
  if (!sky) return sky.error();
  st.sky = std::move(*sky);
  st.screenArray = GlVertexArray::make();
  st.block = GlBuffer::make();
  glNamedBufferData(st.block.id(), sizeof(FrameBlock), nullptr, GL_DYNAMIC_DRAW);
  const std::vector<std::uint8_t> noise = makeNoiseTile();
  st.noise = GlTexture::make(GLenum{GL_TEXTURE_2D});
  glTextureStorage2D(st.noise.id(), 9, GL_RGBA8, kNoiseSize, kNoiseSize);
  glTextureSubImage2D(st.noise.id(), 0, 0, 0, kNoiseSize, kNoiseSize, GL_RGBA, GL_UNSIGNED_BYTE,
                      noise.data());
  glGenerateTextureMipmap(st.noise.id());
  setSampling(st.noise, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_REPEAT);
  return {};
}

void Renderer::setScene(SnapshotPointer scene) {
  State& st = *m_state;
  if (!scene) scene = std::make_shared<const SceneSnapshot>();
  if (scene == st.given) return;
  st.given = scene;
  scene = withTank(scene);
  if (!st.scene || st.scene->terrain != scene->terrain) st.coverStale = true;
  st.scene = std::move(scene);
  st.terrain.setTerrain(st.scene->terrain);
  st.models.setScene(*st.scene);
}

void Renderer::setFrame(FramePointer frame) {
  State& st = *m_state;
  if (frame == st.frame) return;
  st.frame = std::move(frame);
  st.coverStale = true;
}

void Renderer::setFlakeAtlas(std::shared_ptr<const FlakeAtlas> atlas) {
  m_state->flakes.setAtlas(std::move(atlas));
}

void Renderer::State::updateCover() {
  if (!coverStale) return;
  coverStale = false;
  const auto part = [&](const char* name) -> std::shared_ptr<const FramePart> {
    if (!frame) return nullptr;
    const auto at = frame->parts.find(name);
    return at == frame->parts.end() ? nullptr : at->second;
  };
  cover.setCover(std::dynamic_pointer_cast<const CoverPart>(part("cover")), scene.get(),
                 frame ? frame->info.time.film : 0.0);
  const auto particles = [&](const char* name) {
    return std::dynamic_pointer_cast<const ParticlePart>(part(name));
  };
  flakes.setFlakes(std::dynamic_pointer_cast<const FlakesPart>(part("flakes")));
  double spacing = 0.0;
  if (frame) {
    const auto& figures = frame->info.figures;
    const auto told = figures.find("flow_spacing_m");
    if (told != figures.end()) spacing = told->second;
  }
  flow.setFlow(particles("flow"), particles("flow_boundary"), spacing);
  air.setAir(std::dynamic_pointer_cast<const AirPart>(part("air")));
  flow.showDust(!air.hasSnow());
  spray.setSpray(particles("spray"), particles("flow"), flow.spacing());
}

void Renderer::State::prepareAir(const DrawContext& context) {
  const auto vec = [](Vec4f v) { return Vec3f{v.x, v.y, v.z}.to<double>(); };
  const FrameBlock& b = context.block;
  // The sky as it is drawn, in the mean over all directions.
  const Vec3d drawn = vec(b.horizon) * 0.3 + vec(b.zenith) * 0.7;
  AirSky light{vec(b.toSun), vec(b.sun), drawn, vec(b.bounce), {}};
  if (!terrain.empty()) light.sunShare = [this](Vec3d place) { return terrain.sunShare(place); };
  air.prepare(context, light, terrain.shadowRevision());
}

/// Cloud and spray, over all that is solid or flows.
void Renderer::State::drawInAir(GLuint framebuffer, const DrawContext& context) {
  if (air.shows() || !spray.empty()) {
    if (Status s = depth.copy(framebuffer, context.options.width, context.options.height); !s) {
      logWarning(s.error().text());
      return;
    }
  }
  if (air.shows()) air.draw(framebuffer, depth.texture(), context);
  air.bindKept();
  spray.draw(framebuffer, depth.texture(), context);
}

FrameBlock Renderer::State::makeBlock(const RenderCamera& camera, double filmTime,
                                      const RenderOptions& options) {
  const bool snow = options.showSnow && cover.hasSnow() && options.ground == GroundDisplay::Natural;
  const auto picture = scene->settings<RenderNode>(filmTime);
  const LightModel light = lightModel(*scene, filmTime, snow ? cover.snowShare() : 0.0);
  const double aspect = static_cast<double>(options.width) / options.height;
  const double tangent = std::tan(0.5 * degreesToRadians(camera.fovDegrees));
  Vec3d forward = camera.target - camera.position;
  forward = length(forward) > 0.0 ? normalized(forward) : Vec3d{0, 1, 0};
  const Vec3d side = cross(forward, Vec3d{0, 0, 1});
  FrameBlock b;
  b.viewProjection = viewProjection(camera, aspect, kNearPlane);
  b.eye = withW(camera.position, 1.0);
  b.forward = withW(forward, tangent);
  b.right = withW(length(side) > 1e-6 ? normalized(side) : Vec3d{1, 0, 0}, aspect);
  b.toSun = withW(light.toSun, 1.0);
  b.sun = withW(light.sun, light.cloud);
  b.sky = withW(light.sky, snow ? cover.snowShare() : 0.0);
  b.bounce = withW(light.bounce, filmTime);
  b.zenith = withW(light.zenith, 0.0);
  // Colours that stand for values must not fade with distance.
  const bool values = snow && snowLook(picture) == SnowLook::Values;
  const double haze = options.ground == GroundDisplay::Natural && !values ? options.hazeScale : 0.0;
  b.horizon = withW(light.horizon, light.hazeExtinction * haze);
  b.viewport = {static_cast<float>(options.width), static_cast<float>(options.height),
                static_cast<float>(0.5 * options.height / tangent), static_cast<float>(options.quality)};
  terrain.fill(b);
  b.terrainSize.z = snow ? 1.0f : 0.0f;
  b.terrainSize.w = options.ground == GroundDisplay::Natural && !values ? 0.0f : 1.0f;
  b.snowPhong = {static_cast<float>(picture.snowAmbient), static_cast<float>(picture.snowDiffuse),
                 static_cast<float>(picture.snowSpecular), static_cast<float>(picture.snowShininess)};
  return b;
}

void Renderer::State::bindTextures() const {
  glBindTextureUnit(0, noise.id());
  shadows.bindTextures();
  terrain.bindTextures();
  cover.bindTextures();
}

void Renderer::State::drawPasses(GLuint framebuffer, const RenderCamera& camera, double filmTime,
                                 const RenderOptions& options) {
  timings.clear();
  const CoverLook look = coverLookOf(*scene, filmTime);
  timed("upload", [&] {
    updateCover();
    cover.setLook(look);
  });
  FrameBlock b = makeBlock(camera, filmTime, options);
  const Vec3d toSun = lightModel(*scene, filmTime, 0.0).toSun;
  timed("ground", [&] { terrain.update(*scene, filmTime, options.ground, options.selectedNode, toSun); });
  const std::vector<PlacedModel> placed =
      models.place(*scene, filmTime, frame ? frame->part<BodiesPart>("bodies") : nullptr);
  timed("shadow", [&] { shadows.update(models, placed, flow, camera, toSun, b); });
  glNamedBufferSubData(block.id(), 0, sizeof b, &b);
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, block.id());
  const DrawContext context{*scene,
                            camera,
                            filmTime,
                            options,
                            b,
                            Frustum(b.viewProjection),
                            static_cast<double>(b.viewport.z),
                            b.terrainSize.z > 0.5f ? look.look : SnowLook::Physical};
  timed("area", [&] { area.setScene(scene, options.selectedNode); });
  bindTextures();
  timed("flow surface", [&] { flow.prepare(context); });
  timed("air light", [&] { prepareAir(context); });
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, options.width, options.height);
  limitToBand(options, air.empty() ? 0 : AirPass::kMarginRows);
  const float black[4] = {0.0f, 0.0f, 0.0f, 1.0f}, far = 0.0f;
  glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, black);
  glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &far);
  glDepthFunc(GL_GEQUAL);
  const bool snow = b.terrainSize.z > 0.5f;
  timed("models", [&] { models.draw(context, placed); });
  timed("terrain", [&] {
    if (snow) cover.drawFine(context);
    terrain.draw(context, snow ? cover.cuts() : std::vector<Vec4f>{}, flow.bounds());
  });
  timed("sky", [&] {
    sky.use();
    glBindVertexArray(screenArray.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  });
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  timed("cover", [&] {
    if (snow) cover.drawPatches(context, placed);
  });
  glDepthMask(GL_FALSE);
  timed("area", [&] { area.draw(); });
  glDepthMask(GL_TRUE);
  timed("flow", [&] { flow.draw(context); });
  timed("air", [&] { drawInAir(framebuffer, context); });
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  timed("flakes", [&] {
    if (options.showFlakes) flakes.draw(context, air.shows());
  });
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

void Renderer::draw(unsigned framebuffer, const RenderCamera& camera, double filmTime,
                    const RenderOptions& options) {
  State& st = *m_state;
  if (!st.scene) setScene(nullptr);
  const GlStateGuard guard;
  // A moving view is drawn with fewer pixels and enlarged: software drivers are bound by pixels.
  const double scale = std::clamp(options.quality, 0.4, 1.0);
  RenderOptions inner = options;
  inner.width = std::max(1, static_cast<int>(std::lround(scale * options.width)));
  inner.height = std::max(1, static_cast<int>(std::lround(scale * options.height)));
  if (!st.display.prepare(inner.width, inner.height, GL_SRGB8_ALPHA8, inner.samples)) return;
  glEnable(GL_FRAMEBUFFER_SRGB);
  glEnable(GL_MULTISAMPLE);
  st.drawPasses(st.display.framebuffer(), camera, filmTime, inner);
  const bool same = inner.width == options.width && inner.height == options.height;
  const RowRange from = rowsOf(inner), to = rowsOf(options);
  GLuint drawn = st.display.framebuffer();
  if (inner.samples > 1) {
    // OpenGL does not enlarge and resolve in one go. Light is averaged, not its encoding.
    if (!st.smooth.prepare(inner.width, inner.height, GL_SRGB8_ALPHA8, 1)) return;
    glBlitNamedFramebuffer(drawn, st.smooth.framebuffer(), 0, from.begin, inner.width, from.end, 0,
                           from.begin, inner.width, from.end, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    drawn = st.smooth.framebuffer();
  }
  // With the conversion off the encoded bytes are copied as they are.
  glDisable(GL_FRAMEBUFFER_SRGB);
  glBlitNamedFramebuffer(drawn, framebuffer, 0, from.begin, inner.width, from.end, 0, to.begin, options.width,
                         to.end, GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
}

Result<std::vector<float>> Renderer::drawLinear(const RenderCamera& camera, double filmTime,
                                                const RenderOptions& options, int samples) {
  State& st = *m_state;
  if (!st.scene) setScene(nullptr);
  const GlStateGuard guard;
  if (Status s = st.linear.prepare(options.width, options.height, GL_RGBA16F, samples); !s) return s.error();
  if (Status s = st.resolved.prepare(options.width, options.height, GL_RGBA16F, 1); !s) return s.error();
  glDisable(GL_FRAMEBUFFER_SRGB);
  glEnable(GL_MULTISAMPLE);
  st.drawPasses(st.linear.framebuffer(), camera, filmTime, options);
  glBlitNamedFramebuffer(st.linear.framebuffer(), st.resolved.framebuffer(), 0, 0, options.width,
                         options.height, 0, 0, options.width, options.height, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
  const std::size_t row = static_cast<std::size_t>(options.width) * 4;
  std::vector<float> pixels(row * static_cast<std::size_t>(options.height));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, st.resolved.framebuffer());
  glReadPixels(0, 0, options.width, options.height, GL_RGBA, GL_FLOAT, pixels.data());
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(options.height) - 1; top < bottom;
       ++top, --bottom)
    std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(top * row),
                     pixels.begin() + static_cast<std::ptrdiff_t>((top + 1) * row),
                     pixels.begin() + static_cast<std::ptrdiff_t>(bottom * row));
  if (const GLenum error = glGetError(); error != GL_NO_ERROR)
    return Error{ErrorKind::OutOfResources, "The picture could not be drawn", "OpenGL",
                 "the driver reports error " + std::to_string(error),
                 "Choose a smaller picture or fewer samples"};
  return pixels;
}

void Renderer::setMeasuring(bool on) {
  m_state->measuring = on;
}
const StageTimings& Renderer::timings() const {
  return m_state->timings;
}

}  // namespace spin
