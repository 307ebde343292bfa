// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <emmintrin.h>

#include <cstdint>

#include "core/base/host_device.h"

namespace spin::SPIN_ISA {

inline constexpr int kLanes = 4;

/// Four floats; SSE2, which every x86-64 processor has.
struct Pack {
  __m128 v;
  Pack() = default;
  SPIN_HD_INLINE Pack(__m128 raw) : v(raw) {}
  SPIN_HD_INLINE explicit Pack(float s) : v(_mm_set1_ps(s)) {}
  SPIN_HD_INLINE static Pack broadcast(const float* p) { return _mm_set1_ps(*p); }
  SPIN_HD_INLINE static Pack load(const float* p) { return _mm_loadu_ps(p); }
  SPIN_HD_INLINE void store(float* p) const { _mm_storeu_ps(p, v); }
};

SPIN_HD_INLINE Pack operator+(Pack a, Pack b) {
  return _mm_add_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator-(Pack a, Pack b) {
  return _mm_sub_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator-(Pack a) {
  return _mm_xor_ps(a.v, _mm_set1_ps(-0.0f));
}
SPIN_HD_INLINE Pack operator*(Pack a, Pack b) {
  return _mm_mul_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator/(Pack a, Pack b) {
  return _mm_div_ps(a.v, b.v);
}
/// Two roundings: SSE2 has no fused form.
SPIN_HD_INLINE Pack mulAdd(Pack a, Pack b, Pack c) {
  return _mm_add_ps(_mm_mul_ps(a.v, b.v), c.v);
}
SPIN_HD_INLINE Pack squareRoot(Pack a) {
  return _mm_sqrt_ps(a.v);
}
SPIN_HD_INLINE Pack minimum(Pack a, Pack b) {
  return _mm_min_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack maximum(Pack a, Pack b) {
  return _mm_max_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack selectLess(Pack a, Pack b, Pack x, Pack y) {
  const __m128 mask = _mm_cmplt_ps(a.v, b.v);
  return _mm_or_ps(_mm_and_ps(mask, x.v), _mm_andnot_ps(mask, y.v));
}
/// One bit per lane: a < b.
SPIN_HD_INLINE std::uint32_t lessBits(Pack a, Pack b) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmplt_ps(a.v, b.v)));
}

/// Four 32-bit integers; sums and differences wrap round.
struct IntPack {
  __m128i v;
  IntPack() = default;
  SPIN_HD_INLINE IntPack(__m128i raw) : v(raw) {}
  SPIN_HD_INLINE explicit IntPack(std::int32_t s) : v(_mm_set1_epi32(s)) {}
  SPIN_HD_INLINE static IntPack load(const std::int32_t* p) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
  }
  SPIN_HD_INLINE static IntPack iota() { return _mm_setr_epi32(0, 1, 2, 3); }
};

SPIN_HD_INLINE IntPack operator+(IntPack a, IntPack b) {
  return _mm_add_epi32(a.v, b.v);
}
SPIN_HD_INLINE IntPack operator-(IntPack a, IntPack b) {
  return _mm_sub_epi32(a.v, b.v);
}
/// SSE2 multiplies every second lane.
SPIN_HD_INLINE IntPack operator*(IntPack a, IntPack b) {
  const __m128i even = _mm_mul_epu32(a.v, b.v);
  const __m128i odd = _mm_mul_epu32(_mm_srli_epi64(a.v, 32), _mm_srli_epi64(b.v, 32));
  return _mm_unpacklo_epi32(_mm_shuffle_epi32(even, 0x08), _mm_shuffle_epi32(odd, 0x08));
}
SPIN_HD_INLINE Pack toFloat(IntPack a) {
  return _mm_cvtepi32_ps(a.v);
}
/// Towards zero.
SPIN_HD_INLINE IntPack toInt(Pack a) {
  return _mm_cvttps_epi32(a.v);
}
/// p[index], lane by lane.
SPIN_HD_INLINE Pack gather(const float* p, IntPack index) {
  alignas(16) std::int32_t lane[4];
  _mm_store_si128(reinterpret_cast<__m128i*>(lane), index.v);
  return _mm_setr_ps(p[lane[0]], p[lane[1]], p[lane[2]], p[lane[3]]);
}
/// Every second of 2 kLanes floats, from the first one on.
SPIN_HD_INLINE Pack loadEven(const float* p) {
  return _mm_shuffle_ps(_mm_loadu_ps(p), _mm_loadu_ps(p + 4), 0x88);
}
/// Sums of neighbours p[2 l] + p[2 l + 1].
SPIN_HD_INLINE Pack loadPairSums(const float* p) {
  const __m128 low = _mm_loadu_ps(p), high = _mm_loadu_ps(p + 4);
  return _mm_add_ps(_mm_shuffle_ps(low, high, 0x88), _mm_shuffle_ps(low, high, 0xDD));
}
/// p[l / 2].
SPIN_HD_INLINE Pack loadDoubled(const float* p) {
  const __m128 pair = _mm_castpd_ps(_mm_load_sd(reinterpret_cast<const double*>(p)));
  return _mm_unpacklo_ps(pair, pair);
}
/// Smallest lane.
SPIN_HD_INLINE std::int32_t lowest(IntPack a) {
  alignas(16) std::int32_t lane[4];
  _mm_store_si128(reinterpret_cast<__m128i*>(lane), a.v);
  const std::int32_t low = lane[0] < lane[1] ? lane[0] : lane[1];
  const std::int32_t high = lane[2] < lane[3] ? lane[2] : lane[3];
  return low < high ? low : high;
}
/// Largest lane.
SPIN_HD_INLINE std::int32_t highest(IntPack a) {
  alignas(16) std::int32_t lane[4];
  _mm_store_si128(reinterpret_cast<__m128i*>(lane), a.v);
  const std::int32_t low = lane[0] > lane[1] ? lane[0] : lane[1];
  const std::int32_t high = lane[2] > lane[3] ? lane[2] : lane[3];
  return low > high ? low : high;
}

/// Moves the lanes whose bit is set to the front; the rest is unspecified.
class Compressor {
 public:
  SPIN_HD_INLINE explicit Compressor(std::uint32_t bits) : m_bits(bits) {}
  SPIN_HD_INLINE void store(Pack a, float* p) const {
    alignas(16) float lane[4];
    _mm_store_ps(lane, a.v);
    move(lane, p);
  }
  SPIN_HD_INLINE void store(IntPack a, std::int32_t* p) const {
    alignas(16) std::int32_t lane[4];
    _mm_store_si128(reinterpret_cast<__m128i*>(lane), a.v);
    move(lane, p);
  }
  SPIN_HD_INLINE std::uint32_t count() const {
    return (m_bits & 1) + (m_bits >> 1 & 1) + (m_bits >> 2 & 1) + (m_bits >> 3 & 1);
  }

 private:
  template <class T>
  SPIN_HD_INLINE void move(const T* lane, T* p) const {
    // Every lane is written and the place advances only past those that stay: no branch to mispredict.
    for (int l = 0; l < 4; ++l) {
      *p = lane[l];
      p += m_bits >> l & 1;
    }
  }
  std::uint32_t m_bits;
};

}  // namespace spin::SPIN_ISA
