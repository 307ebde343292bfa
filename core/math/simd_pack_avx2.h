// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "core/base/host_device.h"

namespace spin::SPIN_ISA {

inline constexpr int kLanes = 8;

/// Eight floats.
struct Pack {
  __m256 v;
  Pack() = default;
  SPIN_HD_INLINE Pack(__m256 raw) : v(raw) {}
  SPIN_HD_INLINE explicit Pack(float s) : v(_mm256_set1_ps(s)) {}
  SPIN_HD_INLINE static Pack broadcast(const float* p) { return _mm256_broadcast_ss(p); }
  SPIN_HD_INLINE static Pack load(const float* p) { return _mm256_loadu_ps(p); }
  SPIN_HD_INLINE void store(float* p) const { _mm256_storeu_ps(p, v); }
};

SPIN_HD_INLINE Pack operator+(Pack a, Pack b) {
  return _mm256_add_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator-(Pack a, Pack b) {
  return _mm256_sub_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator-(Pack a) {
  return _mm256_xor_ps(a.v, _mm256_set1_ps(-0.0f));
}
SPIN_HD_INLINE Pack operator*(Pack a, Pack b) {
  return _mm256_mul_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack operator/(Pack a, Pack b) {
  return _mm256_div_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack mulAdd(Pack a, Pack b, Pack c) {
  return _mm256_fmadd_ps(a.v, b.v, c.v);
}
SPIN_HD_INLINE Pack squareRoot(Pack a) {
  return _mm256_sqrt_ps(a.v);
}
SPIN_HD_INLINE Pack minimum(Pack a, Pack b) {
  return _mm256_min_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack maximum(Pack a, Pack b) {
  return _mm256_max_ps(a.v, b.v);
}
SPIN_HD_INLINE Pack selectLess(Pack a, Pack b, Pack x, Pack y) {
  return _mm256_blendv_ps(y.v, x.v, _mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ));
}
/// One bit per lane: a < b.
SPIN_HD_INLINE std::uint32_t lessBits(Pack a, Pack b) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)));
}

/// Eight 32-bit integers; sums and differences wrap round.
struct IntPack {
  __m256i v;
  IntPack() = default;
  SPIN_HD_INLINE IntPack(__m256i raw) : v(raw) {}
  SPIN_HD_INLINE explicit IntPack(std::int32_t s) : v(_mm256_set1_epi32(s)) {}
  SPIN_HD_INLINE static IntPack load(const std::int32_t* p) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(p));
  }
  SPIN_HD_INLINE static IntPack iota() { return _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7); }
};

SPIN_HD_INLINE IntPack operator+(IntPack a, IntPack b) {
  return _mm256_add_epi32(a.v, b.v);
}
SPIN_HD_INLINE IntPack operator-(IntPack a, IntPack b) {
  return _mm256_sub_epi32(a.v, b.v);
}
SPIN_HD_INLINE IntPack operator*(IntPack a, IntPack b) {
  return _mm256_mullo_epi32(a.v, b.v);
}
SPIN_HD_INLINE Pack toFloat(IntPack a) {
  return _mm256_cvtepi32_ps(a.v);
}
/// Towards zero.
SPIN_HD_INLINE IntPack toInt(Pack a) {
  return _mm256_cvttps_epi32(a.v);
}
/// p[index], lane by lane.
SPIN_HD_INLINE Pack gather(const float* p, IntPack index) {
  return _mm256_i32gather_ps(p, index.v, 4);
}
/// Every second of 2 kLanes floats, from the first one on.
SPIN_HD_INLINE Pack loadEven(const float* p) {
  const __m256 mixed = _mm256_shuffle_ps(_mm256_loadu_ps(p), _mm256_loadu_ps(p + 8), 0x88);
  return _mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(mixed), 0xD8));
}
/// Sums of neighbours p[2 l] + p[2 l + 1].
SPIN_HD_INLINE Pack loadPairSums(const float* p) {
  const __m256 mixed = _mm256_hadd_ps(_mm256_loadu_ps(p), _mm256_loadu_ps(p + 8));
  return _mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(mixed), 0xD8));
}
/// p[l / 2].
SPIN_HD_INLINE Pack loadDoubled(const float* p) {
  const __m256i order = _mm256_setr_epi32(0, 0, 1, 1, 2, 2, 3, 3);
  return _mm256_permutevar8x32_ps(_mm256_castps128_ps256(_mm_loadu_ps(p)), order);
}

/// Smallest lane.
SPIN_HD_INLINE std::int32_t lowest(IntPack a) {
  __m128i m = _mm_min_epi32(_mm256_castsi256_si128(a.v), _mm256_extracti128_si256(a.v, 1));
  m = _mm_min_epi32(m, _mm_shuffle_epi32(m, 0x4E));
  m = _mm_min_epi32(m, _mm_shuffle_epi32(m, 0xB1));
  return _mm_cvtsi128_si32(m);
}
/// Largest lane.
SPIN_HD_INLINE std::int32_t highest(IntPack a) {
  __m128i m = _mm_max_epi32(_mm256_castsi256_si128(a.v), _mm256_extracti128_si256(a.v, 1));
  m = _mm_max_epi32(m, _mm_shuffle_epi32(m, 0x4E));
  m = _mm_max_epi32(m, _mm_shuffle_epi32(m, 0xB1));
  return _mm_cvtsi128_si32(m);
}

struct CompressTable {
  alignas(32) std::int32_t lanes[256][8];
};

/// For each bit pattern, the lanes that are set, in order.
constexpr CompressTable makeCompressTable() {
  CompressTable table{};
  for (int bits = 0; bits < 256; ++bits) {
    int count = 0;
    for (int lane = 0; lane < 8; ++lane)
      if (bits >> lane & 1) table.lanes[bits][count++] = lane;
  }
  return table;
}
inline constexpr CompressTable kCompressTable = makeCompressTable();

/// Moves the lanes whose bit is set to the front; the rest is unspecified.
class Compressor {
 public:
  SPIN_HD_INLINE explicit Compressor(std::uint32_t bits)
      : m_lanes(_mm256_load_si256(reinterpret_cast<const __m256i*>(kCompressTable.lanes[bits]))),
        m_count(static_cast<std::uint32_t>(_mm_popcnt_u32(bits))) {}
  SPIN_HD_INLINE void store(Pack a, float* p) const {
    _mm256_storeu_ps(p, _mm256_permutevar8x32_ps(a.v, m_lanes));
  }
  SPIN_HD_INLINE void store(IntPack a, std::int32_t* p) const {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), _mm256_permutevar8x32_epi32(a.v, m_lanes));
  }

  SPIN_HD_INLINE std::uint32_t count() const { return m_count; }

 private:
  __m256i m_lanes;
  std::uint32_t m_count;
};

}  // namespace spin::SPIN_ISA
