// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/base/result.h"

namespace spin {

/// What a cache file says about itself.
struct CheckedFileHeader {
  std::string kind;             ///< "frame", "checkpoint", "shared:cover"
  std::int64_t number = 0;      ///< frame number, 0 for shared data
  Hash128 key;                  ///< content key
  std::vector<Hash128> shared;  ///< keys of shared files that this one needs
};

struct CheckedFile {
  CheckedFileHeader header;
  std::vector<char> payload;
};

/// Cache files: magic, version, header, length and checksums of header and payload, so that every truncation
/// and every flipped byte is found. Written to a temporary name, flushed to the disk and renamed: a file with
/// the final name is whole, whenever the process or the machine dies.
Status writeCheckedFile(const std::string& path, const CheckedFileHeader& header,
                        const std::vector<char>& payload);

/// Reads and verifies the header and that the file has the length it claims; cheap.
Result<CheckedFileHeader> readCheckedHeader(const std::string& path);

/// Reads and verifies all.
Result<CheckedFile> readCheckedFile(const std::string& path);

}  // namespace spin
