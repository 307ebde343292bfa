// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/base/cpu_features.h"
#include "core/base/result.h"
#include "core/base/timings.h"
#include "core/math/vec.h"
#include "core/sim/air_part.h"

/// What hangs in the air: mist and powder on a staggered grid (Stam 1999; Harlow and Welch 1965), computed in
/// bricks only where something is. SI, world axes with z up.
namespace spin {

class CpuBackend;

/// What the air carries, per volume: mist, snow and vapour in kg/m3, warmth in K over the air round the
/// cloud. Vapour is what is more than in the air round the cloud.
enum class AirScalar : std::uint8_t { Mist, Snow, Warmth, Vapour };
inline constexpr std::size_t kAirScalars = 4;
using AirAmounts = std::array<double, kAirScalars>;  ///< kg; of warmth K m3

/// How velocities are carried: the semi-Lagrangian scheme as published (Stam 1999, Wen), MacCormack with a
/// clamp (Selle et al. 2008), or a clamped cubic interpolation.
enum class AirAdvection : std::uint8_t { SemiLagrangian, MacCormack, Cubic };
/// Conjugate gradients with a multigrid step as preconditioner, or sweeps as published.
enum class AirPressure : std::uint8_t { Multigrid, Jacobi, GaussSeidel };
/// Weight of a mixture of humid air with its load against the air round it; or as published: the difference
/// of stacked cells (Mukai et al.), or rho = p / (R_av T) with R_av = R_a (1 + 0.378 phi) (Wang et al.).
enum class AirBuoyancy : std::uint8_t { HumidAir, StackedCells, FogDensity };

/// Something solid. Distances in m, positive in the air.
struct AirSolid {
  std::function<double(Vec3d)> distance;
  std::function<Vec3d(Vec3d)>
      velocity;  ///< m/s of its surface; empty: it stands still and is asked only once
  Vec3d low{-1e30, -1e30, -1e30}, high{1e30, 1e30, 1e30};  ///< beyond there is none of it
  /// False only where none of it is in the box between two corners; empty: it may be anywhere. `distance`
  /// does not tell: far from the surface it need not be a true one.
  std::function<bool(Vec3d, Vec3d)> mayTouch = {};
};

/// Parts of a step that are done; for measuring one alone.
struct AirStages {
  bool forces = true, advectVelocity = true, advectScalars = true, diffuse = true, project = true;
};

struct AirConfig {
  double cell = 1.0;  ///< m; > 0
  Vec3d origin{};     ///< m, lower corner of cell (0, 0, 0) of brick (0, 0, 0)
  std::array<std::int32_t, 3> lowBrick{}, highBrick{1, 1, 1};  ///< bricks that may be, the high ones beyond
  std::array<bool, 6>
      closed{};         ///< sides -x, +x, -y, +y, -z, +z of that box are walls; else air goes in and out
  bool sticky = false;  ///< solids hold the air beside them; else it slides
  std::array<bool, 6> stickySides{};    ///< the same of closed sides
  std::array<Vec3d, 6> wallVelocity{};  ///< m/s of closed sides that hold the air
  bool everywhere = false;              ///< all bricks of the box are computed from the start on

  Vec3d gravity{0, 0, -9.80665};                     ///< m/s2
  double temperature = 273.15, pressure = 101325.0;  ///< K, Pa, of the air round the cloud
  double humidity = 0.8;                             ///< of that air, over water, 0..1
  std::function<Vec3d(Vec3d)> wind;                  ///< m/s, of that air; empty: calm
  AirBuoyancy buoyancy = AirBuoyancy::HumidAir;
  bool evaporates = true;            ///< mist and vapour seek saturation
  double viscosity = 0.0;            ///< m2/s, of velocities, implicit
  double smagorinsky = 0.0;          ///< C of eddies smaller than a cell (Smagorinsky 1963); 0 = none, 0..0.5
  std::array<double, 2> settling{};  ///< m/s, of mist and of snow in calm air; >= 0

  AirAdvection advection = AirAdvection::MacCormack;
  bool reflection = true;  ///< advection-reflection (Zehnder et al. 2018): two projections a step
  AirPressure solver = AirPressure::Multigrid;
  double tolerance = 1e-3;  ///< of the projection: residual over the right side, root mean squares
  int mostIterations = 60;
  int sweeps = 40;                   ///< of Jacobi and Gauss-Seidel
  double diffusionTolerance = 1e-5;  ///< of the implicit diffusion, as `tolerance`
  double mostCourant = 4.0;          ///< cells that air goes in a sub-step at most; 0.1 to 100

  AirStages stages;
  std::function<bool()> stop;  ///< asked several times in a step: true ends it as cancelled; may be empty

