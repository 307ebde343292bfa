// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "core/base/host_device.h"

namespace spin::SPIN_ISA {

inline constexpr int kLanes = 16;

/// Sixteen floats.
struct Pack {
  __m512 v;
  Pack() = default;
  SPIN_HD_INLINE Pack(__m512 raw) : v(raw) {}
  SPIN_HD_INLINE explicit Pack(float s) : v(_mm512_set1_ps(s)) {}
  SPIN_HD_INLINE static Pack broadcast(const float* p) { return _mm512_set1_ps(*p); }
  SPIN_HD_INLINE static Pack load(const float* p) { return _mm512_loadu_ps(p); }
  SPIN_HD_INLINE void store(float* p) const { _mm512_storeu_ps(p, v); }
};

SPIN_HD_INLINE Pack operator+(Pack a, Pack b) {
  return _mm512_add_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator-(Pack a, Pack b) {
  return _mm512_sub_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator-(Pack a) {
  return _mm512_xor_ps(a.v, _mm512_set1_ps(-0.0f));
}
SPIN_HD_INLINE Pack operator*(Pack a, Pack b) {
  return _mm512_mul_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator/(Pack a, Pack b) {
  return _mm512_div_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack mulAdd(Pack a, Pack b, Pack c) {
  return _mm512_fmadd_ps(a.v, b.v, c.v);
}
SPIN_HD_INLINE Pack squareRoot(Pack a) {
  return _mm512_sqrt_ps(a.v);
}
SPIN_HD_INLINE Pack minimum(Pack a, Pack b) {
  return _mm512_min_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack maximum(Pack a, Pack b) {
  return _mm512_max_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack selectLess(Pack a, Pack b, Pack x, Pack y) {
  return _mm512_mask_blend_ps(_mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ), y.v, x.v);
}
/// One bit per lane: a < b.
SPIN_HD_INLINE std::uint32_t lessBits(Pack a, Pack b) {
  return _mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ);
}

/// Sixteen 32-bit integers; sums and differences wrap round.
struct IntPack {
  __m512i v;
  IntPack() = default;
  SPIN_HD_INLINE IntPack(__m512i raw) : v(raw) {}
  SPIN_HD_INLINE explicit IntPack(std::int32_t s) : v(_mm512_set1_epi32(s)) {}
  SPIN_HD_INLINE static IntPack load(const std::int32_t* p) { return _mm512_loadu_si512(p); }
  SPIN_HD_INLINE static IntPack iota() {
    return _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
  }
};

SPIN_HD_INLINE IntPack operator+(IntPack a, IntPack b) {
  return _mm512_add_epi32(a.v, b.v);
}
SPIN_HD_INLINE IntPack operator-(IntPack a, IntPack b) {
  return _mm512_sub_epi32(a.v, b.v);
}
SPIN_HD_INLINE IntPack operator*(IntPack a, IntPack b) {
  return _mm512_mullo_epi32(a.v, b.v);
}
SPIN_HD_INLINE Pack toFloat(IntPack a) {
  return _mm512_cvtepi32_ps(a.v);
}
/// Towards zero.
SPIN_HD_INLINE IntPack toInt(Pack a) {
  return _mm512_cvttps_epi32(a.v);
}
/// p[index], lane by lane.
SPIN_HD_INLINE Pack gather(const float* p, IntPack index) {
  return _mm512_i32gather_ps(index.v, p, 4);
}
/// Every second of 2 kLanes floats, from the first one on.
SPIN_HD_INLINE Pack loadEven(const float* p) {
  const __m512i order = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  return _mm512_permutex2var_ps(_mm512_loadu_ps(p), order, _mm512_loadu_ps(p + 16));
}
/// Sums of neighbours p[2 l] + p[2 l + 1].
SPIN_HD_INLINE Pack loadPairSums(const float* p) {
  const __m512i order = _mm512_setr_epi32(1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
  const __m512i even = _mm512_sub_epi32(order, _mm512_set1_epi32(1));
  const __m512 low = _mm512_loadu_ps(p), high = _mm512_loadu_ps(p + 16);
  return _mm512_add_ps(_mm512_permutex2var_ps(low, even, high), _mm512_permutex2var_ps(low, order, high));
}
/// p[l / 2].
SPIN_HD_INLINE Pack loadDoubled(const float* p) {
  const __m512i order = _mm512_setr_epi32(0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7);
  return _mm512_permutexvar_ps(order, _mm512_castps256_ps512(_mm256_loadu_ps(p)));
}
/// Smallest lane.
SPIN_HD_INLINE std::int32_t lowest(IntPack a) {
  return _mm512_reduce_min_epi32(a.v);
}
/// Largest lane.
SPIN_HD_INLINE std::int32_t highest(IntPack a) {
  return _mm512_reduce_max_epi32(a.v);
}

/// Moves the lanes whose bit is set to the front; the rest is unspecified.
class Compressor {
 public:
  SPIN_HD_INLINE explicit Compressor(std::uint32_t bits) : m_mask(static_cast<__mmask16>(bits)) {}
  SPIN_HD_INLINE void store(Pack a, float* p) const {
    _mm512_storeu_ps(p, _mm512_maskz_compress_ps(m_mask, a.v));
  }
  SPIN_HD_INLINE void store(IntPack a, std::int32_t* p) const {
    _mm512_storeu_si512(p, _mm512_maskz_compress_epi32(m_mask, a.v));
  }

  SPIN_HD_INLINE std::uint32_t count() const { return static_cast<std::uint32_t>(_mm_popcnt_u32(m_mask)); }

 private:
  __mmask16 m_mask;
};

}  // namespace spin::SPIN_ISA
