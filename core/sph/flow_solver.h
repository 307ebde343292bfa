// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/cpu_features.h"
#include "core/base/result.h"
#include "core/base/timings.h"
#include "core/fields/raster.h"
#include "core/fields/signed_distance.h"
#include "core/math/vec.h"
#include "core/physics/rheology.h"
#include "core/rigid/rigid_body.h"
#include "core/sph/flow_view.h"
#include "core/sph/wall_view.h"

namespace spin {

/// A material that flows. SI.
struct FlowMaterialConfig {
  double restDensity = 1000.0;   ///< kg/m3; > 0
  double soundSpeed = 40.0;      ///< m/s; > 0, about ten times the fastest flow
  bool tait = false;             ///< Tait's equation of state, else the linear one
  double tensileStrength = 0.0;  ///< Pa, >= 0: tension that it bears where FlowConfig::clampTension is set,
                                 ///< with the equation of state
  Rheology rheology;             ///< default: water
};

/// Solids. Places in world metres.
struct FlowWallsConfig {
  struct Plane {
    Vec3d point{};
    Vec3d normal{0, 0, 1};  ///< into the fluid
    Vec3d velocity{};       ///< m/s
    std::uint8_t surface = 0;
  };
  /// A static mesh: triangles in world metres, of which the solver makes a field that suits its spacing, or
  /// a field that is there already.
  struct MeshWall {
    TriangleMesh triangles;
    std::shared_ptr<const SignedDistance> field;  ///< null = made from the triangles; reach >= support
    std::uint8_t surface = 0;
  };
  std::vector<Plane> planes;             ///< kMostPlanes at most
  std::vector<MeshWall> meshes;          ///< solid inside where closed, else sheets
  Raster<float> ground;                  ///< heights, m; NaN = no ground; empty = none
  Raster<std::uint8_t> groundSurfaces;   ///< same shape; empty = surface 0
  std::vector<WallSurface> surfaces{1};  ///< kMostSurfaces at most
};

/// Takes particles out: those within the box, and behind the plane where there is a normal. World metres.
struct FlowSinkConfig {
  Vec3d low{-1e30, -1e30, -1e30}, high{1e30, 1e30, 1e30};
  Vec3d point{};
  Vec3d normal{};  ///< towards what stays; 0 = the box alone
};

/// Summation takes the density anew from where particles are; continuity carries it along and smooths it by
/// diffusion, so the pressure is quieter and a step cheaper.
enum class DensityMode : std::uint8_t { Summation, Continuity };

/// How rows of cells follow each other in memory: z by z, or along a Z-curve within tiles of 8 x 8 rows.
enum class CellOrder : std::uint8_t { Linear, Morton };

/// From an equation of state (weakly compressible: steps are bound by the speed of sound), or solved for so
/// that the density stays (DFSPH, Bender and Koschier 2015, 2017: steps are bound by how far particles go).
enum class PressureMode : std::uint8_t { EquationOfState, Implicit };

/// Pairwise and Stress act explicitly: steps are bound by the viscosity. Implicit solves for the velocity
/// (pairwise form, conjugate gradients): stable at any step. Auto takes Implicit where viscosity would bind
/// the step to less than half of what else binds it, else Pairwise.
enum class ViscosityMode : std::uint8_t { Auto, Pairwise, Stress, Implicit };

/// The particle solver: SPH with pressure by an equation of state or implicitly, solids without particles
/// (wall_law.h), generalised Newtonian viscosity, XSPH.
struct FlowConfig {
  double spacing = 0.05;                         ///< distance of particles at rest, m; > 0
  double supportSpacings = 2.0;                  ///< support radius: 2 fast, 3 accurate; 1.5 to 4
  std::vector<FlowMaterialConfig> materials{1};  ///< 1 to kMostMaterials
  Vec3d gravity{0, 0, -9.80665};                 ///< m/s2
  Vec3d wind{};                                  ///< m/s
  double windDrag = 0.0;                         ///< 1/m; acceleration = windDrag |w - v| (w - v)
  DensityMode density = DensityMode::Summation;
  double diffusion = 0.1;  ///< delta of the density's diffusion, 0..1; by continuity only
  double smoothing = 0.0;  ///< c of XSPH, 0..1
  Vec3d domainMin{};       ///< m; what leaves the box is taken out
  Vec3d domainMax{};       ///< m; along a periodic axis the length is a whole number of supports, >= 3
  bool periodic[3] = {false, false, false};
  bool clampTension = true;      ///< no negative pressure but for the materials' tensile strength; false for
                                 ///< fluid that fills its room, without a free surface
  bool leapFrog = false;         ///< else semi-implicit Euler
  double courant = 0.25;         ///< share of a spacing that sound goes in a step
  double forceFactor = 0.25;     ///< step <= factor sqrt(spacing / |a|)
  double viscousFactor = 0.125;  ///< step <= factor spacing^2 / nu
  CellOrder cellOrder = CellOrder::Linear;
  PressureMode pressure = PressureMode::EquationOfState;
  double densityError = 0.01;  ///< mean compression that the implicit pressure leaves: 1 % fast, 0.1 %
                               ///< accurate; 1e-5 to 0.1
  int mostIterations = 100;    ///< of each implicit solve; 1 to 10000
  double courantFlow = 0.4;    ///< share of a spacing that the fastest goes in a step, implicit pressure
  ViscosityMode viscosity = ViscosityMode::Pairwise;
  double viscosityError = 1e-3;  ///< residual of the implicit viscosity, share of the velocities' norm
  FlowWallsConfig walls;
  std::vector<RigidBodyConfig> bodies;  ///< in the flow, and on the walls; world metres
  double bodyGroundFriction = 0.6;      ///< Coulomb's, of bodies on walls; with theirs the geometric mean
  bool countImpulse = false;            ///< keep FlowSolver::outerImpulse(): a pass more a step
  std::vector<FlowSinkConfig> sinks;    ///< kMostSinks at most

