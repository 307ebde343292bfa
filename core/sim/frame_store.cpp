// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/frame_store.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "core/base/log.h"
#include "core/sim/cache_folder.h"

namespace spin {
namespace {

/// Checkpoints that a store without a folder keeps.
constexpr std::size_t kMemoryCheckpoints = 4;

/// One version of one frame.
struct FrameSlot {
  Hash128 key;
  std::uint64_t diskBytes = 0;  ///< 0 = not on disk
  std::uint64_t used = 0;       ///< clock of the last use
  bool writing = false;         ///< on its way to the disk: must stay in RAM
  FramePointer memory;
  std::vector<Hash128> shared;
};

bool isWriting(const FrameSlot& slot) {
  return slot.writing;
}

struct CheckpointSlot {
  Hash128 key;
  std::uint64_t diskBytes = 0;
  std::uint64_t made = 0;
  std::shared_ptr<const std::vector<char>> memory;
};

bool isWriting(const CheckpointSlot&) {
  return false;
}

template <class Slot>
Slot* findSlot(std::map<int, std::vector<Slot>>& slots, int frame, const Hash128& key) {
  const auto it = slots.find(frame);
  if (it == slots.end()) return nullptr;
  for (Slot& slot : it->second)
    if (slot.key == key) return &slot;
  return nullptr;
}

template <class Slot>
Slot& slotFor(std::map<int, std::vector<Slot>>& slots, int frame, const Hash128& key) {
  if (Slot* slot = findSlot(slots, frame, key)) return *slot;
  auto& versions = slots[frame];
  versions.emplace_back();
  versions.back().key = key;
  return versions.back();
}

template <class Slot>
void eraseSlot(std::map<int, std::vector<Slot>>& slots, int frame, const Hash128& key) {
  const auto it = slots.find(frame);
  if (it == slots.end()) return;
  std::erase_if(it->second, [&](const Slot& slot) { return slot.key == key; });
  if (it->second.empty()) slots.erase(it);
}

}  // namespace

/// All members of State but `folder` are guarded by `mutex`; files are read and written outside the lock, so
/// that asking for states never waits for the disk.
class FrameStore::State {
 public:
  explicit State(FrameStoreOptions o) : options(std::move(o)), folder(options.directory) {}

  FrameStoreOptions options;
  CacheFolder folder;
  mutable std::mutex mutex;
  std::vector<Hash128> keys;
  std::map<int, std::vector<FrameSlot>> frames;
  std::map<int, std::vector<CheckpointSlot>> checkpoints;
  std::size_t memoryBytes = 0;
  std::uint64_t clock = 0;

