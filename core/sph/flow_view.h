// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/physics/rheology.h"
#include "core/sph/implicit_view.h"
#include "core/sph/sink_view.h"
#include "core/sph/wall_view.h"

namespace spin {

/// Positions are fixed-point: 2^18 units to a cell, and a cell is one support radius. Differences of
/// positions are then exact, resolution is the same everywhere, and a pattern that is moved by whole cells
/// gives the same bits. What a step leaves below a unit is carried along, so slow motion is not lost.
inline constexpr int kCellBits = 18;
inline constexpr std::int32_t kCellUnits = 1 << kCellBits;
/// Along x, particles are sorted into quarter cells, so that a search takes only the part of a row it needs.
inline constexpr int kBinBits = kCellBits - 2;
/// Cells along an axis, at most.
inline constexpr std::int32_t kMaxCells = 1 << (30 - kCellBits);
/// Elements that vector loads may read past the end of an array.
inline constexpr std::size_t kPairPadding = 16;
/// Materials of one solver.
inline constexpr std::size_t kMostMaterials = 4;

/// A row of cells along x: its particles lie in `bins` quarter cells from firstBin on, which are numbered
/// from `start`.
struct FlowRow {
  std::int32_t firstBin;  ///< quarter cell, may be negative
  std::int32_t lastBin;   ///< below firstBin where the row is empty
  std::uint32_t start;    ///< number of the first bin among all rows'
};

/// Rows of cells round the particles that are there: only rows are stored for the whole box, and bins only
/// along the occupied part of each. x fastest, so the cells of a row are contiguous and 27 cells are 9
/// ranges.
struct FlowGrid {
  std::int32_t lowY = 0, lowZ = 0;                     ///< cell of row 0
  std::int32_t cellsY = 0, cellsZ = 0;                 ///< rows
  std::int32_t periodX = 0, periodY = 0, periodZ = 0;  ///< cells of a periodic axis (3 or more), else 0

  bool morton = false;  ///< order of the rows' bins, see rankOf()

  SPIN_HD_INLINE std::int32_t rows() const { return cellsY * cellsZ; }
  SPIN_HD_INLINE std::int32_t rowOf(std::int32_t y, std::int32_t z) const {
    return ((z >> kCellBits) - lowZ) * cellsY + (y >> kCellBits) - lowY;
  }

