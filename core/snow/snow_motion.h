// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/physics/snow_repose.h"
#include "core/snow/ground_wind.h"
#include "core/snow/snow_drift.h"
#include "core/snow/snow_smoothing.h"

namespace spin {

/// How snow moves on the ground, by a scene's settings at one time.
struct MotionSettings {
  bool slides = true, drifts = true;
  SnowRepose repose;
  SlideSettings slide;
  double smoothingRate = 0.0;       ///< m2/s
  double driftThresholdWind = 0.0;  ///< m/s 10 m up; 0 = by air temperature and the snow
  DriftSettings drift;
  ShelterSettings shelter;
  Vec2d wind10{};  ///< m/s, 10 m above level ground
  double airCelsius = 0.0;

  bool moves() const { return slides || drifts || smoothingRate > 0.0; }
};
MotionSettings motionSettings(const SceneSnapshot& scene, double filmTime);

/// What moved, by carried quantity, times m2. Names as in SlideTotals and DriftTotals.
struct MotionTotals {
  std::vector<double> slid, shed, slidOut, eroded, deposited, blownIn, blownOut;
  std::size_t unsettled = 0;  ///< cells still too steep

  /// What came in less what left.
  double net(std::size_t quantity) const {
    return blownIn[quantity] - blownOut[quantity] - slidOut[quantity];
  }
};

/// Quantities that move: by cell of the graph, per m2.
struct MovingSnow {
  CarriedSnow carried;             ///< the first is the depth, m
  std::size_t mass = 1;            ///< which one is the mass, kg/m2
  const double* liquid = nullptr;  ///< kg/m2, one of the carried; null: dry
};

/// Slides, smoothing and drift of a scene's cover, with what they keep between steps. What a step does
/// depends on the scene at its time and on the snow only, so nothing of it need be saved.
class SnowMotion {
 public:
  /// For a run's ground and where its models stand; call again when one moved. The graph is made when snow
  /// next moves or it is asked for.
  void place(SnowGroundPointer ground, std::shared_ptr<const SnowScene> scene);
  bool placed() const { return m_ground != nullptr; }
  const CoverGraph& graph();

  /// Moves the snow for a time in s. The wind over the land is computed when it first matters, and its
  /// shelter again when it turned by a degree; both once for a scene's wind and models' places.
  MotionTotals step(const SceneSnapshot& snapshot, const MotionSettings& settings, double seconds,
                    const MovingSnow& snow, CpuBackend& backend);

 private:
  void slide(const MotionSettings& settings, const MovingSnow& snow, CpuBackend& backend,
             MotionTotals& totals);
  void blow(const SceneSnapshot& snapshot, const MotionSettings& settings, double seconds,
            const MovingSnow& snow, CpuBackend& backend, MotionTotals& totals);
  bool turnTo(const SceneSnapshot& snapshot, const MotionSettings& settings, CpuBackend& backend);

  SnowGroundPointer m_ground;
  std::shared_ptr<const SnowScene> m_standing;  ///< that there is no graph of yet
  std::shared_ptr<const CoverGraph> m_graph;
  std::optional<SnowSlides> m_slides;
  std::optional<SnowDrift> m_drift;
  std::vector<StandingModel> m_models;
  std::optional<WindObstacles> m_obstacles;
  std::optional<WindField> m_field;
  GroundWind m_wind;                 ///< of 1 m/s
  std::optional<int> m_windDegrees;  ///< that it blows to
};

using SnowMotionPointer = std::shared_ptr<SnowMotion>;

}  // namespace spin
