// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/cache_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <optional>

#include "core/base/log.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFrameKind = "frame";
constexpr const char* kCheckpointKind = "checkpoint";
constexpr const char* kSharedPrefix = "shared:";
constexpr std::chrono::minutes kSharedGrace{10};

const char* folderOf(CacheFolder::Kind kind) {
  return kind == CacheFolder::Kind::Frame ? "frames" : "checkpoints";
}
const char* kindName(CacheFolder::Kind kind) {
  return kind == CacheFolder::Kind::Frame ? kFrameKind : kCheckpointKind;
}

/// "000012-0123...ef.frame" gives 12 and the key.
std::optional<std::pair<int, Hash128>> parseName(const std::string& name, const std::string& extension) {
  const std::size_t dash = name.find('-');
  if (dash == std::string::npos || name.size() != dash + 1 + 32 + 1 + extension.size()) return std::nullopt;
  if (name.substr(dash + 34) != extension || name[dash + 33] != '.') return std::nullopt;
  const char* text = name.data();
  int frame = 0;
  Hash128 key;
  const auto whole = [](std::from_chars_result result, const char* end) {
    return result.ec == std::errc() && result.ptr == end;
  };
  if (!whole(std::from_chars(text, text + dash, frame), text + dash) || frame < 0) return std::nullopt;
  const char* hex = text + dash + 1;
  if (!whole(std::from_chars(hex, hex + 16, key.high, 16), hex + 16)) return std::nullopt;
  if (!whole(std::from_chars(hex + 16, hex + 32, key.low, 16), hex + 32)) return std::nullopt;
  return std::pair(frame, key);
}

struct Listed {
  fs::file_time_type time;
  std::string name;
  int frame = 0;
  Hash128 key;
  std::uint64_t bytes = 0;
};

std::vector<Listed> list(const std::string& folder, const std::string& extension) {
  std::vector<Listed> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    Listed file;
    file.name = it->path().filename().string();
    const auto parsed = parseName(file.name, extension);
    std::error_code ignored;
    if (!parsed || !it->is_regular_file(ignored)) continue;
    std::tie(file.frame, file.key) = *parsed;
    file.bytes = it->file_size(ignored);
    file.time = it->last_write_time(ignored);
    found.push_back(std::move(file));
  }
  std::sort(found.begin(), found.end(), [](const Listed& a, const Listed& b) {
    return a.time != b.time ? a.time < b.time : a.name < b.name;
  });
  return found;
}

Result<CheckedFile> readExpected(const std::string& path, const std::string& kind, int frame,
                                 const Hash128& key) {
  Result<CheckedFile> file = readCheckedFile(path);
  if (!file) return file;
  if (file->header.kind != kind || file->header.number != frame || file->header.key != key)
    return badInput("The cache file is damaged", path, "its content is not what its name says");
  return file;
}

}  // namespace

CacheFolder::CacheFolder(std::string path) : m_path(std::move(path)) {
  if (!active()) return;
  for (const char* folder : {"frames", "checkpoints", "shared"}) {
    std::error_code error;
    fs::create_directories(fs::path(m_path) / folder, error);
    if (error) logWarning(fmt::format("The cache folder {} cannot be used: {}", m_path, error.message()));
    if (error) return;
  }
}

std::string CacheFolder::pathOf(Kind kind, int frame, const Hash128& key) const {
  return fmt::format("{}/{}/{:06}-{}.{}", m_path, folderOf(kind), frame, key.hex(), kindName(kind));
}

std::string CacheFolder::sharedPath(const Hash128& key) const {
  return fmt::format("{}/shared/{}.shared", m_path, key.hex());
}

bool CacheFolder::seenBefore(const std::string& name, std::int64_t written) {
  std::lock_guard lock(m_mutex);
  const auto [entry, fresh] = m_seen.try_emplace(name, written);
  return !fresh && std::exchange(entry->second, written) == written;
}

