// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"
#include "core/flow/flow_domain.h"
#include "core/flow/flow_materials.h"
#include "core/flow/flow_walls.h"
#include "core/flow/inflow.h"
#include "core/flow/scene_bodies.h"
#include "core/nodes/weather_nodes.h"

namespace spin {
namespace {

/// Largest compression by the weight of the flow is 1 / kStiffness^2 of what it is deep.
constexpr double kStiffness = 10.0;
/// How much faster than a fluid sound must be at least; snow, which compresses, may be as fast as sound.
constexpr double kFluidMach = 2.0;

/// Collects releases and sources and the materials that they use.
class SceneBuilder {
 public:
  SceneBuilder(const SceneSnapshot& scene, FlowScene& out)
      : m_scene(scene),
        m_out(out),
        m_ground(scene.terrain && !scene.terrain->heights.empty() ? &scene.terrain->heights : nullptr),
        m_settings(scene.settings<FlowSettingsNode>(0.0)) {}

  void run() {
    m_out.config.materials.clear();
    m_out.config.spacing = m_settings.spacing;
    m_out.config.supportSpacings = m_settings.accuracy == FlowAccuracy::Accurate ? 3.0 : 2.0;
    for (const SceneNode* node : m_scene.all<AvalancheReleaseNode>()) addRelease(*node);
    for (const SceneNode* node : m_scene.all<WaterSourceNode>()) addSource(*node);
    if (m_out.config.materials.empty()) m_out.config.materials.resize(1);
    const FlowDomain domain = findDomain(m_scene, m_settings, m_starts, slides());
    m_out.config.domainMin = domain.box.min;
    m_out.config.domainMax = domain.box.max;
    if (!domain.problem.empty()) note(domain.node, domain.problem, true);
    m_out.fastest = std::min(domain.fastest, voellmySpeed());
    setStiffness();
    setFlowWalls(m_scene, m_settings, m_out);
  }

 private:
  void note(const std::string& node, std::string text, bool fatal) {
    m_out.issues.push_back({node, std::move(text), fatal});
  }

  /// Snow loses energy along its way; water is let run.
  bool slides() const {
    return std::all_of(m_out.config.materials.begin(), m_out.config.materials.end(),
                       [](const FlowMaterialConfig& m) { return m.rheology.frictionTangent > 0.0f; });
  }

  /// By Voellmy's law flow of depth d on a slope goes no faster than sqrt(xi d (sin - mu cos)) < sqrt(xi d).
  double voellmySpeed() const {
    if (m_settings.grip != GroundGrip::Coulomb || !(m_settings.turbulence > 0.0)) return 1e300;
    return std::sqrt(m_settings.turbulence * std::max(m_deepest, m_settings.spacing));
  }

  std::uint8_t materialIndex(const SceneNode& node, FlowMaterialKind kind, const std::string& customId,
                             double density) {
    FlowMaterialConfig material;
    if (kind != FlowMaterialKind::Custom) {
      material = flowMaterialPreset(kind).material;
    } else {
      const FlowMaterialNode* custom = customMaterial(node, customId);
      if (custom) material = customFlowMaterial(*custom);
    }
    if (density > 0.0) material.restDensity = density;
    auto& all = m_out.config.materials;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (sameMaterial(all[k], material)) return static_cast<std::uint8_t>(k);
    if (all.size() == kMostMaterials) {
      note(node.id, fmt::format("more than {} different materials flow in this scene", kMostMaterials), true);
      return 0;
    }
    all.push_back(material);
    return static_cast<std::uint8_t>(all.size() - 1);
  }

  const FlowMaterialNode* customMaterial(const SceneNode& node, const std::string& id) {
    for (const SceneNode* other : m_scene.all<FlowMaterialNode>())
      if (other->id == id) return other->as<FlowMaterialNode>();
    note(node.id,
         fmt::format("custom_material is \"{}\", which is no enabled flow_material node of this scene", id),
         true);
    return nullptr;
  }

  static bool sameMaterial(const FlowMaterialConfig& a, const FlowMaterialConfig& b) {
    return a.restDensity == b.restDensity && a.tensileStrength == b.tensileStrength &&
           a.rheology == b.rheology;
  }

