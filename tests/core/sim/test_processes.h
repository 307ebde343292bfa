// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "core/base/log.h"
#include "core/base/random.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "core/sim/runner.h"

namespace spin::test {

/// What the test processes do beside their work; set per test.
struct Behaviour {
  std::atomic<int> nanAtFrame{-1};
  std::atomic<int> stepMilliseconds{0};
  std::atomic<int> stepsDone{0};
  std::atomic<int> begins{0};
};
inline Behaviour& behaviour() {
  static Behaviour b;
  return b;
}

constexpr int kWalkers = 5000;

/// A random walk blown by the weather's wind: chaotic enough that any wrong state shows in the result.
class WalkProcess final : public Process {
 public:
  const char* id() const override { return "walk"; }
  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    if (const SceneNode* weather = input.scene.first<WeatherNode>())
      input.scene.hashNode(*weather, input.to.film, hasher);
  }
  Status begin(const SceneSnapshot&, ProcessContext&) override {
    ++behaviour().begins;
    m_positions.assign(kWalkers, Vec3f{});
    m_total = 0.0;
    return {};
  }
  Status step(const StepInput& input, ProcessContext& context) override {
    const auto wind = static_cast<float>(input.scene.settings<WeatherNode>(input.to.film).windSpeed);
    const CounterRandom random{static_cast<std::uint64_t>(input.scene.settings<SimulationNode>(0).seed), 7};
    const auto frame = static_cast<std::uint32_t>(input.to.frame);
    context.backend.forEach(
        "walk", m_positions.size(),
        [&](std::size_t i) {
          Vec3f& p = m_positions[i];
          p.x = 1.0001f * p.x + wind * random.uniform(i, frame) + std::sin(p.y);
          p.y = p.y + p.x * 1e-3f;
        },
        64);
    m_total = context.backend.reduce(
        "sum", m_positions.size(), m_total,
        [&](std::size_t i) { return static_cast<double>(m_positions[i].x); },
        [](double a, double b) { return a + b; });
    if (Status waited = waitAsAsked(context); !waited) return waited;
    ++behaviour().stepsDone;
    return {};
  }
  void publish(const SceneSnapshot&, const FrameTime& time, Frame& frame) const override {
    auto part = std::make_shared<ParticlePart>();
    part->particles.name = "walkers";
    part->particles.positions = m_positions;
    part->particles.attributes = {{"height", "m", 1, std::vector<float>(m_positions.size(), 1.0f)}};
    if (behaviour().nanAtFrame == time.frame) part->particles.attributes[0].values[17] = std::nanf("");
    frame.parts["walkers"] = std::move(part);
    frame.info.budget.set("emitted", true, 100.0);
    frame.info.budget.set("aloft", false, 100.0);
    frame.info.figures["total_m"] = m_total;
  }
  void saveState(ByteWriter& out) const override {
    out.putArray(m_positions);
    out.put(m_total);
  }
  Status loadState(const SceneSnapshot&, ProcessContext&, ByteReader& in) override {
    m_positions = in.getArray<Vec3f>();
    m_total = in.get<double>();
    if (m_positions.size() != kWalkers)
      return badInput("The state is damaged", "walk", "wrong number of walkers");
    return {};
  }
  void estimate(const SceneSnapshot&, double& stateBytes, double& frameBytes) const override {
    stateBytes = kWalkers * sizeof(Vec3f);
    frameBytes = kWalkers * (sizeof(Vec3f) + sizeof(float));
  }

 private:
  static Status waitAsAsked(ProcessContext& context) {
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::milliseconds(behaviour().stepMilliseconds);
    while (std::chrono::steady_clock::now() < end) {
      if (context.cancel.cancelled()) return Error{ErrorKind::Cancelled, "cancelled", "", "", ""};
      if (context.progress) context.progress(0.5);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return {};
  }
  std::vector<Vec3f> m_positions;
  double m_total = 0.0;
};

/// Two small grids that grow by one unit a step; needed where a snowfall stands in the scene.
class GrowProcess final : public Process {
 public:
  const char* id() const override { return "grow"; }
  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    input.scene.hashNode(*input.scene.first<SnowfallNode>(), input.to.film, hasher);
  }
  Status begin(const SceneSnapshot&, ProcessContext&) override {
    makeLayout();
    m_swe.assign(6, 0.0f);
    return {};
  }
  Status step(const StepInput&, ProcessContext&) override {
    for (std::size_t i = 0; i < m_swe.size(); ++i) m_swe[i] += static_cast<float>(i) * 0.1f;
    return {};
  }
  void publish(const SceneSnapshot&, const FrameTime&, Frame& frame) const override {
    auto part = std::make_shared<CoverPart>();
    part->layout = m_layout;
    part->values = {{m_swe, m_swe}};
    frame.parts["cover"] = std::move(part);
  }
  void saveState(ByteWriter& out) const override { out.putArray(m_swe); }
  Status loadState(const SceneSnapshot&, ProcessContext&, ByteReader& in) override {
    makeLayout();
    m_swe = in.getArray<float>();
    return {};
  }
  void estimate(const SceneSnapshot&, double& stateBytes, double& frameBytes) const override {
    stateBytes = 24;
    frameBytes = 72;
  }

