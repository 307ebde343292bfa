// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/sph/flow_solver.h"
#include "core/sph/implicit_kernels.h"

namespace spin {

/// The solve for the pressure over a backend's arrays, by iterates whose pushes act on the velocities at
/// once, so what is left is measured with the velocities that go on. Both conditions of DFSPH are met in one
/// solve: velocities do not compress, and an excess that is there is taken off by a share a step. All of it
/// at once would turn every error of position into speed.
/// Fluid that bears tension is taken to fill its room, without a free surface. The excess that is wanted is
/// then the mean one: a sum over neighbours in disorder is larger by up to 1 % than over a lattice, and to
/// want the density at rest would raise the pressure until they form one, which resists shear.
template <class Backend>
class ImplicitPressure {
 public:
  void allocate(std::size_t padded) {
    for (Array* array : arrays()) array->resize(padded);
  }
  std::size_t bytes() const { return 5 * m_error.size() * sizeof(float); }

  void point(const FlowConfig& config, FlowView& view) {
    PressureSolveView& s = view.pressureSolve;
    // Walls and bodies ask by the pointer whether the pressure is solved for; it may have been before.
    s.pressure = config.pressure == PressureMode::Implicit ? m_pressure.data() : nullptr;
    s.push = m_push.data();
    s.latest = m_latest.data();
    s.compliance = m_compliance.data();
    s.error = m_error.data();
    s.leastPressure = config.clampTension ? 0.0f : -1e30f;
    s.deficitShare = config.clampTension ? 0.0f : 1.0f;
  }

  /// From velocities that have all forces, the pressure of the step before among them; `compression` is the
  /// mean of what is too dense, `level` the excess that is wanted everywhere, `share` the step's share of the
  /// longest one. Gives the id of a particle whose state is not finite, else UINT32_MAX.
  template <class Passes>
  std::uint32_t solve(Backend& backend, Passes& passes, const FlowConfig& config, FlowView view,
                      double compression, double level, double share, FlowSolve& done) {
    PressureSolveView& s = view.pressureSolve;
    const double wanted = kSurplusShare * compression / (kEasyShare * config.densityError);
    s.surplusShare = static_cast<float>(share * std::clamp(wanted, kSurplusShare, 1.0));
    s.level = static_cast<float>(level);
    // Suction that fills up deficits at once would be as wrong as a push that takes off all of an excess.
    s.deficitRoom = config.clampTension ? static_cast<float>(kDeficitRoom * config.densityError) : 1e30f;
    s.relaxation = kFirstRelaxation;
    const double goal = kSolveShare * share * config.densityError;
    double theta = 1.0, before = INFINITY;
    passes.solve(backend, kStage, view, SolvePass::Divergence);
    for (done.iterations = 0;; ++done.iterations) {
      const SolveError left = backend.reduce(kStage, view.count, noError(), ErrorOf{view}, JoinErrors{});
      done.error = left.sum / view.count;
      done.largest = static_cast<double>(left.largest);
      done.reached = done.error <= goal;
      if (left.broken != UINT32_MAX) return left.broken;
      if ((done.reached && done.iterations >= kLeast) || done.iterations >= config.mostIterations)
        return UINT32_MAX;
      if (done.error > before) {
        // Overshot: momentum starts anew (O'Donoghue and Candes 2015), with smaller corrections.
        theta = 1.0;
        s.relaxation = std::max(kCalmer * s.relaxation, kLeastRelaxation);
      }
      before = done.error;
      const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * theta * theta));
      s.momentum = static_cast<float>((theta - 1.0) / next);
      if (s.momentum > 0.0f) s.relaxation = std::min(s.relaxation, kRelaxation);
      theta = next;
      passes.solve(backend, kStage, view, SolvePass::PressurePush);
      passes.solve(backend, kStage, view, SolvePass::Divergence);
    }
  }

 private:
  using Array = typename Backend::template Array<float>;
  static constexpr const char* kStage = "pressure solve";
  static constexpr int kLeast = 1;
  /// Share of an excess that is taken off in a step, while the mean is below kEasyShare of the error asked
  /// for; in proportion above.
  static constexpr double kSurplusShare = 0.1, kEasyShare = 0.25;
  /// Share of the error asked for: a deficit within it is taken for contact.
  static constexpr double kDeficitRoom = 0.5;
  /// What a step may add to the mean excess, share of the density's error.
  static constexpr double kSolveShare = 0.05;
  /// Plain steps are stable below 4 over the largest eigenvalue's bound, steps with momentum below a third of
  /// that (the spectrum of the Jacobi-scaled matrix reaches about 4 in compressed fluid).
  static constexpr float kFirstRelaxation = 0.5f, kRelaxation = 0.25f, kLeastRelaxation = 0.1f,
                         kCalmer = 0.8f;

  std::array<Array*, 5> arrays() { return {&m_pressure, &m_push, &m_latest, &m_compliance, &m_error}; }

  Array m_pressure, m_push, m_latest, m_compliance, m_error;
};

}  // namespace spin
