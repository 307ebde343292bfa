// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/result.h"
#include "core/fields/signed_distance.h"
#include "core/rigid/mass_properties.h"

namespace spin {

/// A form that bodies share, in body axes from the centre of mass on.
struct RigidShape {
  TriangleMesh mesh;                            ///< m
  MassProperties mass;                          ///< of density 1; its centre is where the mesh was
  SymmetricMatrix inverseInertia;               ///< of density 1
  std::shared_ptr<const SignedDistance> field;  ///< for contacts
  std::vector<Vec3d> points;                    ///< on the surface, corners among them, for contacts
  double radius = 0.0;                          ///< of the sphere about the centre, m
};

/// From a mesh in metres. Fails where the mesh cannot be used, and when cancelled.
Result<std::shared_ptr<const RigidShape>> makeRigidShape(const TriangleMesh& mesh,
                                                         const CancelToken& cancel = {});

}  // namespace spin
