// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace spin {

/// 128-bit content key. Not cryptographic.
struct Hash128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  auto operator<=>(const Hash128&) const = default;
  bool isNull() const { return high == 0 && low == 0; }
  /// 32 lower-case hexadecimal digits.
  std::string hex() const;
};

/// Streaming hash (XXH3, 128 bits) over values in the order they are added. Strings are added with their
/// length, so that ("ab","c") and ("a","bc") differ.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;

  Hasher& addBytes(const void* data, std::size_t size);
  Hasher& add(std::string_view text);
  Hasher& add(const char* text) { return add(std::string_view(text)); }
  Hasher& add(const Hash128& hash) { return add(hash.high).add(hash.low); }
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T> Hasher& add(T value) {
    return addBytes(&value, sizeof value);
  }
  Hash128 digest() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace spin
