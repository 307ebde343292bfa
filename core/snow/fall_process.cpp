// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/nodes/settings_nodes.h"
#include "core/physics/drag.h"
#include "core/physics/snow_visibility.h"
#include "core/sim/flakes_part.h"
#include "core/snow/exposure_field.h"
#include "core/snow/fall_wind.h"
#include "core/snow/snow_inputs.h"
#include "core/snow/snow_processes.h"
#include "core/snow/snow_weather.h"

namespace spin {
namespace {

constexpr Vec3d kGravity{0.0, 0.0, -kStandardGravity};
constexpr double kFullSwingSpeed = 1.0;  // m/s of fall from which a flake swings by the whole amplitude
constexpr int kCoverSamples = 4096;      // of the sizes, for what all flakes hide

/// How far the flakes of one size have come.
struct ClassState {
  Vec3d way{}, velocity{};
  double swingAngle = 0.0;  ///< rad
};

double massOfPlace(const SnowWeather& weather, double place) {
  // Class 0 stands for the smallest flakes; none has no mass at all.
  return massOfMeltedDiameter(flakeClassValue(std::max(place, 0.25)) / weather.spectrum.slope);
}

/// Flakes of one size go the same way in the mean wind, so the drag law is integrated by size, not by flake.
/// Gusts and flutter are swings about that way, functions of place and film time.
class FallProcess final : public Process {
 public:
  const char* id() const override { return "fall"; }

  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    hasher.add("fall");
    hashSnowWeather(input, hasher);
    hashSnowGround(input, hasher);
  }

  Status begin(const SceneSnapshot& scene, ProcessContext& context) override {
    m_landWind = nullptr, m_solved = false;
    const SnowWeather weather = snowWeatherAt(scene, 0.0);
    m_classes.assign(kFlakeClasses, {});
    m_gust = {};
    m_filmTime = 0.0;
    if (const Status solved = solveWind(scene, context); !solved) return solved;
    for (std::size_t c = 0; c < m_classes.size(); ++c)
      m_classes[c].velocity = terminalVelocity(weather, speedOf(weather, c));
    return {};
  }

  Status step(const StepInput& input, ProcessContext& context) override {
    const SnowWeather weather = snowWeatherAt(input.scene, middleFilm(input));
    m_filmTime = input.to.film;
    if (const Status solved = solveWind(input.scene, context); !solved) return solved;
    const double h = input.to.film - input.from.film;
    if (!(h > 0.0)) return {};
    for (std::size_t c = 0; c < m_classes.size(); ++c) advance(m_classes[c], weather, speedOf(weather, c), h);
    m_gust.carried += weather.wind * h;
    m_gust.eddyWay += kEddyTurnover * gustStrength(weather) * h;
    return {};
  }

  void publish(const SceneSnapshot& scene, const FrameTime&, Frame& frame) const override {
    // Flakes that a pause holds still hang in the weather in which it began.
    const SnowWeather weather = snowWeatherAt(scene, m_filmTime);
    auto part = std::make_shared<FlakesPart>();
    FallingFlakes& flakes = part->flakes;
    flakes.seed = static_cast<std::uint64_t>(scene.settings<SimulationNode>(0.0).seed);
    for (std::size_t c = 0; c < m_classes.size(); ++c) flakes.classes.push_back(classOf(weather, c));
    flakes.flutter =
        weather.snowfall.path == FlakePath::DecayingSine ? FlutterLaw::Decaying : FlutterLaw::Steady;
    flakes.gustLength = weather.snowfall.gustLength;
    flakes.gust = m_gust;
    flakes.gust.strength = gustStrength(weather);
    flakes.wind = weather.wind;
    if (length(weather.wind) > FallWind::kCalm) flakes.landWind = m_landWind;
    if (weather.precipitation > 0.0) {
      flakes.numberDensity = weather.spectrum.numberDensity;
      flakes.extinction = snowExtinction(weather.spectrum.massConcentration);
      flakes.cover = std::min(flakes.extinction / (flakes.numberDensity * meanCircle(weather)), 1.0);
      frame.info.figures["visibility_m"] = visibilityOf(flakes.extinction);
    }
    frame.info.figures["flakes_per_m3"] = flakes.numberDensity;
    frame.info.figures["mean_fall_speed_m_s"] = weather.spectrum.meanFallSpeed;
    frame.info.figures["gusts_m_s"] = flakes.gust.strength;
    frame.parts["flakes"] = std::move(part);
  }

