// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sim/snapshot.h"

namespace spin {

/// The scene with a tank to be seen round flow in a closed domain: a floor below it and bars along its edges.
/// Without them water hangs in the sky. The scene itself where it has terrain or no closed domain.
SnapshotPointer withTank(const SnapshotPointer& scene);

}  // namespace spin
