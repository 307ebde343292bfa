// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "core/base/hash.h"
#include "core/sim/serialize.h"

namespace spin {

/// Data that frames share, as long as somebody holds it: found by its content, hashed once by its address.
/// putShared(const T&, ByteWriter&) beside T tells the content.
template <class T>
class SharedRegistry {
 public:
  Hash128 keyOf(const std::shared_ptr<const T>& data) {
    {
      std::lock_guard lock(m_mutex);
      const auto known = m_keys.find(data.get());
      if (known != m_keys.end() && known->second.first.lock() == data) return known->second.second;
    }
    ByteWriter out;
    putShared(*data, out);
    const Hash128 key = Hasher().addBytes(out.bytes().data(), out.bytes().size()).digest();
    std::lock_guard lock(m_mutex);
    std::erase_if(m_byKey, [](const auto& entry) { return entry.second.expired(); });
    std::erase_if(m_keys, [](const auto& entry) { return entry.second.first.expired(); });
    m_keys[data.get()] = {data, key};
    return key;
  }
  /// What is in use already if there is an equal one.
  std::shared_ptr<const T> intern(std::shared_ptr<const T> data) {
    const Hash128 key = keyOf(data);
    std::lock_guard lock(m_mutex);
    auto& entry = m_byKey[key];
    if (auto inUse = entry.lock()) return inUse;
    entry = data;
    return data;
  }
  std::shared_ptr<const T> find(const Hash128& key) {
    std::lock_guard lock(m_mutex);
    const auto entry = m_byKey.find(key);
    return entry == m_byKey.end() ? nullptr : entry->second.lock();
  }

 private:
  std::mutex m_mutex;
  std::map<Hash128, std::weak_ptr<const T>> m_byKey;
  std::map<const T*, std::pair<std::weak_ptr<const T>, Hash128>> m_keys;
};

template <class T>
SharedRegistry<T>& registryOf() {
  static SharedRegistry<T> registry;
  return registry;
}

}  // namespace spin