  /// Bins are numbered row by row in the order of ranks. In the linear order that is the row's number. In
  /// Morton's (1966) it follows a Z-curve within tiles of kTileRows x kTileRows rows, so that neighbouring
  /// rows are near in memory too; whole tiles follow each other linearly, so a long, narrow box pays for no
  /// square round it.
  static constexpr std::int32_t kTileBits = 3, kTileRows = 1 << kTileBits;
  SPIN_HD_INLINE std::int32_t tilesY() const { return (cellsY + kTileRows - 1) >> kTileBits; }
  SPIN_HD_INLINE std::int32_t ranks() const {
    return morton ? (tilesY() * ((cellsZ + kTileRows - 1) >> kTileBits)) << (2 * kTileBits) : rows();
  }
  SPIN_HD_INLINE std::int32_t rankOf(std::int32_t row) const {
    if (!morton) return row;
    const std::int32_t z = row / cellsY, y = row - z * cellsY;
    std::int32_t curve = 0;
    for (std::int32_t bit = 0; bit < kTileBits; ++bit)
      curve |= ((y >> bit & 1) << (2 * bit)) | ((z >> bit & 1) << (2 * bit + 1));
    return (((z >> kTileBits) * tilesY() + (y >> kTileBits)) << (2 * kTileBits)) + curve;
  }
  /// Row of a rank; -1 where a tile reaches beyond the rows.
  SPIN_HD_INLINE std::int32_t rowAtRank(std::int32_t rank) const {
    if (!morton) return rank;
    const std::int32_t tile = rank >> (2 * kTileBits), tiles = tilesY();
    std::int32_t y = tile % tiles << kTileBits, z = tile / tiles << kTileBits;
    for (std::int32_t bit = 0; bit < kTileBits; ++bit) {
      y |= (rank >> (2 * bit) & 1) << bit;
      z |= (rank >> (2 * bit + 1) & 1) << bit;
    }
    return y < cellsY && z < cellsZ ? z * cellsY + y : -1;
  }
};

/// What a pair needs of its second partner, in one stretch of memory.
struct PairRecord {
  float vx, vy, vz;    ///< m/s
  float pressureTerm;  ///< p / (1 + excess)^2, Pa
  float viscosity;     ///< Pa s
  float restDensity;   ///< kg/m3
};

/// What a particle carries that pairs do not need.
struct ParticleExtra {
  std::int16_t restX, restY, restZ;  ///< position below a unit, in 2^-16 units
  std::uint8_t material;             ///< index into FlowConstants::material
  std::uint8_t flags;                ///< kDead, kNearWall
};
inline constexpr std::uint8_t kDead = 1;      ///< left the domain, or taken out
inline constexpr std::uint8_t kNearWall = 2;  ///< a solid is within reach
inline constexpr std::uint8_t kSunk = 4;      ///< dead by a sink
inline constexpr std::uint8_t kTaken = 8;     ///< dead by FlowSolver::exchange
/// Shares of a particle's mass that it has given away are whole numbers of this: their sums are exact.
inline constexpr double kGivenUnit = 1.0 / (1 << 30);

struct FlowMaterial {
  Rheology rheology;
  float restDensity = 1000;  ///< kg/m3
  float soundSpeed = 1;      ///< m/s
  bool tait = false;         ///< else linear
  float tension = 0;         ///< Pa that it bears
};

/// What does not change from pair to pair. h is the support radius, V0 = spacing^3.
struct FlowConstants {
  float densityFactor = 0;                         ///< V0 norm / h^3
  float gradientFactor = 0;                        ///< V0 norm / h^4: times slopeOverQ times offset/h
  float viscousFactor = 0;                         ///< V0 norm / h^5 over the lattice's own factor
  float pairDrag = 1;                              ///< share of the viscosity that acts in the force pass
  float diffusionFactor = 0;                       ///< 2 delta (h/2) c V0 norm / h^5
  float soundFactor = 0;                           ///< 2 c^2 V0 norm / h^5, times the step: see DensityRate
  float aloneRate = 0;                             ///< of what a particle without others forgets, 1/s
  float smoothFactor = 0;                          ///< XSPH's c V0 norm / h^3; 0 = off
  float support = 1;                               ///< h, m
  float spacing = 1;                               ///< m
  float layer = 0.5f;                              ///< spacing / h
  float unitsPerMetre = 1;                         ///< kCellUnits / h
  float timeStep = 0;                              ///< s
  float gravityX = 0, gravityY = 0, gravityZ = 0;  ///< m/s2
  float windX = 0, windY = 0, windZ = 0;           ///< m/s
  float windDrag = 0;                              ///< 1/m: acceleration = windDrag |w - v| (w - v)
  float restX = 0, restY = 0, restZ = 0;  ///< gradient of the excess in fluid at rest, per support: g h / c^2
  bool clampTension = true;               ///< no more tension than materials bear
  bool leapFrog = false;                  ///< else semi-implicit Euler
  FlowMaterial material[kMostMaterials];
};

/// All that a kernel touches. Arrays are sorted by row, then by quarter cell along x.
struct FlowView {
  std::uint32_t count = 0;
  std::int32_t *x = nullptr, *y = nullptr, *z = nullptr;
  PairRecord* record = nullptr;
  float* excess = nullptr;  ///< rho / rho0 - 1; by summation, between density and pressure the bare pair sum
  float* rate = nullptr;    ///< of excess, by continuity, 1/s; null = density by summation
  float *ax = nullptr, *ay = nullptr, *az = nullptr;  ///< acceleration by neighbours, m/s2
  float *sx = nullptr, *sy = nullptr, *sz = nullptr;  ///< XSPH's change of velocity, m/s; null = off
  float* shearRate = nullptr;                         ///< 1/s; null where no material needs it
  float* wallViscosity = nullptr;  ///< mean of a particle and the wall that holds it, Pa s; as shearRate
  float* bodyRate = nullptr;  ///< rate of the excess by bodies in an implicit solve, 1/s; null without bodies
  ParticleExtra* extra = nullptr;
  std::int32_t* given = nullptr;  ///< kGivenUnit; null while no particle has given anything
  std::uint32_t* id = nullptr;
  std::uint32_t* key = nullptr;
  FlowRow* rows = nullptr;
  std::uint32_t* binStart = nullptr;  ///< first particle of each bin, and one past the last
  FlowGrid grid;
  std::int32_t domainX = 0, domainY = 0, domainZ = 0;  ///< end of the domain, units; it begins at 0
  FlowConstants constants;
  WallView walls;
  SinkView sinks;
  std::uint32_t* neighbours = nullptr;  ///< within the support; null unless sampled
  StressRecord* stress = nullptr;       ///< null = viscosity is pairwise
  PressureSolveView pressureSolve;
  ViscousSolveView viscousSolve;
  GroundContact* ground = nullptr;  ///< found once a step, since every stage asks for it; null without ground

  /// Calls visit(WallContact) for every solid within the support of particle i.
  template <class Visit>
  SPIN_HD_INLINE void nearWalls(std::size_t i, const Visit& visit) const {
    const float metres = 1.0f / constants.unitsPerMetre;
    walls.near(static_cast<float>(x[i]) * metres, static_cast<float>(y[i]) * metres,
               static_cast<float>(z[i]) * metres, constants.support, ground ? ground[i] : GroundContact{},
               visit);
  }
};

}  // namespace spin
