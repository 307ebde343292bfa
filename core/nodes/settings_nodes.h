// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/property/property_table.h"

namespace spin {

/// What the colours of flowing particles tell; Material draws them as what they are.
enum class FlowDisplay : std::uint8_t {
  Material,
  Speed,
  Density,
  Pressure,
  Acceleration,
  ShearRate,
  Viscosity,
  ParticleClass,
  Age,
  Neighbours
};
/// Ids and labels, by number.
extern const std::array<Choice, 10> kFlowDisplayChoices;

/// Labels of particle classes, by number of the attribute "class".
extern const std::array<const char*, 3> kFlowClassLabels;

/// What the colours of the snow cover tell; Natural draws it as snow.
enum class SnowDisplay : std::uint8_t { Natural, Depth, Swe, Density, Temperature, LiquidWater, Exposure };
/// Ids and labels, by number.
extern const std::array<Choice, 7> kSnowDisplayChoices;

/// What the colours of mist and powder in the air tell; Natural draws them as they look.
enum class AirDisplay : std::uint8_t { Natural, Density, Velocity, Temperature, Divergence };
/// Ids and labels, by number.
extern const std::array<Choice, 5> kAirDisplayChoices;

/// Where values of the air are shown: in all of it, or on a plane across an axis of the scene.
enum class AirSlice : std::uint8_t { Off, AcrossX, AcrossY, AcrossZ };
extern const std::array<Choice, 4> kAirSliceChoices;

/// How snow that lies is lit.
enum class SnowShading : std::uint8_t {
  Physical,   ///< light that enters comes out again beside it; thin snow sinks between stems and stones
  BlinnPhong  ///< as published: I_a K_a + I_d K_d (L.N) + K_s (N.H)^n, mixed with what lies below by exposure
};

/// How pictures are made.
struct RenderNode : NodeData {
  int width = 1280;
  int height = 720;
  int samples = 4;             ///< multisampling
  double exposure = 0.0;       ///< stops
  double snowfallHaze = 0.12;  ///< share of the falling snow's real extinction that veils the distance
  bool showFlakes = true;
  bool showCaption = true;  ///< caption and credit line on pictures
  std::string caption;
  FlowDisplay flowDisplay = FlowDisplay::Material;
  bool flowRangeAuto = true;      ///< of the colours: what the frame's particles have
  double flowRangeLow = 0.0;      ///< SI unit of what is shown
  double flowRangeHigh = 30.0;    ///< SI unit of what is shown
  bool flowLogarithmic = false;   ///< colours by the logarithm; for values above 0
  bool flowLegend = true;         ///< printed where colours of flow, snow or air stand for values
  bool showFlowBoundary = false;  ///< particles of bodies' surfaces
  SnowDisplay snowDisplay = SnowDisplay::Natural;
  bool snowRangeAuto = true;   ///< of the colours: what the frame's cover has
  double snowRangeLow = 0.0;   ///< in the unit of the legend: m, kg/m2, kg/m3, degC, 1
  double snowRangeHigh = 2.0;  ///< in the unit of the legend
  AirDisplay airDisplay = AirDisplay::Natural;
  AirSlice airSlice = AirSlice::Off;
  double airSlicePosition = 0.0;  ///< local m along the slice's axis
  bool airRangeAuto = true;       ///< of the colours: what the frame's air has
  double airRangeLow = 0.0;       ///< SI unit of what is shown
  double airRangeHigh = 1.0;      ///< SI unit of what is shown
  SnowShading snowShading = SnowShading::Physical;
  double snowAmbient = 0.9;     ///< K_a of the published shading
  double snowDiffuse = 0.85;    ///< K_d
  double snowSpecular = 0.15;   ///< K_s
  double snowShininess = 24.0;  ///< n
};
extern const NodeType kRenderType;

/// How shelter is found.
enum class ExposureMethod : std::uint8_t { Rays, Maps };

/// How the scene is simulated.
struct SimulationNode : NodeData {
  double frameRate = 24.0;  ///< 1/s of film
  double timeScale = 1.0;   ///< seconds of weather per second of film
  int firstFrame = 0;       ///< shown and exported range, inclusive
  int lastFrame = 119;
  std::int64_t seed = 1;
  int exposureRays = 64;  ///< rays or map lookups per cover cell
  ExposureMethod exposureMethod = ExposureMethod::Rays;
  int exposureDirections = 16;    ///< occlusion maps
  int exposureMapSize = 1024;     ///< texels along a map at most
  double newSnowDensity = 0.0;    ///< kg/m3; 0 = by air temperature (67.9 + 51.3 exp(T/2.59 degC))
  double holdsBelowDegrees = 30;  ///< slopes flatter than this keep all snow
  double shedsAboveDegrees = 60;  ///< slopes steeper than this keep none
  double exposureNoise = 0.1;     ///< amplitude of the unevenness of the cover
  bool snowSlides = true;         ///< snow steeper than its angle of repose moves down
  double reposeDryDegrees = 38;   ///< angle of repose of dry snow
  double reposeWetDegrees = 20;   ///< of slush
  double smoothingWidth = 0.1;    ///< m: hollows of this width fill in a day
  bool snowDrifts = true;         ///< the wind carries snow along the ground
  double driftThresholdWind = 0;  ///< m/s, 10 m up; 0 = by air temperature and the snow
  double driftInflow = 1.0;       ///< share of what the wind can carry that blows in over the border
  int checkpointInterval = 24;    ///< frames
  bool pauseSnow = false;         ///< snowfall and cover stand still
  bool pauseFlow = false;         ///< avalanches, water and bodies stand still
  bool pauseAir = false;          ///< mist, powder and spray stand still
};
extern const NodeType kSimulationType;

}  // namespace spin
