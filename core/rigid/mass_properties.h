// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/fields/mesh_shells.h"
#include "core/rigid/rigid_state.h"

namespace spin {

/// What mass and inertia were taken from.
enum class MassSource : std::uint8_t {
  Mesh,  ///< the volume within the mesh, which is closed
  Box,   ///< the box round a mesh that is not, each edge at least a twentieth of the longest
};

/// Of a body of density 1.
struct MassProperties {
  double volume = 0.0;      ///< m3, > 0
  Vec3d centre{};           ///< of mass, m
  SymmetricMatrix inertia;  ///< about the centre, mesh axes, m5
  MassSource source = MassSource::Mesh;
};

/// Volume integrals over the tetrahedra from the origin to each triangle (Tonon 2004). Overlapping shells
/// count twice.
MassProperties massProperties(const MeshShells& mesh);

}  // namespace spin
