// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The loop over bricks on the processor; included once by each air_loop_isa_*.cpp with SPIN_ISA set. Lanes
// are neighbours along x.
#include "core/air/air_loop.h"
#include "core/air/air_passes.h"
#include "core/math/simd_pack.h"
#include "core/sim/air_part.h"

namespace spin::SPIN_ISA {
namespace {

struct PackAt {
  using Real = Pack;
  using Int = IntPack;
  static constexpr int kWidth = kLanes;
  int index = 0, x = 0, y = 0, z = 0;

  SPIN_HD_INLINE Pack load(const float* p, int offset = 0) const { return Pack::load(p + index + offset); }
  SPIN_HD_INLINE void store(Pack value, float* p) const { value.store(p + index); }
  SPIN_HD_INLINE Pack lanesX() const { return toFloat(IntPack(x) + IntPack::iota()); }
  SPIN_HD_INLINE static Pack even(const float* p) { return loadEven(p); }
  SPIN_HD_INLINE static Pack pairSum(const float* p) { return loadPairSums(p); }
  SPIN_HD_INLINE Pack doubled(const float* row) const { return loadDoubled(row + (x >> 1)); }
};

/// `broken` is 0 while all is finite: no maximum keeps what is not a number.
template <class Pass>
SPIN_HD_INLINE void runRow(const Pass& pass, const PackAt& at, Pack& value, Pack& broken) {
  if constexpr (Pass::kResult == AirResult::None) {
    pass(at);
  } else if constexpr (Pass::kResult == AirResult::Sum) {
    value = value + pass(at);
  } else {
    const Pack now = pass(at);
    value = maximum(value, now);
    broken = broken + (now - now);
  }
}

SPIN_HD_INLINE double combined(Pack value, AirResult result) {
  float lanes[kLanes];
  value.store(lanes);
  double total = 0.0;
  for (const float lane : lanes) {
    const double v = static_cast<double>(lane);
    total = result == AirResult::Sum ? total + v : (v > total ? v : total);
  }
  return total;
}

/// What thins out towards the rim of a cloud ends among numbers that are not normalised, with which
/// processors are a hundred times slower: they count as 0 while a pass runs.
class FlushTiny {
 public:
  FlushTiny() : m_before(_mm_getcsr()) { _mm_setcsr(m_before | kFlushResults | kFlushInputs); }
  ~FlushTiny() { _mm_setcsr(m_before); }
  FlushTiny(const FlushTiny&) = delete;
  FlushTiny& operator=(const FlushTiny&) = delete;

 private:
  static constexpr unsigned kFlushResults = 0x8000, kFlushInputs = 0x0040;
  unsigned m_before;
};

}  // namespace

template <class Pass>
void runAirPass(const Pass& given, AirStrides strides, const AirBrick* bricks, std::size_t begin,
                std::size_t end, double* results) {
  const FlushTiny flush;
  const Pass pass = given;  // a copy that no store can reach, so that its pointers stay in registers
  for (std::size_t b = begin; b < end; ++b) {
    const AirBrick brick = bricks[b];
    Pack value(0.0f), broken(0.0f);
    for (int z = 0; z < kBrickZ; ++z)
      for (int y = 0; y < kBrickY; ++y)
        for (int x = 0; x < kBrickX; x += kLanes)
          runRow(
              pass,
              PackAt{brick.first + z * strides.z + y * strides.y + x, brick.x + x, brick.y + y, brick.z + z},
              value, broken);
    if constexpr (Pass::kResult != AirResult::None)
      results[b] = combined(value, Pass::kResult) + combined(broken, AirResult::Sum);
  }
}

#define SPIN_AIR_INSTANCE(Pass) \
  template void runAirPass<Pass>(const Pass&, AirStrides, const AirBrick*, std::size_t, std::size_t, double*);
SPIN_AIR_PASSES(SPIN_AIR_INSTANCE)
#undef SPIN_AIR_INSTANCE

}  // namespace spin::SPIN_ISA
