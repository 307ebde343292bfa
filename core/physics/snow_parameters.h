// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What the snow column's laws are told. Defaults are published values, none fitted to a season; floats,
/// because packs are made of them.
namespace spin {

inline constexpr double kFusionHeat = 334e3;             ///< J/kg
inline constexpr double kSublimationHeat = 2.835e6;      ///< J/kg
inline constexpr double kIceHeat = 2100.0;               ///< J/(kg K)
inline constexpr double kWaterHeat = 4180.0;             ///< J/(kg K)
inline constexpr double kStefanBoltzmann = 5.670374e-8;  ///< W/(m2 K4)

inline constexpr int kSnowLayers = 3;
inline constexpr int kSoilLayers = 4;

struct SnowParameters {
  float emissivity = 0.99f;
  float roughness = 0.01f;  ///< m, of snow

  float freshAlbedo = 0.85f;
  float oldAlbedo = 0.5f;
  float coldAlbedoSeconds = 1000.0f * 3600.0f;  ///< e-folding time of ageing while cold
  float wetAlbedoSeconds = 100.0f * 3600.0f;    ///< and while melting
  float refreshingSnow = 10.0f;                 ///< kg/m2 that make the albedo that of new snow

  float coverDepth = 0.1f;  ///< m: snow hides tanh(depth / this) of the ground

  float newSnowDensity = 0.0f;  ///< kg/m3; 0 = by the air's temperature
  float settledCold = 300.0f;   ///< kg/m3 that cold snow settles to
  float settledWet = 500.0f;    ///< and wet snow
  float settlingSeconds = 200.0f * 3600.0f;

  float heldWater = 0.03f;  ///< share of the pores that liquid water is held in

  float topLayers[kSnowLayers - 1] = {0.1f, 0.2f};  ///< m, thickness of the upper layers of deep snow
  float windlessExchange = 1.0f;                    ///< W/(m2 K) of heat that still air exchanges
  float leastWind = 0.1f;                           ///< m/s: below it still air exchanges as much

  float windHeight = 10.0f;    ///< m
  float airHeight = 2.0f;      ///< m
  bool windAboveSnow = false;  ///< heights count from the snow's surface, else from the ground
  bool airAboveSnow = false;
};

/// Ground below the snow, one material; layers from the top.
struct GroundMaterial {
  float conductivity = 0.6276f;  ///< W/(m K)
  float heatCapacity = 2.2e6f;   ///< J/(m3 K), moist
  float frozenWater = 200.0f;    ///< kg/m3 of water that freezes, over kFreezingRange
  float albedo = 0.2f;
  float roughness = 0.1f;        ///< m
  float evaporation = 0.005f;    ///< m/s, surface conductance of bare ground for vapour; 0 = dry
  float deepConductance = 0.0f;  ///< W/(m2 K) to the ground temperature below the last layer; 0 = none
  float thickness[kSoilLayers] = {0.1f, 0.3f, 0.8f, 2.0f};  ///< m
};

/// Soil water freezes between 0 and this below it, K.
inline constexpr double kFreezingRange = 0.5;

}  // namespace spin
