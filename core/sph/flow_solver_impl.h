// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/sph/backend_passes.h"
#include "core/sph/flow_bodies.h"
#include "core/sph/flow_kernels.h"
#include "core/sph/flow_sampler.h"
#include "core/sph/flow_setup.h"
#include "core/sph/flow_state.h"
#include "core/sph/implicit_pressure.h"
#include "core/sph/implicit_viscosity.h"
#include "core/sph/mesh_walls.h"

namespace spin {

template <class Backend>
class FlowSolverOn final : public FlowSolver {
 public:
  FlowSolverOn(const FlowConfig& config, Backend backend, FlowPasses<Backend> passes)
      : m_config(config), m_backend(std::move(backend)), m_passes(passes), m_view(flowView(config)) {
    if (!config.walls.ground.empty()) {
      // Heights relative to the domain's floor keep their digits.
      std::vector<float> heights = config.walls.ground.values;
      for (float& z : heights) z -= static_cast<float>(config.domainMin.z);
      m_backend.upload(heights, m_ground);
      m_backend.upload(config.walls.groundSurfaces.values, m_groundSurfaces);
    }
    m_meshes.upload(m_backend, config);
    m_meshes.point(m_view.walls);
    m_bodies.init(m_backend, config);
  }

  Status add(const std::vector<FlowParticle>& particles) override {
    return guarded([&]() -> Status {
      FlowHostState state = downloaded();
      if (Status ok = appendParticles(m_config, m_bodies.world().states(), particles, m_nextId, state); !ok)
        return ok;
      m_nextId += static_cast<std::uint32_t>(particles.size());
      take(std::move(state));
      return {};
    });
  }

  Status exchange(const std::vector<FlowExchange>& changes) override {
    if (changes.empty()) return {};
    return guarded([&]() -> Status {
      FlowHostState state = downloaded();
      if (state.given.empty()) state.given.assign(std::max(state.size(), std::size_t{1}), 0);
      if (Status ok = exchangeParticles(changes, state); !ok) return ok;
      // Places and order stay, and with them what the latest step has sampled.
      state.resize(m_view.count + kPairPadding);
      m_backend.upload(state.records, m_record);
      m_backend.upload(state.extras, m_extra);
      m_backend.upload(state.given, m_given);
      allocate(m_view.count);
      point();
      return {};
    });
  }

  FlowSolverState state() const override {
    return {downloaded(), m_nextId, m_lastStep, m_losses, m_bodies.world().states()};
  }

  Status restore(const FlowSolverState& state) override {
    if (Status ok = checkState(m_config, state); !ok) return ok;
    return guarded([&]() -> Status {
      take(state.particles);
      m_nextId = state.nextId;
      m_lastStep = state.lastStep;
      // The force pass reads the step before.
      m_view.constants.timeStep = static_cast<float>(m_lastStep);
      m_losses = state.losses;
      return m_bodies.world().setStates(state.bodies);
    });
  }

  Status reconfigure(const FlowConfig& config) override {
    if (Status ok = checkReconfiguration(m_config, config); !ok) return ok;
    const FlowView fresh = flowView(config);
    // Solids stay as they are: the fields of meshes were made at the start.
    FlowWallsConfig walls = config.walls;
    walls.meshes = std::move(m_config.walls.meshes);
    m_config = config;
    m_config.walls = std::move(walls);
    m_view.constants = fresh.constants;
    m_view.constants.timeStep = static_cast<float>(m_lastStep);
    m_view.walls = fresh.walls;
    m_view.sinks = fresh.sinks;
    m_meshes.point(m_view.walls);
    return guarded([&]() -> Status {
      // Other forms of pressure and viscosity need other arrays.
      if (m_view.count > 0) allocate(m_view.count);
      point();
      return {};
    });
  }

  void sample(bool on) override { m_sampling = on; }

  FlowLosses losses() const override {
    FlowLosses all = m_losses;
    addDead(all);
    return all;
  }

  Result<FlowStep> step(double most) override {
    if (!(most > 0.0) || !std::isfinite(most))
      return badInput(kStopped, "time step", "a step of " + std::to_string(most) + " s");
    FlowStep done;
    done.seconds = most;
    const Status status =
        guarded([&] { return m_view.count == 0 ? m_bodies.move(most, {}) : stepParticles(done); });
    if (!status) return status.error();
    return done;
  }

