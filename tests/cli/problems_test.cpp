// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/nodes/ground_nodes.h"
#include "editor/cli/commands.h"
#include "tests/cli/program.h"

namespace spin {
namespace {

OpenedScene openedWith(const std::vector<std::string>& settings, std::vector<SceneNode> more = {}) {
  OpenedScene opened;
  opened.scene = makeDefaultScene();
  for (SceneNode& node : more) {
    const Status added = opened.scene.append(std::move(node));
    SPIN_CHECK(added.ok(), added.error().text());
  }
  for (const std::string& setting : settings) {
    const Status done = assign(opened.scene, setting);
    SPIN_CHECK(done.ok(), done.error().text());
  }
  auto snapshot = std::make_shared<SceneSnapshot>();
  snapshot->nodes = opened.scene.nodes();
  opened.snapshot = snapshot;
  return opened;
}

/// "node:error" or "node:warning" of each problem.
std::vector<std::string> found(const OpenedScene& opened) {
  std::vector<std::string> list;
  for (const SceneProblem& problem : findProblems(opened))
    list.push_back(problem.node + (problem.error ? ":error" : ":warning"));
  return list;
}

TEST(Problems, ASoundSceneHasNone) {
  EXPECT_TRUE(found(openedWith({})).empty());
}

TEST(Problems, AreNamedWithTheirNode) {
  EXPECT_EQ(found(openedWith({"simulation.first_frame=9", "simulation.last_frame=3"})),
            std::vector<std::string>{"simulation:error"});
  EXPECT_EQ(found(openedWith({"simulation.holds_below_deg=70"})),
            std::vector<std::string>{"simulation:error"});
  EXPECT_EQ(found(openedWith({"simulation.time_scale=0"})), std::vector<std::string>{"simulation:warning"});
  EXPECT_EQ(found(openedWith({}, {makeNode(kSnowfallType, "snow", "Snow")})),
            std::vector<std::string>{"snow:warning"});
  SceneNode ground = makeNode(kGroundTypeLayerType, "ground", "Ground");
  ground.painted = TiledRaster<std::uint8_t>(4, 4, 0);
  EXPECT_EQ(found(openedWith({}, {ground})), std::vector<std::string>{"ground:error"});
}

TEST(Problems, FilesAndRemarksDiffer) {
  OpenedScene opened = openedWith({});
  opened.issues.push_back({"hut", badInput("The file is missing", "hut.glb", "it is not there"), false});
  opened.issues.push_back({"tree", badInput("The file moved", "tree.glb", "found elsewhere"), true});
  EXPECT_EQ(found(opened), (std::vector<std::string>{"hut:error", "tree:warning"}));
  const Status required = requireFiles(opened);
  ASSERT_FALSE(required.ok());
  EXPECT_EQ(required.error().where, "node hut, hut.glb");
  opened.issues.erase(opened.issues.begin());
  EXPECT_TRUE(requireFiles(opened).ok()) << "a remark stops nothing";
}

TEST(Assign, ErrorsAreUsageErrors) {
  Scene scene = makeDefaultScene();
  for (const char* wrong :
       {"weather", "weather.wind=3", "weathr.wind_speed_m_s=3", "weather.wind_speed_m_s=fast",
        "weather.wind_speed_m_s=900", "weather.wind_speed_m_s=nan"}) {
    const Status done = assign(scene, wrong);
    ASSERT_FALSE(done.ok()) << wrong;
    EXPECT_EQ(done.error().kind, ErrorKind::Usage) << wrong;
  }
  EXPECT_TRUE(assign(scene, "render.caption=a=b").ok()) << "the value may hold '='";
}

}  // namespace
}  // namespace spin
