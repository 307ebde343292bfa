// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nodes/ground_nodes.h"
#include "core/physics/snow_parameters.h"

namespace spin {

/// Thermal data of a ground type. Conductivities of quartz, sand, soil and vegetation are those of Tang and
/// Zhang (their lambda over 10, in W/(m K)); the rest are usual values of physics tables.
const GroundMaterial& groundMaterial(GroundType type);

}  // namespace spin