  std::vector<FlowSample> samples() const override {
    const FlowHostState state = downloaded();
    std::vector<float> shear, ax, ay, az;
    m_backend.download(m_shear, shear);
    m_backend.download(m_ax, ax);
    m_backend.download(m_ay, ay);
    m_backend.download(m_az, az);
    std::vector<std::uint32_t> neighbours;
    m_sampler.download(m_backend, neighbours);
    std::vector<FlowSample> result;
    result.reserve(state.size());
    for (std::size_t i = 0; i < state.size(); ++i) {
      if (state.extras[i].flags & kDead) continue;
      const PairRecord& r = state.records[i];
      const double e = 1.0 + static_cast<double>(state.excess[i]);
      result.push_back({flowParticle(m_config, state, i), static_cast<double>(r.restDensity) * e,
                        static_cast<double>(r.pressureTerm) * e * e, static_cast<double>(r.viscosity),
                        shear.empty() ? 0.0 : static_cast<double>(shear[i]),
                        Vec3f{ax[i], ay[i], az[i]}.template to<double>(),
                        neighbours.empty() ? -1 : static_cast<int>(neighbours[i])});
    }
    std::sort(result.begin(), result.end(),
              [](const FlowSample& a, const FlowSample& b) { return a.particle.id < b.particle.id; });
    return result;
  }

  std::size_t count() const override { return m_view.count; }
  std::vector<RigidState> bodies() const override { return m_bodies.world().states(); }
  Status setBodies(const std::vector<RigidState>& states) override {
    return m_bodies.world().setStates(states);
  }
  std::vector<Vec3d> bodyBoundary() const override { return m_bodies.boundary(); }
  Vec3d outerImpulse() const override { return m_outer; }
  StageTimings& timings() override { return m_backend.timings(); }
  const char* device() const override { return Backend::kDevice; }
  std::size_t bytes() const override {
    const auto of = [](const auto&... array) { return (... + (array.size() * sizeof(*array.data()))); };
    return of(m_x, m_y, m_z, m_otherX, m_otherY, m_otherZ, m_record, m_extra, m_otherExtra, m_excess,
              m_otherExcess, m_rate, m_ax, m_ay, m_az, m_given, m_otherGiven) +
           of(m_sx, m_sy, m_sz, m_shear, m_id, m_otherId, m_key, m_otherKey, m_order, m_rows, m_rowBins,
              m_binStart) +
           of(m_ground, m_groundSurfaces, m_contact, m_stress, m_bodyRate, m_wallViscosity) +
           m_sampler.bytes() + m_meshes.bytes() + m_bodies.bytes() + m_pressure.bytes() +
           m_viscosity.bytes() + m_backend.scratchBytes();
  }

 private:
  template <class T>
  using Array = typename Backend::template Array<T>;
  static constexpr const char* kStopped = "The particle solver stopped";
  /// Rows of cells round all particles, at most.
  static constexpr double kMostRows = 67108864.0;
  /// Auto: viscosity is implicit where its explicit step is below this share of the others.
  static constexpr double kImplicitBelow = 0.5;
  static constexpr double kSpreadSteps = 8.0;
  /// Implicit pressure: share of forceFactor that binds the step. Columns at rest stay quiet below it.
  static constexpr double kImplicitForce = 0.4;

  /// Memory that is not there and a device that fails are the world's fault, not a bug.
  template <class Body>
  static Status guarded(const Body& body) {
    try {
      return body();
    } catch (const std::bad_alloc&) {
      return Error{ErrorKind::OutOfResources, kStopped, Backend::kDevice, "there is not enough memory",
                   "Use fewer particles"};
    } catch (const std::runtime_error& error) {
      return Error{ErrorKind::Failed, kStopped, Backend::kDevice, error.what(), "Use --device cpu"};
    }
  }
  static Error notFinite(std::uint32_t id, const char* stage) {
    return {ErrorKind::Failed, kStopped, "particle " + std::to_string(id) + ", stage " + stage,
            "its state is not finite",
            "Use a smaller step or a stiffer material; the last good frame is kept"};
  }

