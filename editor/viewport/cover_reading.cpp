// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/cover_reading.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/nodes/terrain_node.h"
#include "editor/render/cover_values.h"
#include "editor/viewport/scene_picker.h"

namespace spin {
namespace {

struct Place {
  std::size_t grid = 0, cell = 0;
};

const SceneNode* findNode(const SceneSnapshot& scene, const std::string& id) {
  const auto at = std::find_if(scene.nodes.begin(), scene.nodes.end(),
                               [&](const SceneNode& node) { return node.id == id; });
  return at == scene.nodes.end() ? nullptr : &*at;
}

/// The cell that accounts for a point of a node, `point` in the grids' own coordinates.
std::optional<Place> placeOf(const CoverPart& cover, const std::string& node, Vec3d point, bool terrain) {
  std::optional<Place> found;
  double best = std::numeric_limits<double>::max();
  for (std::size_t g = 0; g < cover.layout->grids.size(); ++g) {
    const CoverGrid& grid = cover.layout->grids[g];
    if (grid.node != node) continue;
    const int i = grid.base.column(point.x), j = grid.base.row(point.y);
    if (!grid.base.contains(i, j) || std::isnan(grid.base.at(i, j)) || !(grid.area.at(i, j) > 0.0f)) continue;
    // Patches lie above each other; of the terrain's grids the one with smaller cells is meant.
    const double off =
        terrain ? grid.base.cellSize : std::abs(static_cast<double>(grid.base.at(i, j)) - point.z);
    if (off >= best || (!terrain && off > 3.0 * grid.base.cellSize + 0.3)) continue;
    best = off;
    found = Place{g, grid.base.index(i, j)};
  }
  return found;
}

std::optional<GroundType> typeAt(const SceneSnapshot& scene, const SceneNode& node, Vec3d point,
                                 double filmTime) {
  if (const auto* model = node.as<ModelNode>()) return model->surface;
  if (!scene.terrain) return std::nullopt;
  const Raster<float>& heights = scene.terrain->heights;
  const int i = std::clamp(heights.column(point.x), 0, heights.width - 1);
  const int j = std::clamp(heights.row(point.y), 0, heights.height - 1);
  for (const SceneNode* layer : scene.all<GroundTypeLayerNode>()) {
    const auto* painted = std::get_if<TiledRaster<std::uint8_t>>(&layer->painted);
    if (!painted || painted->width() != heights.width || painted->height() != heights.height) continue;
    if (const int type = painted->at(i, j); type < kGroundTypeCount) return static_cast<GroundType>(type);
    break;
  }
  return scene.settings<GroundTypeLayerNode>(filmTime).base;
}

CoverReading readAt(const SceneSnapshot& scene, const CoverPart* cover, double filmTime, const PickHit& hit) {
  CoverReading reading;
  reading.node = hit.node;
  reading.point = hit.point;
  reading.values.fill(std::numeric_limits<float>::quiet_NaN());
  const SceneNode* node = findNode(scene, hit.node);
  if (!node) return reading;
  reading.type = typeAt(scene, *node, hit.point, filmTime);
  if (!cover) return reading;
  const bool terrain = node->as<TerrainNode>() != nullptr;
  const Vec3d offset = terrain ? Vec3d{} : scene.modelTransform(*node, filmTime).translation;
  const auto place = placeOf(*cover, hit.node, hit.point - offset, terrain);
  if (!place) return reading;
  reading.covered = true;
  for (std::size_t k = 1; k < reading.values.size(); ++k)
    reading.values[k] = coverValue(*cover, place->grid, place->cell, static_cast<SnowDisplay>(k));
  return reading;
}

}  // namespace

std::optional<CoverReading> readCover(const SceneSnapshot& scene, const Frame* frame, double filmTime,
                                      const ViewRay& ray) {
  const auto hit = pickScene(scene, filmTime, ray);
  if (!hit) return std::nullopt;
  const CoverPart* cover = frame ? frame->part<CoverPart>("cover") : nullptr;
  if (cover && (!cover->layout || cover->values.size() != cover->layout->grids.size())) cover = nullptr;
  const CoverReading below = readAt(scene, cover, filmTime, *hit);
  const auto depth = static_cast<double>(below.value(SnowDisplay::Depth));
  // The ray is stopped by the snow before it comes to the ground: one step back along it, not over half of
  // the way, finds what one sees.
  const double reach = 0.5 * length(hit->point - ray.origin);
  if (!(depth > 0.0) || ray.direction.z > -0.02) return below;
  const double back = std::min(depth / -ray.direction.z, reach);
  PickHit above = *hit;
  above.point = hit->point - ray.direction * back;
  above.point.z = hit->point.z;
  const CoverReading seen = readAt(scene, cover, filmTime, above);
  return seen.covered ? seen : below;
}

QString readingText(const CoverReading& reading) {
  const auto number = [&](SnowDisplay of, int digits) {
    const double power = std::pow(10.0, digits);
    // Rounded first, so that nothing is "-0.0"; adding 0 takes the sign from zero.
    const double rounded = std::round(power * static_cast<double>(reading.value(of))) / power + 0.0;
    const QString text = QLocale().toString(rounded, 'f', digits);
    const QString unit = QString::fromUtf8(coverUnit(of));
    return unit.isEmpty() ? text : QStringLiteral("%1 %2").arg(text, unit);
  };
  const auto has = [&](SnowDisplay of) { return !std::isnan(reading.value(of)); };
  const auto say = [](const char* text) { return QCoreApplication::translate("CoverReading", text); };
  QStringList parts;
  if (has(SnowDisplay::Depth)) {
    parts << say(QT_TRANSLATE_NOOP("CoverReading", "Snow %1"))
                 .arg(number(SnowDisplay::Depth, reading.value(SnowDisplay::Depth) < 0.1f ? 3 : 2))
          << number(SnowDisplay::Swe, 1) << number(SnowDisplay::Density, 0);
    if (has(SnowDisplay::LiquidWater))
      parts << say(QT_TRANSLATE_NOOP("CoverReading", "water %1")).arg(number(SnowDisplay::LiquidWater, 1));
  } else if (reading.covered) {
    parts << say(QT_TRANSLATE_NOOP("CoverReading", "No snow"));
  }
  if (has(SnowDisplay::Temperature))
    parts << say(QT_TRANSLATE_NOOP("CoverReading", "surface %1")).arg(number(SnowDisplay::Temperature, 1));
  if (has(SnowDisplay::Exposure))
    parts << say(QT_TRANSLATE_NOOP("CoverReading", "exposure %1")).arg(number(SnowDisplay::Exposure, 2));
  if (reading.type)
    parts << QCoreApplication::translate("Properties",
                                         kGroundTypeChoices[static_cast<std::size_t>(*reading.type)].label);
  return parts.join(QStringLiteral("  \u00b7  "));
}

}  // namespace spin
