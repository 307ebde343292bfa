// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/sph/flow_loop.h"
#include "core/sph/flow_solver_impl.h"

namespace spin {

/// Sorted particles are shared out among threads; the instruction set's own loop runs over each share.
template <>
struct FlowPasses<CpuBackend> {
  static constexpr std::size_t kShare = 1024;
  FlowLoops loops;

  void density(CpuBackend& backend, const FlowView& view) { run(backend, "density", view, loops.density); }
  void shear(CpuBackend& backend, const FlowView& view) { run(backend, "shear rate", view, loops.shear); }
  void force(CpuBackend& backend, const FlowView& view) {
    run(backend, "force", view, loops.force[view.sx ? 1 : 0][view.rate ? 1 : 0]);
  }
  void solve(CpuBackend& backend, const char* name, const FlowView& view, SolvePass pass) {
    run(backend, name, view, loops.solve[static_cast<std::size_t>(pass)]);
  }

 private:
  static void run(CpuBackend& backend, const char* name, const FlowView& view, FlowLoops::Loop loop) {
    backend.forChunks(name, view.count, kShare, [&](std::size_t begin, std::size_t end, std::size_t) {
      loop(view, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
    });
  }
};

Result<std::unique_ptr<FlowSolver>> makeFlowSolverCpu(const FlowConfig& config, int threads, Isa isa) {
  return makeFlowSolverCpu(config, CpuBackend(threads), isa);
}

Result<std::unique_ptr<FlowSolver>> makeFlowSolverCpu(const FlowConfig& config, const CpuBackend& like,
                                                      Isa isa) {
  if (const Status ok = checkFlowConfig(config); !ok) return ok.error();
  FlowConfig ready = config;
  if (const Status ok = makeMeshFields(ready, like.threads()); !ok) return ok.error();
  std::unique_ptr<FlowSolver> solver = std::make_unique<FlowSolverOn<CpuBackend>>(
      ready, like.sharingThreads(), FlowPasses<CpuBackend>{flowLoopsFor(isa)});
  return solver;
}

}  // namespace spin