  void addRelease(const SceneNode& node) {
    FlowRelease release;
    release.node = &node;
    release.data = static_cast<const AvalancheReleaseNode&>(*evaluate(node, 0.0));
    if (const auto crossing = selfCrossing(release.data.outline))
      note(node.id,
           fmt::format("the outline crosses itself: the edge from corner {} meets that from corner {}",
                       crossing->first + 1, crossing->second + 1),
           true);
    const ReleaseArea& area = m_areas.emplace_back(node, m_ground);
    checkArea(node, area);
    checkOverlap(release, area);
    const double depth = release.data.depth * (release.data.depthIsVertical ? area.normal().z : 1.0);
    release.layers = std::max(1, static_cast<int>(std::lround(depth / m_settings.spacing)));
    if (depth < 2.5 * m_settings.spacing)
      note(node.id,
           fmt::format("the slab of {:.2f} m is {:.1f} spacings deep: {} layer{} of particles show{} a bulk "
                       "that slides, but no profile within it (4 or more do)",
                       depth, depth / m_settings.spacing, release.layers, release.layers == 1 ? "" : "s",
                       release.layers == 1 ? "s" : ""),
           false);
    release.material =
        materialIndex(node, release.data.material, release.data.customMaterial, release.data.density);
    release.particles =
        slabParticles(area, release.data.depth, release.data.depthIsVertical, m_settings.spacing);
    m_deepest = std::max(m_deepest, depth);
    for (const Vec3d& p : area.samples()) m_starts.push_back({{p.x, p.y, p.z + depth}, 0.0, node.id});
    m_out.releases.push_back(std::move(release));
  }

  void checkArea(const SceneNode& node, const ReleaseArea& area) {
    if (area.samples().empty())
      note(node.id,
           m_ground.heights() ? "no part of the release area lies on the terrain"
                              : "the release has no area: its outline has fewer than three corners",
           true);
    else if (area.shareWithoutGround() > 0.0)
      note(node.id,
           fmt::format("{:.0f} % of the area within the outline lies outside the terrain or over holes of it "
                       "and is left out",
                       100.0 * area.shareWithoutGround()),
           false);
  }

  /// Round the area in plan.
  static Box3d boxOf(const ReleaseArea& area) {
    Box3d box;
    const double half = area.sampleSize();
    for (const Vec3d& p : area.samples())
      box.extend(p - Vec3d{half, half, 0}), box.extend(p + Vec3d{half, half, 0});
    return box;
  }

  /// Two slabs in one place are pressed apart at once, which looks like an explosion.
  void checkOverlap(const FlowRelease& release, const ReleaseArea& area) {
    const double all = std::max(static_cast<double>(area.samples().size()), 1.0);
    const Box3d own = boxOf(area);
    for (std::size_t k = 0; k < m_out.releases.size(); ++k) {
      const FlowRelease& other = m_out.releases[k];
      if (other.data.releaseTime != release.data.releaseTime) continue;
      const Box3d its = boxOf(m_areas[k]);
      if (own.empty() || its.empty() || own.max.x < its.min.x || its.max.x < own.min.x ||
          own.max.y < its.min.y || its.max.y < own.min.y)
        continue;
      const auto both = std::count_if(area.samples().begin(), area.samples().end(),
                                      [&](const Vec3d& p) { return m_areas[k].contains(p.x, p.y); });
      if (const double share = static_cast<double>(both) / all; share > 0.005)
        note(release.node->id,
             fmt::format("{:.0f} % of its area lies within that of \"{}\", which breaks loose at the same "
                         "time: there two slabs begin in one place and burst apart",
                         100.0 * share, other.node->name),
             false);
    }
  }

  void addSource(const SceneNode& node) {
    const auto source = static_cast<const WaterSourceNode&>(*evaluate(node, 0.0));
    const InflowLattice lattice = inflowLattice(m_scene, source, m_settings.spacing);
    if (!lattice.problem.empty()) note(node.id, lattice.problem, true);
    FlowInflow inflow{&node, materialIndex(node, source.material, source.customMaterial, 0.0)};
    const double speed = length(lattice.velocity);
    for (const Vec3d& p : lattice.positions) m_starts.push_back({p, speed, node.id});
    m_deepest = std::max(m_deepest, lattice.thickness);
    m_out.inflows.push_back(inflow);
  }

