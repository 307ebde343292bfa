// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cloud/cloud_scene.h"
#include "core/flow/flow_estimate.h"

namespace spin {

/// Cells that the cloud of a scene will fill, about: of a small box nearly all, of a large one those over a
/// part of the ground.
double filledCells(const CloudScene& cloud);
/// The solver's fields and work arrays, bytes a cell (bench air-speed).
inline constexpr double kCloudWorkBytes = 580.0;

/// A fatal issue where the cloud takes more than `available` bytes. `node` is that of the air.
std::optional<FlowIssue> memoryIssue(const CloudScene& cloud, const std::string& node,
                                     double available = physicalMemory());
/// All issues of the air of a scene: why it cannot start, and that of memory.
std::vector<FlowIssue> findCloudIssues(const SceneSnapshot& scene);

}  // namespace spin
