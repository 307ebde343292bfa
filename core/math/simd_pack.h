// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Packs of floats and 32-bit integers for files that are compiled for one instruction set. Such a file
// defines SPIN_ISA (the name of its namespace) before including this header, and everything here lands in
// spin::SPIN_ISA: the same template under two sets of compiler flags must not share a symbol.
#ifndef SPIN_ISA
#error "define SPIN_ISA before including core/math/simd_pack.h"
#endif

#if defined(__AVX512F__)
#include "core/math/simd_pack_avx512.h"
#elif defined(__AVX2__)
#include "core/math/simd_pack_avx2.h"
#else
#include "core/math/simd_pack_sse2.h"
#endif
