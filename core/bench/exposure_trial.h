// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/bench/bench_case.h"
#include "core/sim/snapshot.h"

namespace spin {

/// A comparison of the cover's exposure with plain ray casting over the same cells.
struct ExposureTrial {
  SnapshotPointer snapshot;
  std::map<std::string, std::string> settings;  ///< of its rows, besides rays, reference and caster
  std::size_t points = 1000;
  int referenceRays = 65536;     ///< a point; own error at most 0.5 / sqrt(referenceRays)
  std::vector<int> rays = {64};  ///< of the cover, a row each; bars from 64 rays on
  /// Directions and sizes of occlusion maps to compare too, a row each, without bars.
  std::vector<std::pair<int, int>> maps = {{16, 1024}};
  /// Draws a like number of points from each kind of cell that the scene has, instead of evenly from all
  /// cells, and tells the error of each kind: coarse terrain near models and far from them, fine terrain,
  /// patches of models.
  bool byKind = false;
};

/// Rows with RMSE (bar 0.02), 99th percentile of the error (bar 0.08) and what the points are. The scene is
/// taken at film time 0. BadInput if no snow can lie in it.
Result<std::vector<BenchRow>> compareExposure(const ExposureTrial& trial, const BenchOptions& options);

/// Trial of the case's size: with --quick 1,000 points, 4,096 rays and the default setting only.
ExposureTrial exposureTrial(SnapshotPointer snapshot, const BenchOptions& options);

}  // namespace spin
