// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <new>

namespace spin {

/// N arrays of one length for loops that walk along all of them at once. The memory is one piece, not set to
/// anything, and the columns begin at different places of a page: arrays that all begin on one would share
/// the few ways of the same cache sets.
template <class T, std::size_t N>
class Columns {
 public:
  /// Makes room for that many values a column. What was in it is lost where it has to grow. Throws
  /// std::bad_alloc where no such memory is.
  void reserve(std::size_t length) {
    if (length <= m_room) return;
    if (length > std::numeric_limits<std::size_t>::max() / (2 * N * sizeof(T)) - kPage)
      throw std::bad_alloc();
    const std::size_t stride = (length + kPage - 1) / kPage * kPage + kStagger;
    m_memory = std::make_unique_for_overwrite<T[]>(stride * N);
    m_stride = stride;
    m_room = length;
  }
  T* operator[](std::size_t column) { return m_memory.get() + column * m_stride; }
  const T* operator[](std::size_t column) const { return m_memory.get() + column * m_stride; }

 private:
  static constexpr std::size_t kPage = 4096 / sizeof(T), kStagger = 320 / sizeof(T);  // five cache lines

  std::size_t m_room = 0, m_stride = 0;
  std::unique_ptr<T[]> m_memory;
};

}  // namespace spin
