// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/property_table.h"

namespace spin {

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
};
extern const NodeType kRenderType;

/// How the scene is simulated.
struct SimulationNode : NodeData {
  double frameRate = 24.0;  ///< 1/s of film
  double timeScale = 1.0;   ///< seconds of weather per second of film
  int firstFrame = 0;       ///< shown and exported range, inclusive
  int lastFrame = 119;
  std::int64_t seed = 1;
  int exposureRays = 64;          ///< rays per cover cell
  double newSnowDensity = 0.0;    ///< kg/m3; 0 = by air temperature (67.9 + 51.3 exp(T/2.59 degC))
  double holdsBelowDegrees = 30;  ///< slopes flatter than this keep all snow
  double shedsAboveDegrees = 60;  ///< slopes steeper than this keep none
  double exposureNoise = 0.1;     ///< amplitude of the unevenness of the cover
  int checkpointInterval = 24;    ///< frames
};
extern const NodeType kSimulationType;

}  // namespace spin