  FlowHostState downloaded() const {
    FlowHostState state;
    if (m_view.count == 0) return state;
    m_backend.download(m_x, state.x);
    m_backend.download(m_y, state.y);
    m_backend.download(m_z, state.z);
    m_backend.download(m_record, state.records);
    m_backend.download(m_extra, state.extras);
    m_backend.download(m_id, state.ids);
    m_backend.download(m_excess, state.excess);
    m_backend.download(m_given, state.given);
    state.resize(m_view.count);
    return state;
  }

  /// Makes these the particles.
  void take(FlowHostState state) {
    const std::size_t n = state.size();
    state.resize(n + kPairPadding);
    m_backend.upload(state.x, m_x);
    m_backend.upload(state.y, m_y);
    m_backend.upload(state.z, m_z);
    m_backend.upload(state.records, m_record);
    m_backend.upload(state.extras, m_extra);
    m_backend.upload(state.ids, m_id);
    m_backend.upload(state.excess, m_excess);
    m_backend.upload(state.given, m_given);
    m_view.count = static_cast<std::uint32_t>(n);
    m_sampler.forget();
    allocate(n);
    point();
  }

  /// Counts the dead that are still in the arrays.
  void addDead(FlowLosses& losses) const {
    const FlowLossCount dead =
        m_backend.reduce("losses", m_view.count, FlowLossCount{}, LossesOf{m_view}, JoinLosses{});
    for (std::size_t m = 0; m < kMostMaterials; ++m) {
      losses.left[m] += dead.left[m];
      losses.sunk[m] += dead.sunk[m];
      losses.taken[m] += dead.taken[m];
      losses.leftGiven[m] += dead.leftGiven[m];
      losses.sunkGiven[m] += dead.sunkGiven[m];
      losses.takenGiven[m] += dead.takenGiven[m];
    }
  }

  void allocate(std::size_t n) {
    // Vector loads may start at the last particle.
    const std::size_t padded = n + kPairPadding;
    for (Array<std::int32_t>* array : {&m_otherX, &m_otherY, &m_otherZ}) array->resize(padded);
    for (Array<float>* array : {&m_otherExcess, &m_ax, &m_ay, &m_az}) array->resize(padded);
    if (m_config.density == DensityMode::Continuity) m_rate.resize(padded);
    if (m_config.smoothing > 0.0)
      for (Array<float>* array : {&m_sx, &m_sy, &m_sz}) array->resize(padded);
    if (needsShearRate(m_config))
      for (Array<float>* array : {&m_shear, &m_wallViscosity}) array->resize(padded);
    if (m_config.viscosity == ViscosityMode::Stress) m_stress.resize(padded);
    if (m_config.pressure == PressureMode::Implicit) m_pressure.allocate(padded);
    if (implicitPressure() && m_bodies.any()) m_bodyRate.resize(padded);
    if (mayNeedImplicitViscosity(m_config)) m_viscosity.allocate(padded);
    if (!m_config.walls.ground.empty()) m_contact.resize(padded);
    if (m_given.size() > 0) m_otherGiven.resize(padded);
    m_otherExtra.resize(padded);
    m_otherId.resize(padded);
    m_otherKey.resize(padded);
    m_key.resize(n);
  }

  /// Swapping moves arrays between the sorted and the other set; the view follows.
  void point() {
    m_view.x = m_x.data();
    m_view.y = m_y.data();
    m_view.z = m_z.data();
    m_view.record = m_record.data();
    m_view.excess = m_excess.data();
    m_view.rate = m_config.density == DensityMode::Continuity ? m_rate.data() : nullptr;
    m_view.ax = m_ax.data();
    m_view.ay = m_ay.data();
    m_view.az = m_az.data();
    const bool smooth = m_config.smoothing > 0.0;
    m_view.sx = smooth ? m_sx.data() : nullptr;
    m_view.sy = smooth ? m_sy.data() : nullptr;
    m_view.sz = smooth ? m_sz.data() : nullptr;
    m_view.shearRate = needsShearRate(m_config) ? m_shear.data() : nullptr;
    m_view.wallViscosity = needsShearRate(m_config) ? m_wallViscosity.data() : nullptr;
    m_view.stress = m_config.viscosity == ViscosityMode::Stress ? m_stress.data() : nullptr;
    m_view.bodyRate = implicitPressure() && m_bodies.any() ? m_bodyRate.data() : nullptr;
    m_pressure.point(m_config, m_view);
    m_viscosity.point(m_view);
    m_view.extra = m_extra.data();
    m_view.given = m_given.size() > 0 ? m_given.data() : nullptr;
    m_view.id = m_id.data();
    m_view.key = m_key.data();
    m_view.rows = m_rows.data();
    m_view.binStart = m_binStart.data();
    if (m_config.walls.ground.empty()) return;
    m_view.ground = m_contact.data();
    m_view.walls.ground.heights = m_ground.data();
    m_view.walls.ground.surfaces = m_config.walls.groundSurfaces.empty() ? nullptr : m_groundSurfaces.data();
  }

