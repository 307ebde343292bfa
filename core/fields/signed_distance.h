// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/result.h"
#include "core/fields/signed_distance_view.h"
#include "core/fields/triangle_mesh.h"

namespace spin {

struct SignedDistanceOptions {
  double cell = 0.0;   ///< m; > 0
  double reach = 0.0;  ///< distances are kept up to here on both sides, m; > 0
  /// A solid thinner than this, and a sheet of no thickness, acts as one of this thickness about its middle,
  /// m: what comes from either side is stopped, and both sides are kept apart. 0 = as it is.
  double leastThickness = 0.0;
  double mostBytes = 2e9;  ///< a field larger than this is refused before memory is taken
  int threads = 0;         ///< <= 0: all; the values do not depend on it
  CancelToken cancel;
};

/// Signed distance of the union of a mesh's solids: closed shells are solid inside, open ones are sheets.
/// Stored in blocks of 8^3 cells, only where the surface is within reach; deep inside and far outside a block
/// is one number. Signs are by pseudo-normals (Baerentzen and Aanaes 2005).
class SignedDistance {
 public:
  /// Fails for meshes and options that cannot be, for what needs more than mostBytes, and when cancelled.
  static Result<std::shared_ptr<const SignedDistance>> make(const TriangleMesh& mesh,
                                                            const SignedDistanceOptions& options);

  /// For positions relative to `origin` (world m). The arrays' pointers are the host's.
  SignedDistanceView view(Vec3d origin) const;
  const std::vector<std::uint32_t>& blocks() const { return m_blocks; }
  const std::vector<float>& values() const { return m_values; }
  double cell() const { return m_cell; }
  double reach() const { return m_reach; }
  std::size_t bytes() const {
    return m_blocks.size() * sizeof(std::uint32_t) + m_values.size() * sizeof(float);
  }

 private:
  friend class SignedDistanceBuilder;
  Vec3d m_origin{};  ///< of the first node, world m
  std::int32_t m_count[3] = {0, 0, 0};
  double m_cell = 1.0, m_reach = 0.0;
  std::vector<std::uint32_t> m_blocks;
  std::vector<float> m_values;
};

}  // namespace spin
