// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

/// Limits on what a foreign file may bring, for readers and for the checks on their answers.
namespace spin {

inline constexpr int kMaxRasterEdge = 20000;              ///< cells
inline constexpr double kMaxHeight = 20000.0;             ///< m above or below zero
inline constexpr double kMinCellSize = 1e-3;              ///< m
inline constexpr double kMaxCellSize = 1e5;               ///< m
inline constexpr double kMaxWorldCoordinate = 1e8;        ///< m
inline constexpr std::size_t kMaxTriangles = 20'000'000;  ///< with instances
inline constexpr std::size_t kMaxInstances = 100'000;     ///< of one model
inline constexpr double kMaxModelSize = 1e5;              ///< m from the model's origin
inline constexpr int kMaxTextureEdge = 8192;              ///< texels; readers shrink larger pictures

}  // namespace spin
