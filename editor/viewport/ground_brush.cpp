// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/ground_brush.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "editor/viewport/scene_picker.h"

namespace spin {
namespace {

constexpr int kRingPoints = 72;

}  // namespace

bool hasSize(const PaintedLayer& layer, const Raster<float>& heights) {
  return std::visit(
      [&](const auto& raster) {
        if constexpr (std::is_same_v<std::decay_t<decltype(raster)>, std::monostate>)
          return false;
        else
          return raster.width() == heights.width && raster.height() == heights.height;
      },
      layer);
}

const SceneNode* paintedNode(const SceneSnapshot& scene, const PaintedKind& kind, const std::string& id) {
  const SceneNode* first = nullptr;
  for (const SceneNode& node : scene.nodes) {
    if (node.type != kind.type) continue;
    if (node.id == id) return &node;
    if (!first) first = &node;
  }
  return first;
}

PaintedLayer paintedLayer(const SceneSnapshot& scene, const PaintedKind& kind, const std::string& id) {
  const Raster<float>& heights = scene.terrain->heights;
  const SceneNode* node = paintedNode(scene, kind, id);
  if (node && hasSize(node->painted, heights)) return node->painted;
  if (kind.numbers)
    return TiledRaster<std::uint8_t>(heights.width, heights.height, static_cast<std::uint8_t>(kind.blank));
  return TiledRaster<float>(heights.width, heights.height, kind.blank);
}

double unpaintedValue(const SceneSnapshot& scene, const PaintedKind& kind, double filmTime) {
  if (kind.type == &kGroundTypeLayerType)
    return static_cast<double>(scene.settings<GroundTypeLayerNode>(filmTime).base);
  if (kind.type == &kGroundTemperatureLayerType)
    return scene.settings<GroundTemperatureLayerNode>(filmTime).base;
  const bool replaces = scene.settings<SnowDepthLayerNode>(0.0).use == SnowDepthUse::Replace;
  if (kind.type == &kSnowDepthLayerType && replaces && scene.first<SnowfallNode>())
    return scene.settings<SnowfallNode>(0.0).oldSnowDepth;
  return 0.0;
}

GroundBrush::GroundBrush() : m_kind(paintedKind(kGroundTypeLayerType)) {
  m_values = {{m_kind, static_cast<double>(GroundType::Rock)},
              {paintedKind(kGroundTemperatureLayerType), celsiusToKelvin(5.0)},
              {paintedKind(kSnowDepthLayerType), 0.5},
              {paintedKind(kKeepClearLayerType), 1.0},
              {paintedKind(kAvalancheReleaseType), kReleasePainted}};
}

void GroundBrush::setTip(const BrushTip& tip) {
  m_tip.radius = std::clamp(tip.radius, kLeastBrushRadius, kMostBrushRadius);
  m_tip.hardness = std::clamp(tip.hardness, 0.0, 1.0);
  m_tip.strength = std::clamp(tip.strength, 0.01, 1.0);
}

void GroundBrush::setLayer(const PaintedKind& kind, std::string node) {
  if (painting()) return;
  m_kind = &kind;
  m_node = std::move(node);
}

double GroundBrush::value() const {
  return m_values.at(m_kind);
}

void GroundBrush::setValue(double si) {
  m_values[m_kind] = std::clamp(si, m_kind->least, m_kind->most);
}

void GroundBrush::hover(const ViewportContext& context, Vec2d pixel) {
  m_position = context.scene ? pickTerrain(*context.scene, context.view.ray(pixel)) : std::nullopt;
}

std::vector<Vec3d> GroundBrush::ring(const ViewportContext& context, double share) const {
  std::vector<Vec3d> ring;
  if (!m_position || !context.scene || !context.scene->terrain) return ring;
  const TerrainSurface surface(context.scene->terrain->heights);
  for (int k = 0; k < kRingPoints; ++k) {
    const double angle = 2.0 * kPi * k / kRingPoints;
    const double x = m_position->x + share * m_tip.radius * std::cos(angle);
    const double y = m_position->y + share * m_tip.radius * std::sin(angle);
    ring.push_back({x, y, surface.heightAt(x, y).value_or(m_position->z)});
  }
  return ring;
}

std::optional<double> GroundBrush::valueHere(const ViewportContext& context) const {
  if (!m_position || !context.scene || !context.scene->terrain) return std::nullopt;
  const Raster<float>& heights = context.scene->terrain->heights;
  const int i = heights.column(m_position->x), j = heights.row(m_position->y);
  if (!heights.contains(i, j)) return std::nullopt;
  const PaintedLayer layer = paintedLayer(*context.scene, *m_kind, m_node);
  double value = 0.0;
  if (const auto* numbers = std::get_if<TiledRaster<std::uint8_t>>(&layer))
    value = numbers->at(i, j);
  else
    value = static_cast<double>(std::get<TiledRaster<float>>(layer).at(i, j));
  if (!std::isnan(value) && (!m_kind->numbers || m_kind->holds(value))) return value;
  const double base = unpaintedValue(*context.scene, *m_kind, context.filmTime);
  return m_kind->holds(base) ? std::optional(base) : std::nullopt;
}

bool GroundBrush::begin(const ViewportContext& context, Vec2d pixel, BrushMode mode, PaintedLayer layer,
                        double pressure) {
  hover(context, pixel);
  if (!m_position) return false;
  const SceneSnapshot& scene = *context.scene;
  const StrokeTask task{mode, m_tip, value(), unpaintedValue(scene, *m_kind, context.filmTime)};
  m_stroke.emplace(std::move(layer), scene.terrain->heights, *m_kind, task);
  work(pressure);
  return true;
}

bool GroundBrush::drag(const ViewportContext& context, Vec2d pixel, double pressure) {
  hover(context, pixel);
  if (!m_position || !m_stroke) return false;
  work(pressure);
  return m_stroke->changed();
}

BrushPress GroundBrush::pressOf(double pressure) const {
  const double felt = std::clamp(pressure, 0.0, 1.0);
  // A feather-light touch still paints a dot.
  return {m_pressesStrength ? felt : 1.0, m_pressesRadius ? std::max(0.05, felt) : 1.0};
}

void GroundBrush::work(double pressure) {
  m_stroke->moveTo({m_position->x, m_position->y}, pressOf(pressure));
}

}  // namespace spin
