// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/random.h"
#include "core/flake/cluster_map.h"
#include "core/flake/flake_settings.h"

namespace spin {

/// Diffusion-limited aggregation off the lattice (Witten and Sander 1981): walkers come from far away, walk
/// until they touch the cluster, and stay. Far from it they jump as far as nothing can be touched; a walker
/// outside the launching circle is put back on it with the exact distribution of its first return, so that
/// none is lost and none is killed (Sander, Sander and Ziff 1994; Menshutin and Shchur 2006).
///
/// Lengths are particle diameters. The same settings give the same bits on every machine: walks are addressed
/// by the counter generator and use only +, *, / and square roots.
class FlakeGrower {
 public:
  /// The settings must pass checkFlakeSettings.
  explicit FlakeGrower(const FlakeSettings& settings);

  /// Lets at least `particles` more stick, fewer if the flake is grown then. Fails only with
  /// ErrorKind::Cancelled; what has grown stays and may be grown on.
  Status grow(std::size_t particles, const CancelToken& cancel);

  bool done() const;
  /// Share of what is wanted, 0..1, by radius or number.
  double progress() const;

  const FlakeSettings& settings() const { return m_settings; }
  /// Centres in the order in which they came; of a symmetric flake all images, one after the other.
  const std::vector<Vec2d>& centres() const { return m_map.centres(); }
  /// Largest distance of a centre from the nucleus.
  double reach() const { return m_reach; }
  /// Radius with the outermost particle, m.
  double radius() const { return (m_reach + 0.5) * m_settings.particleDiameter; }

 private:
  struct Landing {
    Vec2d p{}, parent{};
  };
  /// A particle's place in the sector, and whether it lies on one of the sector's walls.
  struct Place {
    Vec2d p{};
    bool onWall = false;
  };
  class Walk;

  void plantSeed();
  Landing walkOnce(Walk& walk) const;
  Vec2d returned(Vec2d p, double radius, Vec2d z) const;
  /// Where a walker that has landed stays; false where there is no room for it beside its mirror image.
  bool settle(Landing landing, Place& place) const;
  void fold(Landing& landing) const;
  Vec2d aligned(Landing landing) const;
  bool besideTwin(Vec2d parent, Vec2d inward, Place& place) const;
  bool landedOften(const Place& place);
  void addImages(const Place& place);
  void add(Vec2d p);

  FlakeSettings m_settings;
  int m_arms = 1;
  std::array<Vec2d, 8> m_turns{};  ///< unit vectors of the arms
  Vec2d m_wall{};                  ///< unit vector of the sector's other wall, half an arm's angle on
  ClusterMap m_map;
  double m_reach = 0.0;
  double m_tip = 0.0;  ///< how far the arms' axes have grown
  std::uint64_t m_walkers = 0;
  std::unordered_map<std::uint64_t, int> m_landings;  ///< by place, see landedOften()
};

}  // namespace spin
