// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace spin::test {

/// How many times longer than promised something may take here: a sanitizer slows it down, and so does
/// whatever else wants the processors (the promise is for a machine that is free).
inline double patience() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  constexpr double kBuild = 5.0;
#else
  constexpr double kBuild = 1.0;
#endif
  double load = 0.0;
  if (getloadavg(&load, 1) != 1) load = 0.0;
  return kBuild * std::max(1.0, load / std::max(1u, std::thread::hardware_concurrency()));
}

/// A promised duration as it must be kept here and now.
inline std::chrono::duration<double> timeLimit(std::chrono::milliseconds promised) {
  return promised * patience();
}

}  // namespace spin::test
