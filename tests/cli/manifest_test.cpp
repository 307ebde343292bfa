// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/manifest.h"

#include <gtest/gtest.h>

#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/sim/flakes_part.h"
#include "editor/cli/job_export.h"

namespace spin {
namespace {

OpenedScene openedScene() {
  OpenedScene opened;
  opened.file = "/some/where/my valley.spindrift";
  opened.scene = makeDefaultScene();
  auto snapshot = std::make_shared<SceneSnapshot>();
  snapshot->nodes = opened.scene.nodes();
  SceneNode terrain = makeNode(kTerrainType, "terrain", "Terrain");
  setPlainValue(terrain, *kTerrainType.find("credit"), std::string("Land Tirol"));
  snapshot->nodes.push_back(terrain);
  auto data = std::make_shared<TerrainData>();
  data->geo = {{400000.5, 500000.25, 900.0}, 31287, ""};
  snapshot->terrain = data;
  opened.snapshot = snapshot;
  return opened;
}

JobOptions jobOptions() {
  JobOptions options;
  options.formats = {"png8", "ply"};
  options.output = "/tmp/secret";
  options.threads = 2;
  options.scene.assignments = {"weather.wind_speed_m_s=6", "render.caption=it's cold"};
  return options;
}

TEST(Manifest, CommandRepeatsTheJobWithoutPlaceAndThreads) {
  EXPECT_EQ(equivalentCommand(openedScene(), jobOptions(), {2, 8}),
            "spindrift-cli run 'my valley.spindrift' --set weather.wind_speed_m_s=6 --set "
            R"('render.caption=it'\''s cold' --frames 2:8 --format png8 --format ply)");
}

TEST(Manifest, CommandAllowsTheSameFolders) {
  JobOptions options;
  options.scene.allowedFolders = {"/some/data/dem tiles", "/some/where/below"};
  EXPECT_EQ(equivalentCommand(openedScene(), options, {0, 1}),
            "spindrift-cli run 'my valley.spindrift' --allow '../data/dem tiles' --allow below --frames 0:1");
}

TEST(Manifest, SaysWhereAndInWhichUnits) {
  const std::string text = manifestText(openedScene(), jobOptions(), {2, 8}, JsonValue::array(), "llvmpipe");
  EXPECT_EQ(text.find("/tmp"), std::string::npos);
  EXPECT_EQ(text, manifestText(openedScene(), jobOptions(), {2, 8}, JsonValue::array(), "llvmpipe"));
  const Result<JsonValue> parsed = parseJson(text, "manifest");
  ASSERT_TRUE(parsed.ok()) << parsed.error().text();
  EXPECT_EQ(parsed->find("frames")->find("count")->number, 7);
  EXPECT_EQ(parsed->find("frame_rate_1_s")->number, 24);
  EXPECT_EQ(parsed->find("seed")->number, 1);
  EXPECT_EQ(parsed->find("up_axis")->text, "z");
  EXPECT_EQ(parsed->find("place")->find("epsg")->number, 31287);
  EXPECT_EQ(parsed->find("place")->find("origin_m")->items[0].number, 400000.5);
  EXPECT_EQ(parsed->find("credits")->items[0].text, "Land Tirol");
}

TEST(Caption, HasTheTextAndTheCreditUnlessSwitchedOff) {
  const OpenedScene opened = openedScene();
  SceneSnapshot scene = *opened.snapshot;
  EXPECT_EQ(captionLines(scene), std::vector<std::string>{"Land Tirol"});
  for (SceneNode& node : scene.nodes)
    if (node.id == "render") {
      setPlainValue(node, *node.type->find("caption"), std::string("Morning"));
      EXPECT_EQ(captionLines(scene), (std::vector<std::string>{"Morning", "Land Tirol"}));
      setPlainValue(node, *node.type->find("show_caption"), false);
    }
  EXPECT_TRUE(captionLines(scene).empty());
}

TEST(Unwrap, ParticlesStandRoundTheCamera) {
  const OpenedScene opened = openedScene();
  auto frame = std::make_shared<Frame>();
  auto flakes = std::make_shared<ParticlePart>();
  flakes->particles.wrapBox = 10.0;
  flakes->particles.positions = {{0, 0, 0}, {9.5f, 1, 1}};
  frame->parts["flakes"] = flakes;
  const FramePointer unwrapped = unwrapAtCamera(frame, *opened.snapshot);
  const auto* part = unwrapped->part<ParticlePart>("flakes");
  ASSERT_TRUE(part);
  EXPECT_EQ(part->particles.wrapBox, 0.0);
  // The default camera stands at (0, -50, 20).
  EXPECT_EQ(part->particles.positions[0], (Vec3f{0, -50, 20}));
  EXPECT_EQ(part->particles.positions[1], (Vec3f{-0.5f, -49, 21}));
  EXPECT_EQ(flakes->particles.wrapBox, 10.0) << "the cached frame is untouched";
  auto snowy = std::make_shared<Frame>();
  auto falling = std::make_shared<FlakesPart>();
  FlakeClass one;
  one.diameter = 0.002;
  falling->flakes.classes.assign(kFlakeClasses, one);
  falling->flakes.numberDensity = 1000.0;
  snowy->parts["flakes"] = falling;
  const FramePointer around = unwrapAtCamera(snowy, *opened.snapshot);
  const auto* particles = around->part<ParticlePart>("flakes");
  ASSERT_TRUE(particles) << "exporters know particles only";
  ASSERT_GT(particles->particles.size(), 1000u);
  for (const Vec3f& p : particles->particles.positions)
    ASSERT_LT(length(p.to<double>() - Vec3d{0, -50, 20}), 0.5 * SnowfallNode().boxSize + 1e-3);
  auto plain = std::make_shared<Frame>();
  EXPECT_EQ(unwrapAtCamera(plain, *opened.snapshot), FramePointer(plain));
}

}  // namespace
}  // namespace spin
