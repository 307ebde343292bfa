// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/sph/pair_loop.h"
#include "core/sph/sph_slice_impl.h"

namespace spin {

/// Rows are shared out among threads; within a row the instruction set's own loop runs.
template <>
struct PairStages<CpuBackend> {
  static constexpr std::size_t kRowChunk = 4;
  PairLoops loops;

  void density(CpuBackend& backend, const SliceView& view) { run(backend, "density", view, loops.density); }
  void force(CpuBackend& backend, const SliceView& view) { run(backend, "force", view, loops.force); }

 private:
  static void run(CpuBackend& backend, const char* name, const SliceView& view,
                  void (*loop)(const SliceView&, std::uint32_t, std::uint32_t)) {
    backend.forChunks(name, static_cast<std::size_t>(view.grid.rows()), kRowChunk,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        loop(view, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
                      });
  }
};

Result<std::unique_ptr<SphSliceSolver>> makeSphSliceCpu(const SphSliceConfig& config, int threads, Isa isa) {
  if (const Status ok = checkSliceConfig(config); !ok) return ok.error();
  std::unique_ptr<SphSliceSolver> solver = std::make_unique<SphSlice<CpuBackend>>(
      config, CpuBackend(threads), PairStages<CpuBackend>{pairLoopsFor(isa)});
  return solver;
}

}  // namespace spin
