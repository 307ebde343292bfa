// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/snow/snow_scene.h"
#include "core/snow/snow_weather.h"

namespace spin {

struct Sphere {
  Vec3d centre{};
  double radius = 0.0;
};

/// Where the sky may have changed since the cells of a cover were last asked: everywhere, or only within the
/// cones of fall that meet a model that moved, where it stood and where it stands.
class SkyChange {
 public:
  static SkyChange everywhere() { return {}; }
  /// From one standing of the same models to another, with the same directions of fall.
  SkyChange(const FallCone& cone, const std::vector<StandingModel>& before,
            const std::vector<StandingModel>& after);

  bool isEverywhere() const { return m_everywhere; }
  /// Whether a model moved: all of its own cells have another sky then.
  bool moved(std::size_t model) const { return m_everywhere || m_models[model]; }
  /// False only if no point of a box (local m), nor of its surroundings within a margin, sees a change.
  bool reaches(const Box3d& box, double margin) const;

 private:
  SkyChange() = default;

  bool m_everywhere = true;
  Vec3d m_towardsSky{0, 0, 1};
  double m_halfAngle = 0.0;
  std::vector<bool> m_models;
  std::vector<Sphere> m_spheres;
};

}  // namespace spin
