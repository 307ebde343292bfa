// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/result.h"
#include "plugins/host/plugin_host.h"

namespace spin {

/// File descriptors that the helper finds open: the request to read, the answer to write.
inline constexpr int kHelperRequestFd = 3;
inline constexpr int kHelperAnswerFd = 4;

/// Bytes shared with a child process: an anonymous file in memory that cannot shrink, so that a mapping of it
/// stays valid whatever the child does.
class SharedBytes {
 public:
  SharedBytes();
  ~SharedBytes();
  SharedBytes(const SharedBytes&) = delete;
  SharedBytes& operator=(const SharedBytes&) = delete;

  Status write(const std::vector<char>& bytes);
  /// Maps what is there now for reading; data() and size() hold until destruction.
  Status map();
  int fd() const { return m_fd; }
  const char* data() const { return m_data; }
  std::size_t size() const { return m_size; }

 private:
  int m_fd = -1;
  const char* m_data = nullptr;
  std::size_t m_size = 0;
};

/// Runs the helper on a request and waits, from any thread and without an event loop. On success the answer
/// is mapped (its seal is not yet checked). The helper and everything it started are killed on cancel, on
/// time-out and when they hold more memory than allowed. Its stdout and stderr never reach the terminal: the
/// last lines become part of the reason where it fails. `path` is the file that errors name.
Status runHelper(const std::string& program, const std::vector<char>& request, const ImportLimits& limits,
                 const CancelToken& cancel, const std::string& path, SharedBytes& answer);

}  // namespace spin