  Status stepParticles(FlowStep& done) {
    if (Status ok = sortIntoCells(); !ok || m_view.count == 0) return ok;
    m_bodies.place(m_backend, m_view);
    m_sampler.begin(m_backend, m_view, m_sampling);
    if (Status ok = implicitPressure() ? stepByPressureSolve(done) : stepByState(done); !ok) return ok;
    m_sampler.end(m_backend, m_view, m_kick);
    return {};
  }

  bool implicitPressure() const { return m_config.pressure == PressureMode::Implicit; }

  Status stepByState(FlowStep& done) {
    if (!m_view.rate) {
      m_passes.density(m_backend, m_view);
      m_bodies.density(m_backend, m_view);
    }
    m_backend.forEach("pressure", m_view.count, PressureKernel{m_view});
    if (m_view.shearRate) m_passes.shear(m_backend, m_view);
    const bool solves = chooseViscosity(done);
    force();
    const StepLimits limits = m_backend.reduce("step", m_view.count, noLimits(), limitsOf(), JoinLimits{});
    if (limits.broken != UINT32_MAX) return notFinite(limits.broken, "force");
    chooseStep(limits, solves, done);
    m_view.constants.timeStep = static_cast<float>(done.seconds);
    const double kick = m_config.leapFrog ? 0.5 * (m_lastStep + done.seconds) : done.seconds;
    m_lastStep = done.seconds;
    m_kick = kick;
    m_bodies.rub(m_backend, m_view, kick);
    const std::vector<RigidImpulse> impulses = m_bodies.reaction(m_backend, m_view, kick, false);
    if (!solves) {
      const IntegrateKernel integrate{m_view, static_cast<float>(kick)};
      if (m_config.countImpulse) countImpulse(integrate);
      m_backend.forEach("integrate", m_view.count, integrate);
      return moveBodies(done.seconds, impulses);
    }
    const Vec3d before = m_config.countImpulse ? momentum() : Vec3d{};
    m_backend.forEach("integrate", m_view.count,
                      PredictKernel{{m_view, static_cast<float>(kick)}, false, true});
    if (Status ok = solveViscosity(kick, done); !ok) return ok;
    m_backend.forEach("integrate", m_view.count, WallEndKernel{m_view, false});
    if (m_config.countImpulse) m_outer += momentum() - before - m_bodies.given(m_backend, m_view) * kick;
    m_backend.forEach("integrate", m_view.count, AdvanceKernel{{m_view, m_view.constants.timeStep}});
    return moveBodies(done.seconds, impulses);
  }

  Status moveBodies(double seconds, const std::vector<RigidImpulse>& impulses) {
    const Status moved = m_bodies.move(seconds, impulses);
    if (m_config.countImpulse && m_bodies.any()) m_outer += m_bodies.world().outerImpulse();
    return moved;
  }

  /// Of all particles, kg m/s.
  Vec3d momentum() {
    const ImpulseSum sum = m_backend.reduce("impulse", m_view.count, ImpulseSum{0, 0, 0},
                                            MomentumOf{m_view, particleVolume()}, AddImpulse{});
    return {sum.x, sum.y, sum.z};
  }
  double particleVolume() const { return m_config.spacing * m_config.spacing * m_config.spacing; }

  void countImpulse(const IntegrateKernel& integrate) {
    const ImpulseSum sum = m_backend.reduce("impulse", m_view.count, ImpulseSum{0, 0, 0},
                                            OuterImpulseOf{integrate, particleVolume()}, AddImpulse{});
    m_outer += Vec3d{sum.x, sum.y, sum.z};
  }

