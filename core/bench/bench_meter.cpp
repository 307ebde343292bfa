// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/bench_meter.h"

#include <sys/resource.h>

#include <fstream>
#include <string>

namespace spin {
namespace {

/// A "Name:   123 kB" line of /proc/self/status in bytes; 0 if it is not there.
double statusBytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    double kilobytes = 0.0;
    if (word == name + ":" && status >> kilobytes) return kilobytes * 1024.0;
  }
  return 0.0;
}

}  // namespace

double peakResidentBytes() {
  const double bytes = statusBytes("VmHWM");
  if (bytes > 0.0) return bytes;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

double residentBytes() {
  return statusBytes("VmRSS");
}

bool resetPeakResidentBytes() {
  // Value 5 resets the peak resident set size (proc(5), since Linux 4.0).
  std::ofstream clear("/proc/self/clear_refs");
  clear << "5" << std::flush;
  return clear.good();
}

BenchMeter::BenchMeter() {
  resetPeakResidentBytes();
  m_start = std::chrono::steady_clock::now();
}

double BenchMeter::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
}

void BenchMeter::finish(BenchRow& row) const {
  row.seconds = seconds();
  row.peakBytes = peakResidentBytes();
}

}  // namespace spin
