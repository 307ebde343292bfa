// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_kernels.h"
#include "core/sph/implicit_kernels.h"
#include "core/sph/viscous_kernels.h"

namespace spin {

/// How a backend arranges the pair passes. The general form gives every particle a thread; the processor has
/// its own in flow_solver_cpu.cpp.
template <class Backend>
struct FlowPasses {
  void density(Backend& backend, const FlowView& view) {
    backend.forEach("density", view.count, PairKernel<DensityPass>{view});
  }
  void shear(Backend& backend, const FlowView& view) {
    backend.forEach("shear rate", view.count, PairKernel<ShearPass>{view});
  }
  void force(Backend& backend, const FlowView& view) {
    if (view.sx && view.rate)
      backend.forEach("force", view.count, PairKernel<SmoothContinuityForcePass>{view});
    else if (view.sx)
      backend.forEach("force", view.count, PairKernel<SmoothForcePass>{view});
    else if (view.rate)
      backend.forEach("force", view.count, PairKernel<ContinuityForcePass>{view});
    else
      backend.forEach("force", view.count, PairKernel<PlainForcePass>{view});
  }
  void solve(Backend& backend, const char* name, const FlowView& view, SolvePass pass) {
    switch (pass) {
      case SolvePass::Constraint:
        return backend.forEach(name, view.count, PairKernel<ConstraintPass>{view});
      case SolvePass::Divergence:
        return backend.forEach(name, view.count, PairKernel<DivergencePass>{view});
      case SolvePass::PressurePush:
        return backend.forEach(name, view.count, PairKernel<PressurePushPass>{view});
      case SolvePass::ViscousProduct:
        return backend.forEach(name, view.count, PairKernel<ViscousProductPass>{view});
      case SolvePass::Stress:
        return backend.forEach(name, view.count, PairKernel<StressPass>{view});
    }
  }
};

}  // namespace spin
