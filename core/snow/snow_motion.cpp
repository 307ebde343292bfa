// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_motion.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/units.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/physics/blowing_snow.h"
#include "core/snow/snow_weather.h"

namespace spin {
namespace {

/// Drifts shelter less as they grow: the wind is asked again after so long, s.
constexpr double kLongestBlow = 900.0;

void add(std::vector<double>& sums, const std::vector<double>& more) {
  for (std::size_t q = 0; q < sums.size(); ++q) sums[q] += more[q];
}

}  // namespace

MotionSettings motionSettings(const SceneSnapshot& scene, double filmTime) {
  const auto simulation = scene.settings<SimulationNode>(filmTime);
  const SnowWeather weather = snowWeatherAt(scene, filmTime);
  MotionSettings settings;
  settings.slides = simulation.snowSlides;
  settings.drifts = simulation.snowDrifts;
  settings.repose.dry = degreesToRadians(simulation.reposeDryDegrees);
  settings.repose.wet = degreesToRadians(std::min(simulation.reposeWetDegrees, simulation.reposeDryDegrees));
  // A width w is evened out in a time t where rate * t = w^2/2: the spread of diffusion.
  settings.smoothingRate = 0.5 * simulation.smoothingWidth * simulation.smoothingWidth / 86400.0;
  settings.driftThresholdWind = simulation.driftThresholdWind;
  settings.drift.inflow = simulation.driftInflow;
  settings.wind10 = {weather.wind.x, weather.wind.y};
  settings.drift.settlingWay = std::max(1.0, 0.35 * std::hypot(weather.wind.x, weather.wind.y));
  settings.airCelsius = kelvinToCelsius(weather.airTemperature);
  return settings;
}

void SnowMotion::place(SnowGroundPointer ground, std::shared_ptr<const SnowScene> scene) {
  if (ground != m_ground) m_field.reset();
  m_ground = std::move(ground);
  m_standing = std::move(scene);
}

const CoverGraph& SnowMotion::graph() {
  if (!m_standing) return *m_graph;
  m_graph = std::make_shared<const CoverGraph>(makeCoverGraph(*m_ground, m_standing.get()));
  m_slides.emplace(m_graph);
  m_drift.reset();
  m_windDegrees.reset();
  m_models = m_standing->models;
  m_obstacles.reset();
  m_standing.reset();
  return *m_graph;
}

MotionTotals SnowMotion::step(const SceneSnapshot& snapshot, const MotionSettings& settings, double seconds,
                              const MovingSnow& snow, CpuBackend& backend) {
  SPIN_CHECK(placed(), "snow moves on a ground");
  {
    ScopedStage stage(backend.timings(), "cover graph");
    graph();
  }
  MotionTotals totals;
  const std::vector<double> none(snow.carried.size(), 0.0);
  totals.slid = totals.shed = totals.slidOut = totals.eroded = totals.deposited = none;
  totals.blownIn = totals.blownOut = none;
  if (settings.drifts && seconds > 0.0) blow(snapshot, settings, seconds, snow, backend, totals);
  if (settings.slides) slide(settings, snow, backend, totals);
  SmoothingSettings smoothing;
  smoothing.spread = settings.smoothingRate * seconds;
  smoothSnow(*m_graph, snow.carried, smoothing, backend);
  return totals;
}

void SnowMotion::slide(const MotionSettings& settings, const MovingSnow& snow, CpuBackend& backend,
                       MotionTotals& totals) {
  const double* depth = snow.carried[0];
  std::vector<float> tangents(m_graph->size());
  backend.forEach("slides", tangents.size(), [&](std::size_t c) {
    tangents[c] = static_cast<float>(settings.repose.tangent(snow.liquid ? snow.liquid[c] : 0.0, depth[c]));
  });
  const SlideTotals slid = m_slides->settle(snow.carried, tangents.data(), settings.slide, backend);
  add(totals.slid, slid.slid), add(totals.shed, slid.shed), add(totals.slidOut, slid.left);
  totals.unsettled = slid.unsettled;
}

/// The wind at the ground for the settings' wind; false where none blows or there is no land for it.
bool SnowMotion::turnTo(const SceneSnapshot& snapshot, const MotionSettings& settings, CpuBackend& backend) {
  const double speed = std::hypot(settings.wind10.x, settings.wind10.y);
  if (!(speed > 0.0) || !snapshot.terrain || m_ground->terrain.empty()) return false;
  if (!m_field) {
    const WindObstacles start = makeWindObstacles(snapshot, *m_ground, modelsAtStart(snapshot, *m_ground));
    WindSettings wind;
    wind.roughness = settings.drift.roughness;
    auto field = WindField::make(snapshot.terrain->heights, start.tops, wind, backend);
    if (!field) return false;
    m_field = std::move(*field);
  }
  const int degrees =
      static_cast<int>(std::lround(radiansToDegrees(std::atan2(settings.wind10.y, settings.wind10.x))));
  if (m_windDegrees == degrees) return true;
  const double angle = degreesToRadians(static_cast<double>(degrees));
  if (!m_obstacles) m_obstacles = makeWindObstacles(snapshot, *m_ground, m_models);
  m_wind = groundWind(*m_graph, *m_field, *m_obstacles, {std::cos(angle), std::sin(angle)},
                      settings.drift.roughness, settings.shelter, backend);
  if (!m_drift) m_drift.emplace(m_graph);
  m_drift->setDirections(m_wind.direction);
  m_windDegrees = degrees;
  return true;
}

void SnowMotion::blow(const SceneSnapshot& snapshot, const MotionSettings& settings, double seconds,
                      const MovingSnow& snow, CpuBackend& backend, MotionTotals& totals) {
  const double* depth = snow.carried[0];
  const double* mass = snow.carried[snow.mass];
  const double roughness = settings.drift.roughness, perWind = 0.4 / std::log(10.0 / roughness);
  const double speed = std::hypot(settings.wind10.x, settings.wind10.y);
  const double least = settings.driftThresholdWind > 0.0 ? settings.driftThresholdWind
                                                         : driftThresholdWind(settings.airCelsius);
  // No crest speeds the wind up by more than this; below it no field need be solved.
  constexpr double kMostSpeedUp = 3.0;
  if (speed * kMostSpeedUp < least || !turnTo(snapshot, settings, backend)) return;
  std::vector<float> friction, threshold(m_graph->size());
  backend.forEach("drift", threshold.size(), [&](std::size_t c) {
    const double density = depth[c] > 0.0 ? mass[c] / depth[c] : 100.0;
    const double liquid = snow.liquid && mass[c] > 0.0 ? snow.liquid[c] / mass[c] : 0.0;
    threshold[c] = static_cast<float>(settings.driftThresholdWind > 0.0
                                          ? settings.driftThresholdWind * perWind
                                          : driftThreshold(settings.airCelsius, density, liquid, roughness));
  });
  const int parts = static_cast<int>(std::min(std::ceil(seconds / kLongestBlow), 96.0));
  for (int part = 0; part < parts; ++part) {
    m_wind.sheltered(depth, settings.shelter, backend, friction);
    for (float& u : friction) u *= static_cast<float>(speed);
    ScopedStage stage(backend.timings(), "drift");
    const DriftTotals blown =
        m_drift->blow(snow.carried, snow.mass, friction, threshold, settings.drift, seconds / parts);
    add(totals.eroded, blown.eroded), add(totals.deposited, blown.deposited);
    add(totals.blownIn, blown.blownIn), add(totals.blownOut, blown.blownOut);
  }
}

}  // namespace spin
