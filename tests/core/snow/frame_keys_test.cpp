// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/nodes/ground_nodes.h"
#include "core/nodes/node_registry.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

/// Snow on a hill and on a box, with one node of every type.
SceneSnapshot fullScene() {
  test::TestScene test;
  SceneSnapshot scene = test.land(9, 9, 2.0, [](double x, double) { return 0.1 * x; })
                            .model("box", test::modelOf(test::boxMesh({-1, -1, 0}, {1, 1, 2})), ModelNode{})
                            .build();
  for (const NodeType* type : nodeTypes()) {
    const bool there = std::any_of(scene.nodes.begin(), scene.nodes.end(),
                                   [&](const SceneNode& node) { return node.type == type; });
    if (!there) scene.nodes.push_back(makeNode(*type, type->id, type->label));
  }
  return scene;
}

/// Another value that the property takes.
Value changed(const PropertyRow& row, const Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return !*flag;
  if (const auto* text = std::get_if<std::string>(&value)) return *text + "x";
  if (const auto* points = std::get_if<PlanPoints>(&value)) {
    PlanPoints more = *points;
    more.push_back({1.0, 2.0});
    return more;
  }
  if (row.kind == PropertyKind::Choice) return std::int64_t{std::get<std::int64_t>(value) == 0};
  const auto other = [&](double v) { return v + row.step <= row.max ? v + row.step : v - row.step; };
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    return static_cast<std::int64_t>(other(static_cast<double>(*integer)));
  if (const auto* vector = std::get_if<Vec3d>(&value)) return Vec3d{other(vector->x), vector->y, vector->z};
  return other(std::get<double>(value));
}

std::vector<Hash128> keysOf(const SceneSnapshot& scene) {
  return frameKeys(scene, Pipeline::compile(scene), "cpu", 3);
}

TEST(FrameKeys, ChangeWithEveryPropertyThatAffectsTheSimulationAndNoOther) {
  const SceneSnapshot scene = fullScene();
  const std::vector<Hash128> before = keysOf(scene);
  int rows = 0;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n)
    for (const PropertyRow& row : scene.nodes[n].type->properties) {
      SceneSnapshot edited = scene;
      SceneNode& node = edited.nodes[n];
      const Value value = changed(row, plainValue(node, row));
      ASSERT_TRUE(validate(row, value).ok()) << node.id << "." << row.id;
      setPlainValue(node, row, value);
      const bool simulated = static_cast<int>(row.affects) & static_cast<int>(Affects::Simulation);
      // A file counts by its content, which this edit does not change.
      const bool counts = simulated && row.kind != PropertyKind::Path;
      EXPECT_EQ(keysOf(edited) != before, counts) << node.id << "." << row.id;
      ++rows;
    }
  EXPECT_GT(rows, 40);
}

TEST(FrameKeys, AnimatingAPropertyLaterKeepsTheFramesBeforeIt) {
  const SceneSnapshot scene = fullScene();
  const std::vector<Hash128> before = keysOf(scene);
  for (std::size_t n = 0; n < scene.nodes.size(); ++n)
    for (const PropertyRow& row : scene.nodes[n].type->properties) {
      const bool simulated = static_cast<int>(row.affects) & static_cast<int>(Affects::Simulation);
      SceneSnapshot edited = scene;
      SceneNode& node = edited.nodes[n];
      if (!row.animatable || !simulated) continue;
      const std::string id = row.id;
      const Value value = plainValue(node, row);
      const double then = 0.5 * (scene.timeOf(2).film + scene.timeOf(3).film);
      node.curves[id].setKey({0.0, value, Interpolation::Step});
      node.curves[id].setKey({then, changed(row, value), Interpolation::Step});
      const std::vector<Hash128> after = keysOf(edited);
      EXPECT_NE(after[3], before[3]) << node.id << "." << id;
      // A model that turns at any time keeps no snow from the start.
      if (id == "rotation_deg" || id == "scale") continue;
      for (std::size_t frame = 0; frame < 3; ++frame) EXPECT_EQ(after[frame], before[frame]) << node.id << id;
    }
}

}  // namespace
}  // namespace spin
