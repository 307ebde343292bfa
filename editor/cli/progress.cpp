// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/progress.h"

#include <fmt/format.h>

namespace spin {
namespace {

constexpr auto kJsonInterval = std::chrono::milliseconds(100);
constexpr auto kLineInterval = std::chrono::seconds(5);

std::string duration(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  return whole < 90 ? fmt::format("{} s", whole) : fmt::format("{} min {} s", whole / 60, whole % 60);
}

std::string readableLine(const Progress& p) {
  std::string line = p.stage;
  if (p.frame >= 0) line += fmt::format(": frame {} of {}..{}", p.frame, p.first, p.last);
  line += fmt::format(", {:.0f} %", 100.0 * p.fraction);
  if (p.secondsLeft >= 0.0) line += fmt::format(", {} left", duration(p.secondsLeft));
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
  if (p.frame >= 0)
    line += p.secondsLeft < 0.0 ? std::string(",\"seconds_left\":null")
                                : fmt::format(",\"seconds_left\":{:.1f}", p.secondsLeft);
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

void ProgressPrinter::write(const std::string& line) {
  std::fputs((line + "\n").c_str(), m_stream);
  std::fflush(m_stream);
}

void ProgressPrinter::print(const Progress& progress) {
  const auto now = std::chrono::steady_clock::now();
  const bool newStage = progress.stage != m_last.stage;
  const bool json = m_style == ProgressStyle::Json;
  const bool newFrame = json && progress.frame != m_last.frame;
  if (!newStage && !newFrame &&
      now - m_time < (json ? kJsonInterval : std::chrono::milliseconds(kLineInterval)))
    return;
  m_time = now;
  m_last = progress;
  write(json ? progressLine(progress) : readableLine(progress));
}

void ProgressPrinter::done(const std::string& output, std::size_t files, std::uint64_t bytes) {
  if (m_style == ProgressStyle::Json) write(doneLine(output, files, bytes));
}

void ProgressPrinter::failed(const Error& error) {
  if (m_style == ProgressStyle::Json) write(failedLine(error));
}

}  // namespace spin
