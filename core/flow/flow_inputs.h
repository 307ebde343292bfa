// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sim/process.h"

namespace spin {

/// Adds all that flow depends on: its nodes, the weather, the terrain with its ground types, and bodies with
/// their models.
void hashFlowInputs(const StepInput& input, Hasher& hasher);

}  // namespace spin
