// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/nodes/settings_nodes.h"
#include "core/physics/drag.h"
#include "core/physics/flutter.h"
#include "core/snow/snow_inputs.h"
#include "core/snow/snow_processes.h"
#include "core/snow/snow_weather.h"

namespace spin {
namespace {

constexpr Vec3d kGravity{0.0, 0.0, -kStandardGravity};

constexpr std::uint32_t kFlakeStream = 0x666c616bu;
constexpr double kFullSwingSpeed = 1.0;  // m/s of fall from which a flake swings by the whole amplitude

/// Share of the flakes that are smaller than this one. Multiples of the golden ratio are spread evenly over
/// the quantiles for any number of flakes.
double quantileOf(std::size_t id) {
  constexpr double kGolden = 0.61803398874989485;
  const double spread = (static_cast<double>(id) + 0.5) * kGolden;
  return spread - std::floor(spread);
}

double wrapped(double value, double period) {
  const double inside = value - period * std::floor(value / period);
  return inside >= period ? 0.0 : inside;  // a NaN goes on and is found
}

/// Flakes fall by the drag law in one periodic box. Their flutter is a swing about that path, a function of
/// film time alone, so it adds no drift.
class FallProcess final : public Process {
 public:
  const char* id() const override { return "fall"; }

  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    hasher.add("fall");
    hashSnowWeather(input, hasher);
  }

  Status begin(const SceneSnapshot& scene, ProcessContext&) override {
    const SnowWeather weather = snowWeatherAt(scene, 0.0);
    const std::uint64_t seed = seedOf(scene);
    const auto count = static_cast<std::size_t>(std::max(weather.snowfall.flakeCount, 0));
    m_positions.resize(count);
    m_velocities.resize(count);
    const CounterRandom random{seed, 0x66616c6cu};
    for (std::size_t k = 0; k < count; ++k) {
      const UInt4 a = random.words(k, 0), b = random.words(k, 1);
      m_positions[k] = Vec3d{toUnitDouble(a.x, a.y), toUnitDouble(a.z, a.w), toUnitDouble(b.x, b.y)} *
                       weather.snowfall.boxSize;
      m_velocities[k] = weather.wind - Vec3d{0, 0, speedOf(weather, quantileOf(k))};
    }
    return {};
  }

  Status step(const StepInput& input, ProcessContext& context) override {
    const SnowWeather weather = snowWeatherAt(input.scene, middleFilm(input));
    const double h = input.to.film - input.from.film;
    if (weather.precipitation <= 0.0 || !(h > 0.0)) return {};
    context.backend.forEach("fall", m_positions.size(), [&](std::size_t k) {
      if (context.cancel.cancelled()) return;
      fall(k, speedOf(weather, quantileOf(k)), weather, h);
    });
    if (context.cancel.cancelled())
      return Error{ErrorKind::Cancelled, "The simulation stopped", "fall", "it was cancelled", ""};
    return {};
  }

  void publish(const SceneSnapshot& scene, const FrameTime& time, Frame& frame) const override {
    const SnowWeather weather = snowWeatherAt(scene, time.film);
    const std::uint64_t seed = seedOf(scene);
    auto part = std::make_shared<ParticlePart>();
    ParticleSet& set = part->particles;
    set.name = "flakes";
    set.wrapBox = weather.snowfall.boxSize;
    set.attributes = {{"velocity", "m/s", 3, {}}, {"diameter", "m", 1, {}}, {"mass", "kg", 1, {}}};
    const std::size_t count = weather.precipitation > 0.0 ? m_positions.size() : 0;
    set.weight = count == 0 ? 1.0
                            : weather.spectrum.numberDensity * std::pow(weather.snowfall.boxSize, 3) /
                                  static_cast<double>(count);
    reserve(set, count);
    const CounterRandom random{seed, kFlakeStream};
    for (std::size_t k = 0; k < count; ++k) addFlake(set, k, drawFlutter(random, k), weather, time.film);
    frame.info.figures["flakes_per_m3"] = weather.spectrum.numberDensity;
    frame.info.figures["mean_fall_speed_m_s"] = weather.spectrum.meanFallSpeed;
    frame.parts["flakes"] = std::move(part);
  }

