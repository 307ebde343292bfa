// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sim/process.h"

namespace spin {

/// Avalanches and water: the particle solver of core/sph with the scene's releases, sources, sinks and
/// ground. It runs in film time: a film second is a second of flow, whatever the weather's time scale.
/// Places, materials and the domain are those at film time 0; wind, sinks, flows and velocities follow their
/// keys, frame by frame.
ProcessType flowProcessType();

}  // namespace spin
