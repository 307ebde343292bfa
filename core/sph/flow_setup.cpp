// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/flow_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/physics/kernels.h"
#include "core/rigid/rigid_world.h"
#include "core/sph/solid_test.h"

namespace spin {
namespace {

constexpr const char* kWhat = "The particle solver cannot start";

Error badConfig(const char* property, std::string why) {
  return badInput(kWhat, property, std::move(why));
}

double cellsAlong(const FlowConfig& c, int axis) {
  return (c.domainMax[axis] - c.domainMin[axis]) / c.support();
}

Status checkAxis(const FlowConfig& c, int axis) {
  const double cells = cellsAlong(c, axis);
  if (!(cells > 0.0)) return badConfig("domainMax", "the box is empty");
  if (cells > kMaxCells)
    return badInput(kWhat, "domainMax",
                    fmt::format("{:.0f} supports along an axis, at most {} fit", cells, kMaxCells),
                    "Make the box smaller or the spacing larger");
  if (c.periodic[axis] && (cells < 2.5 || std::abs(cells - std::round(cells)) > 1e-6))
    return badConfig("domainMax",
                     fmt::format("a periodic axis must be 3 or more whole supports long, this is {}", cells));
  return {};
}

bool inRange(double value, double low, double high) {
  return value >= low && value <= high;  // a NaN is in none
}

Status checkMaterial(const FlowMaterialConfig& m) {
  const Rheology& r = m.rheology;
  if (!inRange(m.restDensity, 1e-3, 1e5)) return badConfig("restDensity", "allowed is 0.001 to 100000 kg/m3");
  if (!inRange(m.soundSpeed, 1e-6, 1e5)) return badConfig("soundSpeed", "allowed is 0.000001 to 100000 m/s");
  if (!inRange(m.tensileStrength, 0.0, 1e9)) return badConfig("tensileStrength", "allowed is 0 to 1e9 Pa");
  for (const float value : {r.viscosity, r.cohesion, r.frictionTangent, r.regularisation, r.viscosityAtSpeed,
                            r.crossFactor, r.least, r.most})
    if (!inRange(static_cast<double>(value), 0.0, 1e12))
      return badConfig("rheology", "viscosities, stresses and factors are finite and not below 0");
  if (!inRange(static_cast<double>(r.exponent), 0.05, 5.0))
    return badConfig("rheology", "the exponent is 0.05 to 5");
  if (r.least > r.most) return badConfig("rheology", "the least viscosity is above the most");
  return {};
}

Status checkWalls(const FlowWallsConfig& walls) {
  if (walls.planes.size() > kMostPlanes)
    return badConfig("planes", fmt::format("at most {} fit", kMostPlanes));
  if (walls.surfaces.empty() || walls.surfaces.size() > kMostSurfaces)
    return badConfig("surfaces", fmt::format("1 to {} are allowed", kMostSurfaces));
  for (const WallSurface& surface : walls.surfaces)
    if (!inRange(static_cast<double>(surface.tangent), 0.0, 1e3) ||
        !inRange(static_cast<double>(surface.turbulence), 0.0, 1e6))
      return badConfig("surfaces", "friction coefficients are finite and not below 0");
  for (const auto& plane : walls.planes)
    if (!isFinite(plane.point) || !isFinite(plane.velocity) || !(length(plane.normal) > 0.0) ||
        !isFinite(plane.normal) || plane.surface >= walls.surfaces.size())
      return badConfig("planes", "a plane has no direction, no place or no surface");
  for (const auto& mesh : walls.meshes)
    if (mesh.surface >= walls.surfaces.size()) return badConfig("meshes", "a mesh has no surface");
  const Raster<std::uint8_t>& kinds = walls.groundSurfaces;
  if (!kinds.empty() && !walls.ground.hasShapeOf(kinds))
    return badConfig("groundSurfaces", "another shape than the ground");
  if (std::any_of(kinds.values.begin(), kinds.values.end(),
                  [&](std::uint8_t k) { return k >= walls.surfaces.size(); }))
    return badConfig("groundSurfaces", "a cell names a surface that is not there");
  return {};
}

Status checkBodies(const FlowConfig& c) {
  const auto world = RigidWorld::make(c.bodies, {}, c.gravity, c.bodyGroundFriction);
  if (!world) return world.error();
  for (const RigidBodyConfig& body : c.bodies)
    if (body.surface >= c.walls.surfaces.size()) return badConfig("bodies", "a body has no surface");
  return {};
}

Status checkSinks(const std::vector<FlowSinkConfig>& sinks) {
  if (sinks.size() > kMostSinks) return badConfig("sinks", fmt::format("at most {} fit", kMostSinks));
  for (const FlowSinkConfig& sink : sinks)
    if (!isFinite(sink.low) || !isFinite(sink.high) || !isFinite(sink.point) || !isFinite(sink.normal))
      return badConfig("sinks", "a sink's place or direction is not finite");
  return {};
}

void setSinks(const FlowConfig& c, SinkView& view) {
  view.count = static_cast<std::int32_t>(c.sinks.size());
  for (std::size_t k = 0; k < c.sinks.size(); ++k) {
    const FlowSinkConfig& sink = c.sinks[k];
    const double size = length(sink.normal);
    const Vec3d n = size > 0.0 ? sink.normal * (1.0 / size) : Vec3d{};
    const Vec3f low = (sink.low - c.domainMin).to<float>(), high = (sink.high - c.domainMin).to<float>();
    // Without a plane everything counts as behind it.
    const double offset = size > 0.0 ? dot(n, sink.point - c.domainMin) : 1.0;
    view.sinks[k] = {low.x,
                     low.y,
                     low.z,
                     high.x,
                     high.y,
                     high.z,
                     static_cast<float>(n.x),
                     static_cast<float>(n.y),
                     static_cast<float>(n.z),
                     static_cast<float>(offset)};
  }
}

void setWalls(const FlowConfig& c, WallView& view) {
  for (std::size_t k = 0; k < c.walls.surfaces.size(); ++k) view.surface[k] = c.walls.surfaces[k];
  view.planeCount = static_cast<std::int32_t>(c.walls.planes.size());
  for (std::size_t k = 0; k < c.walls.planes.size(); ++k) {
    const auto& plane = c.walls.planes[k];
    const Vec3d normal = normalized(plane.normal);
    const Vec3f n = normal.to<float>(), v = plane.velocity.to<float>();
    view.planes[k] = {n.x, n.y, n.z, static_cast<float>(dot(normal, plane.point - c.domainMin)),
                      v.x, v.y, v.z, plane.surface};
  }
  const Raster<float>& ground = c.walls.ground;
  view.ground.width = ground.width;
  view.ground.height = ground.height;
  view.ground.originX = static_cast<float>(ground.originX - c.domainMin.x);
  view.ground.originY = static_cast<float>(ground.originY - c.domainMin.y);
  view.ground.cell = static_cast<float>(ground.cellSize);
}

/// What the pairwise viscosity makes too much of: its sum over layers of a lattice that slide along each
/// other, as in a flow that shears, taken as planes. 1.0000 at a support of 2 spacings, 1.0096 at 3.
double latticeFactor(double supportSpacings) {
  double sum = 0.0;
  for (double layer = 1.0; layer < supportSpacings; ++layer)
    sum += layer * layer * CubicSpline::shape(layer / supportSpacings);
  return 4.0 * kPi * CubicSpline::kNorm / (supportSpacings * supportSpacings * supportSpacings) * sum;
}

FlowConstants flowConstants(const FlowConfig& c) {
  const double h = c.support(), volume = c.spacing * c.spacing * c.spacing * CubicSpline::kNorm;
  FlowConstants k;
  k.densityFactor = static_cast<float>(volume / (h * h * h));
  k.gradientFactor = static_cast<float>(volume / (h * h * h * h));
  k.viscousFactor = static_cast<float>(volume / (h * h * h * h * h) / latticeFactor(c.supportSpacings));
  // One diffusion for all materials: by the slowest sound, which is stable for the others too.
  double sound = c.materials[0].soundSpeed;
  for (const FlowMaterialConfig& m : c.materials) sound = std::min(sound, m.soundSpeed);
  k.diffusionFactor = static_cast<float>(c.diffusion * h * sound * volume / (h * h * h * h * h));
  k.aloneRate = static_cast<float>(sound / h);
  double fastest = sound;
  for (const FlowMaterialConfig& m : c.materials) fastest = std::max(fastest, m.soundSpeed);
  k.soundFactor = static_cast<float>(2.0 * fastest * fastest * volume / (h * h * h * h * h));
  const Vec3f rest = (c.gravity * (h / (sound * sound))).to<float>();
  k.restX = rest.x, k.restY = rest.y, k.restZ = rest.z;
  k.smoothFactor = static_cast<float>(c.smoothing) * k.densityFactor;
  k.support = static_cast<float>(h);
  k.spacing = static_cast<float>(c.spacing);
  k.layer = static_cast<float>(1.0 / c.supportSpacings);
  k.unitsPerMetre = static_cast<float>(kCellUnits / h);
  const Vec3f g = c.gravity.to<float>(), w = c.wind.to<float>();
  k.gravityX = g.x, k.gravityY = g.y, k.gravityZ = g.z;
  k.windX = w.x, k.windY = w.y, k.windZ = w.z;
  k.windDrag = static_cast<float>(c.windDrag);
  k.clampTension = c.clampTension;
  k.leapFrog = c.leapFrog;
  for (std::size_t m = 0; m < c.materials.size(); ++m)
    k.material[m] = {c.materials[m].rheology, static_cast<float>(c.materials[m].restDensity),
                     static_cast<float>(c.materials[m].soundSpeed), c.materials[m].tait,
                     static_cast<float>(c.materials[m].tensileStrength)};
  return k;
}

/// Position in units, NaN-safe: what is not within the domain fails.
bool toUnits(double metres, double support, std::int32_t end, bool periodic, std::int32_t& units) {
  const double exact = metres / support * kCellUnits;
  if (!(exact >= -0.5 && exact <= end + 0.5)) return false;
  units = std::clamp(static_cast<std::int32_t>(std::lround(exact)), 0, end);
  if (units == end) units = periodic ? 0 : end - 1;
  return true;
}

}  // namespace

bool needsShearRate(const FlowConfig& config) {
  // The stress form is made of the velocity gradient.
  if (config.viscosity == ViscosityMode::Stress) return true;
  return std::any_of(config.materials.begin(), config.materials.end(),
                     [](const FlowMaterialConfig& m) { return m.rheology.needsShearRate(); });
}

bool mayNeedImplicitViscosity(const FlowConfig& c) {
  if (c.viscosity != ViscosityMode::Auto) return c.viscosity == ViscosityMode::Implicit;
  return std::any_of(c.materials.begin(), c.materials.end(), [&](const FlowMaterialConfig& m) {
    if (m.rheology.needsShearRate() || c.pressure == PressureMode::Implicit) return true;
    const double viscous =
        c.viscousFactor * c.spacing * c.spacing * m.restDensity / static_cast<double>(m.rheology.viscosity);
    return viscous < c.courant * c.spacing / m.soundSpeed;
  });
}

namespace {

Status checkSolves(const FlowConfig& c) {
  if (!inRange(c.densityError, 1e-5, 0.1)) return badConfig("densityError", "allowed is 0.00001 to 0.1");
  if (!inRange(c.viscosityError, 1e-6, 0.1)) return badConfig("viscosityError", "allowed is 0.000001 to 0.1");
  if (c.mostIterations < 1 || c.mostIterations > 10000)
    return badConfig("mostIterations", "allowed is 1 to 10000");
  if (!inRange(c.courantFlow, 1e-3, 1.0)) return badConfig("courantFlow", "allowed is 0.001 to 1");
  if (c.pressure == PressureMode::Implicit && c.density == DensityMode::Continuity)
    return badConfig("density", "the implicit pressure takes the density by summation");
  if (c.pressure == PressureMode::Implicit && c.leapFrog)
    return badConfig("leapFrog", "the implicit pressure has its own order of velocity and position");
  return {};
}

}  // namespace

Status checkFlowConfig(const FlowConfig& c) {
  if (!inRange(c.spacing, 1e-6, 1e4)) return badConfig("spacing", "allowed is 0.000001 to 10000 m");
  if (!inRange(c.supportSpacings, 1.5, 4.0)) return badConfig("supportSpacings", "allowed is 1.5 to 4");
  if (c.materials.empty() || c.materials.size() > kMostMaterials)
    return badConfig("materials", fmt::format("1 to {} are allowed", kMostMaterials));
  for (const FlowMaterialConfig& material : c.materials)
    if (Status ok = checkMaterial(material); !ok) return ok;
  if (!isFinite(c.gravity) || !isFinite(c.wind))
    return badConfig("gravity", "gravity and wind must be finite");
  if (!inRange(c.windDrag, 0.0, 1e3)) return badConfig("windDrag", "allowed is 0 to 1000 1/m");
  if (!inRange(c.diffusion, 0.0, 1.0)) return badConfig("diffusion", "allowed is 0 to 1");
  if (!inRange(c.smoothing, 0.0, 1.0)) return badConfig("smoothing", "allowed is 0 to 1");
  if (!inRange(c.courant, 1e-3, 1.0) || !inRange(c.forceFactor, 1e-3, 1.0) ||
      !inRange(c.viscousFactor, 1e-3, 1.0))
    return badConfig("courant", "the step's factors are 0.001 to 1");
  for (int axis = 0; axis < 3; ++axis)
    if (Status ok = checkAxis(c, axis); !ok) return ok;
  if (Status ok = checkBodies(c); !ok) return ok;
  if (Status ok = checkSinks(c.sinks); !ok) return ok;
  if (Status ok = checkSolves(c); !ok) return ok;
  return checkWalls(c.walls);
}

Status makeMeshFields(FlowConfig& c, int threads, const CancelToken& cancel) {
  for (auto& mesh : c.walls.meshes) {
    if (mesh.field && mesh.field->reach() < c.support() * 0.999)
      return badConfig("meshes", "a field does not reach as far as the support");
    if (mesh.field) continue;
    SignedDistanceOptions options;
    options.cell = 0.5 * c.spacing;
    options.reach = c.support();
    // Particles on both sides of a plate of one spacing are two supports of the fast mode apart.
    options.leastThickness = c.spacing;
    options.threads = threads;
    options.cancel = cancel;
    auto field = SignedDistance::make(mesh.triangles, options);
    if (!field) return field.error();
    mesh.field = std::move(*field);
    mesh.triangles = {};
  }
  return {};
}

Status checkReconfiguration(const FlowConfig& from, const FlowConfig& to) {
  if (Status ok = checkFlowConfig(to); !ok) return ok;
  const auto kept = [&](const auto FlowConfig::*member) { return from.*member == to.*member; };
  bool same = kept(&FlowConfig::spacing) && kept(&FlowConfig::supportSpacings) &&
              kept(&FlowConfig::domainMin) && kept(&FlowConfig::domainMax) && kept(&FlowConfig::density) &&
              kept(&FlowConfig::leapFrog) && from.materials.size() == to.materials.size() &&
              from.walls.ground.hasShapeOf(to.walls.ground) &&
              from.walls.meshes.size() == to.walls.meshes.size() &&
              from.walls.groundSurfaces.size() == to.walls.groundSurfaces.size() &&
              needsShearRate(from) == needsShearRate(to) && (from.smoothing > 0.0) == (to.smoothing > 0.0);
  for (int axis = 0; axis < 3; ++axis) same = same && from.periodic[axis] == to.periodic[axis];
  if (!same)
    return badConfig("configuration", "spacing, domain, materials and ground must stay as they were");
  return {};
}

FlowView flowView(const FlowConfig& c) {
  FlowView view;
  view.constants = flowConstants(c);
  const auto end = [&](int axis) {
    return static_cast<std::int32_t>(
        std::min(std::ceil(cellsAlong(c, axis) * kCellUnits - 0.5), 1073741824.0));
  };
  const auto period = [&](int axis) {
    return c.periodic[axis] ? static_cast<std::int32_t>(std::lround(cellsAlong(c, axis))) : 0;
  };
  view.domainX = end(0), view.domainY = end(1), view.domainZ = end(2);
  view.grid.periodX = period(0), view.grid.periodY = period(1), view.grid.periodZ = period(2);
  view.grid.morton = c.cellOrder == CellOrder::Morton;
  setWalls(c, view.walls);
  setSinks(c, view.sinks);
  return view;
}

void FlowHostState::resize(std::size_t n) {
  for (auto* axis : {&x, &y, &z}) axis->resize(n);
  records.resize(n);
  extras.resize(n);
  ids.resize(n);
  excess.resize(n);
  if (!given.empty()) given.resize(n);
}

Status appendParticles(const FlowConfig& c, const std::vector<RigidState>& bodies,
                       const std::vector<FlowParticle>& particles, std::uint32_t firstId,
                       FlowHostState& state) {
  constexpr const char* kParticles = "The particles cannot be used";
  const std::size_t before = state.size();
  if (before + particles.size() > INT32_MAX - kPairPadding || particles.size() > UINT32_MAX - firstId)
    return badInput(kParticles, {}, "there are more than 2^31");
  const FlowView view = flowView(c);
  const SolidTest inSolid(c, view.walls, bodies);
  const bool gave =
      std::any_of(particles.begin(), particles.end(), [](const FlowParticle& p) { return p.given != 0.0; });
  if (gave) state.given.resize(std::max(before, std::size_t{1}));
  state.resize(before + particles.size());
  std::size_t i = before;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const FlowParticle& p = particles[k];
    const Vec3d local = p.position - c.domainMin;
    const bool placed = toUnits(local.x, c.support(), view.domainX, c.periodic[0], state.x[i]) &&
                        toUnits(local.y, c.support(), view.domainY, c.periodic[1], state.y[i]) &&
                        toUnits(local.z, c.support(), view.domainZ, c.periodic[2], state.z[i]);
    if (!placed || !isFinite(p.velocity) || !inRange(p.excess, -0.5, 1.0) || !inRange(p.given, -1.0, 1.0) ||
        p.material >= c.materials.size()) {
      state.resize(before);
      return badInput(
          kParticles, fmt::format("particle {}", k),
          "it lies outside the domain, its velocity or density is not one, or its material is not there");
    }
    if (inSolid(p.position)) continue;
    const Vec3f v = p.velocity.to<float>();
    state.records[i] = {v.x, v.y, v.z, 0.0f, 0.0f, 0.0f};
    state.extras[i] = {0, 0, 0, p.material, 0};
    state.excess[i] = static_cast<float>(p.excess);
    if (!state.given.empty()) state.given[i] = unitsGiven(p.given);
    state.ids[i] = firstId + static_cast<std::uint32_t>(k);
    ++i;
  }
  state.resize(i);
  return {};
}

