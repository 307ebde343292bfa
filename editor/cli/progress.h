// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace spin {

/// One report of a job's progress. With --progress json each is one line on stdout, a JSON object:
///
///   {"stage":"load","fraction":0}
///   {"stage":"simulate","frame":12,"first":0,"last":119,"fraction":0.0504,"seconds_left":null,
///    "stage_seconds_left":33.2}                                      (one line, broken here)
///   {"stage":"export","frame":3,"first":0,"last":119,"fraction":0.513,"seconds_left":60.1,
///    "stage_seconds_left":60.1}
///   {"stage":"done","fraction":1,"exit_code":0,"output":"out","files":361,"bytes":123456}
///   {"stage":"failed","exit_code":3,"error":"The scene could not be read (a.spindrift): ..."}
///
/// stage: load, simulate, export, then once done or failed (failed also when cancelled: exit_code 5).
/// frame: the frame in work; first, last: the range of the stage. fraction: of the whole job, 0 .. 1, never
/// falling. seconds_left: of the whole job, null while unknown; while it simulates frames that will be
/// exported nobody knows yet how long the export takes. stage_seconds_left: of this stage alone. The last
/// line of a job is done or failed. Readers skip keys and stages they do not know.
struct Progress {
  std::string stage;
  int frame = -1;  ///< -1 = no frames in this stage
  int first = 0;
  int last = 0;
  double fraction = 0.0;
  double secondsLeft = -1.0;       ///< of the whole job; < 0 = unknown
  double stageSecondsLeft = -1.0;  ///< < 0 = unknown
};
using ProgressSink = std::function<void(const Progress&)>;

/// The line, without its end.
std::string progressLine(const Progress& progress);
std::string doneLine(const std::string& output, std::size_t files, std::uint64_t bytes);
std::string failedLine(const Error& error);
/// Text as a JSON string with its quotes.
std::string jsonText(const std::string& text);

enum class ProgressStyle { Lines, Terminal, Json };

/// Prints progress to a stream: JSON lines at most every 100 ms and at each change of stage or frame;
/// readable lines at each change of stage and then every 5 %, at most one a second, or every 30 s, so that
/// logs stay short; on a terminal one line that is overwritten and goes at the end.
class ProgressPrinter {
 public:
  ProgressPrinter(ProgressStyle style, std::FILE* stream) : m_style(style), m_stream(stream) {}
  void print(const Progress& progress);
  void done(const std::string& output, std::size_t files, std::uint64_t bytes);
  void failed(const Error& error);
  ProgressStyle style() const { return m_style; }

 private:
  void write(const std::string& text);
  bool isDue(const Progress& progress, std::chrono::steady_clock::time_point now) const;

  ProgressStyle m_style;
  std::FILE* m_stream;
  Progress m_last;
  std::chrono::steady_clock::time_point m_time{};
};

}  // namespace spin
