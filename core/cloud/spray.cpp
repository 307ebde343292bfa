// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/spray.h"

#include <algorithm>

namespace spin {
namespace {

bool within(const Box3d& box, Vec3d p) {
  return p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z && p.x < box.max.x && p.y < box.max.y &&
         p.z < box.max.z;
}

}  // namespace

SprayEnd flyOn(SprayParcel& parcel, double seconds, double film, const SprayWorld& world, Vec3d& end) {
  const Vec3d from = parcel.position, way = parcel.velocity * seconds;
  const double all = length(way);
  const bool mayRejoin = world.flow && film - parcel.born > kSprayGrace;
  double gone = 0.0;
  for (;;) {
    const Vec3d p = all > 0.0 ? from + way * (gone / all) : from;
    end = p;
    const double free = world.solids.distance(p);
    // Where the box ends at the ground what falls through it has landed.
    if (!within(world.box, p))
      return free <= 0.0 && p.z < world.box.min.z ? SprayEnd::Landed : SprayEnd::Left;
    if (free <= 0.0) return SprayEnd::Landed;
    parcel.position = p;
    if (mayRejoin && world.flow->count(p) >= world.dense) return SprayEnd::Rejoins;
    if (gone >= all) return SprayEnd::Flies;
    gone = std::min(gone + std::clamp(free, 0.1 * world.spacing, world.spacing), all);
  }
}

}  // namespace spin