std::vector<CacheFolder::Entry> CacheFolder::newFiles(Kind kind) {
  std::vector<Entry> entries;
  if (!active()) return entries;
  std::vector<std::string> problems;
  const std::string folder = fmt::format("{}/{}", m_path, folderOf(kind));
  for (const Listed& file : list(folder, kindName(kind))) {
    if (seenBefore(file.name, file.time.time_since_epoch().count())) continue;
    const Result<CheckedFileHeader> header = readCheckedHeader(folder + "/" + file.name);
    if (!header) {
      problems.push_back(header.error().text());
      continue;
    }
    const bool fits =
        header->kind == kindName(kind) && header->number == file.frame && header->key == file.key;
    const bool whole = fits && std::all_of(header->shared.begin(), header->shared.end(),
                                           [this](const Hash128& key) { return sharedIsThere(key); });
    if (whole)
      entries.push_back({file.frame, file.key, file.bytes, header->shared});
    else
      problems.push_back(fmt::format(
          "The cache file {}/{} cannot be used: {}", folder, file.name,
          fits ? "data that it shares is damaged or missing" : "its content is not what its name says"));
  }
  // A folder of another version is one message, not hundreds.
  if (!problems.empty()) logWarning(problems.front());
  if (problems.size() > 1)
    logWarning(fmt::format("{} more files in {} cannot be used either; what they held is computed again",
                           problems.size() - 1, folder));
  return entries;
}

bool CacheFolder::sharedIsThere(const Hash128& key) {
  {
    std::lock_guard lock(m_mutex);
    if (m_there.count(key)) return true;
  }
  const Result<CheckedFileHeader> header = readCheckedHeader(sharedPath(key));
  if (!header || header->key != key) return false;
  std::lock_guard lock(m_mutex);
  m_there.insert(key);
  return true;
}

bool CacheFolder::sharedIsWhole(const Hash128& key) {
  {
    std::lock_guard lock(m_mutex);
    // Another process may have cleaned the folder meanwhile.
    std::error_code error;
    if (m_whole.count(key) && fs::exists(sharedPath(key), error)) return true;
  }
  const Result<CheckedFile> file = readCheckedFile(sharedPath(key));
  if (!file || file->header.key != key) return false;
  std::lock_guard lock(m_mutex);
  m_there.insert(key);
  m_whole.insert(key);
  return true;
}

Status CacheFolder::writeShared(const FramePart& part, const Hash128& key) {
  if (sharedIsWhole(key)) return {};
  ByteWriter out;
  part.saveShared(key, out);
  const std::string kind = std::string(kSharedPrefix) + part.kind();
  if (Status written = writeCheckedFile(sharedPath(key), {kind, 0, key, {}}, out.bytes()); !written)
    return written;
  std::lock_guard lock(m_mutex);
  m_there.insert(key);
  m_whole.insert(key);
  m_own.insert(key);
  return {};
}

Result<std::shared_ptr<const void>> CacheFolder::loadedShared(const Hash128& key) {
  {
    std::lock_guard lock(m_mutex);
    const auto known = m_loaded.find(key);
    if (known != m_loaded.end())
      if (auto inUse = known->second.lock()) return inUse;
  }
  const Result<CheckedFile> file = readCheckedFile(sharedPath(key));
  if (!file) {
    // The next frame that shares it writes it again.
    std::lock_guard lock(m_mutex);
    m_there.erase(key);
    m_whole.erase(key);
    return file.error();
  }
  ByteReader in(file->payload.data(), file->payload.size());
  const std::string prefix = kSharedPrefix;
  const std::string& kind = file->header.kind;
  auto loaded = kind.starts_with(prefix) ? loadShared(kind.substr(prefix.size()), in) : nullptr;
  if (!loaded) return badInput("The cache file is damaged", sharedPath(key), "its content cannot be read");
  std::lock_guard lock(m_mutex);
  std::erase_if(m_loaded, [](const auto& entry) { return entry.second.expired(); });
  m_loaded[key] = loaded;
  return loaded;
}

