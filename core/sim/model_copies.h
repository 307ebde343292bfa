// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/sim/snapshot.h"

namespace spin {

/// Copies of one model at most: more would be a mistake, and each has a place in every table.
inline constexpr std::size_t kMostCopies = 100'000;

/// The model with one more set of instances for each of the node's copies: each at its place in plan, as high
/// above the ground there as the node stands above its own, turned and scaled at random by the node's seed.
/// Meshes are the model's own. Returns `model` itself where the node has no copies. Copies stand where they
/// do at film time 0 and move with the node.
std::shared_ptr<const ModelData> withCopies(const std::shared_ptr<const ModelData>& model,
                                            const SceneSnapshot& scene, const SceneNode& node);

/// Instances of a model that one of its copies has: the first so many are those of the node itself.
std::size_t instancesOfACopy(const SceneNode& node, const ModelData& model);

}  // namespace spin