  /// All forces with the pressure of the step before, then the pressure's change.
  Status stepByPressureSolve(FlowStep& done) {
    m_passes.solve(m_backend, "density", m_view, SolvePass::Constraint);
    m_bodies.constraint(m_backend, m_view);
    m_backend.forEach("pressure", m_view.count, ConstraintKernel{m_view});
    if (m_view.shearRate) m_passes.shear(m_backend, m_view);
    FlowLimits limits =
        m_backend.reduce("step", m_view.count, noFlowLimits(), flowLimitsOf(), JoinFlowLimits{});
    if (limits.step.broken != UINT32_MAX) return notFinite(limits.step.broken, "density");
    done.compression = limits.excess / m_view.count;
    done.largestCompression = static_cast<double>(limits.largest);
    // What goes far is compressed by more than its velocities foresee: where that is too much, go less far.
    const double room = m_config.densityError / std::max(done.compression, 1e-12);
    limits.step.sound *= static_cast<float>(std::clamp(0.7 * room, 0.25, 1.0));
    if (const double gravity = length(m_config.gravity); gravity > 0.0)
      limits.step.force =
          static_cast<float>(kImplicitForce * m_config.forceFactor * std::sqrt(m_config.spacing / gravity));
    const bool solves = chooseViscosity(limits.step, done);
    const double asked = done.seconds;
    chooseStep(limits.step, solves, done);
    spreadStep(asked, done);
    m_kick = m_lastStep = done.seconds;
    const double longest =
        std::min(static_cast<double>(limits.step.sound), static_cast<double>(limits.step.force));
    const double share = std::isfinite(longest) ? done.seconds / longest : done.seconds / asked;
    const auto kick = static_cast<float>(done.seconds);
    m_view.constants.timeStep = kick;
    m_view.pressureSolve.timeStep = kick;
    force();
    m_bodies.rub(m_backend, m_view, done.seconds);
    const Vec3d before = m_config.countImpulse ? momentum() : Vec3d{};
    m_bodies.beginSolve(m_backend, m_view, done.seconds);
    m_backend.forEach("integrate", m_view.count, PredictKernel{{m_view, kick}, true, solves});
    if (solves)
      if (Status ok = solveViscosity(done.seconds, done); !ok) return ok;
    WithBodies passes{m_passes, m_bodies};
    const double level = m_config.clampTension ? 0.0 : limits.balance / m_view.count;
    const std::uint32_t broken =
        m_pressure.solve(m_backend, passes, m_config, m_view, done.compression, level, share, done.pressure);
    if (broken != UINT32_MAX) return notFinite(broken, "pressure solve");
    m_backend.forEach("integrate", m_view.count, WallEndKernel{m_view, !solves});
    if (m_config.countImpulse)
      m_outer += momentum() - before - m_bodies.given(m_backend, m_view) * done.seconds;
    const std::vector<RigidImpulse> impulses = m_bodies.reaction(m_backend, m_view, done.seconds, true);
    m_backend.forEach("integrate", m_view.count, AdvanceKernel{{m_view, m_view.constants.timeStep}});
    return moveBodies(done.seconds, impulses);
  }

  /// The solve's passes, with what bodies have to do with them.
  struct WithBodies {
    FlowPasses<Backend>& passes;
    FlowBodies<Backend>& bodies;
    void solve(Backend& backend, const char* stage, const FlowView& view, SolvePass pass) {
      if (pass == SolvePass::Divergence) bodies.divergence(backend, view);
      passes.solve(backend, stage, view, pass);
      if (pass == SolvePass::PressurePush) bodies.push(backend, view);
    }
  };

  void force() {
    m_passes.force(m_backend, m_view);
    if (m_view.stress) m_passes.solve(m_backend, "stress", m_view, SolvePass::Stress);
    if (m_view.rate) m_bodies.rate(m_backend, m_view);
    m_bodies.pressure(m_backend, m_view);
  }

  Status solveViscosity(double kick, FlowStep& done) {
    const std::uint32_t broken = m_viscosity.solve(m_backend, m_passes, m_config, m_view, kick, done.viscous);
    if (broken != UINT32_MAX) return notFinite(broken, "viscosity solve");
    return {};
  }

