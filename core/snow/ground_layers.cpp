// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/ground_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/snow/snow_inputs.h"

namespace spin {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// The node's layer if it has the terrain's size.
template <class T>
const TiledRaster<T>* layerOf(const SceneSnapshot& scene, const SceneNode* node) {
  if (!node || !scene.terrain) return nullptr;
  const auto* layer = std::get_if<TiledRaster<T>>(&node->painted);
  const Raster<float>& heights = scene.terrain->heights;
  return layer && layer->width() == heights.width && layer->height() == heights.height ? layer : nullptr;
}

/// Where a place lies between the points of the terrain.
struct Spot {
  int i0 = 0, j0 = 0;        ///< south-western one of the four points round it
  double u = 0.0, v = 0.0;   ///< 0..1 towards the next column and row
  int nearI = 0, nearJ = 0;  ///< nearest point
  bool inside = false;
};

/// Cells round the outermost points belong to the terrain, as those of the cover do.
Spot spotAt(const Raster<float>& heights, double x, double y) {
  Spot spot;
  const double px = (x - heights.originX) / heights.cellSize, py = (y - heights.originY) / heights.cellSize;
  spot.inside = px >= -0.5 && py >= -0.5 && px < heights.width - 0.5 && py < heights.height - 0.5;
  if (!spot.inside) return spot;
  const auto clampTo = [](double p, int last) { return std::clamp(p, 0.0, static_cast<double>(last)); };
  const double cx = clampTo(px, heights.width - 1), cy = clampTo(py, heights.height - 1);
  spot.i0 = std::min(static_cast<int>(cx), std::max(0, heights.width - 2));
  spot.j0 = std::min(static_cast<int>(cy), std::max(0, heights.height - 2));
  spot.u = cx - spot.i0;
  spot.v = cy - spot.j0;
  spot.nearI = static_cast<int>(std::lround(cx));
  spot.nearJ = static_cast<int>(std::lround(cy));
  return spot;
}

float valueAt(const TiledRaster<float>& layer, const Spot& spot) {
  if (!spot.inside || std::isnan(layer.at(spot.nearI, spot.nearJ))) return kNan;
  double sum = 0.0, weight = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    const int right = corner & 1, up = corner >> 1;
    const double w = (right ? spot.u : 1.0 - spot.u) * (up ? spot.v : 1.0 - spot.v);
    if (!(w > 0.0)) continue;
    const float value = layer.at(spot.i0 + right, spot.j0 + up);
    if (std::isnan(value)) continue;
    sum += w * static_cast<double>(value);
    weight += w;
  }
  return static_cast<float>(sum / weight);
}

template <class Visit>
void forEachCell(const SceneSnapshot& scene, const Raster<float>& grid, const Visit& visit) {
  if (!scene.terrain) return;
  for (int j = 0; j < grid.height; ++j)
    for (int i = 0; i < grid.width; ++i)
      visit(grid.index(i, j), spotAt(scene.terrain->heights, grid.x(i), grid.y(j)));
}

std::vector<float> sampled(const SceneSnapshot& scene, const SceneNode* node, const Raster<float>& grid,
                           float unpainted) {
  std::vector<float> values(grid.size(), unpainted);
  const TiledRaster<float>* layer = layerOf<float>(scene, node);
  if (!layer) return values;
  forEachCell(scene, grid, [&](std::size_t cell, const Spot& spot) {
    const float value = valueAt(*layer, spot);
    if (!std::isnan(value)) values[cell] = value;
  });
  return values;
}

bool works(const KeepClearLayerNode& mask, double filmTime) {
  return filmTime >= mask.start && filmTime < mask.stop && mask.strength > 0.0;
}

}  // namespace

GroundLayers groundLayersOn(const SceneSnapshot& scene, const Raster<float>& grid) {
  GroundLayers layers;
  layers.type.assign(grid.size(), scene.settings<GroundTypeLayerNode>(0.0).base);
  if (const auto* types = layerOf<std::uint8_t>(scene, scene.first<GroundTypeLayerNode>()))
    forEachCell(scene, grid, [&](std::size_t cell, const Spot& spot) {
      const int type = spot.inside ? types->at(spot.nearI, spot.nearJ) : kUnpaintedGround;
      if (type < kGroundTypeCount) layers.type[cell] = static_cast<GroundType>(type);
    });
  layers.temperature = sampled(scene, scene.first<GroundTemperatureLayerNode>(), grid, kNan);
  layers.startDepth = sampled(scene, scene.first<SnowDepthLayerNode>(), grid, kNan);
  const auto depth = scene.settings<SnowDepthLayerNode>(0.0);
  layers.startDensity = depth.density;
  layers.startAdds = depth.use == SnowDepthUse::Add;
  for (const SceneNode* node : scene.all<KeepClearLayerNode>())
    if (layerOf<float>(scene, node)) layers.keepClear.push_back({node->id, sampled(scene, node, grid, 0.0f)});
  return layers;
}

std::vector<float> clearedShares(const SceneSnapshot& scene, const GroundLayers& layers, double filmTime) {
  std::vector<float> cleared;
  const std::vector<const SceneNode*> nodes = scene.all<KeepClearLayerNode>();
  for (const GroundLayers::Mask& mask : layers.keepClear) {
    const auto node =
        std::find_if(nodes.begin(), nodes.end(), [&](const SceneNode* n) { return n->id == mask.node; });
    SPIN_CHECK(node != nodes.end(), "the ground layers are of another scene");
    const auto data = evaluate(**node, filmTime);
    const auto& settings = static_cast<const KeepClearLayerNode&>(*data);
    if (!works(settings, filmTime)) continue;
    if (cleared.empty()) cleared.assign(mask.share.size(), 0.0f);
    const auto strength = static_cast<float>(settings.strength);
    for (std::size_t c = 0; c < cleared.size(); ++c)
      cleared[c] = 1.0f - (1.0f - cleared[c]) * (1.0f - strength * std::clamp(mask.share[c], 0.0f, 1.0f));
  }
  return cleared;
}

void hashGroundLayers(const StepInput& input, Hasher& hasher) {
  for (const SceneNode* node :
       {input.scene.first<GroundTypeLayerNode>(), input.scene.first<SnowDepthLayerNode>()})
    if (node) input.scene.hashNode(*node, 0.0, hasher);
  if (const SceneNode* node = input.scene.first<GroundTemperatureLayerNode>())
    for (const double film : {input.from.film, middleFilm(input), input.to.film})
      input.scene.hashNode(*node, film, hasher);
}

void hashKeepClear(const StepInput& input, Hasher& hasher) {
  for (const SceneNode* node : input.scene.all<KeepClearLayerNode>())
    for (const double film : {input.from.film, middleFilm(input), input.to.film})
      input.scene.hashNode(*node, film, hasher);
}

}  // namespace spin
