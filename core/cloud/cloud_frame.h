// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cloud/cloud_scene.h"
#include "core/cloud/cloud_state.h"
#include "core/flow/flow_coupling.h"

namespace spin {

/// What a frame is told of the cloud.
struct CloudReport {
  const AirSolver& air;
  const CloudScene& scene;
  const AirNode& settings;
  const CloudState& state;
  const FlowCoupling& coupling;
  const SnowFallout* cover = nullptr;
  const std::vector<AirStep>& steps;  ///< of the latest frame
};

/// Puts the parts "air" and "spray", terms of the mass budget and figures into the frame.
void publishCloud(const CloudReport& report, Frame& frame);
/// Bytes in a frame of a cell of the air and of a parcel of spray.
inline constexpr double kAirFrameBytes = 16.0, kSprayFrameBytes = 48.0;

}  // namespace spin
