// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/packed_bytes.h"

#ifdef SPIN_HAS_BLOSC
#include <blosc.h>
#endif

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace spin {
namespace {

// Layout: one byte that tells the form, then the bytes themselves or pieces: length | Blosc's buffer.
constexpr char kPlain = 0, kBlosc = 1;

std::vector<char> plain(const std::vector<char>& bytes) {
  std::vector<char> out(bytes.size() + 1);
  out[0] = kPlain;
  std::copy(bytes.begin(), bytes.end(), out.begin() + 1);
  return out;
}

#ifdef SPIN_HAS_BLOSC

constexpr std::size_t kPiece = std::size_t{16} << 20;

/// Appends one packed piece; false where the library cannot.
bool packPiece(const char* data, std::size_t size, std::vector<char>& out) {
  constexpr int kLevel = 1;
  const std::size_t before = out.size();
  out.resize(before + sizeof(std::uint32_t) + size + BLOSC_MAX_OVERHEAD);
  char* to = out.data() + before + sizeof(std::uint32_t);
  const int made = blosc_compress_ctx(kLevel, BLOSC_SHUFFLE, sizeof(float), size, data, to,
                                      size + BLOSC_MAX_OVERHEAD, BLOSC_ZSTD_COMPNAME, 0, 1);
  if (made <= 0) return false;
  const auto length = static_cast<std::uint32_t>(made);
  std::memcpy(out.data() + before, &length, sizeof length);
  out.resize(before + sizeof length + length);
  return true;
}

/// Takes one piece off the front of [at, end); false if it is damaged.
bool unpackPiece(const char*& at, const char* end, std::vector<char>& out) {
  std::uint32_t length = 0;
  if (static_cast<std::size_t>(end - at) < sizeof length) return false;
  std::memcpy(&length, at, sizeof length);
  at += sizeof length;
  std::size_t raw = 0;
  if (length > static_cast<std::size_t>(end - at) || blosc_cbuffer_validate(at, length, &raw) < 0 ||
      raw > kPiece)
    return false;
  const std::size_t before = out.size();
  out.resize(before + raw);
  if (blosc_decompress_ctx(at, out.data() + before, raw, 1) != static_cast<int>(raw)) return false;
  at += length;
  return true;
}

#endif

}  // namespace

std::vector<char> packBytes(const std::vector<char>& bytes) {
#ifdef SPIN_HAS_BLOSC
  std::vector<char> out{kBlosc};
  for (std::size_t at = 0; at < bytes.size(); at += kPiece)
    if (!packPiece(bytes.data() + at, std::min(kPiece, bytes.size() - at), out)) return plain(bytes);
  return out;
#else
  return plain(bytes);
#endif
}

std::optional<std::vector<char>> unpackBytes(const std::vector<char>& packed) {
  if (packed.empty()) return {};
  if (packed[0] == kPlain) return std::vector<char>(packed.begin() + 1, packed.end());
#ifdef SPIN_HAS_BLOSC
  if (packed[0] != kBlosc) return {};
  std::vector<char> out;
  const char* at = packed.data() + 1;
  const char* end = packed.data() + packed.size();
  while (at < end)
    if (!unpackPiece(at, end, out)) return {};
  return out;
#else
  return {};
#endif
}

}  // namespace spin