  LimitsOf limitsOf() const {
    return {m_view, static_cast<float>(m_config.courant), static_cast<float>(m_config.forceFactor),
            static_cast<float>(m_config.viscousFactor)};
  }
  FlowLimitsOf flowLimitsOf() const {
    return {m_view, static_cast<float>(m_config.courantFlow), static_cast<float>(m_config.viscousFactor)};
  }

  /// Which form of viscosity this step takes; whether it is the implicit one. Pairs drag in the force pass
  /// only in the pairwise form.
  bool chooseViscosity(FlowStep& done) {
    // Accelerations are not there yet: sound is what else binds the step.
    StepLimits limits = noLimits();
    if (m_config.viscosity == ViscosityMode::Auto && mayNeedImplicitViscosity(m_config)) {
      m_backend.forEach("step", m_view.count, ClearAccelerationKernel{m_view});
      limits = m_backend.reduce("step", m_view.count, noLimits(), limitsOf(), JoinLimits{});
      limits.force = INFINITY;
    }
    return chooseViscosity(limits, done);
  }
  bool chooseViscosity(const StepLimits& limits, FlowStep& done) {
    done.viscosity = m_config.viscosity;
    if (m_config.viscosity == ViscosityMode::Auto) {
      const double others =
          std::min({static_cast<double>(limits.sound), static_cast<double>(limits.force), done.seconds});
      done.viscosity = static_cast<double>(limits.viscous) < kImplicitBelow * others
                           ? ViscosityMode::Implicit
                           : ViscosityMode::Pairwise;
    }
    const bool pairwise = done.viscosity == ViscosityMode::Pairwise;
    const bool stress = done.viscosity == ViscosityMode::Stress;
    m_view.constants.pairDrag = pairwise ? 1.0f : stress ? kPairShare : 0.0f;
    return done.viscosity == ViscosityMode::Implicit;
  }

  void chooseStep(const StepLimits& limits, bool solvesViscosity, FlowStep& done) const {
    const auto limit = [&](float seconds, StepLimit kind) {
      if (static_cast<double>(seconds) >= done.seconds) return;
      done.seconds = static_cast<double>(seconds);
      done.limit = kind;
    };
    limit(limits.sound, implicitPressure() ? StepLimit::Flow : StepLimit::Sound);
    limit(limits.force, StepLimit::Force);
    if (!solvesViscosity) limit(limits.viscous, StepLimit::Viscous);
  }

  /// A last small step before the time asked for would want a pressure that is wrong for the next: few steps
  /// are made equal.
  static void spreadStep(double asked, FlowStep& done) {
    const double steps = std::ceil(asked / done.seconds - 1e-9);
    if (steps > 1.0 && steps <= kSpreadSteps) done.seconds = asked / steps;
  }

  /// Rows round all that lives, each as long as its particles; a bin's number is the sort key.
  Status sortIntoCells() {
    const FlowBounds bounds =
        m_backend.reduce("rows", m_view.count, noBounds(), BoundsOf{m_view}, JoinBounds{});
    if (bounds.broken != UINT32_MAX) return notFinite(bounds.broken, "integrate");
    if (bounds.alive < m_view.count) addDead(m_losses);
    if (bounds.alive == 0) {
      m_view.count = 0;
      return {};
    }
    FlowGrid& grid = m_view.grid;
    grid.lowY = bounds.lowY, grid.cellsY = bounds.highY - bounds.lowY + 1;
    grid.lowZ = bounds.lowZ, grid.cellsZ = bounds.highZ - bounds.lowZ + 1;
    if (static_cast<double>(grid.cellsY) * grid.cellsZ > kMostRows)
      return Error{ErrorKind::OutOfResources, kStopped, "cells",
                   "the particles are spread over too many rows of cells",
                   "Make the domain smaller or the spacing larger"};
    sortIntoBins(makeRows(), bounds.alive);
    return {};
  }

