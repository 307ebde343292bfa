// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/fields/triangle_mesh.h"

namespace spin {

/// Points spread evenly over a surface: no two nearer than `distance`, and hardly a place farther than that
/// from one (dart throwing, Cook 1986, with candidates laid over each triangle by the golden ratio's
/// sequence, Roberts 2018). Corners of the mesh come first. The same for the same mesh. `place` moves a
/// candidate (corner of the mesh or not, normal of its triangle) or turns it down.
std::vector<Vec3d> surfaceSamples(
    const TriangleMesh& mesh, double distance,
    const std::function<std::optional<Vec3d>(Vec3d candidate, Vec3d normal)>& place);

}  // namespace spin
