// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/columns.h"
#include "core/base/cpu_features.h"
#include "core/base/parallel.h"
#include "core/fields/particles.h"
#include "core/sim/flakes_part.h"
#include "core/snow/fall_wind.h"
#include "core/snow/flake_groups.h"
#include "core/snow/flake_look.h"

namespace spin {

/// Who looks at the flakes. Without a frustum all flakes round the eye count.
struct FlakeView {
  Vec3d eye{};
  Vec3d forward{0, 1, 0}, right{1, 0, 0}, up{0, 0, 1};  ///< unit vectors
  double tangentX = 0.0, tangentY = 0.0;  ///< of half the angles of view, with a margin; 0 = no frustum
  double share = 1.0;                     ///< of the flakes to show, 0..1
  double leastFade = 1e-3;                ///< fainter flakes do not count; < 0 = all flakes do, in order
  const FallWind* wind = nullptr;         ///< round land and models, of the frame's flakes; null = none
  bool operator==(const FlakeView&) const = default;
};

/// Flakes as seen from a place, array by array (FlakeField's order): only those that show.
struct FlakeRecords {
  std::size_t count = 0;
  Columns<float, kFlakeRecord> values;  ///< by FlakeValue; `count` of each are set

  std::span<const float> operator[](FlakeValue value) const {
    return {values[static_cast<std::size_t>(value)], count};
  }
};

/// What a number of flakes keep for life, and where they are in a frame. A flake's place is a function of
/// film time and of the world alone; the eye only decides which of its copies counts and how far it fades,
/// so a moving camera moves no flake. Places are found for packs of flakes at once, on all threads; the
/// result does not depend on their number.
class FlakeField {
 public:
  /// Draws what the flakes keep: 44 bytes each.
  FlakeField(std::uint64_t seed, const std::vector<FlakeGroup>& groups);
  ~FlakeField();
  /// Whether another seed or numbers of flakes would be the same field; boxes and weights may differ.
  bool fits(std::uint64_t seed, const std::vector<FlakeGroup>& groups) const;

  std::size_t size() const { return m_size; }
  /// Looks at the flakes of a frame. The groups must fit.
  void look(const FallingFlakes& flakes, const std::vector<FlakeGroup>& groups, const FlakeView& view,
            CpuBackend& backend, FlakeRecords& seen, Isa isa = bestIsa()) const;
  /// Place of a flake among the classes.
  double classOf(std::size_t flake) const;

 private:
  struct Seeds;
  void close(const std::vector<std::size_t>& counts, CpuBackend& backend, FlakeRecords& seen) const;

  std::uint64_t m_seed = 0;
  std::vector<std::uint32_t> m_blocks;  ///< by group
  std::size_t m_size = 0;
  std::unique_ptr<Seeds> m_seeds;
};

/// A size of flakes by its place among the classes, between two of them.
FlakeClass flakeAt(const FallingFlakes& flakes, double place);

/// The flakes round a place as particles for export: in view of an eye without a frustum, with velocity,
/// diameter, mass and the number of real flakes that each stands for.
ParticleSet flakesAround(const FallingFlakes& flakes, const SnowfallNode& snowfall, Vec3d eye,
                         CpuBackend& backend);

}  // namespace spin
