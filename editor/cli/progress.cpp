// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/progress.h"

#include <fmt/format.h>

namespace spin {
namespace {

constexpr auto kQuickInterval = std::chrono::milliseconds(100);
constexpr auto kLineInterval = std::chrono::seconds(1);
constexpr auto kSignOfLife = std::chrono::seconds(30);
constexpr double kLineShare = 0.05;
/// To the left edge, and empties the line.
constexpr const char* kClearLine = "\r\033[K";

std::string duration(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  return whole < 90 ? fmt::format("{} s", whole) : fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string readableLine(const Progress& p) {
  std::string line = p.stage;
  if (p.frame >= 0) line += fmt::format(": frame {} of {}..{}", p.frame, p.first, p.last);
  line += fmt::format(", {:.0f} %", 100.0 * p.fraction);
  if (p.secondsLeft >= 0.0)
    line += fmt::format(", {} left", duration(p.secondsLeft));
  else if (p.stageSecondsLeft >= 0.0)
    line += fmt::format(", {} left of this stage", duration(p.stageSecondsLeft));
  return line;
}

}  // namespace

std::string jsonText(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (c == '\n')
      out += "\\n";
    else if (byte < 0x20)
      out += fmt::format("\\u{:04x}", byte);
    else
      out += c;
  }
  return out + "\"";
}

std::string progressLine(const Progress& p) {
  std::string line = fmt::format("{{\"stage\":{}", jsonText(p.stage));
  if (p.frame >= 0) line += fmt::format(",\"frame\":{},\"first\":{},\"last\":{}", p.frame, p.first, p.last);
  line += fmt::format(",\"fraction\":{:.6g}", p.fraction);
  const auto addSeconds = [&](const char* key, double seconds) {
    line += fmt::format(",\"{}\":{}", key, seconds < 0.0 ? "null" : fmt::format("{:.1f}", seconds));
  };
  if (p.frame >= 0) {
    addSeconds("seconds_left", p.secondsLeft);
    addSeconds("stage_seconds_left", p.stageSecondsLeft);
  }
  return line + "}";
}

std::string doneLine(const std::string& output, std::size_t files, std::uint64_t bytes) {
  return fmt::format(
      "{{\"stage\":\"done\",\"fraction\":1,\"exit_code\":0,\"output\":{},\"files\":{},\"bytes\":{}}}",
      jsonText(output), files, bytes);
}

std::string failedLine(const Error& error) {
  return fmt::format("{{\"stage\":\"failed\",\"exit_code\":{},\"error\":{}}}", exitCode(error.kind),
                     jsonText(error.text()));
}

void ProgressPrinter::write(const std::string& text) {
  std::fputs(text.c_str(), m_stream);
  std::fflush(m_stream);
}

bool ProgressPrinter::isDue(const Progress& progress, std::chrono::steady_clock::time_point now) const {
  if (progress.stage != m_last.stage) return true;
  const auto waited = now - m_time;
  if (m_style == ProgressStyle::Json) return progress.frame != m_last.frame || waited >= kQuickInterval;
  if (m_style == ProgressStyle::Terminal) return waited >= kQuickInterval;
  const bool further = progress.fraction - m_last.fraction >= kLineShare;
  return waited >= (further ? kLineInterval : kSignOfLife);
}

void ProgressPrinter::print(const Progress& progress) {
  const auto now = std::chrono::steady_clock::now();
  if (!isDue(progress, now)) return;
  m_time = now;
  m_last = progress;
  if (m_style == ProgressStyle::Json) return write(progressLine(progress) + "\n");
  if (m_style == ProgressStyle::Lines) return write(readableLine(progress) + "\n");
  // The cursor goes back, so that a message between two reports starts at the left edge.
  write(kClearLine + readableLine(progress) + "\r");
}

void ProgressPrinter::done(const std::string& output, std::size_t files, std::uint64_t bytes) {
  if (m_style == ProgressStyle::Json) write(doneLine(output, files, bytes) + "\n");
  if (m_style == ProgressStyle::Terminal) write(kClearLine);
}

void ProgressPrinter::failed(const Error& error) {
  if (m_style == ProgressStyle::Json) write(failedLine(error) + "\n");
  if (m_style == ProgressStyle::Terminal) write(kClearLine);
}

}  // namespace spin