  /// Sound speed for all materials, and how viscous they may become.
  void setStiffness() {
    FlowConfig& c = m_out.config;
    const bool fluid = std::any_of(c.materials.begin(), c.materials.end(), [](const FlowMaterialConfig& m) {
      return m.rheology.frictionTangent == 0.0f;
    });
    double sound = m_settings.soundSpeed;
    if (sound <= 0.0)
      sound = std::max({1.0, kStiffness * std::sqrt(kStandardGravity * std::max(m_deepest, c.spacing)),
                        (fluid ? kFluidMach : 1.0) * m_out.fastest});
    for (FlowMaterialConfig& m : c.materials) {
      m.soundSpeed = sound;
      if (!m.rheology.needsShearRate()) continue;
      if (m_settings.pressure == FlowPressure::Implicit && m_settings.viscosityCap == 0.0) continue;
      // By this viscosity the step is half of what sound allows: nu = 2 (viscous factor / courant) s c.
      const double free = 2.0 * c.viscousFactor / c.courant * c.spacing * sound * m.restDensity;
      const double cap = m_settings.viscosityCap > 0.0 ? m_settings.viscosityCap : free;
      m.rheology.most = std::min(m.rheology.most, static_cast<float>(cap));
      m.rheology.least = std::min(m.rheology.least, m.rheology.most);
    }
  }

  const SceneSnapshot& m_scene;
  FlowScene& m_out;
  FlowGround m_ground;
  FlowSettingsNode m_settings;
  std::vector<FlowBeginning> m_starts;
  std::deque<ReleaseArea> m_areas;  ///< by release
  double m_deepest = 0.0;
};

}  // namespace

const FlowIssue* FlowScene::fatal() const {
  const auto found =
      std::find_if(issues.begin(), issues.end(), [](const FlowIssue& issue) { return issue.fatal; });
  return found == issues.end() ? nullptr : &*found;
}

bool sceneHasFlow(const SceneSnapshot& scene) {
  return scene.first<AvalancheReleaseNode>() || scene.first<WaterSourceNode>();
}

FlowScene makeFlowScene(const SceneSnapshot& scene, double filmTime, bool withBodies) {
  FlowScene out;
  SceneBuilder(scene, out).run();
  if (withBodies) addSceneBodies(scene, out);
  const FlowSettingsNode settings = scene.settings<FlowSettingsNode>(filmTime);
  out.config.density =
      settings.density == FlowDensity::Continuity ? DensityMode::Continuity : DensityMode::Summation;
  if (settings.pressure == FlowPressure::Implicit) {
    out.config.pressure = PressureMode::Implicit;
    out.config.density = DensityMode::Summation;
    out.config.densityError = settings.accuracy == FlowAccuracy::Accurate ? 1e-3 : 1e-2;
  }
  // Solves for the viscosity where that would bind the step.
  out.config.viscosity = ViscosityMode::Auto;
  updateFlowConfig(scene, filmTime, out.config);
  const std::vector<const SceneNode*> sinks = scene.all<FlowSinkNode>();
  if (sinks.size() > kMostSinks)
    out.issues.push_back(
        {sinks.back()->id,
         fmt::format("there are {} sinks, at most {} are possible", sinks.size(), kMostSinks), true});
  return out;
}

void updateFlowConfig(const SceneSnapshot& scene, double filmTime, FlowConfig& config) {
  const FlowSettingsNode settings = scene.settings<FlowSettingsNode>(filmTime);
  config.smoothing = settings.smoothing;
  config.windDrag = settings.windDrag;
  config.wind = {};
  if (scene.first<WeatherNode>()) {
    const WeatherNode weather = scene.settings<WeatherNode>(filmTime);
    config.wind = windVector(weather.windSpeed, weather.windFromDegrees);
  }
  config.sinks.clear();
  for (const SceneNode* node : scene.all<FlowSinkNode>()) {
    if (config.sinks.size() == kMostSinks) break;
    const auto sink = static_cast<const FlowSinkNode&>(*evaluate(*node, filmTime));
    FlowSinkConfig made;
    if (sink.shape == FlowSinkShape::Plane) {
      made.point = sink.position;
      made.normal = length(sink.normal) > 0.0 ? sink.normal : Vec3d{0, 0, 1};
    } else {
      made.low = sink.position - sink.size * 0.5;
      made.high = sink.position + sink.size * 0.5;
    }
    config.sinks.push_back(made);
  }
}

Vec3d sourcePoint(const SceneSnapshot& scene, const WaterSourceNode& source, Vec3d point) {
  if (source.onGround && scene.terrain && !scene.terrain->heights.empty())
    point.z += TerrainSurface(scene.terrain->heights).nearestHeight(point.x, point.y);
  return point;
}

}  // namespace spin