Status exchangeParticles(const std::vector<FlowExchange>& changes, FlowHostState& state) {
  std::vector<std::pair<std::uint32_t, std::size_t>> wanted;  // number of a particle, place in `changes`
  wanted.reserve(changes.size());
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const FlowExchange& c = changes[k];
    if (!isFinite(c.velocity) || !inRange(c.given, -1.0, 1.0))
      return badInput("The exchange cannot be made", fmt::format("particle {}", c.id),
                      "its velocity is not finite, or what it gave is not a share");
    wanted.emplace_back(c.id, k);
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<std::size_t> place(changes.size(), SIZE_MAX);
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (state.extras[i].flags & kDead) continue;
    const auto found =
        std::lower_bound(wanted.begin(), wanted.end(), std::pair(state.ids[i], std::size_t{0}));
    if (found != wanted.end() && found->first == state.ids[i]) place[found->second] = i;
  }
  for (std::size_t k = 0; k < changes.size(); ++k)
    if (place[k] == SIZE_MAX)
      return badInput("The exchange cannot be made", fmt::format("particle {}", changes[k].id),
                      "it is not in the flow, or is named twice");
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const Vec3f v = changes[k].velocity.to<float>();
    PairRecord& r = state.records[place[k]];
    r.vx = v.x, r.vy = v.y, r.vz = v.z;
    state.given[place[k]] = unitsGiven(changes[k].given);
    if (changes[k].taken) state.extras[place[k]].flags |= kDead | kTaken;
  }
  return {};
}

FlowParticle flowParticle(const FlowConfig& c, const FlowHostState& state, std::size_t i) {
  const double unit = c.support() / kCellUnits;
  const ParticleExtra& extra = state.extras[i];
  const auto at = [&](std::int32_t whole, std::int16_t rest) { return (whole + rest / 65536.0) * unit; };
  const PairRecord& r = state.records[i];
  FlowParticle p;
  p.position = c.domainMin +
               Vec3d{at(state.x[i], extra.restX), at(state.y[i], extra.restY), at(state.z[i], extra.restZ)};
  p.velocity = Vec3f{r.vx, r.vy, r.vz}.to<double>();
  p.material = extra.material;
  p.id = state.ids[i];
  p.excess = static_cast<double>(state.excess[i]);
  if (!state.given.empty()) p.given = state.given[i] * kGivenUnit;
  return p;
}

}  // namespace spin
