// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/log.h"

#include <cstdio>
#include <mutex>

namespace spin {
namespace {

void writeToStderr(LogLevel level, std::string_view message) {
  const char* mark = level == LogLevel::Error ? "error: " : level == LogLevel::Warning ? "warning: " : "";
  std::fprintf(stderr, "spindrift: %s%.*s\n", mark, static_cast<int>(message.size()), message.data());
}

struct LogState {
  std::mutex mutex;
  LogSink sink = writeToStderr;
  LogLevel level = LogLevel::Info;
};

LogState& logState() {
  static LogState state;
  return state;
}

}  // namespace

void setLogSink(LogSink sink) {
  std::lock_guard lock(logState().mutex);
  logState().sink = sink ? std::move(sink) : LogSink(writeToStderr);
}

void setLogLevel(LogLevel level) {
  std::lock_guard lock(logState().mutex);
  logState().level = level;
}

void log(LogLevel level, std::string_view message) {
  std::lock_guard lock(logState().mutex);
  if (level >= logState().level) logState().sink(level, message);
}

}  // namespace spin
