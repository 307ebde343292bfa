// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_run.h"
#include "core/bench/worst.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "core/physics/flutter.h"
#include "core/snow/flake_field.h"

namespace spin {
namespace {

using Complex = std::complex<double>;

/// Ways that flakes have gone, headings and speeds of their swing, gathered over the frames of a fall.
class Watch {
 public:
  explicit Watch(std::size_t flakes) : m_ways(flakes), m_last(flakes) {}

  void begin(const std::vector<Vec3d>& positions) { m_last = positions; }
  /// Positions may be wrapped into a box of that size, 0 = not; between two looks a flake goes less than
  /// half.
  void look(const std::vector<Vec3d>& positions, const std::vector<Vec2d>& swings, double box) {
    const auto way = [&](double d) { return box > 0.0 ? std::remainder(d, box) : d; };
    for (std::size_t k = 0; k < m_ways.size(); ++k) {
      const Vec3d d = positions[k] - m_last[k];
      m_ways[k] += Vec3d{way(d.x), way(d.y), way(d.z)};
    }
    m_last = positions;
    lookAtSwings(swings);
  }

  double meanFall() const {
    double sum = 0.0;
    for (const Vec3d& w : m_ways) sum -= w.z;
    return sum / static_cast<double>(m_ways.size());
  }
  /// Largest angle of a flake's way from the vertical, degrees.
  double largestDrift() const {
    double largest = 0.0;
    for (const Vec3d& w : m_ways) largest = worse(largest, std::atan2(std::hypot(w.x, w.y), -w.z));
    return radiansToDegrees(largest);
  }
  /// Largest mean of exp(i n heading), n = 1 and 2, over the looks, times the root of the number: about 1 by
  /// chance, above 4 by chance in less than 1 of 10^6 looks.
  double anisotropy() const { return m_anisotropy; }
  /// Largest |mean velocity| over the root mean square, times the root of the number.
  double commonSwing() const { return m_common; }
  /// Range of the mean square of the swing's speed over the looks, over its mean, times the root of the
  /// number: 2 to 11 by chance, the root of the number where all beat in step.
  double beat() const {
    return (m_highest - m_lowest) / (m_squares / m_looks) * std::sqrt(static_cast<double>(m_ways.size()));
  }

 private:
  void lookAtSwings(const std::vector<Vec2d>& swings) {
    Complex once{}, twice{}, mean{};
    double squares = 0.0;
    for (const Vec2d& v : swings) {
      const Complex c{v.x, v.y};
      const double size = std::abs(c);
      squares += size * size, mean += c;
      if (size > 0.0) once += c / size, twice += (c / size) * (c / size);
    }
    const double n = static_cast<double>(swings.size()), root = std::sqrt(n);
    m_anisotropy = worse(m_anisotropy, std::max(std::abs(once), std::abs(twice)) / root);
    m_common = worse(m_common, std::abs(mean) / root / std::sqrt(squares / n));
    m_lowest = std::min(m_lowest, squares / n), m_highest = std::max(m_highest, squares / n);
    m_squares += squares / n, m_looks += 1.0;
  }

  std::vector<Vec3d> m_ways, m_last;
  double m_anisotropy = 0.0, m_common = 0.0, m_lowest = 1e300, m_highest = 0.0, m_squares = 0.0,
         m_looks = 0.0;
};

void report(BenchRow& row, const Watch& watch, double fallWithout) {
  row.addError("fall_speed_change", std::abs(watch.meanFall() / fallWithout - 1.0), "1", 0.02);
  row.addError("drift_deg", watch.largestDrift(), "deg", 20.0);
  row.addError("heading_anisotropy", watch.anisotropy(), "1", 4.5);
  row.addError("common_swing", watch.commonSwing(), "1", 4.5);
  row.addError("beat", watch.beat(), "1", 15.0);
}

template <class T>
SceneNode nodeOf(const NodeType& type, const T& data) {
  SceneNode node = makeNode(type, type.id, type.id);
  node.data = std::make_shared<T>(data);
  return node;
}

SceneSnapshot stillAir(double amplitude, int flakes) {
  WeatherNode weather;
  weather.windSpeed = 0.0;
  SnowfallNode snowfall;
  snowfall.flutterAmplitude = amplitude;
  snowfall.flakeCount = flakes;
  snowfall.groups = 1;
  SceneSnapshot scene;
  scene.nodes = {nodeOf(kWeatherType, weather), nodeOf(kSnowfallType, snowfall),
                 nodeOf(kSimulationType, SimulationNode{})};
  return scene;
}

/// All flakes of a scene, frame by frame, as its pictures have them.
class Eye {
 public:
  explicit Eye(const SnowfallNode& snowfall) : m_snowfall(snowfall) {}
  void look(const Frame& frame) {
    const auto* part = frame.part<FlakesPart>("flakes");
    SPIN_CHECK(part, "the frame has no flakes");
    const auto groups = flakeGroups(m_snowfall, part->flakes.numberDensity);
    if (!m_field) m_field = std::make_unique<FlakeField>(part->flakes.seed, groups);
    FlakeView all;
    all.leastFade = -1.0;
    CpuBackend backend;
    m_field->look(part->flakes, groups, all, backend, m_seen);
  }
  std::vector<Vec3d> positions() const {
    std::vector<Vec3d> all;
    for (std::size_t k = 0; k < m_seen.count; ++k)
      all.push_back({at(FlakeValue::X, k), at(FlakeValue::Y, k), at(FlakeValue::Z, k)});
    return all;
  }
  std::vector<Vec2d> swings() const {
    std::vector<Vec2d> all;
    for (std::size_t k = 0; k < m_seen.count; ++k)
      all.push_back({at(FlakeValue::VX, k), at(FlakeValue::VY, k)});
    return all;
  }

