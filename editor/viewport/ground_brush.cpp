// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/ground_brush.h"

#include <cmath>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"
#include "core/nodes/flow_nodes.h"
#include "editor/viewport/scene_picker.h"

namespace spin {
namespace {

constexpr int kRimPoints = 48;

/// The painted layer of the first node that fits, or a blank one of the terrain's size.
template <class Fits>
TiledRaster<std::uint8_t> layerOf(const SceneSnapshot& scene, std::uint8_t blank, const Fits& fits) {
  const Raster<float>& heights = scene.terrain->heights;
  for (const SceneNode& node : scene.nodes) {
    const auto* painted = std::get_if<TiledRaster<std::uint8_t>>(&node.painted);
    const bool sized = painted && painted->width() == heights.width && painted->height() == heights.height;
    if (sized && fits(node)) return *painted;
  }
  return {heights.width, heights.height, blank};
}

}  // namespace

TiledRaster<std::uint8_t> groundTypeLayer(const SceneSnapshot& scene) {
  return layerOf(scene, kUnpaintedGround,
                 [](const SceneNode& node) { return node.as<GroundTypeLayerNode>() != nullptr; });
}

TiledRaster<std::uint8_t> releaseLayer(const SceneSnapshot& scene, const std::string& id) {
  return layerOf(scene, kReleaseUnpainted,
                 [&id](const SceneNode& node) { return node.id == id && node.as<AvalancheReleaseNode>(); });
}

void GroundBrush::hover(const ViewportContext& context, Vec2d pixel) {
  m_position = context.scene ? pickTerrain(*context.scene, context.view.ray(pixel)) : std::nullopt;
}

std::vector<Vec3d> GroundBrush::rim(const ViewportContext& context) const {
  std::vector<Vec3d> rim;
  if (!m_position || !context.scene || !context.scene->terrain) return rim;
  const TerrainSurface surface(context.scene->terrain->heights);
  for (int k = 0; k < kRimPoints; ++k) {
    const double angle = 2.0 * kPi * k / kRimPoints;
    const double x = m_position->x + m_radius * std::cos(angle);
    const double y = m_position->y + m_radius * std::sin(angle);
    rim.push_back({x, y, surface.heightAt(x, y).value_or(m_position->z)});
  }
  return rim;
}

bool GroundBrush::begin(const ViewportContext& context, Vec2d pixel) {
  hover(context, pixel);
  if (!m_position) return false;
  const Raster<float>& grid = context.scene->terrain->heights;
  if (m_release.empty())
    m_stroke.emplace(groundTypeLayer(*context.scene), grid, m_radius, m_value);
  else
    m_stroke.emplace(releaseLayer(*context.scene, m_release), grid, m_radius,
                     m_rubsOut ? kReleaseUnpainted : kReleasePainted);
  m_stroke->moveTo({m_position->x, m_position->y});
  return true;
}

bool GroundBrush::drag(const ViewportContext& context, Vec2d pixel) {
  hover(context, pixel);
  if (!m_position || !m_stroke) return false;
  m_stroke->moveTo({m_position->x, m_position->y});
  return m_stroke->changed();
}

}  // namespace spin
