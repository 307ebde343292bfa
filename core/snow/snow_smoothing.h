// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/parallel.h"
#include "core/snow/snow_slides.h"

namespace spin {

struct SmoothingSettings {
  double spread = 0.0;     ///< m2: rate times time; hollows narrower than its root fill
  double fullDepth = 0.1;  ///< m: thinner snow takes part in proportion
  int mostSteps = 32;      ///< of the explicit scheme; what they cannot reach is not smoothed
};

/// Evens the snow's surface out by its curvature: snow flows down the surface's slope at a rate, from snow to
/// snow only, as far as both cells have some: ds/dt = rate * Laplacian(s). A cell gives at most half of its
/// snow a step. Snow does not cross rims of models. Amounts are kept to rounding, with any number of threads
/// the same bits. Returns the spread that was done, m2: the asked one unless mostSteps was too few.
double smoothSnow(const CoverGraph& graph, const CarriedSnow& snow, const SmoothingSettings& settings,
                  CpuBackend& backend);

}  // namespace spin