  void saveState(ByteWriter& out) const override {
    out.putArray(m_classes);
    out.put(m_gust);
    out.put(m_filmTime);
  }
  Status loadState(const SceneSnapshot& scene, ProcessContext& context, ByteReader& in) override {
    m_landWind = nullptr, m_solved = false;
    m_classes = in.getArray<ClassState>();
    m_gust = in.get<GustState>();
    m_filmTime = in.get<double>();
    if (!in.ok() || !std::isfinite(m_filmTime) || m_classes.size() != static_cast<std::size_t>(kFlakeClasses))
      return badInput("The checkpoint could not be used", "fall", "its flakes do not fit the scene");
    return solveWind(scene, context);
  }
  void estimate(const SceneSnapshot&, double& stateBytes, double& frameBytes) const override {
    stateBytes = kFlakeClasses * sizeof(ClassState) + sizeof(GustState);
    frameBytes = kFlakeClasses * sizeof(FlakeClass);
  }

 private:
  /// Solves the winds over the land when first one blows: it takes a second or more.
  Status solveWind(const SceneSnapshot& scene, ProcessContext& context) {
    const SnowGroundPointer* ground = context.exchange.find<SnowGroundPointer>();
    if (m_solved || !ground || !(length(snowWeatherAt(scene, m_filmTime).wind) > FallWind::kCalm)) return {};
    m_landWind = makeFallWindTable(scene, **ground, context.backend, context.cancel);
    if (context.cancel.cancelled()) return cancelledError();
    m_solved = true;
    return {};
  }
  static double gustStrength(const SnowWeather& weather) {
    return weather.snowfall.gustIntensity * length(weather.wind);
  }
  static double speedOf(const SnowWeather& weather, std::size_t c) {
    const FlakeFallLaw& law = weather.spectrum.law;
    return law.terminalSpeed(law.diameterOfMass(massOfPlace(weather, static_cast<double>(c))));
  }
  static Vec3d terminalVelocity(const SnowWeather& weather, double speed) {
    return weather.wind - Vec3d{0, 0, speed};
  }
  /// How much wider and faster flakes of a fall speed swing than in still air.
  static double gain(const SnowWeather& weather, double speed) {
    return weather.snowfall.path == FlakePath::DecayingSine ? flutterGain(length(weather.wind), speed) : 1.0;
  }

  static void advance(ClassState& state, const SnowWeather& weather, double speed, double h) {
    if (weather.snowfall.path == FlakePath::DecayingSine) {
      state.velocity = terminalVelocity(weather, speed);
      state.way += state.velocity * h;
    } else {
      state.way += dragAdvance(state.velocity, weather.wind, speed, kGravity, h);
    }
    state.swingAngle += weather.snowfall.flutterRate * gain(weather, speed) * h;
  }

  FlakeClass classOf(const SnowWeather& weather, std::size_t c) const {
    const ClassState& state = m_classes[c];
    FlakeClass out;
    out.mass = massOfPlace(weather, static_cast<double>(c));
    out.diameter = weather.spectrum.law.diameterOfMass(out.mass);
    out.fallSpeed = speedOf(weather, c);
    out.way = state.way;
    out.velocity = state.velocity;
    // The swing of slow flakes is smaller in proportion, or the smallest would fly sideways.
    out.swingAmplitude = weather.snowfall.flutterAmplitude * gain(weather, out.fallSpeed) *
                         std::min(out.fallSpeed / kFullSwingSpeed, 1.0);
    out.swingRate = weather.snowfall.flutterRate * gain(weather, out.fallSpeed);
    out.swingAngle = state.swingAngle;
    return out;
  }

  /// Mean area of the circles round the flakes, m2.
  static double meanCircle(const SnowWeather& weather) {
    double sum = 0.0;
    for (int k = 0; k < kCoverSamples; ++k) {
      const double x = weather.spectrum.meltedDiameter((k + 0.5) / kCoverSamples);
      const double d = weather.spectrum.law.diameterOfMass(massOfMeltedDiameter(x));
      sum += 0.25 * kPi * d * d;
    }
    return sum / kCoverSamples;
  }

  std::shared_ptr<const WindTable> m_landWind;  ///< null: not asked for yet, or there is no land
  bool m_solved = false;
  std::vector<ClassState> m_classes;
  GustState m_gust;
  double m_filmTime = 0.0;  ///< s, to which they were moved
};

}  // namespace

ProcessType fallProcessType() {
  return {"fall", 320, [](const SceneSnapshot& scene) { return scene.first<SnowfallNode>() != nullptr; },
          [] { return std::unique_ptr<Process>(std::make_unique<FallProcess>()); }};
}

}  // namespace spin
