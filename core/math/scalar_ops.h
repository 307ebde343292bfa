// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"

/// The operations that laws and pair loops are written in, for plain numbers; core/math/simd_pack.h has the
/// same names for packs. Laws choose by selectLess, minimum and maximum instead of `if`, so that one text
/// serves a number, a pack and CUDA.
namespace spin {

SPIN_HD_INLINE double mulAdd(double a, double b, double c) {
  return a * b + c;
}
SPIN_HD_INLINE double squareRoot(double a) {
  return sqrt(a);
}
SPIN_HD_INLINE double minimum(double a, double b) {
  return a < b ? a : b;
}
SPIN_HD_INLINE double maximum(double a, double b) {
  return a > b ? a : b;
}
/// a < b ? x : y
SPIN_HD_INLINE double selectLess(double a, double b, double x, double y) {
  return a < b ? x : y;
}

/// Contracted on the device, where that is one instruction; two roundings on the host.
SPIN_HD_INLINE float mulAdd(float a, float b, float c) {
#if defined(__CUDA_ARCH__)
  return fmaf(a, b, c);
#else
  return a * b + c;
#endif
}
SPIN_HD_INLINE float squareRoot(float a) {
  return sqrtf(a);
}
SPIN_HD_INLINE float minimum(float a, float b) {
  return a < b ? a : b;
}
SPIN_HD_INLINE float maximum(float a, float b) {
  return a > b ? a : b;
}
SPIN_HD_INLINE float selectLess(float a, float b, float x, float y) {
  return a < b ? x : y;
}

/// Towards zero.
SPIN_HD_INLINE int toInt(float a) {
  return static_cast<int>(a);
}
SPIN_HD_INLINE float toFloat(int a) {
  return static_cast<float>(a);
}
SPIN_HD_INLINE float gather(const float* p, int index) {
  return p[index];
}

}  // namespace spin
