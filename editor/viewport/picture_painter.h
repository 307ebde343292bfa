// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "editor/render/egl_context.h"
#include "editor/render/render_target.h"
#include "editor/render/renderer.h"
#include "editor/viewport/band_plan.h"
#include "editor/viewport/draw_budget.h"

namespace spin {

/// All that a picture of the view depends on.
struct PictureRequest {
  SnapshotPointer scene;
  FramePointer frame;
  std::shared_ptr<const FlakeAtlas> flakeAtlas;  ///< null = soft discs
  RenderCamera camera;
  double filmTime = 0.0;
  RenderOptions options;  ///< width and height in pixels of the screen; detail and samples are chosen here
  bool moving = false;    ///< more pictures of the same movement follow
};

/// Draws pictures into memory with an OpenGL context of its own, current on the thread that made it. Detail
/// and resolution follow the time the last pictures took.
class PicturePainter {
 public:
  /// The error says what the driver lacks.
  static Result<std::unique_ptr<PicturePainter>> create();
  ~PicturePainter();

  struct Drawn {
    QImage picture;        ///< of the size asked for, 32 bit RGB
    double seconds = 0.0;  ///< wall time of upload, drawing and read-back
    bool complete = true;  ///< nothing was left out for speed
  };
  /// Fails where the driver has no room for the size.
  Result<Drawn> draw(const PictureRequest& request);
  /// The same picture in full detail and with smooth edges, band by band; nothing if `interrupted` says so
  /// between two bands.
  std::optional<QImage> refine(const PictureRequest& request, const std::function<bool()>& interrupted);

  std::string rendererName() const { return m_context->rendererName(); }

 private:
  explicit PicturePainter(std::unique_ptr<EglContext> context);
  QImage read(const RenderTarget& drawn, int width, int height);

  std::unique_ptr<EglContext> m_context;  ///< first in, last out: everything below is freed with it current
  std::unique_ptr<Renderer> m_renderer;
  RenderTarget m_drawn;    ///< at the resolution the budget allows
  RenderTarget m_refined;  ///< at full resolution
  RenderTarget m_shown;    ///< upside down, as images are stored
  bool m_software = false;
  DrawBudget m_budget;
  BandPlan m_bands;
  std::shared_ptr<const TerrainData> m_terrain;
};

}  // namespace spin
