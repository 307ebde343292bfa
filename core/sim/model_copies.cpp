// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/model_copies.h"

#include <algorithm>

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/fields/terrain_surface.h"
#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

double groundAt(const SceneSnapshot& scene, double x, double y) {
  return scene.terrain ? TerrainSurface(scene.terrain->heights).nearestHeight(x, y) : 0.0;
}

/// Where copy k stands in the world, from the node's own place.
Transform placeOfCopy(const SceneSnapshot& scene, const ModelNode& data, const Transform& own,
                      std::size_t k) {
  constexpr std::uint32_t kStream = 0x636f7079u;
  const UInt4 words = CounterRandom{static_cast<std::uint64_t>(data.copySeed), kStream}.words(k);
  const Vec2d at = data.copies[k];
  const double above = data.onGround
                           ? own.translation.z - groundAt(scene, own.translation.x, own.translation.y)
                           : own.translation.z;
  const double height = data.onGround ? groundAt(scene, at.x, at.y) + above : above;
  const double turn = data.copyTurnDegrees * (toUnitDouble(words.x, words.y) - 0.5);
  const double scale = 1.0 + data.copyScale * (2.0 * toUnitDouble(words.z, words.w) - 1.0);
  Transform still = own;
  still.translation = {};
  return translationOf({at.x, at.y, height}) * rotationOfDegrees({0.0, 0.0, turn}) *
         scalingOf({scale, scale, scale}) * still;
}

}  // namespace

std::size_t instancesOfACopy(const SceneNode& node, const ModelData& model) {
  const auto* data = node.as<ModelNode>();
  const std::size_t sets = data ? std::min(data->copies.size(), kMostCopies) + 1 : 1;
  return std::max<std::size_t>(model.instances.size() / sets, 1);
}

std::shared_ptr<const ModelData> withCopies(const std::shared_ptr<const ModelData>& model,
                                            const SceneSnapshot& scene, const SceneNode& node) {
  const auto evaluated = evaluate(node, 0.0);
  const auto& data = static_cast<const ModelNode&>(*evaluated);
  const std::size_t count = std::min(data.copies.size(), kMostCopies);
  const Transform own = scene.modelTransform(node, 0.0);
  if (count == 0 || own.determinant() == 0.0) return model;
  const Transform toModel = own.inverse();
  auto copied = std::make_shared<ModelData>(*model);
  copied->instances.reserve(model->instances.size() * (count + 1));
  for (std::size_t k = 0; k < count; ++k) {
    const Transform move = toModel * placeOfCopy(scene, data, own, k);
    for (const MeshInstance& instance : model->instances)
      copied->instances.push_back({instance.mesh, move * instance.transform});
  }
  return copied;
}

}  // namespace spin
