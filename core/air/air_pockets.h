// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/air/brick_solids.h"

namespace spin {

/// Parts of the air that are cut off from all that is not computed: their pressure is known up to a constant
/// only, and what flows into them has nowhere to go. Indices of the window's cells, part by part.
using AirPockets = std::vector<std::vector<std::uint32_t>>;

/// `solids`: one for each of window.nearKeys().
AirPockets findPockets(const AirWindow& window, const std::vector<BrickSolids>& solids);

}  // namespace spin
