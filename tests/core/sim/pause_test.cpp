// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/core/sim/test_processes.h"

namespace spin {
namespace {

/// A process that runs beside the test's snow and belongs to the flow.
class DripProcess final : public Process {
 public:
  const char* id() const override { return "flow"; }
  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    hasher.add(input.scene.settings<WeatherNode>(input.to.film).airTemperature);
  }
  Status begin(const SceneSnapshot&, ProcessContext&) override {
    m_drops = 0.0;
    return {};
  }
  Status step(const StepInput&, ProcessContext&) override {
    m_drops += 1.0;
    return {};
  }
  void publish(const SceneSnapshot&, const FrameTime&, Frame& frame) const override {
    frame.info.figures["drops"] = m_drops;
  }
  void saveState(ByteWriter& out) const override { out.put(m_drops); }
  Status loadState(const SceneSnapshot&, ProcessContext&, ByteReader& in) override {
    m_drops = in.get<double>();
    return {};
  }
  void estimate(const SceneSnapshot&, double&, double&) const override {}

 private:
  double m_drops = 0.0;
};

class Pause : public ::testing::Test {
 protected:
  void SetUp() override {
    test::behaviour().nanAtFrame = -1;
    test::behaviour().stepMilliseconds = 0;
    options.types.push_back({"flow", 700, [](const SceneSnapshot&) { return true; },
                             [] { return std::unique_ptr<Process>(std::make_unique<DripProcess>()); }});
  }
  /// On from frame `from` to before frame `to`; ten frames a second.
  static void pause(SceneSnapshot& of, const char* property, int from, int to) {
    AnimationCurve& curve = of.nodes[2].curves[property];
    curve.setKey({0.0, false, Interpolation::Step});
    curve.setKey({from / 10.0, true, Interpolation::Step});
    curve.setKey({to / 10.0, false, Interpolation::Step});
  }
  std::vector<double> figures(const SceneSnapshot& of, const char* name) {
    FrameStore store;
    EXPECT_TRUE(runSimulation(of, store, options, {}, CancelToken()).ok());
    std::vector<double> found;
    for (int frame = 0; frame <= options.lastFrame; ++frame)
      found.push_back(store.get(frame)->info.figures.at(name));
    return found;
  }
  SceneSnapshot scene = test::testScene();
  RunOptions options = test::testOptions(9);
};

TEST_F(Pause, HoldsOneGroupStillWhileTheOtherGoesOn) {
  pause(scene, "pause_flow", 3, 6);
  EXPECT_EQ(figures(scene, "drops"), (std::vector<double>{0, 1, 2, 2, 2, 2, 3, 4, 5, 6}));
  EXPECT_EQ(figures(scene, "total_m"), figures(test::testScene(), "total_m"));
  SceneSnapshot still = test::testScene();
  pause(still, "pause_snow", 3, 6);
  EXPECT_EQ(figures(still, "drops").back(), 9.0);
  const std::vector<double> walked = figures(still, "total_m");
  EXPECT_EQ(walked[2], walked[5]);
  EXPECT_NE(walked[5], walked[6]);
}

TEST_F(Pause, KeepsTheFramesBeforeItAndIgnoresWhatIsHeldStill) {
  const auto before = frameKeys(scene, options);
  pause(scene, "pause_flow", 4, 100);
  const auto paused = frameKeys(scene, options);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(paused[k], before[k]);
  for (std::size_t k = 4; k < paused.size(); ++k) EXPECT_NE(paused[k], before[k]);
  // What the flow alone depends on may change while it stands still.
  const auto withoutWeather = [&](double temperature) {
    SceneSnapshot s;
    s.nodes = {scene.nodes[0], scene.nodes[2]};
    RunOptions alone = options;
    alone.types = {options.types.back()};
    AnimationCurve& curve = s.nodes[0].curves["air_temperature_k"];
    curve.setKey({0.0, 270.0, Interpolation::Step});
    curve.setKey({0.5, temperature, Interpolation::Step});
    return frameKeys(s, alone);
  };
  EXPECT_EQ(withoutWeather(260.0), withoutWeather(250.0));
}

TEST_F(Pause, ARunThatWasCutOffGoesOnTheSame) {
  pause(scene, "pause_flow", 3, 6);
  const std::vector<double> whole = figures(scene, "drops");
  FrameStore store;
  RunOptions first = options;
  first.lastFrame = 4;
  ASSERT_TRUE(runSimulation(scene, store, first, {}, CancelToken()).ok());
  ASSERT_TRUE(runSimulation(scene, store, options, {}, CancelToken()).ok());
  for (int frame = 0; frame <= options.lastFrame; ++frame)
    EXPECT_EQ(store.get(frame)->info.figures.at("drops"), whole[static_cast<std::size_t>(frame)]);
}

}  // namespace
}  // namespace spin