  void saveState(ByteWriter& out) const override {
    out.putArray(m_positions);
    out.putArray(m_velocities);
  }
  Status loadState(const SceneSnapshot& scene, ProcessContext&, ByteReader& in) override {
    m_positions = in.getArray<Vec3d>();
    m_velocities = in.getArray<Vec3d>();
    const auto count = static_cast<std::size_t>(std::max(scene.settings<SnowfallNode>(0.0).flakeCount, 0));
    if (!in.ok() || m_positions.size() != count || m_velocities.size() != count)
      return badInput("The checkpoint could not be used", "fall", "its flakes do not fit the scene");
    return {};
  }
  void estimate(const SceneSnapshot& scene, double& stateBytes, double& frameBytes) const override {
    const double count = scene.settings<SnowfallNode>(0.0).flakeCount;
    stateBytes = count * 2.0 * sizeof(Vec3d);
    frameBytes = count * (sizeof(std::uint64_t) + 8.0 * sizeof(float));
  }

 private:
  static std::uint64_t seedOf(const SceneSnapshot& scene) {
    return static_cast<std::uint64_t>(scene.settings<SimulationNode>(0.0).seed);
  }
  static double massOf(const SnowWeather& weather, double quantile) {
    return massOfMeltedDiameter(weather.spectrum.meltedDiameter(quantile));
  }
  static double speedOf(const SnowWeather& weather, double quantile) {
    const FlakeFallLaw& law = weather.spectrum.law;
    return law.terminalSpeed(law.diameterOfMass(massOf(weather, quantile)));
  }

  void fall(std::size_t k, double terminalSpeed, const SnowWeather& weather, double h) {
    Vec3d velocity = m_velocities[k];
    const Vec3d path = dragAdvance(velocity, weather.wind, terminalSpeed, kGravity, h);
    const double box = weather.snowfall.boxSize;
    const Vec3d p = m_positions[k] + path;
    m_positions[k] = {wrapped(p.x, box), wrapped(p.y, box), wrapped(p.z, box)};
    m_velocities[k] = velocity;
  }

  static void reserve(ParticleSet& set, std::size_t count) {
    set.ids.reserve(count);
    set.positions.reserve(count);
    for (ParticleAttribute& a : set.attributes)
      a.values.reserve(count * static_cast<std::size_t>(a.components));
  }

  void addFlake(ParticleSet& set, std::size_t k, const Flutter& flutter, const SnowWeather& weather,
                double film) const {
    const double mass = massOf(weather, quantileOf(k)), diameter = weather.spectrum.law.diameterOfMass(mass);
    // The swing of slow flakes is smaller in proportion, or the smallest would fly sideways.
    const double amplitude = weather.snowfall.flutterAmplitude *
                             std::min(weather.spectrum.law.terminalSpeed(diameter) / kFullSwingSpeed, 1.0);
    const FlutterState swing =
        flutterAt(flutter, FlutterLaw::Steady, amplitude, weather.snowfall.flutterRate, film);
    const Vec3d p = m_positions[k] + Vec3d{swing.offset.x, swing.offset.y, 0.0};
    const Vec3d v = m_velocities[k] + Vec3d{swing.velocity.x, swing.velocity.y, 0.0};
    const auto box = static_cast<float>(weather.snowfall.boxSize);
    const auto inBox = [&](double c) {
      const auto rounded = static_cast<float>(wrapped(c, weather.snowfall.boxSize));
      return rounded < box ? rounded : 0.0f;
    };
    set.ids.push_back(k);
    set.positions.push_back({inBox(p.x), inBox(p.y), inBox(p.z)});
    const Vec3f velocity = v.to<float>();
    set.attributes[0].values.insert(set.attributes[0].values.end(), {velocity.x, velocity.y, velocity.z});
    set.attributes[1].values.push_back(static_cast<float>(diameter));
    set.attributes[2].values.push_back(static_cast<float>(mass));
  }

  std::vector<Vec3d> m_positions;   ///< in [0, box)^3, without flutter
  std::vector<Vec3d> m_velocities;  ///< m/s, without flutter
};

}  // namespace

ProcessType fallProcessType() {
  return {"fall", 200, [](const SceneSnapshot& scene) { return scene.first<SnowfallNode>() != nullptr; },
          [] { return std::unique_ptr<Process>(std::make_unique<FallProcess>()); }};
}

}  // namespace spin