 private:
  double at(FlakeValue value, std::size_t k) const { return static_cast<double>(m_seen[value][k]); }
  SnowfallNode m_snowfall;
  std::unique_ptr<FlakeField> m_field;
  FlakeRecords m_seen;
};

/// The process as scenes run it.
Result<Watch> watchProcess(const SceneSnapshot& scene, int frames) {
  SnowRun run(scene, makeBvhRayScene);
  if (const Status status = run.begin(); !status) return status.error();
  const auto snowfall = scene.settings<SnowfallNode>(0.0);
  Eye eye(snowfall);
  eye.look(run.frame());
  Watch watch(eye.positions().size());
  watch.begin(eye.positions());
  for (int f = 0; f < frames; ++f) {
    if (const Status status = run.step(); !status) return status.error();
    eye.look(run.frame());
    watch.look(eye.positions(), eye.swings(), snowfall.boxSize);
  }
  return watch;
}

Result<BenchRow> measureProcess(int flakes, int frames) {
  BenchRow row;
  row.caseId = "flutter";
  row.settings = {
      {"law", "steady, in a scene"}, {"flakes", std::to_string(flakes)}, {"frames", std::to_string(frames)}};
  const BenchMeter meter;
  const double amplitude = SnowfallNode().flutterAmplitude;
  const auto with = watchProcess(stillAir(amplitude, flakes), frames);
  if (!with) return with.error();
  const auto without = watchProcess(stillAir(0.0, flakes), frames);
  if (!without) return without.error();
  report(row, *with, without->meanFall());
  meter.finish(row);
  return row;
}

/// A law by itself, about flakes that fall at 1 m/s; windSpeed only makes the swing larger and faster.
BenchRow measureLaw(FlutterLaw law, const char* id, double windSpeed, int flakes, int frames) {
  BenchRow row;
  row.caseId = "flutter";
  row.settings = {{"law", id},
                  {"wind_m_s", fmt::format("{:g}", windSpeed)},
                  {"flakes", std::to_string(flakes)},
                  {"frames", std::to_string(frames)}};
  const BenchMeter meter;
  const double gain = flutterGain(windSpeed, 1.0), step = 1.0 / 24.0;
  const double amplitude = gain * SnowfallNode().flutterAmplitude, rate = gain * SnowfallNode().flutterRate;
  const auto n = static_cast<std::size_t>(flakes);
  Watch watch(n);
  std::vector<Vec3d> positions(n);
  std::vector<Vec2d> swings(n);
  for (int f = 0; f <= frames; ++f) {
    for (std::size_t k = 0; k < n; ++k) {
      const FlutterState s = flutterAt(drawFlutter(CounterRandom{1, 7}, k), law, amplitude, rate, f * step);
      positions[k] = {s.offset.x, s.offset.y, -f * step};
      swings[k] = s.velocity;
    }
    f == 0 ? watch.begin(positions) : watch.look(positions, swings, 0.0);
  }
  report(row, watch, frames * step);
  meter.finish(row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  const int flakes = options.quick ? 5000 : 20000, frames = options.quick ? 72 : 240;
  auto process = measureProcess(flakes, frames);
  if (!process) return process.error();
  return std::vector<BenchRow>{std::move(*process),
                               measureLaw(FlutterLaw::Steady, "steady", 0.0, flakes, frames),
                               measureLaw(FlutterLaw::Decaying, "decaying", 0.0, flakes, frames),
                               measureLaw(FlutterLaw::Decaying, "decaying", 5.0, flakes, frames)};
}

}  // namespace

BenchCase flutterCase() {
  return {"flutter", "fall speed, drift, headings and common beat of fluttering flakes",
          "unchanged speed, isotropy, independence", run};
}

}  // namespace spin
