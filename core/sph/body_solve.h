// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/body_kernels.h"

/// Bodies in the implicit pressure (implicit_passes.h): their boundary particles take part as walls do, and
/// free bodies follow the iterates' pushes, else a body lighter than the flow would swing.
namespace spin {

/// Adds bodies to density and gradient sums; the gradient lies in the acceleration arrays.
struct BodyConstraintKernel {
  FlowView v;
  BodyView b;
  SPIN_HD void operator()(std::size_t k) const {
    const std::uint32_t i = b.list[k];
    float sum = 0.0f;
    PairVector<float> gradient{0.0f, 0.0f, 0.0f};
    forBoundaryNear(v, b.grid, i, [&](const PairVector<float>& d, std::uint32_t j) {
      const float volume = b.record[j].volume, slope = volume * CubicSpline::slopeOverQ(distanceOf(d));
      sum += volume * densityTerm(d);
      gradient.x += slope * d.x;
      gradient.y += slope * d.y;
      gradient.z += slope * d.z;
    });
    const float scale = -kSolveMirror * v.constants.gradientFactor;
    v.excess[i] += sum;
    gradient = {scale * gradient.x, scale * gradient.y, scale * gradient.z};
    v.ax[i] += gradient.x;
    v.ay[i] += gradient.y;
    v.az[i] += gradient.z;
    b.gift[k] = {gradient.x, gradient.y, gradient.z};
  }
};

/// Sizes of the gradients that BodyConstraintKernel left.
SPIN_HD_INLINE float gradientSize(const BodyGift& g) {
  return squareRoot(g.x * g.x + g.y * g.y + g.z * g.z);
}
struct BodyGradientOf {
  BodyView b;
  SPIN_HD double operator()(std::size_t k) const { return static_cast<double>(gradientSize(b.gift[k])); }
};
struct AddNumbers {
  SPIN_HD double operator()(double a, double b) const { return a + b; }
};

/// A pressure near a free body moves that, which changes the rates of all particles near it: for a light body
/// by more than the pressure moves its own particle. The sum of a row of that matrix, V0 |g_i| sum |g_k|
/// times the body's mobility, joins the stiffness, so that the iterates stay bounded at any density.
struct BodyMobilityKernel {
  FlowView v;
  BodyView b;
  float rows;  ///< V0 sum |g_k| times the mobility of the most mobile body, m5/(m3 kg)
  SPIN_HD void operator()(std::size_t k) const {
    v.pressureSolve.compliance[b.list[k]] += rows * gradientSize(b.gift[k]);
  }
};

struct ClearBodyRateKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const { v.bodyRate[i] = 0.0f; }
};

/// Rate of the excess by bodies with the velocities of now.
struct BodyDivergenceKernel {
  FlowView v;
  BodyView b;
  SPIN_HD void operator()(std::size_t k) const {
    const std::uint32_t i = b.list[k];
    const PairRecord& r = v.record[i];
    float sum = 0.0f;
    forBoundaryNear(v, b.grid, i, [&](const PairVector<float>& d, std::uint32_t j) {
      const BodyRecord& w = b.record[j];
      const float approach = (r.vx - w.vx) * d.x + (r.vy - w.vy) * d.y + (r.vz - w.vz) * d.z;
      sum -= w.volume * CubicSpline::slopeOverQ(distanceOf(d)) * approach;
    });
    v.bodyRate[i] = kSolveMirror * v.constants.gradientFactor * sum;
  }
};

/// What an iterate's push does to flow particles near bodies.
struct BodySolvePushKernel {
  FlowView v;
  BodyView b;
  SPIN_HD void operator()(std::size_t k) const {
    const std::uint32_t i = b.list[k];
    PairRecord& r = v.record[i];
    PairVector<float> sum{0.0f, 0.0f, 0.0f};
    const float push = kSolveMirror * v.pressureSolve.push[i];
    forBoundaryNear(v, b.grid, i, [&](const PairVector<float>& d, std::uint32_t j) {
      const float scale =
          b.record[j].volume * bodyForceScale(v.constants, push, CubicSpline::slopeOverQ(distanceOf(d)));
      sum.x += scale * d.x;
      sum.y += scale * d.y;
      sum.z += scale * d.z;
    });
    const float perMass = 1.0f / r.restDensity, seconds = v.pressureSolve.timeStep;
    const PairVector<float> a{perMass * sum.x, perMass * sum.y, perMass * sum.z};
    r.vx += seconds * a.x;
    r.vy += seconds * a.y;
    r.vz += seconds * a.z;
    v.ax[i] += a.x;
    v.ay[i] += a.y;
    v.az[i] += a.z;
    BodyGift& gift = b.gift[k];
    gift = {gift.x + a.x, gift.y + a.y, gift.z + a.z};
  }
};

/// And to boundary particles.
struct BodySolveLoadKernel {
  FlowView v;
  BodyView b;
  BodyLoad* load;
  double volume;  ///< V0, m3
  SPIN_HD void operator()(std::size_t n) const {
    const BodyRecord& w = b.record[n];
    BodyLoad sum{0, 0, 0, 0, 0, 0};
    forBoundaryNear(b.grid, v, n, [&](const PairVector<float>& d, std::uint32_t i) {
      const float slope = CubicSpline::slopeOverQ(distanceOf(d));
      const double scale =
          volume * static_cast<double>(
                       w.volume * bodyForceScale(v.constants, kSolveMirror * v.pressureSolve.push[i], slope));
      BodyReactionKernel::add(sum, scale * static_cast<double>(d.x), scale * static_cast<double>(d.y),
                              scale * static_cast<double>(d.z), static_cast<double>(w.armX),
                              static_cast<double>(w.armY), static_cast<double>(w.armZ));
    });
    load[w.point] = sum;
  }
};

/// Boundary particles take their bodies' velocities anew; the places stay.
struct BodyVelocityKernel {
  BodyRecord* record;
  const BodyPoint* points;
  const BodyPose* poses;
  SPIN_HD void operator()(std::size_t n) const {
    BodyRecord& w = record[n];
    const BodyPose& pose = poses[points[w.point].body];
    w.vx = pose.vx + pose.wy * w.armZ - pose.wz * w.armY;
    w.vy = pose.vy + pose.wz * w.armX - pose.wx * w.armZ;
    w.vz = pose.vz + pose.wx * w.armY - pose.wy * w.armX;
  }
};

/// Sum over the list of what bodies gave, kg m/s2.
struct BodyGiftOf {
  FlowView v;
  BodyView b;
  double volume;  ///< V0, m3
  SPIN_HD ImpulseSum operator()(std::size_t k) const {
    const double mass = volume * static_cast<double>(v.record[b.list[k]].restDensity);
    const BodyGift& g = b.gift[k];
    return {mass * static_cast<double>(g.x), mass * static_cast<double>(g.y),
            mass * static_cast<double>(g.z)};
  }
};

}  // namespace spin