  bool valid(int frame, const Hash128& key) const {
    return frame >= 0 && static_cast<std::size_t>(frame) < keys.size() &&
           keys[static_cast<std::size_t>(frame)] == key;
  }
  FrameState stateOf(int frame) const {
    const auto it = frames.find(frame);
    if (it == frames.end()) return FrameState::Missing;
    const bool ready = std::any_of(it->second.begin(), it->second.end(),
                                   [&](const FrameSlot& slot) { return valid(frame, slot.key); });
    return ready ? FrameState::Ready : FrameState::Stale;
  }
  void dropMemory(FrameSlot& slot) {
    if (!slot.memory) return;
    memoryBytes -= slot.memory->memoryBytes();
    slot.memory.reset();
  }
  void keepInMemory(FrameSlot& slot, FramePointer frame) {
    dropMemory(slot);
    slot.memory = std::move(frame);
    slot.used = ++clock;
    memoryBytes += slot.memory->memoryBytes();
  }
  void scan();
  void evict();
  void dropReplaced(int frame, const Hash128& key);
  FramePointer fetch(int frame, const Hash128& key);
  std::vector<std::pair<int, Hash128>> candidates(int frame) const;
  void limitMemoryCheckpoints();
};

void FrameStore::State::scan() {
  const std::vector<CacheFolder::Entry> frameFiles = folder.newFiles(CacheFolder::Kind::Frame);
  const std::vector<CacheFolder::Entry> checkpointFiles = folder.newFiles(CacheFolder::Kind::Checkpoint);
  std::lock_guard lock(mutex);
  for (const CacheFolder::Entry& file : frameFiles) {
    FrameSlot& slot = slotFor(frames, file.frame, file.key);
    slot.diskBytes = file.bytes;
    if (slot.used == 0) slot.used = ++clock;
    slot.shared = file.shared;
  }
  for (const CacheFolder::Entry& file : checkpointFiles)
    slotFor(checkpoints, file.frame, file.key).diskBytes = file.bytes;
}

/// Stale frames leave RAM first, then the least recently used; the last used one stays even if it alone
/// exceeds the budget.
void FrameStore::State::evict() {
  while (memoryBytes > options.memoryBudget) {
    FrameSlot* oldest = nullptr;
    int oldestFrame = 0;
    const auto rank = [this](int frame, const FrameSlot& slot) {
      return std::pair(valid(frame, slot.key), slot.used);
    };
    for (auto& [frame, versions] : frames)
      for (FrameSlot& slot : versions) {
        if (!slot.memory || slot.writing || slot.used == clock) continue;
        if (oldest && rank(oldestFrame, *oldest) < rank(frame, slot)) continue;
        oldest = &slot;
        oldestFrame = frame;
      }
    if (!oldest) return;
    dropMemory(*oldest);
    if (oldest->diskBytes == 0) eraseSlot(frames, oldestFrame, Hash128(oldest->key));
  }
}

/// Older versions of a frame leave RAM once the valid one is there; their files stay.
void FrameStore::State::dropReplaced(int frame, const Hash128& key) {
  if (!valid(frame, key)) return;
  auto& versions = frames[frame];
  for (FrameSlot& slot : versions)
    if (slot.key != key && !slot.writing) dropMemory(slot);
  std::erase_if(versions, [](const FrameSlot& slot) { return !slot.memory && slot.diskBytes == 0; });
}

FramePointer FrameStore::State::fetch(int frame, const Hash128& key) {
  {
    std::lock_guard lock(mutex);
    FrameSlot* slot = findSlot(frames, frame, key);
    if (!slot) return nullptr;
    slot->used = ++clock;
    if (slot->memory) return slot->memory;
  }
  Result<FramePointer> loaded = folder.readFrame(frame, key);
  std::lock_guard lock(mutex);
  FrameSlot* slot = findSlot(frames, frame, key);
  if (!loaded) {
    logWarning(loaded.error().text());
    if (slot && !slot->memory) eraseSlot(frames, frame, key);
    return nullptr;
  }
  if (slot && !slot->memory) {
    keepInMemory(*slot, *loaded);
    evict();
  }
  return *loaded;
}

/// Frames to show instead of `frame`, best first.
std::vector<std::pair<int, Hash128>> FrameStore::State::candidates(int frame) const {
  struct Candidate {
    int distance;
    bool stale;
    bool later;
    std::uint64_t unused;
    int frame;
    Hash128 key;
    auto operator<=>(const Candidate&) const = default;
  };
  std::vector<Candidate> all;
  for (const auto& [number, versions] : frames)
    for (const FrameSlot& slot : versions)
      all.push_back(
          {std::abs(number - frame), !valid(number, slot.key), number > frame, ~slot.used, number, slot.key});
  std::sort(all.begin(), all.end());
  std::vector<std::pair<int, Hash128>> order;
  for (const Candidate& c : all) order.emplace_back(c.frame, c.key);
  return order;
}

void FrameStore::State::limitMemoryCheckpoints() {
  while (checkpoints.size() > kMemoryCheckpoints) {
    auto oldest = checkpoints.begin();
    for (auto it = checkpoints.begin(); it != checkpoints.end(); ++it)
      if (it->second.back().made < oldest->second.back().made) oldest = it;
    checkpoints.erase(oldest);
  }
}

FrameStore::FrameStore(FrameStoreOptions options) : m_state(std::make_unique<State>(std::move(options))) {
  m_state->scan();
}

FrameStore::~FrameStore() = default;

const FrameStoreOptions& FrameStore::options() const {
  return m_state->options;
}

void FrameStore::setKeys(std::vector<Hash128> keys) {
  m_state->scan();
  std::lock_guard lock(m_state->mutex);
  m_state->keys = std::move(keys);
}

int FrameStore::lastFrame() {
  m_state->scan();
  std::lock_guard lock(m_state->mutex);
  const int frame = m_state->frames.empty() ? -1 : m_state->frames.rbegin()->first;
  const int checkpoint = m_state->checkpoints.empty() ? -1 : m_state->checkpoints.rbegin()->first;
  return std::max(frame, checkpoint);
}

std::vector<Hash128> FrameStore::keys() const {
  std::lock_guard lock(m_state->mutex);
  return m_state->keys;
}

FrameState FrameStore::state(int frame) const {
  std::lock_guard lock(m_state->mutex);
  return m_state->stateOf(frame);
}

bool FrameStore::has(int frame, const Hash128& key) const {
  std::lock_guard lock(m_state->mutex);
  return findSlot(m_state->frames, frame, key) != nullptr;
}

std::vector<FrameState> FrameStore::states(int count) const {
  std::lock_guard lock(m_state->mutex);
  std::vector<FrameState> states;
  for (int frame = 0; frame < count; ++frame) states.push_back(m_state->stateOf(frame));
  return states;
}

Status FrameStore::put(FramePointer frame) {
  State& s = *m_state;
  const int number = frame->info.time.frame;
  const Hash128 key = frame->info.key;
  std::vector<Hash128> shared;
  for (const SharedReference& reference : sharedReferences(*frame)) shared.push_back(reference.key);
  {
    std::lock_guard lock(s.mutex);
    FrameSlot& slot = slotFor(s.frames, number, key);
    slot.writing = s.folder.active();
    slot.shared = std::move(shared);
    s.keepInMemory(slot, frame);
    s.dropReplaced(number, key);
    s.evict();
  }
  if (!s.folder.active()) return {};
  const Result<CacheFolder::Entry> written = s.folder.writeFrame(*frame);
  std::lock_guard lock(s.mutex);
  FrameSlot& slot = slotFor(s.frames, number, key);
  slot.writing = false;
  if (!written) return written.error();
  slot.diskBytes = written->bytes;
  s.evict();
  return {};
}

FramePointer FrameStore::get(int frame) {
  Hash128 key;
  {
    std::lock_guard lock(m_state->mutex);
    if (m_state->stateOf(frame) != FrameState::Ready) return nullptr;
    key = m_state->keys[static_cast<std::size_t>(frame)];
  }
  return m_state->fetch(frame, key);
}

FramePointer FrameStore::nearest(int frame) {
  std::vector<std::pair<int, Hash128>> order;
  {
    std::lock_guard lock(m_state->mutex);
    order = m_state->candidates(frame);
  }
  for (const auto& [number, key] : order)
    if (FramePointer found = m_state->fetch(number, key)) return found;
  return nullptr;
}

Status FrameStore::putCheckpoint(int frame, const Hash128& key, const std::vector<char>& state) {
  State& s = *m_state;
  if (!s.folder.active()) {
    std::lock_guard lock(s.mutex);
    CheckpointSlot& slot = slotFor(s.checkpoints, frame, key);
    slot.memory = std::make_shared<const std::vector<char>>(state);
    slot.made = ++s.clock;
    std::erase_if(s.checkpoints[frame], [&](const CheckpointSlot& other) { return other.key != key; });
    s.limitMemoryCheckpoints();
    return {};
  }
  const Result<CacheFolder::Entry> written = s.folder.writeCheckpoint(frame, key, state);
  if (!written) return written.error();
  std::lock_guard lock(s.mutex);
  slotFor(s.checkpoints, frame, key).diskBytes = written->bytes;
  return {};
}

std::optional<FrameStore::Checkpoint> FrameStore::latestCheckpoint(int frame) {
  State& s = *m_state;
  for (;;) {
    int number = -1;
    CheckpointSlot slot;
    {
      std::lock_guard lock(s.mutex);
      for (const auto& [at, versions] : s.checkpoints)
        for (const CheckpointSlot& candidate : versions)
          if (at <= frame && s.valid(at, candidate.key)) number = at, slot = candidate;
    }
    if (number < 0) return std::nullopt;
    if (slot.memory) return Checkpoint{number, *slot.memory};
    Result<std::vector<char>> state = s.folder.readCheckpoint(number, slot.key);
    if (state) return Checkpoint{number, std::move(*state)};
    logWarning(state.error().text());
    std::lock_guard lock(s.mutex);
    eraseSlot(s.checkpoints, number, slot.key);
  }
}

FrameStore::Usage FrameStore::usage() const {
  Usage usage;
  std::lock_guard lock(m_state->mutex);
  const State& s = *m_state;
  usage.memoryBytes = s.memoryBytes;
  usage.diskBytes = s.folder.sharedBytes();
  const auto count = [&](const auto& slots) {
    for (const auto& [frame, versions] : slots)
      for (const auto& slot : versions) {
        usage.diskBytes += slot.diskBytes;
        if (!s.valid(frame, slot.key)) usage.staleDiskBytes += slot.diskBytes;
      }
  };
  count(s.frames);
  count(s.checkpoints);
  for (const auto& [frame, versions] : s.checkpoints)
    for (const CheckpointSlot& slot : versions)
      if (slot.memory) usage.memoryBytes += slot.memory->size();
  return usage;
}

Status FrameStore::purgeStale() {
  State& s = *m_state;
  // What another process has written since then needs its shared data too.
  s.scan();
  std::lock_guard lock(s.mutex);
  if (s.keys.empty())
    return Error{ErrorKind::Usage, "The cache was not cleaned", s.options.directory,
                 "which frames are stale is known only once a scene is loaded", "Load the scene first"};
  Status status;
  const auto purge = [&](auto& slots, CacheFolder::Kind kind, const auto& forget) {
    for (auto& [frame, versions] : slots)
      std::erase_if(versions, [&](auto& slot) {
        if (s.valid(frame, slot.key) || isWriting(slot)) return false;
        if (slot.diskBytes > 0)
          if (Status removed = s.folder.remove(kind, frame, slot.key); !removed)
            return status = removed, false;
        forget(slot);
        return true;
      });
    std::erase_if(slots, [](const auto& entry) { return entry.second.empty(); });
  };
  purge(s.frames, CacheFolder::Kind::Frame, [&](FrameSlot& slot) { s.dropMemory(slot); });
  purge(s.checkpoints, CacheFolder::Kind::Checkpoint, [](CheckpointSlot&) {});
  if (!status) return status;
  std::vector<Hash128> used;
  for (const auto& [frame, versions] : s.frames)
    for (const FrameSlot& slot : versions) used.insert(used.end(), slot.shared.begin(), slot.shared.end());
  return s.folder.removeSharedBut(used);
}

}  // namespace spin
