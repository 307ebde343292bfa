// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/scene/asset_library.h"
#include "plugins/host/plugin_host.h"

namespace spin::test {

/// A folder that is removed again.
class TempFolder {
 public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "spindrift-test-XXXXXX").string();
    m_path = mkdtemp(name.data());
  }
  ~TempFolder() {
    std::error_code error;
    std::filesystem::remove_all(m_path, error);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::string path() const { return m_path.string(); }
  std::string file(const std::string& name) const { return (m_path / name).string(); }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(m_path))
      all.push_back(entry.path().filename());
    return all;
  }

 private:
  std::filesystem::path m_path;
};

inline std::string writeBytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

inline std::string readBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Sets a variable for the life of the object.
class ScopedEnvironment {
 public:
  ScopedEnvironment(const char* name, const std::string& value) : m_name(name) {
    setenv(name, value.c_str(), 1);
  }
  ~ScopedEnvironment() { unsetenv(m_name); }
  ScopedEnvironment(const ScopedEnvironment&) = delete;
  ScopedEnvironment& operator=(const ScopedEnvironment&) = delete;

 private:
  const char* m_name;
};

/// Long enough for a busy machine, short enough for a test that would hang.
inline constexpr ImportLimits kTestLimits{std::size_t{4} << 30, 30.0};

inline Result<TerrainImport> readTerrain(const std::string& path, const ImportOptions& options = {},
                                         const ImportLimits& limits = kTestLimits) {
  return makeHelperAssetReader(limits)->readTerrain(path, options, CancelToken());
}
inline Result<ModelImport> readModel(const std::string& path, const ImportOptions& options = {},
                                     const ImportLimits& limits = kTestLimits) {
  return makeHelperAssetReader(limits)->readModel(path, options, CancelToken());
}

inline std::string lineOf(const ImportSummary& summary, const std::string& label) {
  for (const SummaryLine& line : summary.lines)
    if (line.label == label) return line.value;
  return "(no line " + label + ")";
}

inline bool mentions(const std::vector<std::string>& lines, const std::string& part) {
  for (const std::string& line : lines)
    if (line.find(part) != std::string::npos) return true;
  return false;
}

/// A failed result whose text names the file and the parts, and that gives advice.
template <class R>
void expectError(const R& result, ErrorKind kind, const std::string& file, std::vector<std::string> parts) {
  ASSERT_FALSE(result.ok()) << "accepted " << file;
  const Error& error = result.error();
  EXPECT_EQ(static_cast<int>(error.kind), static_cast<int>(kind)) << error.text();
  parts.push_back(file);
  for (const std::string& part : parts)
    EXPECT_NE(error.text().find(part), std::string::npos) << "\"" << part << "\" not in: " << error.text();
}

/// Peak resident memory of this process, bytes.
inline std::size_t peakMemory() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
    if (line.rfind("VmHWM:", 0) == 0) return std::strtoull(line.c_str() + 6, nullptr, 10) * 1024;
  return 0;
}

/// What a command prints; nothing if it fails.
inline std::string outputOf(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
  std::string text;
  char buffer[4096];
  for (std::size_t n = 0; pipe && (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    text.append(buffer, n);
  return pipe && pclose(pipe) == 0 ? text : std::string();
}

}  // namespace spin::test
