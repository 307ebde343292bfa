// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace spin {

enum class LogLevel { Debug, Info, Warning, Error };

/// Receives every message at or above the level; called under a lock, from any thread.
using LogSink = std::function<void(LogLevel, std::string_view)>;

/// Replaces the sink (default: "spindrift: ..." on stderr, so that stdout stays free for results).
void setLogSink(LogSink sink);
void setLogLevel(LogLevel level);
void log(LogLevel level, std::string_view message);

inline void logInfo(std::string_view message) {
  log(LogLevel::Info, message);
}
inline void logWarning(std::string_view message) {
  log(LogLevel::Warning, message);
}
inline void logError(std::string_view message) {
  log(LogLevel::Error, message);
}

}  // namespace spin
