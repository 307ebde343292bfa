// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/cpu_features.h"

namespace spin {
namespace {

constexpr Isa kAll[] = {Isa::Baseline, Isa::Avx2, Isa::Avx512};

}  // namespace

const char* isaName(Isa isa) {
  switch (isa) {
    case Isa::Avx2:
      return "avx2";
    case Isa::Avx512:
      return "avx512";
    case Isa::Baseline:
      break;
  }
  return "baseline";
}

bool cpuRuns(Isa isa) {
#if defined(__x86_64__)
  switch (isa) {
    case Isa::Avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Isa::Avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") && cpuRuns(Isa::Avx2);
    case Isa::Baseline:
      break;
  }
#endif
  return isa == Isa::Baseline;
}

std::vector<Isa> runnableIsas() {
  std::vector<Isa> found;
  for (const Isa isa : kAll)
    if (cpuRuns(isa)) found.push_back(isa);
  return found;
}

Isa bestIsa() {
  return runnableIsas().back();
}

Result<Isa> chooseIsa(std::string_view request) {
  if (request == "auto") return bestIsa();
  for (const Isa isa : kAll) {
    if (request != isaName(isa)) continue;
    if (cpuRuns(isa)) return isa;
    return Error{ErrorKind::Failed, "The instruction set cannot be used", std::string(request),
                 "this processor does not have it", "Use --isa auto"};
  }
  return Error{ErrorKind::Usage,
               "Unknown instruction set",
               std::string(request),
               "known are auto, avx512, avx2 and baseline",
               {}};
}

}  // namespace spin
