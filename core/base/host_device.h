// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Marks functions that are compiled for the host and, under nvcc, for the device.
#if defined(__CUDACC__)
#define SPIN_HD __host__ __device__
#else
#define SPIN_HD
#endif

// Such a function that is always inlined: it leaves no symbol behind, so a file compiled for a wide
// instruction set cannot lend its body to callers on a processor without it.
#if defined(__CUDACC__)
#define SPIN_HD_INLINE SPIN_HD __forceinline__
#else
#define SPIN_HD_INLINE inline __attribute__((always_inline))
#endif

// On the processor such a function that is never inlined, a copy for each file: what stands behind a hot loop
// keeps its registers out of it.
#if defined(__CUDACC__)
#define SPIN_HD_APART SPIN_HD_INLINE
#else
#define SPIN_HD_APART static inline __attribute__((noinline))
#endif

// Always inlined, for a lambda, after its parameters.
#if defined(__CUDACC__)
#define SPIN_INLINE_LAMBDA
#else
#define SPIN_INLINE_LAMBDA __attribute__((always_inline))
#endif

// Tells the compiler that a loop's iterations are independent; ignored where it has no meaning.
#if defined(__CUDACC__)
#define SPIN_SIMD_LOOP
#else
#define SPIN_SIMD_LOOP _Pragma("GCC ivdep")
#endif
