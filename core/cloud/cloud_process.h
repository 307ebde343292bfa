// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sim/process.h"

namespace spin {

/// Mist of water and powder of avalanches: the grid of core/air, the flow's particles and the spray between
/// them. It acts within the flow's step, after every part of a frame (FlowCoupling), and by itself where the
/// flow is held.
ProcessType cloudProcessType();

}  // namespace spin
