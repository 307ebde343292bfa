// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "core/base/host_device.h"

namespace spin {

/// target = min(target, value) from many threads; the result does not depend on their order.
SPIN_HD_INLINE void lowerTo(std::int32_t& target, std::int32_t value) {
#if defined(__CUDA_ARCH__)
  if (target > value) atomicMin(&target, value);
#else
  std::atomic_ref<std::int32_t> shared(target);
  std::int32_t known = shared.load(std::memory_order_relaxed);
  while (known > value && !shared.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
  }
#endif
}

/// target = max(target, value) from many threads.
SPIN_HD_INLINE void raiseTo(std::int32_t& target, std::int32_t value) {
#if defined(__CUDA_ARCH__)
  if (target < value) atomicMax(&target, value);
#else
  std::atomic_ref<std::int32_t> shared(target);
  std::int32_t known = shared.load(std::memory_order_relaxed);
  while (known < value && !shared.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
  }
#endif
}

}  // namespace spin
