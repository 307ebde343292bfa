// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/scene.h"

#include <gtest/gtest.h>

#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"

namespace spin {
namespace {

std::vector<std::string> ids(const Scene& scene) {
  std::vector<std::string> list;
  for (const SceneNode& node : scene.nodes()) list.push_back(node.id);
  return list;
}

TEST(Scene, RefusesBadAndDoubledNodes) {
  Scene scene = makeDefaultScene();
  EXPECT_FALSE(scene.append(makeNode(kModelType, "Tree", "x")).ok()) << "upper case";
  EXPECT_FALSE(scene.append(makeNode(kModelType, "", "x")).ok());
  EXPECT_FALSE(scene.append(makeNode(kModelType, "9tree", "x")).ok());
  EXPECT_FALSE(scene.append(makeNode(kModelType, std::string(65, 'a'), "x")).ok());
  EXPECT_TRUE(scene.append(makeNode(kModelType, "tree", "x")).ok());
  EXPECT_FALSE(scene.append(makeNode(kModelType, "tree", "y")).ok()) << "id is taken";
  EXPECT_FALSE(scene.append(makeNode(kWeatherType, "weather_2", "x")).ok()) << "only one weather";
}

TEST(Scene, MovesRowsBothWays) {
  Scene scene;
  for (const char* id : {"a", "b", "c", "d"}) ASSERT_TRUE(scene.append(makeNode(kModelType, id, id)).ok());
  scene.move(0, 2);
  EXPECT_EQ(ids(scene), (std::vector<std::string>{"b", "c", "a", "d"}));
  scene.move(3, 0);
  EXPECT_EQ(ids(scene), (std::vector<std::string>{"d", "b", "c", "a"}));
  EXPECT_TRUE(scene.remove("c"));
  EXPECT_FALSE(scene.remove("c"));
}

TEST(Scene, FreeIdsAreValidAndFree) {
  Scene scene;
  ASSERT_TRUE(scene.append(makeNode(kModelType, "tree", "x")).ok());
  ASSERT_TRUE(scene.append(makeNode(kModelType, "tree_2", "x")).ok());
  EXPECT_EQ(scene.freeId("tree"), "tree_3");
  for (const std::string& wish : {std::string("Große Hütte 1"), std::string("123"), std::string(),
                                  std::string(500, 'x'), std::string("\xff\xfe"), std::string("__")})
    EXPECT_TRUE(isValidNodeId(scene.freeId(wish))) << wish << " -> " << scene.freeId(wish);
}

TEST(Scene, SetsFromTextAndEndsTheAnimation) {
  Scene scene = makeDefaultScene();
  scene.find("weather")->curves["wind_speed_m_s"].setKey({0.0, 9.0, Interpolation::Linear});
  ASSERT_TRUE(scene.setFromText("weather.wind_speed_m_s", "4.5").ok());
  EXPECT_EQ(valueAt(*scene.find("weather"), *kWeatherType.find("wind_speed_m_s"), 3.0), Value(4.5));
}

TEST(Scene, SetFromTextNamesWhatIsNear) {
  Scene scene = makeDefaultScene();
  const auto advice = [&](const char* path, const char* value) {
    const Status status = scene.setFromText(path, value);
    return status ? std::string("ok") : status.error().text();
  };
  EXPECT_NE(advice("wether.wind_speed_m_s", "4").find("\"weather\""), std::string::npos);
  EXPECT_NE(advice("weather.wind_speed", "4").find("\"wind_speed_m_s\""), std::string::npos);
  EXPECT_NE(advice("weather.wind_speed_m_s", "400").find("0 to 80"), std::string::npos);
  EXPECT_NE(advice("weather", "4").find("node.property"), std::string::npos);
  EXPECT_EQ(plainValue(*scene.find("weather"), *kWeatherType.find("wind_speed_m_s")), Value(2.0))
      << "nothing was changed";
}

}  // namespace
}  // namespace spin
