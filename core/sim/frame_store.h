// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/sim/frame.h"

namespace spin {

enum class FrameState : std::uint8_t { Missing, Stale, Ready };

struct FrameStoreOptions {
  std::string directory;  ///< cache folder; empty = RAM only
  std::size_t memoryBudget = std::size_t{1}
                             << 30;  ///< bytes of frames kept in RAM; least recently used leave first
};

/// Frames and checkpoints by number and content key. Thread-safe. Frames whose key no longer fits the scene
/// stay as "stale" (still shown while scrubbing) until the new frame of that number replaces them; nothing on
/// disk is deleted but by purgeStale(). Files are written to a temporary name and renamed; a damaged file
/// counts as missing.
class FrameStore {
 public:
  /// Makes the folder and takes in what lies there. A folder that cannot be used is a warning in the log, and
  /// the first put() fails.
  explicit FrameStore(FrameStoreOptions options = {});
  ~FrameStore();
  FrameStore(const FrameStore&) = delete;
  FrameStore& operator=(const FrameStore&) = delete;

  const FrameStoreOptions& options() const;

  /// Declares the valid keys for frames 0 .. keys.size()-1; frames with other keys become stale. Also takes
  /// in files that another process has put into the folder meanwhile.
  void setKeys(std::vector<Hash128> keys);
  std::vector<Hash128> keys() const;
  /// Number of the last frame or checkpoint of any key, also of those that another process has written; -1 =
  /// none.
  int lastFrame();
  FrameState state(int frame) const;
  /// Whether a frame with this content is there, whatever keys are declared.
  bool has(int frame, const Hash128& key) const;
  /// States of frames 0 .. count-1 in one call (for the timeline).
  std::vector<FrameState> states(int count) const;

  /// Keeps a frame under info.time.frame and info.key; in RAM at once, on disk before it returns.
  /// RAM only: frames that the budget pushes out are missing again.
  Status put(FramePointer frame);
  /// The frame with the valid key (from RAM or disk); null if not ready.
  FramePointer get(int frame);
  /// As get(), else the stale frame of that number, else the nearest ready or stale one; null if the store is
  /// empty.
  FramePointer nearest(int frame);

  /// A RAM-only store keeps the latest few checkpoints.
  Status putCheckpoint(int frame, const Hash128& key, const std::vector<char>& state);
  /// The latest checkpoint at or before `frame` whose key is valid.
  struct Checkpoint {
    int frame = 0;
    std::vector<char> state;
  };
  std::optional<Checkpoint> latestCheckpoint(int frame);

  struct Usage {
    std::size_t memoryBytes = 0;
    std::uint64_t diskBytes = 0;
    std::uint64_t staleDiskBytes = 0;
  };
  Usage usage() const;
  /// Deletes stale frames and checkpoints from disk and RAM, on the user's word only. Needs declared keys.
  Status purgeStale();

 private:
  class State;
  std::unique_ptr<State> m_state;
};

}  // namespace spin