  double support() const { return supportSpacings * spacing; }
  double particleMass(std::size_t material) const {
    return materials[material].restDensity * spacing * spacing * spacing;
  }
};

struct FlowParticle {
  Vec3d position{};  ///< world m
  Vec3d velocity{};  ///< m/s
  std::uint8_t material = 0;
  std::uint32_t id = 0;  ///< in the order of adding, from 0
  double excess = 0.0;   ///< rho / rho0 - 1 to begin with, where the density is carried by continuity
  double given = 0.0;    ///< share of its mass that it has given away, -1..1; below 0 it has gathered some
};

/// What something beside the flow does to a particle between steps. Pairs go on with its whole mass, so few
/// should give much; what was given is kept with the particle and leaves with it.
struct FlowExchange {
  std::uint32_t id = 0;
  Vec3d velocity{};    ///< m/s from now on, rounded to floats
  double given = 0.0;  ///< share from now on, rounded to kGivenUnit
  bool taken = false;  ///< it is taken out of the flow
};

/// What a particle carries at the latest step.
struct FlowSample {
  FlowParticle particle;
  double density = 0.0;      ///< kg/m3
  double pressure = 0.0;     ///< Pa
  double viscosity = 0.0;    ///< Pa s
  double shearRate = 0.0;    ///< 1/s; 0 where no material needs it
  Vec3d pairAcceleration{};  ///< by neighbours alone, m/s2; after a sampled step, of all that acted
  int neighbours = -1;       ///< within the support; -1 unless the latest step was sampled
};

/// Flow: how far the fastest particle goes; with the implicit pressure it stands for Sound.
enum class StepLimit : std::uint8_t { Asked, Sound, Force, Viscous, Flow };

/// How an implicit solve went.
struct FlowSolve {
  int iterations = 0;
  double error = 0.0;    ///< what was left: mean compression by this step, or share of the velocities' norm
  double largest = 0.0;  ///< the same of the worst particle; 0 for viscosity
  bool reached = true;   ///< false: the limit of iterations came first
};

struct FlowStep {
  double seconds = 0.0;
  StepLimit limit = StepLimit::Asked;
  FlowSolve pressure;               ///< implicit pressure only
  double compression = 0.0;         ///< implicit pressure only: mean of max(rho / rho0 - 1, 0) at the start
  double largestCompression = 0.0;  ///< the same of the worst particle
  FlowSolve viscous;                ///< implicit viscosity only
  ViscosityMode viscosity = ViscosityMode::Pairwise;  ///< the form that was used, never Auto
};

/// Particles that are no longer there, by material.
struct FlowLosses {
  std::array<std::uint64_t, kMostMaterials> left{};   ///< beyond the domain
  std::array<std::uint64_t, kMostMaterials> sunk{};   ///< taken out by sinks
  std::array<std::uint64_t, kMostMaterials> taken{};  ///< taken out by exchange()
  /// Sums of what those had given away before, kGivenUnit.
  std::array<std::int64_t, kMostMaterials> leftGiven{}, sunkGiven{}, takenGiven{};
};

class CpuBackend;
struct FlowSolverState;

/// One solver on one device. Fails with what, particle and stage where a state is not finite; the particles
/// are then of no use any more.
class FlowSolver {
 public:
  virtual ~FlowSolver() = default;
  /// Adds particles at rest or moving; ids go on from the last. Positions within the domain. What lies in a
  /// solid by more than a quarter of a spacing is left out, for there is no room: count() says what is there.
  virtual Status add(const std::vector<FlowParticle>& particles) = 0;
  /// Changes some of the particles: each once, by the number that it has. Fails where one is not there, and
  /// then changes nothing.
  virtual Status exchange(const std::vector<FlowExchange>& changes) = 0;
  /// One step of `most` seconds (> 0), or shorter where stability asks for it.
  virtual Result<FlowStep> step(double most) = 0;
  /// Particles that are alive, by id.
  virtual std::vector<FlowSample> samples() const = 0;
  virtual std::size_t count() const = 0;
  /// States of FlowConfig::bodies; all of what changes of them.
  virtual std::vector<RigidState> bodies() const = 0;
  /// Sets them, to go on from a checkpoint or to move kinematic ones. Fails where one is not finite.
  virtual Status setBodies(const std::vector<RigidState>& states) = 0;
  /// Boundary particles of all bodies where they are now, world m; for drawing.
  virtual std::vector<Vec3d> bodyBoundary() const = 0;
  /// With countImpulse: what all but flow and moving bodies gave both since the start, N s: gravity, wind,
  /// walls, kinematic bodies. Their momentum changes by just that, while no particle leaves.
  virtual Vec3d outerImpulse() const = 0;
  /// Since the beginning.
  virtual FlowLosses losses() const = 0;
  /// All that going on needs, bit for bit (core/sph/flow_state.h).
  virtual FlowSolverState state() const = 0;
  /// Takes the place of all particles and of the past; fails where the state does not fit the configuration,
  /// and then changes nothing.
  virtual Status restore(const FlowSolverState& state) = 0;
  /// Changes wind, gravity, friction, sinks, planes and the step's factors; keeps the particles. Fails where
  /// anything else differs.
  virtual Status reconfigure(const FlowConfig& config) = 0;
  /// Whether steps from now on keep the neighbour count and the whole acceleration for samples(), at the
  /// price of another search.
  virtual void sample(bool on) = 0;
  virtual StageTimings& timings() = 0;
  /// Memory of all arrays, bytes.
  virtual std::size_t bytes() const = 0;
  /// "cpu" or "cuda".
  virtual const char* device() const = 0;
};

/// On the processor; threads <= 0 takes all. Fails where a value is out of range.
Result<std::unique_ptr<FlowSolver>> makeFlowSolverCpu(const FlowConfig& config, int threads, Isa isa);
/// On the threads of a backend that the caller has.
Result<std::unique_ptr<FlowSolver>> makeFlowSolverCpu(const FlowConfig& config, const CpuBackend& like,
                                                      Isa isa);

}  // namespace spin
