// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_domain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"
#include "core/flow/flow_reach.h"
#include "core/sph/flow_view.h"

namespace spin {
namespace {

/// Room below the ground and beyond closed sides, supports: what is pressed into a wall is not lost.
constexpr double kBelow = 2.0;

double leastFriction(const FlowSettingsNode& s) {
  if (s.grip != GroundGrip::Coulomb) return 0.0;
  return std::min({s.quartz, s.sand, s.soil, s.vegetation, s.rock, s.ice, s.asphalt, s.water});
}

std::vector<FlowStart> energiesOf(const std::vector<FlowBeginning>& starts) {
  std::vector<FlowStart> list;
  for (const FlowBeginning& s : starts)
    list.push_back({s.top.x, s.top.y, s.top.z + 0.5 * s.speed * s.speed / kStandardGravity});
  return list;
}

/// Round what flow can reach; half of the friction is taken, so that the box is rather too large.
FlowDomain reachedDomain(const SceneSnapshot& scene, const FlowSettingsNode& settings,
                         const std::vector<FlowBeginning>& starts, bool slides) {
  FlowDomain domain;
  double drop = 0.0;
  for (const FlowBeginning& s : starts) {
    domain.box.extend(s.top);
    drop = std::max(drop, 0.5 * s.speed * s.speed / kStandardGravity);
  }
  if (scene.terrain && !scene.terrain->heights.empty()) {
    const double loss = slides ? 0.5 * leastFriction(settings) : 0.0;
    const FlowReach reach = findReach(scene.terrain->heights, energiesOf(starts), loss);
    domain.box.extend(reach.box);
    drop = std::max(drop, findReach(scene.terrain->heights, energiesOf(starts), 2.0 * loss).speedHead);
  } else {
    domain.box.extend(Vec3d{domain.box.min.x, domain.box.min.y, 0.0});
    drop = std::max(drop, domain.box.size().z);
  }
  domain.fastest = std::sqrt(2.0 * kStandardGravity * drop);
  const double below = kBelow * supportOf(settings);
  domain.box.min = domain.box.min - Vec3d{settings.margin, settings.margin, below};
  domain.box.max = domain.box.max + Vec3d{settings.margin, settings.margin, settings.headroom};
  return domain;
}

/// Only as much below the given floor as flow on it needs.
FlowDomain givenDomain(const SceneSnapshot& scene, const FlowSettingsNode& settings,
                       const std::vector<FlowBeginning>& starts) {
  FlowDomain domain;
  const double below = kBelow * supportOf(settings), beside = settings.closed ? below : 0.0;
  domain.box.min = settings.domainMin - Vec3d{beside, beside, below};
  domain.box.max = settings.domainMax + Vec3d{beside, beside, 0.0};
  double low = settings.domainMin.z, high = low;
  if (scene.terrain) low = std::max(low, valueRange(scene.terrain->heights).x);
  for (const FlowBeginning& s : starts)
    high = std::max(high, s.top.z + 0.5 * s.speed * s.speed / kStandardGravity);
  domain.fastest = std::sqrt(2.0 * kStandardGravity * std::max(high - low, 0.0));
  for (const FlowBeginning& s : starts)
    for (int axis = 0; axis < 3; ++axis)
      if (s.top[axis] < settings.domainMin[axis] || s.top[axis] > settings.domainMax[axis]) {
        domain.node = s.node;
        domain.problem = "flow begins outside the domain that the flow settings give";
      }
  return domain;
}

}  // namespace

double supportOf(const FlowSettingsNode& settings) {
  return settings.spacing * (settings.accuracy == FlowAccuracy::Accurate ? 3.0 : 2.0);
}

bool givesDomain(const FlowSettingsNode& settings) {
  return settings.domainMin.x < settings.domainMax.x && settings.domainMin.y < settings.domainMax.y &&
         settings.domainMin.z < settings.domainMax.z;
}

FlowDomain findDomain(const SceneSnapshot& scene, const FlowSettingsNode& settings,
                      const std::vector<FlowBeginning>& starts, bool slides) {
  FlowDomain domain;
  const SceneNode* node = scene.first<FlowSettingsNode>();
  if (starts.empty()) return domain.box = {{0, 0, 0}, {1, 1, 1}}, domain;
  domain = givesDomain(settings) ? givenDomain(scene, settings, starts)
                                 : reachedDomain(scene, settings, starts, slides);
  if (domain.node.empty()) domain.node = node ? node->id : starts.front().node;
  const Vec3d size = domain.box.size();
  const double cells = std::max({size.x, size.y, size.z}) / supportOf(settings);
  if (domain.problem.empty() && cells > kMaxCells)
    domain.problem = fmt::format(
        "the domain of {:.0f} x {:.0f} x {:.0f} m is {:.0f} support radii of {} m long, at most {} fit: make "
        "spacing_m {:.3g} or more, or give a smaller domain_min_m and domain_max_m",
        size.x, size.y, size.z, cells, supportOf(settings), kMaxCells, settings.spacing * cells / kMaxCells);
  return domain;
}

}  // namespace spin
