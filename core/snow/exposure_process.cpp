// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/exposure_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/log.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/snow/snow_inputs.h"
#include "core/snow/snow_motion.h"
#include "core/snow/snow_processes.h"

namespace spin {

namespace {

/// Maps of all directions are held at once.
constexpr double kMostMapBytes = 1e9;

/// Texels along maps that memory has room for.
int largestMap(int directions) {
  return static_cast<int>(std::sqrt(kMostMapBytes / (sizeof(float) * std::max(directions, 1))));
}

}  // namespace

ExposureSettings exposureSettings(const SceneSnapshot& scene, double filmTime) {
  const SnowWeather weather = snowWeatherAt(scene, filmTime);
  const auto simulation = scene.settings<SimulationNode>(filmTime);
  ExposureSettings settings;
  settings.cone = fallCone(weather.wind, directingSpectrum(scene, weather).meanFallSpeed,
                           degreesToRadians(weather.snowfall.fallSpreadDegrees));
  settings.rays = std::max(simulation.exposureRays, 1);
  if (simulation.exposureMethod == ExposureMethod::Maps)
    settings.mapDirections = std::clamp(simulation.exposureDirections, 1, settings.rays);
  settings.mapSize = std::clamp(simulation.exposureMapSize, 64, largestMap(settings.mapDirections));
  settings.hold.holdsBelow = degreesToRadians(simulation.holdsBelowDegrees);
  settings.hold.shedsAbove =
      degreesToRadians(std::max(simulation.shedsAboveDegrees, simulation.holdsBelowDegrees));
  settings.noise = simulation.exposureNoise;
  settings.seed = static_cast<std::uint64_t>(simulation.seed);
  return settings;
}

namespace {

/// Where the models stand.
Hash128 placesOf(const SceneSnapshot& scene, double filmTime) {
  Hasher hasher;
  for (const SceneNode* node : scene.all<ModelNode>()) {
    if (!scene.models.count(node->id)) continue;
    const Transform placement = scene.modelTransform(*node, filmTime);
    for (const double value : placement.linear) hasher.add(value);
    hasher.add(placement.translation.x).add(placement.translation.y).add(placement.translation.z);
  }
  return hasher.digest();
}

/// Holds the exposure and asks again only when the directions of fall or settings changed, or where a model
/// moved. It is a pure function of those, so a checkpoint need not store it.
class ExposureProcess final : public Process {
 public:
  const char* id() const override { return "exposure"; }

  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    hasher.add("exposure");
    hashSnowWeather(input, hasher);
    hashSnowGround(input, hasher);
  }

  Status begin(const SceneSnapshot& scene, ProcessContext& context) override {
    prepare(scene, context);
    return update(scene, 0.0, context);
  }
  Status step(const StepInput& input, ProcessContext& context) override {
    return update(input.scene, middleFilm(input), context);
  }

  void publish(const SceneSnapshot&, const FrameTime&, Frame& frame) const override {
    if (!m_field) return;
    if (m_field->samplingRmse) frame.info.figures["exposure_sampling_rmse"] = *m_field->samplingRmse;
    frame.info.figures["fall_cone_deg"] = radiansToDegrees(m_field->cone.halfAngle);
  }

  /// The field is made again from its time: a pause may keep it for many frames after it.
  void saveState(ByteWriter& out) const override { out.put(m_filmTime); }
  Status loadState(const SceneSnapshot& scene, ProcessContext& context, ByteReader& in) override {
    prepare(scene, context);
    const double filmTime = in.get<double>();
    if (!in.ok() || !std::isfinite(filmTime))
      return badInput("The checkpoint could not be used", "exposure", "it does not tell the field's time");
    return update(scene, filmTime, context);
  }

  void estimate(const SceneSnapshot& scene, double& stateBytes, double& frameBytes) const override {
    stateBytes = frameBytes = 0.0;
    // About 150 bytes a triangle of the ray scene, with their tree; two to a terrain cell.
    constexpr double kTriangle = 150.0;
    if (scene.terrain) stateBytes += static_cast<double>(scene.terrain->heights.size()) * 2.0 * kTriangle;
    for (const auto& [node, model] : scene.models)
      if (model) stateBytes += static_cast<double>(model->triangleCount()) * kTriangle;
  }

 private:
  void prepare(const SceneSnapshot& scene, ProcessContext& context) {
    m_field = nullptr;
    m_memory = {};
    m_scenes.emplace(context.makeRayScene);
    m_places.reset();
    m_motion = std::make_shared<SnowMotion>();
    context.exchange.emplace<SnowMotionPointer>(m_motion);
    m_ground = makeSnowGround(scene);
    for (const std::string& message : m_ground->messages) logWarning(message);
    const auto simulation = scene.settings<SimulationNode>(0.0);
    if (const int side = exposureSettings(scene, 0.0).mapSize; side < simulation.exposureMapSize)
      logWarning(
          fmt::format("Occlusion maps are {} texels wide instead of {}: {} directions of them would "
                      "take more than {:g} GB",
                      side, simulation.exposureMapSize, simulation.exposureDirections, kMostMapBytes / 1e9));
    context.exchange.emplace<SnowGroundPointer>(m_ground);
  }

  Status update(const SceneSnapshot& scene, double filmTime, ProcessContext& context) {
    const ExposureSettings settings = exposureSettings(scene, filmTime);
    const Hash128 places = placesOf(scene, filmTime);
    const bool moved = !m_places || !(places == *m_places);
    m_filmTime = filmTime;
    if (m_field && !moved && settings == m_settings) return {};
    m_field = nullptr;  // it is of the past, also where this is cancelled
    std::optional<SnowScene> made = [&] {
      ScopedStage stage(context.backend.timings(), "ray scene");
      return m_scenes->at(scene, *m_ground, filmTime, context.cancel);
    }();
    if (!made) return cancelledError();
    const auto standing = std::make_shared<const SnowScene>(std::move(*made));
    if (moved) m_motion->place(m_ground, standing);
    m_places = places;
    auto field = makeExposureField(scene, *m_ground, *standing, settings,
                                   {context.backend, context.cancel, context.progress, context.makeMapRaster},
                                   &m_memory);
    if (!field) return field.error();
    m_field = std::make_shared<const ExposureField>(std::move(field.value()));
    m_settings = settings;
    context.exchange.emplace<ExposureFieldPointer>(m_field);
    return {};
  }

  SnowGroundPointer m_ground;
  ExposureFieldPointer m_field;
  ExposureSettings m_settings;  ///< of the field
  double m_filmTime = 0.0;      ///< that it holds for, s
  std::optional<SnowSceneMaker> m_scenes;
  ExposureMemory m_memory;
  SnowMotionPointer m_motion;
  std::optional<Hash128> m_places;  ///< of the models that it was placed for
};

}  // namespace

ProcessType exposureProcessType() {
  return {"exposure", 300, snowHasGround,
          [] { return std::unique_ptr<Process>(std::make_unique<ExposureProcess>()); }};
}

}  // namespace spin
