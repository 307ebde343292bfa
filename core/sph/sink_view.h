// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"

namespace spin {

inline constexpr std::size_t kMostSinks = 8;

/// Solver's metres. Takes what lies in the box with n . x < offset; a sink without a plane has n = 0 and
/// offset = 1.
struct FlowSink {
  float lowX, lowY, lowZ, highX, highY, highZ;
  float nx, ny, nz, offset;

  SPIN_HD_INLINE bool takes(float x, float y, float z) const {
    return x >= lowX && y >= lowY && z >= lowZ && x <= highX && y <= highY && z <= highZ &&
           nx * x + ny * y + nz * z < offset;
  }
};

struct SinkView {
  FlowSink sinks[kMostSinks] = {};
  std::int32_t count = 0;

  SPIN_HD_INLINE bool take(float x, float y, float z) const {
    bool taken = false;
    for (std::int32_t k = 0; k < count; ++k) taken = taken || sinks[k].takes(x, y, z);
    return taken;
  }
};

}  // namespace spin
