// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_walls.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/flow/flow_domain.h"
#include "core/nodes/ground_nodes.h"

namespace spin {
namespace {

/// Surface of closed sides; those before it are the ground types.
constexpr std::uint8_t kSmooth = kGroundTypeCount;
static_assert(kFirstBodySurface == kSmooth + 1);

void setSurfaces(const FlowSettingsNode& s, FlowWallsConfig& walls) {
  const double frictions[kGroundTypeCount] = {s.quartz, s.sand, s.soil,    s.vegetation,
                                              s.rock,   s.ice,  s.asphalt, s.water};
  walls.surfaces.clear();
  for (const double friction : frictions) {
    WallSurface surface;
    surface.friction = s.grip == GroundGrip::NoSlip     ? WallFriction::NoSlip
                       : s.grip == GroundGrip::FreeSlip ? WallFriction::FreeSlip
                                                        : WallFriction::Coulomb;
    surface.tangent = static_cast<float>(friction);
    if (s.turbulence > 0.0) surface.turbulence = static_cast<float>(kStandardGravity / s.turbulence);
    walls.surfaces.push_back(surface);
  }
  walls.surfaces.push_back({WallFriction::FreeSlip});
}

/// Ground type of every cell of the terrain, as a function of column and row.
class GroundTypes {
 public:
  GroundTypes(const SceneSnapshot& scene, const Raster<float>& heights) {
    const SceneNode* node = scene.first<GroundTypeLayerNode>();
    m_base = static_cast<std::uint8_t>(scene.settings<GroundTypeLayerNode>(0.0).base);
    m_painted = node ? std::get_if<TiledRaster<std::uint8_t>>(&node->painted) : nullptr;
    if (m_painted && (m_painted->width() != heights.width || m_painted->height() != heights.height))
      m_painted = nullptr;
  }
  std::uint8_t at(int i, int j) const {
    const std::uint8_t type = m_painted ? m_painted->at(i, j) : kUnpaintedGround;
    return type < kGroundTypeCount ? type : m_base;
  }
  std::uint8_t base() const { return m_base; }

 private:
  std::uint8_t m_base = 0;
  const TiledRaster<std::uint8_t>* m_painted = nullptr;
};

/// The part of the terrain that the domain covers, with a cell more on every side.
void setGround(const SceneSnapshot& scene, const Raster<float>& heights, FlowConfig& c) {
  const auto column = [&](double x) {
    return std::clamp(static_cast<int>(std::floor((x - heights.originX) / heights.cellSize)), 0,
                      heights.width - 1);
  };
  const auto row = [&](double y) {
    return std::clamp(static_cast<int>(std::floor((y - heights.originY) / heights.cellSize)), 0,
                      heights.height - 1);
  };
  const int i0 = column(c.domainMin.x - heights.cellSize), i1 = column(c.domainMax.x + 2 * heights.cellSize);
  const int j0 = row(c.domainMin.y - heights.cellSize), j1 = row(c.domainMax.y + 2 * heights.cellSize);
  c.walls.ground = Raster<float>(i1 - i0 + 1, j1 - j0 + 1, heights.x(i0), heights.y(j0), heights.cellSize);
  c.walls.groundSurfaces = c.walls.ground.sameShape<std::uint8_t>();
  const GroundTypes types(scene, heights);
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i) {
      c.walls.ground.at(i - i0, j - j0) = heights.at(i, j);
      c.walls.groundSurfaces.at(i - i0, j - j0) = types.at(i, j);
    }
}

void closeSides(const FlowSettingsNode& settings, FlowConfig& c) {
  const bool given = givesDomain(settings);
  const Vec3d low = given ? settings.domainMin : c.domainMin, high = given ? settings.domainMax : c.domainMax;
  c.walls.planes.push_back({low, {1, 0, 0}, {}, kSmooth});
  c.walls.planes.push_back({low, {0, 1, 0}, {}, kSmooth});
  c.walls.planes.push_back({high, {-1, 0, 0}, {}, kSmooth});
  c.walls.planes.push_back({high, {0, -1, 0}, {}, kSmooth});
}

}  // namespace

void setFlowWalls(const SceneSnapshot& scene, const FlowSettingsNode& settings, FlowScene& flow) {
  FlowConfig& c = flow.config;
  setSurfaces(settings, c.walls);
  c.walls.planes.clear();
  if (scene.terrain && !scene.terrain->heights.empty())
    setGround(scene, scene.terrain->heights, c);
  else
    c.walls.planes.push_back(
        {{0, 0, 0}, {0, 0, 1}, {}, static_cast<std::uint8_t>(scene.settings<GroundTypeLayerNode>(0.0).base)});
  if (settings.closed) closeSides(settings, c);
}

}  // namespace spin
