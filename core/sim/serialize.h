// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "core/base/result.h"

namespace spin {

/// Little-endian binary writer for cache frames, checkpoints and the import helper's answers.
class ByteWriter {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) {
    const auto* bytes = reinterpret_cast<const char*>(&value);
    m_bytes.insert(m_bytes.end(), bytes, bytes + sizeof value);
  }
  void put(const std::string& text) {
    put(static_cast<std::uint64_t>(text.size()));
    m_bytes.insert(m_bytes.end(), text.begin(), text.end());
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void putArray(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    const auto* bytes = reinterpret_cast<const char*>(values.data());
    m_bytes.insert(m_bytes.end(), bytes, bytes + values.size() * sizeof(T));
  }
  const std::vector<char>& bytes() const { return m_bytes; }
  std::vector<char> take() { return std::move(m_bytes); }

 private:
  std::vector<char> m_bytes;
};

/// Reads what ByteWriter wrote. Never reads past the end and never allocates more than the bytes that are
/// there: a short or damaged input leaves ok() false and yields zeros.
class ByteReader {
 public:
  ByteReader(const char* data, std::size_t size) : m_data(data), m_size(size) {}

  template <class T>
  requires std::is_trivially_copyable_v<T> T get() {
    T value{};
    if (take(sizeof value)) std::memcpy(&value, m_data + m_at - sizeof value, sizeof value);
    return value;
  }
  std::string getText() {
    const auto size = get<std::uint64_t>();
    if (!m_ok || size > m_size - m_at || !take(static_cast<std::size_t>(size)))
      return m_ok = false, std::string();
    return std::string(m_data + m_at - size, static_cast<std::size_t>(size));
  }
  template <class T>
  requires std::is_trivially_copyable_v<T> std::vector<T> getArray() {
    const auto count = get<std::uint64_t>();
    if (!m_ok || count > (m_size - m_at) / sizeof(T)) return m_ok = false, std::vector<T>();
    std::vector<T> values(static_cast<std::size_t>(count));
    take(values.size() * sizeof(T));
    if (!values.empty())
      std::memcpy(values.data(), m_data + m_at - values.size() * sizeof(T), values.size() * sizeof(T));
    return values;
  }
  bool ok() const { return m_ok; }
  bool atEnd() const { return m_at == m_size; }

 private:
  bool take(std::size_t bytes) {
    if (!m_ok || bytes > m_size - m_at) return m_ok = false;
    m_at += bytes;
    return true;
  }
  const char* m_data;
  std::size_t m_size;
  std::size_t m_at = 0;
  bool m_ok = true;
};

}  // namespace spin
