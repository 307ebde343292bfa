// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/cpu_features.h"
#include "core/base/result.h"
#include "core/base/timings.h"
#include "core/math/vec.h"

namespace spin {

/// A slice of the particle solver: density by summation, linear state equation, half-space floor, symmetric
/// pressure force, pairwise viscosity, semi-implicit Euler. Support radius: two spacings.
struct SphSliceConfig {
  double spacing = 0.05;        ///< distance of particles at rest, m; > 0
  double restDensity = 1000.0;  ///< kg/m3; > 0
  double soundSpeed = 40.0;     ///< m/s; > 0, about ten times the fastest flow
  double viscosity = 0.0;       ///< Pa s; >= 0
  double gravity = 9.80665;     ///< m/s2, downward
  Vec3d domainMin{};            ///< m; particles may leave the box, the search is fastest inside
  Vec3d domainMax{};            ///< m; along a periodic axis the length is a whole number of supports, >= 3
  bool periodicX = false;
  bool periodicY = false;
  bool floor = true;         ///< solid half-space below domainMin.z
  bool clampTension = true;  ///< no negative pressure

  double support() const { return 2.0 * spacing; }
  double particleMass() const { return restDensity * spacing * spacing * spacing; }
  /// Largest step that stays stable: a quarter spacing at the speed of sound, and the viscous limit.
  double stableTimeStep() const;
};

struct SphParticle {
  Vec3d position{};          ///< m
  Vec3d velocity{};          ///< m/s
  double density = 0.0;      ///< kg/m3
  Vec3d pairAcceleration{};  ///< of the latest step, by neighbours alone, m/s2
};

/// One solver on one device.
class SphSliceSolver {
 public:
  virtual ~SphSliceSolver() = default;
  /// Replaces all particles; velocities may be empty (at rest). Positions finite and within 1024 supports of
  /// domainMin along each axis.
  virtual Status setParticles(const std::vector<Vec3d>& positions, const std::vector<Vec3d>& velocities) = 0;
  /// Advances by timeStep seconds (> 0). Fails where the device does.
  virtual Status step(double timeStep) = 0;
  /// In the order of setParticles.
  virtual std::vector<SphParticle> particles() const = 0;
  virtual StageTimings& timings() = 0;
  /// Memory of all arrays, bytes.
  virtual std::size_t bytes() const = 0;
  /// "cpu" or "cuda".
  virtual const char* device() const = 0;
};

/// On the processor; threads <= 0 takes all. Fails where a value is out of range or the box has more cells
/// than fit.
Result<std::unique_ptr<SphSliceSolver>> makeSphSliceCpu(const SphSliceConfig& config, int threads, Isa isa);

}  // namespace spin
