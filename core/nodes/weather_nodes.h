// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/property_table.h"

namespace spin {

/// What falls.
enum class PrecipitationPhase : std::uint8_t { Snow, ByTemperature };

/// The sun that warms snow. A picture's light is moved for its looks, so it melts nothing unless told to.
enum class MeltingSun : std::uint8_t { None, Pictured, ByDate };

/// Weather over the whole scene.
struct WeatherNode : NodeData {
  double airTemperature = 268.15;           ///< K
  double windSpeed = 2.0;                   ///< m/s
  double windFromDegrees = 270.0;           ///< where the wind comes from: 0 north, 90 east
  double precipitationRate = 5.0 / 3600.0;  ///< kg/(m2 s) on level ground
  PrecipitationPhase phase = PrecipitationPhase::Snow;
  double sunAzimuthDegrees = 160.0;  ///< from north through east
  double sunElevationDegrees = 28.0;
  double cloudCover = 0.4;        ///< 0 clear .. 1 overcast
  double relativeHumidity = 0.8;  ///< over water, share
  std::string source;             ///< a station's record instead of the values above; empty = none
  std::string start;              ///< UTC of film time 0, "2005-10-01 00:00"; empty = that of the record
  MeltingSun sun = MeltingSun::None;
  bool lightByDate = false;            ///< pictures do
  double latitudeDegrees = 47.2;       ///< north positive
  double longitudeDegrees = 11.3;      ///< east positive
  bool altitudeKnown = false;          ///< else the weather is that of the terrain's lowest point
  double altitude = 0.0;               ///< m above sea at which it was measured
  double lapseRate = 0.0;              ///< K/m by which the air cools upwards
  double precipitationGradient = 0.0;  ///< 1/m, growth upwards as a share
};
extern const NodeType kWeatherType;

/// Wind vector from speed and the direction it comes from, m/s (x east, y north).
Vec3d windVector(double speed, double fromDegrees);
/// Unit vector towards the sun.
Vec3d sunDirection(double azimuthDegrees, double elevationDegrees);

/// Types of falling snow with measured fall speeds (Locatelli and Hobbs 1974).
enum class FlakeType : std::uint8_t { UnrimedDendriteAggregate, RimedDendriteAggregate, HexagonalGraupel };

/// How flakes find their way down.
enum class FlakePath : std::uint8_t {
  DragAndFlutter,  ///< drag law, with a steady swing about the path
  DecayingSine,    ///< at terminal speed, with a swing that dies away and begins anew, stronger in wind
};

/// Falling snow: turns the weather's precipitation into flakes and cover.
struct SnowfallNode : NodeData {
  FlakeType type = FlakeType::UnrimedDendriteAggregate;
  double rateFactor = 1.0;          ///< on the weather's precipitation rate
  double oldSnowDepth = 0.0;        ///< m, on open level ground at film time 0
  double oldSnowDensity = 250.0;    ///< kg/m3
  double fallSpreadDegrees = 15.0;  ///< half-angle of the cone of fall directions
  FlakePath path = FlakePath::DragAndFlutter;
  double flutterAmplitude = 0.15;  ///< m
  double flutterRate = 3.0;        ///< rad/s
  double gustIntensity = 0.2;      ///< root mean square of each component of the gusts over the mean wind
  double gustLength = 25.0;        ///< m, wavelength of the largest eddies
  double boxSize = 48.0;           ///< m, edge of the wrap-round box at the camera
  int groups = 5;                  ///< of flakes by distance
  int flakeCount = 250000;         ///< drawn flakes in the box
  double sizeLawA = 0.0;           ///< constant of the sprites' size law, m2
  double sizeLawB = 0.0;           ///< its linear term, m
};
extern const NodeType kSnowfallType;

}  // namespace spin
