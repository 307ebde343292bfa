// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/air/air_exchange.h"

namespace spin {

/// Copies of a window's arrays in host memory.
struct HostFields {
  std::array<std::vector<float>, 3> u;
  std::array<std::vector<float>, kAirScalars> q;
  std::array<std::vector<float>, 2> pressure;
};

/// Air that is faster is none that these laws hold for, m/s; steps would be too many.
inline constexpr double kMostSpeed = 1e5;

std::vector<std::int32_t> firstCells(const AirWindow& window);
/// Bricks to go on with: those that hold something or move, and as many round them as the cloud may reach in
/// a sub-step. Round moving air only where something hangs nearby or has been brought (`touched`): else wind
/// that is not quite steady over the land would have all of it computed.
std::vector<BrickKey> bricksRound(const AirConfig& config, const AirWindow& window,
                                  const std::vector<double>& activity, const std::vector<BrickKey>& touched);
void appendDeposits(const AirConfig& config, const AirWindow& window, const std::vector<float>& mist,
                    const std::vector<float>& snow, std::vector<AirDeposit>& to);
void publishAir(const AirConfig& config, const AirWindow& window, const std::vector<BrickSolids>& solids,
                const HostFields& fields, bool divergence, AirPart& part);
/// What is wrong in the first cell whose state is none, and where: "the air is at -127 K at (3, 4.5, 2) m".
std::string firstBroken(const AirConfig& config, const AirWindow& window,
                        const std::vector<BrickSolids>& solids, const HostFields& fields);
/// Without budget and order.
AirState packState(const AirWindow& window, const std::vector<BrickSolids>& solids, const HostFields& fields);
Status checkAirState(const AirConfig& config, const AirState& state);
/// Indices and values of AirState::upper along an axis.
void listUpperFaces(const AirWindow& window, const AirState& state, std::size_t axis,
                    std::vector<std::uint32_t>& index, std::vector<float>& values);

}  // namespace spin
