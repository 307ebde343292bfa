// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/checked_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <cerrno>
#include <cstring>

#include "core/sim/packed_bytes.h"
#include "core/sim/serialize.h"

namespace spin {
namespace {

static_assert(std::endian::native == std::endian::little, "cache files are little-endian");

// Layout: prefix | header bytes | header checksum | payload. The prefix holds the sizes.
constexpr std::uint64_t kMagic = 0x3146'5444'4e49'5053ull;  // "SPINDTF1"
constexpr std::uint32_t kVersion = 3;
constexpr std::uint64_t kMaxHeaderBytes = 1 << 20;

struct Prefix {
  std::uint64_t magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t headerBytes = 0;
  std::uint64_t payloadBytes = 0;
  Hash128 payloadSum;
};

Hash128 sumOf(const Prefix& prefix, const std::vector<char>& header) {
  return Hasher().addBytes(&prefix, sizeof prefix).addBytes(header.data(), header.size()).digest();
}

class Descriptor {
 public:
  explicit Descriptor(int fd) : m_fd(fd) {}
  ~Descriptor() {
    if (m_fd >= 0) ::close(m_fd);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return m_fd; }
  int close() { return ::close(std::exchange(m_fd, -1)); }

 private:
  int m_fd;
};

bool writeAll(int fd, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t wrote = ::write(fd, at, size);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return false;
    at += wrote;
    size -= static_cast<std::size_t>(wrote);
  }
  return true;
}

bool readAll(int fd, void* data, std::size_t size) {
  char* at = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = ::read(fd, at, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

Error writeError(const std::string& path, int number) {
  const bool full = number == ENOSPC || number == EDQUOT || number == EFBIG;
  return {full ? ErrorKind::OutOfResources : ErrorKind::Failed, "The cache file could not be written", path,
          std::strerror(number),
          full ? "Free some disk space or choose another cache folder" : "Check the folder's permissions"};
}

Error damaged(const std::string& path, const std::string& why) {
  return badInput("The cache file is damaged", path, why, "It is computed again when it is needed");
}

Result<CheckedFileHeader> readHeader(int fd, const std::string& path, Prefix& prefix) {
  struct stat info {};
  if (::fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) return damaged(path, "it is no regular file");
  if (!readAll(fd, &prefix, sizeof prefix)) return damaged(path, "it is too short");
  if (prefix.magic != kMagic) return damaged(path, "it does not start like a cache file");
  if (prefix.version != kVersion) return damaged(path, fmt::format("it has version {}", prefix.version));
  const auto size = static_cast<std::uint64_t>(info.st_size);
  const std::uint64_t head = sizeof prefix + prefix.headerBytes + sizeof(Hash128);
  if (prefix.headerBytes > kMaxHeaderBytes || head > size || prefix.payloadBytes != size - head)
    return damaged(path, fmt::format("its length of {} bytes is not what it claims", size));
  std::vector<char> bytes(prefix.headerBytes);
  Hash128 sum;
  if (!readAll(fd, bytes.data(), bytes.size()) || !readAll(fd, &sum, sizeof sum))
    return damaged(path, "it is too short");
  if (sum != sumOf(prefix, bytes)) return damaged(path, "the checksum of its header is wrong");
  ByteReader in(bytes.data(), bytes.size());
  CheckedFileHeader header;
  header.kind = in.getText();
  header.number = in.get<std::int64_t>();
  header.key = in.get<Hash128>();
  header.shared = in.getArray<Hash128>();
  if (!in.ok() || !in.atEnd()) return damaged(path, "its header makes no sense");
  return header;
}

Result<int> openForReading(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return badInput("The cache file could not be read", path, std::strerror(errno));
  return fd;
}

}  // namespace

Status writeCheckedFile(const std::string& path, const CheckedFileHeader& header,
                        const std::vector<char>& bytes) {
  const std::vector<char> payload = packBytes(bytes);
  ByteWriter out;
  out.put(header.kind);
  out.put(header.number);
  out.put(header.key);
  out.putArray(header.shared);
  Prefix prefix;
  prefix.headerBytes = static_cast<std::uint32_t>(out.bytes().size());
  prefix.payloadBytes = payload.size();
  prefix.payloadSum = Hasher().addBytes(payload.data(), payload.size()).digest();
  const Hash128 sum = sumOf(prefix, out.bytes());

  static std::atomic<unsigned> counter{0};
  const std::string temporary = fmt::format("{}.{}-{}.tmp", path, ::getpid(), counter++);
  Descriptor fd(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  if (fd.get() < 0) return writeError(path, errno);
  const bool whole = writeAll(fd.get(), &prefix, sizeof prefix) &&
                     writeAll(fd.get(), out.bytes().data(), out.bytes().size()) &&
                     writeAll(fd.get(), &sum, sizeof sum) &&
                     writeAll(fd.get(), payload.data(), payload.size()) && ::fsync(fd.get()) == 0 &&
                     fd.close() == 0 && ::rename(temporary.c_str(), path.c_str()) == 0;
  if (!whole) {
    const int number = errno;
    ::unlink(temporary.c_str());
    return writeError(path, number);
  }
  return {};
}

Result<CheckedFileHeader> readCheckedHeader(const std::string& path) {
  const Result<int> opened = openForReading(path);
  if (!opened) return opened.error();
  const Descriptor fd(*opened);
  Prefix prefix;
  return readHeader(fd.get(), path, prefix);
}

Result<CheckedFile> readCheckedFile(const std::string& path) {
  const Result<int> opened = openForReading(path);
  if (!opened) return opened.error();
  const Descriptor fd(*opened);
  Prefix prefix;
  Result<CheckedFileHeader> header = readHeader(fd.get(), path, prefix);
  if (!header) return header.error();
  CheckedFile file{std::move(*header), {}};
  file.payload.resize(static_cast<std::size_t>(prefix.payloadBytes));
  if (!readAll(fd.get(), file.payload.data(), file.payload.size())) return damaged(path, "it is too short");
  if (Hasher().addBytes(file.payload.data(), file.payload.size()).digest() != prefix.payloadSum)
    return damaged(path, "its checksum is wrong");
  std::optional<std::vector<char>> unpacked = unpackBytes(file.payload);
  if (!unpacked) return damaged(path, "it is packed in a way that this program cannot read");
  file.payload = std::move(*unpacked);
  return file;
}

}  // namespace spin