  std::vector<AirSolid> solids;
  /// A brick whose cells all lie below these, and neighbours' too, is given up.
  AirAmounts least{1e-5, 1e-4, 0.2, 1e-4};
  double leastSpeed = 0.5;  ///< m/s, against the wind
};

/// Brought into the air at a place.
struct AirSource {
  Vec3d position{};
  AirAmounts amounts{};
  Vec3d impulse{};  ///< N s, all of it: what is brought has its own momentum
};

/// What takes in what is added at a place.
struct AirCellNow {
  std::uint32_t cell = 0;  ///< the same for places that share it, until bricks come or go
  double volume = 0.0;     ///< m3 that are open; 0 where none takes anything
  AirAmounts densities{};  ///< kg/m3, warmth in K
};

/// Something that the air drags and that drags the air.
struct AirDrag {
  Vec3d position{};
  Vec3d velocity{};   ///< m/s; comes back as it is afterwards
  double mass = 0.0;  ///< kg
  double rate = 0.0;  ///< 1/s: dv/dt = rate (air - v)
};

/// Came down in a cell, since it was last asked.
struct AirDeposit {
  Vec3d position{};               ///< centre of the cell
  double mist = 0.0, snow = 0.0;  ///< kg
};

/// Every term is counted where it happens.
struct AirBudget {
  AirAmounts present{}, added{}, condensed{}, enteredSides{}, leftSides{}, deposited{}, givenUp{};
  Vec3d addedImpulse{}, solidImpulse{};  ///< N s given to the air, and what had no open face to go to
};

struct AirStep {
  double seconds = 0.0;
  int subSteps = 0, solves = 0, iterations = 0;  ///< iterations of all solves
  double residual = 0.0;                         ///< the largest that a solve left
  bool reached = true;                           ///< all came below the tolerance
  double fastest = 0.0;                          ///< m/s
  std::size_t cells = 0;                         ///< that were computed
};

inline constexpr std::size_t kAirFields = 10;

/// All that going on needs, bit for bit, after takeDeposits().
struct AirState {
  std::vector<std::array<std::int32_t, 3>> bricks;
  /// (field * bricks + brick) * kBrickCells + cell, cells as in AirField. Fields: velocity's three parts,
  /// each at its cell's lower face, m/s; mist, snow, warmth, vapour per volume; two pressures (of the first
  /// and the second projection of a step, as potentials in m/s; 0 = cold start); and, told only, the share of
  /// a cell's volume that `per volume` means: 0 in solids.
  std::vector<float> values;
  /// Velocities at the upper faces of bricks that no brick lies beyond, along x, y and z, brick by brick.
  std::array<std::vector<float>, 3> upper;
  bool forward = false;  ///< order of the axes that scalars were carried along last
  AirBudget budget;
};

class AirSolver {
 public:
  virtual ~AirSolver() = default;
  /// Bricks come to be where needed. Beyond the box nothing is taken: amounts are booked as left.
  virtual Status add(const std::vector<AirSource>& sources) = 0;
  /// Particles and air exchange momentum for some time; what one loses the other gains. Unconditionally
  /// stable: per cell the air and all that is in it are solved together, implicitly.
  virtual Status drag(std::vector<AirDrag>& particles, double seconds) = 0;
  /// Air velocity at places; where no brick is, the wind.
  virtual std::vector<Vec3d> velocities(const std::vector<Vec3d>& places) const = 0;
  /// The cells that take in what is added at the places: those that hold them or, where that is solid, the
  /// lowest open one of the two above. Bricks come to be where needed.
  virtual Result<std::vector<AirCellNow>> cellsAt(const std::vector<Vec3d>& places) = 0;
  /// Goes on by `seconds` (> 0), in sub-steps. Fails with what, where and stage if a value is not finite, and
  /// where air is colder or faster than any can be; so do add() and drag().
  virtual Result<AirStep> step(double seconds) = 0;
  /// Replaces solids that move (the same number in the same order as in the configuration). What cells hold
  /// stays in them or goes on to those beside; what is enclosed by solids is booked as given up.
  virtual Status moveSolids(const std::vector<AirSolid>& solids) = 0;
  virtual std::vector<AirDeposit> takeDeposits() = 0;
  virtual AirBudget budget() const = 0;
  /// Bricks and fields of a frame; `divergence` asks for that field as well.
  virtual void publish(bool divergence, AirPart& part) const = 0;
  virtual AirState state() const = 0;
  virtual Status restore(const AirState& state) = 0;
  virtual std::size_t cells() const = 0;
  virtual std::size_t bytes() const = 0;
  virtual StageTimings& timings() = 0;
  virtual const char* device() const = 0;  ///< "cpu" or "cuda"
};

Result<std::unique_ptr<AirSolver>> makeAirSolverCpu(const AirConfig& config, const CpuBackend& like, Isa isa);

}  // namespace spin