Result<CacheFolder::Entry> CacheFolder::writeFrame(const Frame& frame) {
  Entry entry{frame.info.time.frame, frame.info.key, 0, {}};
  for (const auto& [name, part] : frame.parts)
    for (const Hash128& key : part->sharedKeys()) {
      if (Status written = writeShared(*part, key); !written) return written.error();
      entry.shared.push_back(key);
    }
  ByteWriter out;
  saveFrame(frame, out);
  const std::string path = pathOf(Kind::Frame, entry.frame, entry.key);
  const CheckedFileHeader header{kFrameKind, entry.frame, entry.key, entry.shared};
  if (Status written = writeCheckedFile(path, header, out.bytes()); !written) return written.error();
  std::error_code error;
  entry.bytes = fs::file_size(path, error);
  return entry;
}

Result<FramePointer> CacheFolder::readFrame(int frame, const Hash128& key) {
  const std::string path = pathOf(Kind::Frame, frame, key);
  const Result<CheckedFile> file = readExpected(path, kFrameKind, frame, key);
  if (!file) return file.error();
  std::vector<std::shared_ptr<const void>> held;  // until the frame holds it itself
  for (const Hash128& shared : file->header.shared) {
    Result<std::shared_ptr<const void>> loaded = loadedShared(shared);
    if (!loaded) return loaded.error();
    held.push_back(std::move(*loaded));
  }
  ByteReader in(file->payload.data(), file->payload.size());
  const std::shared_ptr<Frame> loaded = loadFrame(in);
  if (!loaded || loaded->info.key != key)
    return badInput("The cache file is damaged", path, "its content cannot be read");
  return FramePointer(loaded);
}

Result<CacheFolder::Entry> CacheFolder::writeCheckpoint(int frame, const Hash128& key,
                                                        const std::vector<char>& state) {
  const std::string path = pathOf(Kind::Checkpoint, frame, key);
  if (Status written = writeCheckedFile(path, {kCheckpointKind, frame, key, {}}, state); !written)
    return written.error();
  std::error_code error;
  return Entry{frame, key, fs::file_size(path, error), {}};
}

Result<std::vector<char>> CacheFolder::readCheckpoint(int frame, const Hash128& key) {
  Result<CheckedFile> file = readExpected(pathOf(Kind::Checkpoint, frame, key), kCheckpointKind, frame, key);
  if (!file) return file.error();
  return std::move(file->payload);
}

Status CacheFolder::remove(Kind kind, int frame, const Hash128& key) {
  std::error_code error;
  const std::string path = pathOf(kind, frame, key);
  fs::remove(path, error);
  if (!error) return {};
  return Error{ErrorKind::Failed, "The cache file could not be deleted", path, error.message(),
               "Check the folder's permissions"};
}

Status CacheFolder::removeSharedBut(const std::vector<Hash128>& used) {
  std::lock_guard lock(m_mutex);
  for (auto it = m_there.begin(); it != m_there.end();) {
    std::error_code error;
    // Another process writes what its frame shares before the frame.
    const bool fresh =
        !m_own.count(*it) &&
        fs::file_time_type::clock::now() - fs::last_write_time(sharedPath(*it), error) < kSharedGrace;
    if (fresh || std::find(used.begin(), used.end(), *it) != used.end()) {
      ++it;
      continue;
    }
    fs::remove(sharedPath(*it), error);
    if (error)
      return Error{ErrorKind::Failed, "The cache file could not be deleted", sharedPath(*it), error.message(),
                   ""};
    m_whole.erase(*it);
    m_own.erase(*it);
    it = m_there.erase(it);
  }
  return {};
}

std::uint64_t CacheFolder::sharedBytes() const {
  std::uint64_t bytes = 0;
  std::lock_guard lock(m_mutex);
  for (const Hash128& key : m_there) {
    std::error_code error;
    const std::uint64_t size = fs::file_size(sharedPath(key), error);
    if (!error) bytes += size;
  }
  return bytes;
}

}  // namespace spin