 private:
  void makeLayout() {
    auto layout = std::make_shared<CoverLayout>();
    CoverGrid grid{"terrain", "terrain", Raster<float>(3, 2, 0, 0, 5, 2.5f),
                   Raster<float>(3, 2, 0, 0, 5, 25.0f)};
    grid.base.values[4] = std::nanf("");
    layout->grids.push_back(std::move(grid));
    m_layout = std::move(layout);
  }
  std::shared_ptr<const CoverLayout> m_layout;
  std::vector<float> m_swe;
};

inline std::vector<ProcessType> testTypes() {
  return {{"grow", 400, [](const SceneSnapshot& s) { return s.first<SnowfallNode>() != nullptr; },
           [] { return std::unique_ptr<Process>(std::make_unique<GrowProcess>()); }},
          {"walk", 200, [](const SceneSnapshot& s) { return s.first<WeatherNode>() != nullptr; },
           [] { return std::unique_ptr<Process>(std::make_unique<WalkProcess>()); }}};
}

inline void setProperty(SceneNode& node, const char* property, const Value& value) {
  setPlainValue(node, *node.type->find(property), value);
}

/// Weather, snowfall and simulation settings with a checkpoint every four frames.
inline SceneSnapshot testScene() {
  SceneSnapshot scene;
  scene.nodes = {makeNode(kWeatherType, "weather", "Weather"),
                 makeNode(kSnowfallType, "snowfall", "Snowfall"),
                 makeNode(kSimulationType, "simulation", "Simulation")};
  setProperty(scene.nodes[2], "frame_rate", 10.0);
  setProperty(scene.nodes[2], "checkpoint_interval", std::int64_t{4});
  return scene;
}

inline RunOptions testOptions(int lastFrame, int threads = 2) {
  RunOptions options;
  options.lastFrame = lastFrame;
  options.threads = threads;
  options.types = testTypes();
  return options;
}

/// A folder that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static std::atomic<int> counter{0};
    m_path = std::filesystem::temp_directory_path() /
             ("spindrift-test-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    std::filesystem::create_directories(m_path);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string path(const std::string& name = {}) const {
    return name.empty() ? m_path.string() : (m_path / name).string();
  }

 private:
  std::filesystem::path m_path;
};

/// Catches the log while it lives.
class LogCatcher {
 public:
  LogCatcher() {
    setLogSink([this](LogLevel, std::string_view text) { m_text += std::string(text) + "\n"; });
  }
  ~LogCatcher() { setLogSink({}); }
  LogCatcher(const LogCatcher&) = delete;
  LogCatcher& operator=(const LogCatcher&) = delete;
  const std::string& text() const { return m_text; }

 private:
  std::string m_text;
};

/// The cover's layout of a frame.
inline std::shared_ptr<const CoverLayout> layoutOf(const Frame& frame) {
  const auto* cover = frame.part<CoverPart>("cover");
  SPIN_CHECK(cover, "the frame has a cover");
  return cover->layout;
}

/// All that counts of a frame, as bytes.
inline std::vector<char> resultOf(const FramePointer& frame) {
  ByteWriter out;
  saveFrame(*frame, out, false);
  return out.take();
}

/// Bytes of frames 0 .. last of a store; an empty entry where a frame is missing.
inline std::vector<std::vector<char>> resultsOf(FrameStore& store, int last) {
  std::vector<std::vector<char>> all;
  for (int frame = 0; frame <= last; ++frame) {
    const FramePointer found = store.get(frame);
    all.push_back(found ? resultOf(found) : std::vector<char>{});
  }
  return all;
}

/// An uninterrupted run in RAM.
inline std::vector<std::vector<char>> referenceResults(const SceneSnapshot& scene, int last,
                                                       int threads = 2) {
  FrameStore store;
  const Status done = runSimulation(scene, store, testOptions(last, threads), {}, CancelToken());
  SPIN_CHECK(done.ok(), done.error().text());
  return resultsOf(store, last);
}

}  // namespace spin::test
