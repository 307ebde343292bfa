// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/air_solver.h"

namespace spin {

/// Whether all numbers are finite and in the ranges that AirConfig gives.
Status checkAirConfig(const AirConfig& config);

}  // namespace spin
