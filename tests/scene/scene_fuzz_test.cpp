// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/nodes/node_registry.h"
#include "core/scene/scene_file.h"

namespace spin {
namespace {

std::string sample() {
  Scene scene = makeDefaultScene();
  for (const NodeType* type : nodeTypes()) {
    if (scene.firstOf(*type)) continue;
    EXPECT_TRUE(scene.append(makeNode(*type, scene.freeId(type->id), type->label)).ok());
  }
  EXPECT_TRUE(scene.setFromText("camera.position_m", "1 2.5 -3").ok());
  EXPECT_TRUE(scene.setFromText("render.caption", "Snow \u96ea").ok());
  scene.find("weather")->curves["cloud_cover"].setKey({0.5, 0.25, Interpolation::Smooth});
  scene.find("weather")->curves["cloud_cover"].setKey({1.5, 0.75, Interpolation::Step});
  return writeSceneText(scene);
}

/// One to four changes: bytes flipped, pieces cut out, doubled or replaced by awkward words.
std::string mutated(std::string text, std::uint64_t number) {
  static constexpr std::string_view kWords[] = {"1e999",
                                                "-1",
                                                "null",
                                                "{",
                                                "}",
                                                "[",
                                                "]",
                                                "\"",
                                                ",",
                                                "\\u0000",
                                                "0",
                                                "true",
                                                "1e-400",
                                                "\xff\xfe",
                                                "\"keys\"",
                                                ":",
                                                "9999999999999999999"};
  const CounterRandom random{number, 0};
  std::uint64_t draw = 0;
  const auto pick = [&](std::size_t below) {
    return static_cast<std::size_t>(static_cast<double>(random.uniform(draw++)) * static_cast<double>(below));
  };
  for (std::size_t change = 1 + pick(4); change > 0 && !text.empty(); --change) {
    const std::size_t at = pick(text.size()), length = std::min(text.size() - at, 1 + pick(60));
    switch (pick(10)) {
      case 0:
        text[at] = static_cast<char>(pick(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.replace(at, std::min<std::size_t>(length, 8), kWords[pick(std::size(kWords))]);
        break;
      case 4:
        text.resize(at);
        break;
      default:
        if (const std::size_t digit = text.find_first_of("0123456789", at); digit != std::string::npos)
          text[digit] = static_cast<char>('0' + pick(10));
    }
  }
  return text;
}

TEST(SceneFuzz, MutatedTextIsAnErrorOrAValidScene) {
  const std::string good = sample();
  ASSERT_TRUE(readSceneText(good, "good").ok()) << readSceneText(good, "good").error().text();
  int refused = 0, read = 0;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const std::string text = mutated(good, number);
    const Result<LoadedScene> loaded = readSceneText(text, "fuzz");
    if (!loaded) {
      ++refused;
      EXPECT_FALSE(loaded.error().text().empty());
      continue;
    }
    ++read;
    for (const SceneNode& node : loaded->scene.nodes()) {
      for (const PropertyRow& row : node.type->properties) {
        EXPECT_TRUE(validate(row, plainValue(node, row)).ok()) << number;
        EXPECT_TRUE(validate(row, valueAt(node, row, 1.0)).ok()) << number;
      }
    }
    const std::string written = writeSceneText(loaded->scene, loaded->extras);
    EXPECT_TRUE(readSceneText(written, "again").ok()) << number << written;
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(read, 20) << "mutations are too wild to test what is accepted";
}

}  // namespace
}  // namespace spin
