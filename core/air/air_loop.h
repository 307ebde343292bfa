// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/air/air_lanes.h"
#include "core/base/check.h"
#include "core/base/cpu_features.h"
#include "core/base/parallel.h"

namespace spin {

/// What a pass gives back per brick: nothing, the sum over its cells, or the largest (>= 0). Where one of
/// them is not finite, neither is what comes back.
enum class AirResult : std::uint8_t { None, Sum, Most };

// The loop of each instruction set over bricks [begin, end), defined in air_loop_impl.h.
#define SPIN_AIR_LOOP(isa)                                                                         \
  namespace isa {                                                                                  \
  template <class Pass>                                                                            \
  void runAirPass(const Pass& pass, AirStrides strides, const AirBrick* bricks, std::size_t begin, \
                  std::size_t end, double* results);                                               \
  }
SPIN_AIR_LOOP(isa_baseline)
SPIN_AIR_LOOP(isa_avx2)
SPIN_AIR_LOOP(isa_avx512)
#undef SPIN_AIR_LOOP

/// How a backend goes over bricks; the processor's shares them out among its threads.
template <class Backend>
class AirPasses;

template <>
class AirPasses<CpuBackend> {
 public:
  explicit AirPasses(Isa isa) : m_isa(isa) {
    SPIN_CHECK(cpuRuns(isa), "this processor does not have the instruction set");
  }

  template <class Pass>
  void run(CpuBackend& backend, const char* name, AirStrides strides, const std::vector<AirBrick>& bricks,
           const Pass& pass, double* results = nullptr) {
    constexpr std::size_t kShare = 16;
    const auto loop = loopFor<Pass>();
    backend.forChunks(name, bricks.size(), kShare, [&](std::size_t begin, std::size_t end, std::size_t) {
      loop(pass, strides, bricks.data(), begin, end, results);
    });
  }
  /// Results of the bricks, in their order.
  template <class Pass>
  const std::vector<double>& results(CpuBackend& backend, const char* name, AirStrides strides,
                                     const std::vector<AirBrick>& bricks, const Pass& pass) {
    m_results.resize(bricks.size());
    run(backend, name, strides, bricks, pass, m_results.data());
    return m_results;
  }

 private:
  template <class Pass>
  using Loop = void (*)(const Pass&, AirStrides, const AirBrick*, std::size_t, std::size_t, double*);
  template <class Pass>
  Loop<Pass> loopFor() const {
    if (m_isa == Isa::Avx512) return isa_avx512::runAirPass<Pass>;
    if (m_isa == Isa::Avx2) return isa_avx2::runAirPass<Pass>;
    return isa_baseline::runAirPass<Pass>;
  }

  Isa m_isa;
  std::vector<double> m_results;
};

}  // namespace spin
