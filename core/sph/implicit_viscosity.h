// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/sph/flow_solver.h"
#include "core/sph/viscous_kernels.h"

namespace spin {

/// Matrix-free conjugate gradients for the velocity over a backend's arrays; sums in double and in a fixed
/// order.
template <class Backend>
class ImplicitViscosity {
 public:
  void allocate(std::size_t padded) {
    m_direction.resize(padded);
    for (Array* array : arrays()) array->resize(padded);
  }
  std::size_t bytes() const {
    return m_direction.size() * sizeof(ViscousRecord) + 8 * m_slip.size() * sizeof(float);
  }

  void point(FlowView& view) {
    ViscousSolveView& s = view.viscousSolve;
    s.direction = m_direction.data();
    s.qx = m_qx.data(), s.qy = m_qy.data(), s.qz = m_qz.data();
    s.rx = m_rx.data(), s.ry = m_ry.data(), s.rz = m_rz.data();
    s.diagonal = m_diagonal.data();
    s.slip = m_slip.data();
  }

  /// Replaces velocities by those after `seconds` of viscosity and wall friction. Gives the id of a particle
  /// whose state is not finite, else UINT32_MAX.
  template <class Passes>
  std::uint32_t solve(Backend& backend, Passes& passes, const FlowConfig& config, FlowView view,
                      double seconds, FlowSolve& done) {
    view.viscousSolve.timeStep = static_cast<float>(seconds);
    view.viscousSolve.factor =
        static_cast<float>(seconds * static_cast<double>(view.constants.viscousFactor));
    const auto leastSpeed = static_cast<float>(length(config.gravity) * seconds);
    const std::size_t n = view.count;
    const ViscousMomentum start = momentum(backend, view);
    backend.forEach(kStage, n, ViscousBeginKernel{view});
    passes.solve(backend, kStage, view, SolvePass::ViscousProduct);
    backend.forEach(kStage, n, ViscousResidualKernel{view});
    double before = 0.0;
    for (done.iterations = 0;; ++done.iterations) {
      const ViscousNorms norms = backend.reduce(kStage, n, ViscousNorms{0.0, 0.0, 0.0},
                                                ViscousNormsOf{view, leastSpeed}, JoinViscousNorms{});
      done.error = norms.whole > 0.0 ? std::sqrt(norms.left / norms.whole) : 0.0;
      done.reached = done.error <= config.viscosityError;
      if (done.reached || done.iterations >= config.mostIterations) break;
      if (done.iterations > 0)
        backend.forEach(kStage, n,
                        ViscousTurnKernel{view, static_cast<float>(norms.preconditioned / before)});
      before = norms.preconditioned;
      passes.solve(backend, kStage, view, SolvePass::ViscousProduct);
      backend.forEach(kStage, n, ViscousWallKernel{view});
      const ViscousProduct product = backend.reduce(kStage, n, ViscousProduct{0.0, UINT32_MAX},
                                                    ViscousProductOf{view}, JoinViscousProduct{});
      if (product.broken != UINT32_MAX) return product.broken;
      if (!(product.dot > 0.0)) break;
      backend.forEach(kStage, n,
                      ViscousAdvanceKernel{view, static_cast<float>(norms.preconditioned / product.dot)});
    }
    backend.forEach(kStage, n, ViscousEndKernel{view});
    restore(backend, view, start);
    return UINT32_MAX;
  }

 private:
  using Array = typename Backend::template Array<float>;
  static constexpr const char* kStage = "viscosity solve";

  ViscousMomentum momentum(Backend& backend, const FlowView& view) {
    return backend.reduce(kStage, view.count, ViscousMomentum{0.0, 0.0, 0.0, 0.0, 0}, ViscousMomentumOf{view},
                          JoinViscousMomentum{});
  }
  /// Where no wall takes part, takes off what the rounding of many iterations has added to the momentum.
  void restore(Backend& backend, const FlowView& view, const ViscousMomentum& start) {
    if (start.walls != 0) return;
    const ViscousMomentum end = momentum(backend, view);
    const auto part = [&](double before, double after) {
      return static_cast<float>((before - after) / end.mass);
    };
    backend.forEach(
        kStage, view.count,
        ViscousShiftKernel{view, part(start.x, end.x), part(start.y, end.y), part(start.z, end.z)});
  }

  std::array<Array*, 8> arrays() { return {&m_qx, &m_qy, &m_qz, &m_rx, &m_ry, &m_rz, &m_diagonal, &m_slip}; }

  typename Backend::template Array<ViscousRecord> m_direction;
  Array m_qx, m_qy, m_qz, m_rx, m_ry, m_rz, m_diagonal, m_slip;
};

}  // namespace spin
