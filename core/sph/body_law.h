// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/body_view.h"
#include "core/sph/flow_kernels.h"

/// What happens between a flow particle and a boundary particle, seen from either: the same numbers with the
/// other sign, so the momentum of flow and bodies together is kept to rounding.
namespace spin {

/// Calls visit(offset, j) for every boundary particle within a support of flow particle i; offset x_j - x_i
/// in supports.
template <class Visit>
SPIN_HD_INLINE void forBoundaryNear(const FlowView& v, const FlowView& boundary, std::size_t i,
                                    const Visit& visit) {
  constexpr float kToSupport = 1.0f / static_cast<float>(kCellUnits);
  forRowRanges(
      boundary, v.y[i] >> kCellBits, v.z[i] >> kCellBits, v.x[i], v.x[i], [&](const RowRange& range) {
        for (std::uint32_t j = range.begin; j < range.end; ++j) {
          const PairVector<float> d{static_cast<float>(boundary.x[j] + range.shiftX - v.x[i]) * kToSupport,
                                    static_cast<float>(boundary.y[j] + range.shiftY - v.y[i]) * kToSupport,
                                    static_cast<float>(boundary.z[j] + range.shiftZ - v.z[i]) * kToSupport};
          if (d.x * d.x + d.y * d.y + d.z * d.z < 1.0f) visit(d, j);
        }
      });
}

/// The implicit pressure mirrors the flow in bodies: they have the particle's pressure and its velocity with
/// the normal part turned round, so they count twice in the constraint's gradient. Counted once, the first
/// layer would carry its column with twice the pressure.
inline constexpr float kSolveMirror = 2.0f;

/// P_i + p_b of a pair: the body's pressure is the particle's, continued hydrostatically to the boundary
/// particle and never below 0, as at walls (pressure mirroring: Akinci et al. 2012). `pressure` is p_i,
/// `toBody` x_b - x_i in supports.
/// Where the pressure is solved for, the body's is the particle's, as the solve has it.
SPIN_HD_INLINE float bodyPush(const FlowView& v, float pressureTerm, float pressure, float restDensity,
                              const PairVector<float>& toBody) {
  if (v.pressureSolve.pressure) return kSolveMirror * pressureTerm;
  const FlowConstants& c = v.constants;
  const float rise =
      c.support * (c.gravityX * toBody.x + c.gravityY * toBody.y + c.gravityZ * toBody.z) * restDensity;
  return pressureTerm + maximum(pressure + rise, 0.0f);
}

/// Pressure force of a pair on the flow particle, N, without the boundary particle's volume: V0
/// gradientFactor (P_i + p_b) slope, to be multiplied with the offset to the other partner.
SPIN_HD_INLINE float bodyForceScale(const FlowConstants& c, float push, float slope) {
  return c.gradientFactor * push * slope;
}

/// Weight of a boundary particle in what its surface does along itself.
SPIN_HD_INLINE float bodyWeight(float volume, float slope) {
  return -volume * slope;
}

/// No step brings a flow particle nearer to a boundary particle than this, spacings: balls of that size about
/// boundary particles a spacing apart leave no hole. Particles that press on each other stay a spacing off.
inline constexpr float kClosestToBoundary = 0.75f;

/// The wall lies in the middle between a particle that touches it and the boundary particle inside: the
/// velocity extrapolated to there (Takeda et al. 1994) doubles the difference.
inline constexpr float kBodyMirror = 2.0f;

}  // namespace spin
