// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace spin::detail {

void checkFailed(const char* file, int line, const char* condition, const std::string& detail) {
  std::fprintf(stderr, "spindrift: bug at %s:%d: check failed: %s: %s\n", file, line, condition,
               detail.c_str());
  std::fflush(stderr);
  std::abort();
}

}  // namespace spin::detail
