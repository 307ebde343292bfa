// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/snapshot.h"

#include "core/fields/content_hash.h"
#include "core/fields/terrain_surface.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"

namespace spin {
namespace {

void addValue(Hasher& hasher, const Value& value) {
  hasher.add(static_cast<std::uint64_t>(value.index()));
  if (const auto* flag = std::get_if<bool>(&value)) hasher.add(*flag);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) hasher.add(*integer);
  if (const auto* real = std::get_if<double>(&value)) hasher.add(*real);
  if (const auto* vector = std::get_if<Vec3d>(&value)) hasher.add(vector->x).add(vector->y).add(vector->z);
  if (const auto* text = std::get_if<std::string>(&value)) hasher.add(std::string_view(*text));
  if (const auto* points = std::get_if<PlanPoints>(&value)) {
    hasher.add(static_cast<std::uint64_t>(points->size()));
    for (const Vec2d& p : *points) hasher.add(p.x).add(p.y);
  }
}

/// Tiles that were never painted share one buffer, so each distinct buffer is hashed once.
template <class T>
void addPainted(Hasher& hasher, const TiledRaster<T>& layer) {
  hasher.add(layer.width()).add(layer.height());
  std::map<const void*, Hash128> known;
  for (std::size_t t = 0; t < layer.tileCount(); ++t) {
    const auto& tile = *layer.tile(t);
    const auto [entry, fresh] = known.try_emplace(&tile);
    if (fresh) entry->second = Hasher().addBytes(tile.data(), sizeof tile).digest();
    hasher.add(entry->second);
  }
}

void addPainted(Hasher& hasher, const PaintedLayer& painted) {
  hasher.add(static_cast<std::uint64_t>(painted.index()));
  if (const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&painted)) addPainted(hasher, *types);
  if (const auto* reals = std::get_if<TiledRaster<float>>(&painted)) addPainted(hasher, *reals);
}

}  // namespace

FrameTime SceneSnapshot::timeOf(int frame) const {
  const SimulationNode settings = this->settings<SimulationNode>(0.0);
  FrameTime time;
  time.frame = frame;
  time.film = frame / settings.frameRate;
  time.weather = time.film * settings.timeScale;
  return time;
}

Transform SceneSnapshot::modelTransform(const SceneNode& model, double filmTime) const {
  const auto data = evaluate(model, filmTime);
  const auto* placed = dynamic_cast<const ModelNode*>(data.get());
  SPIN_CHECK(placed, "modelTransform() of a node that is no model: " + model.id);
  Vec3d position = placed->position;
  if (placed->onGround && terrain)
    position.z += TerrainSurface(terrain->heights).nearestHeight(position.x, position.y);
  return translationOf(position) * rotationOfDegrees(placed->rotationDegrees) * scalingOf(placed->scale);
}

void SceneSnapshot::hashNode(const SceneNode& node, double filmTime, Hasher& hasher) const {
  hasher.add(std::string_view(node.id)).add(node.type->id).add(node.enabled);
  for (const PropertyRow& property : node.type->properties) {
    const bool simulated = static_cast<int>(property.affects) & static_cast<int>(Affects::Simulation);
    // A file counts by its content, not by where it lies.
    if (!simulated || property.kind == PropertyKind::Path) continue;
    hasher.add(property.id);
    addValue(hasher, valueAt(node, property, filmTime));
  }
  const auto asset = assetHashes.find(node.id);
  const auto model = models.find(node.id);
  if (asset != assetHashes.end())
    hasher.add(asset->second);
  else if (node.as<TerrainNode>() && terrain)
    hasher.add(contentHash(*terrain));
  else if (node.as<WeatherNode>() && weather)
    hasher.add(contentHash(*weather));
  else if (model != models.end() && model->second)
    hasher.add(contentHash(*model->second));
  addPainted(hasher, node.painted);
}

}  // namespace spin
