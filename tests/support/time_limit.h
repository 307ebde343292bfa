// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace spin::test {

/// How many times longer than promised a build with a sanitizer may take; 1 in every other build.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kPatience = 5;
#else
inline constexpr int kPatience = 1;
#endif

/// A promised duration as this build must keep it.
constexpr std::chrono::milliseconds timeLimit(std::chrono::milliseconds promised) {
  return promised * kPatience;
}

}  // namespace spin::test
