// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <fcntl.h>

#include "plugins/host/helper_process.h"

namespace spin {
namespace {

Error noMemory(const char* what) {
  return {ErrorKind::OutOfResources, what, "", std::strerror(errno), "Free memory and try again"};
}

}  // namespace

SharedBytes::SharedBytes() : m_fd(memfd_create("spindrift-import", MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
  if (m_fd >= 0) fcntl(m_fd, F_ADD_SEALS, F_SEAL_SHRINK);
}

SharedBytes::~SharedBytes() {
  if (m_data) munmap(const_cast<char*>(m_data), m_size);
  if (m_fd >= 0) close(m_fd);
}

Status SharedBytes::write(const std::vector<char>& bytes) {
  if (m_fd < 0) return noMemory("Memory for the import could not be taken");
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t n = pwrite(m_fd, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return noMemory("Memory for the import could not be taken");
    done += static_cast<std::size_t>(n);
  }
  return {};
}

Status SharedBytes::map() {
  struct stat about {};
  if (m_fd < 0 || fstat(m_fd, &about) != 0) return noMemory("The import's answer could not be read");
  m_size = static_cast<std::size_t>(about.st_size);
  if (m_size == 0) return {};
  void* at = mmap(nullptr, m_size, PROT_READ, MAP_PRIVATE, m_fd, 0);
  if (at == MAP_FAILED) {
    m_size = 0;
    return noMemory("The import's answer could not be read");
  }
  m_data = static_cast<const char*>(at);
  return {};
}

}  // namespace spin
