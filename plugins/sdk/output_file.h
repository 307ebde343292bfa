// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace spin {

inline Error cannotWrite(const std::string& path, const std::string& why) {
  return {errno == ENOSPC || errno == EDQUOT ? ErrorKind::OutOfResources : ErrorKind::Failed,
          "The file could not be written", path, why,
          "Check the folder's rights and the space left on the disk"};
}

/// A file under way: libraries write to temporaryPath(), commit() checks it and gives it its name, so that
/// nobody ever sees half a file. Without commit() it is removed again.
class OutputFile {
 public:
  /// The temporary name keeps the extension, by which libraries choose the format.
  explicit OutputFile(const std::string& path) : m_path(path), m_temporary(temporaryPathOf(path)) {}
  ~OutputFile() {
    if (!m_committed) std::remove(m_temporary.c_str());
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where this process writes the file until it is whole.
  static std::string temporaryPathOf(const std::string& path) {
    const std::filesystem::path wanted(path);
    const std::string name =
        "." + wanted.stem().string() + ".part" + std::to_string(getpid()) + wanted.extension().string();
    return (wanted.parent_path() / name).string();
  }
  const std::string& temporaryPath() const { return m_temporary; }

  Status write(const std::vector<char>& bytes) {
    errno = 0;
    std::FILE* file = std::fopen(m_temporary.c_str(), "wbe");
    if (!file) return cannotWrite(m_path, std::strerror(errno));
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int problem = errno;
    const bool closed = std::fclose(file) == 0;
    if (written && closed) return {};
    if (!written) errno = problem;
    return cannotWrite(m_path, std::strerror(errno));
  }

  /// Refuses a file that is smaller than it can be.
  Status commit(std::size_t leastBytes) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(m_temporary, error);
    errno = 0;
    if (error) return cannotWrite(m_path, error.message());
    if (size < leastBytes) return cannotWrite(m_path, "only " + std::to_string(size) + " bytes arrived");
    if (std::rename(m_temporary.c_str(), m_path.c_str()) != 0)
      return cannotWrite(m_path, std::strerror(errno));
    m_committed = true;
    return {};
  }

 private:
  std::string m_path;
  std::string m_temporary;
  bool m_committed = false;
};

}  // namespace spin
