// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/rigid/rigid_shape.h"

namespace spin {

/// The boundary particles of a body, in body axes from its centre of mass on.
struct BodyBoundary {
  std::vector<Vec3d> positions;  ///< m
  std::vector<float> volumes;    ///< in rest volumes of a flow particle
};

/// Places particles half a spacing below the surface (in the middle where the body is thinner, on it where it
/// is a sheet), about one to a square of the spacing. Each stands for the volume 1 / sum W over the body's
/// own (Akinci et al. 2012), times one factor that gives a flow particle half a spacing off a plane face the
/// density that the solid behind it gives as a wall (solidShare()). At least one particle.
BodyBoundary sampleBody(const RigidShape& shape, double spacing, double support);

}  // namespace spin