  /// Gives the number of bins.
  std::uint32_t makeRows() {
    const auto rows = static_cast<std::size_t>(m_view.grid.rows());
    const auto ranks = static_cast<std::size_t>(m_view.grid.ranks());
    if (m_rows.size() < rows) m_rows.resize(rows);
    if (m_rowBins.size() < ranks) m_rowBins.resize(ranks);
    m_view.rows = m_rows.data();
    m_backend.forEach("rows", rows, ClearRowKernel{m_view});
    m_backend.forEach("rows", m_view.count, RowExtentKernel{m_view});
    m_backend.forEach("rows", ranks, RowBinsKernel{m_view, m_rowBins.data()});
    const std::uint64_t bins = m_backend.exclusiveScan("rows", m_rowBins.data(), m_rowBins.data(), ranks);
    m_backend.forEach("rows", rows, RowStartKernel{m_view, m_rowBins.data()});
    if (bins > UINT32_MAX - 2) throw std::runtime_error("too many bins");
    if (m_binStart.size() < bins + 2) m_binStart.resize(bins + bins / 8 + 2);
    m_view.binStart = m_binStart.data();
    return static_cast<std::uint32_t>(bins);
  }

  void sortIntoBins(std::uint32_t bins, std::uint32_t alive) {
    const std::size_t n = m_view.count;
    m_backend.forEach("key", n, KeyKernel{m_view, bins});
    if (m_key.size() != n) m_key.resize(n);
    m_backend.sortByKey("sort", m_key, bins + 1, m_order);
    // The dead are last in the order, and stay behind.
    m_view.count = alive;
    // What the density makes anew needs no place in the sorted set: the pressure is carried there.
    if (implicitPressure()) m_backend.forEach("gather", n, KeepPressureKernel{m_view});
    m_backend.forEach("gather", alive,
                      GatherKernel{m_view, m_order.data(), m_otherX.data(), m_otherY.data(), m_otherZ.data(),
                                   m_otherExtra.data(), m_otherId.data(), m_otherKey.data(),
                                   m_otherExcess.data(), m_otherGiven.data()});
    std::swap(m_x, m_otherX);
    std::swap(m_y, m_otherY);
    std::swap(m_z, m_otherZ);
    std::swap(m_extra, m_otherExtra);
    std::swap(m_id, m_otherId);
    std::swap(m_excess, m_otherExcess);
    if (m_view.given) std::swap(m_given, m_otherGiven);
    point();
    if (implicitPressure())
      m_backend.forEach("gather", alive, TakeStateKernel{m_view});
    else
      m_backend.forEach("gather", alive, TakeVelocityKernel{m_view});
    FlowView sorted = m_view;
    sorted.key = m_otherKey.data();
    m_backend.forEach("cells", static_cast<std::size_t>(alive) + 1, BinStartKernel{sorted, bins});
    if (alive != n) m_key.resize(alive);
    m_view.key = m_key.data();
  }

  FlowConfig m_config;
  mutable Backend m_backend;
  FlowPasses<Backend> m_passes;
  FlowView m_view;
  std::uint32_t m_nextId = 0;
  Vec3d m_outer{};      ///< N s
  FlowLosses m_losses;  ///< those dropped from the arrays
  bool m_sampling = false;
  FlowSampler<Backend> m_sampler;
  ImplicitPressure<Backend> m_pressure;
  ImplicitViscosity<Backend> m_viscosity;
  double m_kick = 0.0;      ///< s, by which the latest step advanced velocities
  double m_lastStep = 0.0;  ///< 0 before the first: the leap-frog's first kick is half a step
  Array<std::int32_t> m_x, m_y, m_z, m_otherX, m_otherY, m_otherZ, m_given, m_otherGiven;
  Array<PairRecord> m_record;
  Array<ParticleExtra> m_extra, m_otherExtra;
  Array<float> m_excess, m_otherExcess, m_rate, m_ax, m_ay, m_az, m_sx, m_sy, m_sz, m_shear, m_wallViscosity,
      m_ground;
  Array<std::uint8_t> m_groundSurfaces;
  Array<GroundContact> m_contact;
  MeshWalls<Backend> m_meshes;
  FlowBodies<Backend> m_bodies;
  Array<float> m_bodyRate;
  Array<StressRecord> m_stress;
  Array<std::uint32_t> m_id, m_otherId, m_key, m_otherKey, m_order, m_rowBins, m_binStart;
  Array<FlowRow> m_rows;
};

}  // namespace spin
