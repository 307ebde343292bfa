// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/sim/frame.h"
#include "core/sim/snapshot.h"

namespace spin {

struct FlakeAtlas;

/// Where the eye is. Local metres, z up.
struct RenderCamera {
  Vec3d position{0, -50, 20};
  Vec3d target{};
  double fovDegrees = 45.0;  ///< vertical
};

/// The scene's camera node at a film time.
RenderCamera cameraOf(const SceneSnapshot& scene, double filmTime);

/// What the ground shows: its look, or a painted layer.
enum class GroundDisplay : std::uint8_t { Natural, GroundType, GroundTemperature, SnowDepth, KeepClear };

struct RenderOptions {
  int width = 1280;
  int height = 720;
  bool showFlakes = true;
  bool showSnow = true;
  GroundDisplay ground = GroundDisplay::Natural;
  std::string selectedNode;  ///< outlined; empty = none
  /// Share of the height to draw, from the bottom; the rest of the target is left as it is.
  Vec2d band{0.0, 1.0};
  /// < 1 draws coarser terrain, fewer flakes and, in draw(), fewer pixels that are enlarged (while the user
  /// moves the view).
  double quality = 1.0;
  /// Share of the weather's haze. Pictures of the scene's camera show all of it; a working view from farther
  /// away less.
  double hazeScale = 1.0;
  int samples = 1;  ///< a pixel, in draw(); clamped to what the driver has
};

/// Draws a snapshot and a frame into the bound framebuffer of the current OpenGL 4.5 core context. No
/// widgets, no Qt: the viewport and the command line use the same object. All calls need that context
/// current. One tone curve (exposure of the scene, linear, soft shoulder above 0.7) serves both ways out:
/// draw() writes its values sRGB-encoded, drawLinear() returns them as they are, so that whoever encodes them
/// as sRGB gets what the viewport shows. The same input gives the same bytes on the same OpenGL renderer.
class Renderer {
 public:
  Renderer();
  ~Renderer();  ///< needs the context current if initialise() succeeded
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Compiles shaders; the error says what the driver lacks.
  Status initialise();
  /// Takes over a new snapshot; only what changed is uploaded again (compared by content and node data). Null
  /// = empty scene.
  void setScene(SnapshotPointer scene);
  /// Takes over a frame's cover and flakes; null = bare scene.
  void setFrame(FramePointer frame);
  /// Takes over the shapes of falling flakes; null = soft discs.
  void setFlakeAtlas(std::shared_ptr<const FlakeAtlas> atlas);
  /// Draws at a film time into the lower left of `framebuffer` (0 = default), sRGB-encoded; the target's own
  /// depth buffer is not touched. Leaves blending, depth test and clip control as OpenGL starts with.
  void draw(unsigned framebuffer, const RenderCamera& camera, double filmTime, const RenderOptions& options);
  /// Draws into a multisampled half-float target of its own and returns display-referred linear RGBA (0..1,
  /// alpha 1 where anything or the sky is), rows from the top. `samples` is clamped to what the driver has.
  /// Fails on sizes that the driver refuses.
  Result<std::vector<float>> drawLinear(const RenderCamera& camera, double filmTime,
                                        const RenderOptions& options, int samples);

  /// Seconds of the last draw by pass (glFinish and a clock; only measured when asked for).
  void setMeasuring(bool on);
  const StageTimings& timings() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace spin
