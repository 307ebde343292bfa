// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/fields/raster.h"
#include "core/nodes/ground_nodes.h"
#include "core/sim/process.h"

namespace spin {

/// The painted layers of a scene's ground on one grid, values in the order of the grid's cells. A layer that
/// the scene lacks, or whose size is not the terrain's, counts as unpainted. Does not depend on time: when a
/// mask works is told by clearedShares().
struct GroundLayers {
  /// A keep-clear node with its painted shares, 0..1.
  struct Mask {
    std::string node;
    std::vector<float> share;
  };

  std::vector<GroundType> type;    ///< the node's base type where nothing is painted
  std::vector<float> temperature;  ///< K; NaN where nothing is painted
  std::vector<float> startDepth;   ///< m of snow when the film begins; NaN where nothing is painted
  double startDensity = 250.0;     ///< kg/m3, of that snow
  bool startAdds = false;          ///< it lies on the snowfall's old snow; otherwise it replaces it
  std::vector<Mask> keepClear;     ///< enabled nodes that have something painted, in scene order
};

/// Samples the layers at the centres of a grid's cells, whose plan is the terrain's (local metres). Types are
/// those of the nearest point of the terrain; depths, shares and temperatures are interpolated between the
/// painted ones of the four points round the place, and unpainted where the nearest one is. Beyond the rim
/// and without terrain nothing is painted. One pass over the cells.
GroundLayers groundLayersOn(const SceneSnapshot& scene, const Raster<float>& grid);

/// Share 0..1 of what falls at a film time that is taken away, by cell: several masks leave the product of
/// what each leaves. Empty where no mask works at that time.
std::vector<float> clearedShares(const SceneSnapshot& scene, const GroundLayers& layers, double filmTime);

/// Adds types, temperatures and start depths, which rule from the beginning.
void hashGroundLayers(const StepInput& input, Hasher& hasher);
/// Adds what is kept clear at the beginning, middle and end of the step.
void hashKeepClear(const StepInput& input, Hasher& hasher);

}  // namespace spin
