// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What rises in the case `bubble`, in the middle of a closed box of 1 m: the mean acceleration of the faces
/// that touch it as a share of its own buoyancy g', where a face takes the mean of the two cells' buoyancy.
/// The lattice's equations solved by cosine transforms; without walls and cells a sphere has 2/3 and a
/// cylinder 1/2 (added mass), a layer 0.
namespace spin {

inline constexpr double kBubbleRadius = 0.1;      // m
inline constexpr double kSphereShare = 0.6149;    // 64^3 cells
inline constexpr double kCylinderShare = 0.4672;  // 128^2 cells

}  // namespace spin
