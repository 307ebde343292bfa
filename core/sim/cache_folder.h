// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "core/sim/checked_file.h"
#include "core/sim/frame.h"

namespace spin {

/// The frame store's files:
///   frames/000012-KEY.frame, checkpoints/000012-KEY.checkpoint, shared/KEY.shared
/// Thread-safe. Knows nothing of which keys are valid.
class CacheFolder {
 public:
  /// A whole file of the folder, by the name and the header.
  struct Entry {
    int frame = 0;
    Hash128 key;
    std::uint64_t bytes = 0;
    std::vector<Hash128> shared;
  };
  enum class Kind { Frame, Checkpoint };

  /// Makes the folders; an empty path makes a folder that holds nothing.
  explicit CacheFolder(std::string path);
  bool active() const { return !m_path.empty(); }

  /// Files that are new or rewritten since the last call, oldest first. Damaged ones are named in the log and
  /// left out.
  std::vector<Entry> newFiles(Kind kind);

  /// Writes the frame and what it shares; gives the entry.
  Result<Entry> writeFrame(const Frame& frame);
  Result<FramePointer> readFrame(int frame, const Hash128& key);
  Result<Entry> writeCheckpoint(int frame, const Hash128& key, const std::vector<char>& state);
  Result<std::vector<char>> readCheckpoint(int frame, const Hash128& key);

  Status remove(Kind kind, int frame, const Hash128& key);
  /// Removes shared files whose key is not in the list; of other processes only those that have been there
  /// for a while, since the frame that needs one is written after it.
  Status removeSharedBut(const std::vector<Hash128>& used);
  std::uint64_t sharedBytes() const;

 private:
  std::string pathOf(Kind kind, int frame, const Hash128& key) const;
  std::string sharedPath(const Hash128& key) const;
  Status writeShared(const FramePart& part, const Hash128& key);
  /// Loads it, or finds it loaded.
  Result<std::shared_ptr<const void>> loadedShared(const Hash128& key);
  /// By its header and length; cheap.
  bool sharedIsThere(const Hash128& key);
  /// By all its bytes.
  bool sharedIsWhole(const Hash128& key);
  /// Whether the file was seen with this time of writing; remembers it.
  bool seenBefore(const std::string& name, std::int64_t written);

  std::string m_path;
  mutable std::mutex m_mutex;
  std::map<std::string, std::int64_t> m_seen;             ///< time of writing by file name
  std::map<Hash128, std::weak_ptr<const void>> m_loaded;  ///< shared data in use
  std::set<Hash128> m_there;                              ///< shared files of the folder
  std::set<Hash128> m_whole;                              ///< of these, those that were verified
  std::set<Hash128> m_own;                                ///< of these, those that this process wrote
};

}  // namespace spin
