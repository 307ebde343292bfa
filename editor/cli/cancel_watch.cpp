// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/cancel_watch.h"

#include <chrono>
#include <utility>

namespace spin {
namespace {

constexpr auto kLook = std::chrono::milliseconds(25);
/// Leaves the rest of the second for the end of the program.
constexpr auto kPatience = std::chrono::milliseconds(700);

}  // namespace

CancelWatch::CancelWatch(const CancelToken& cancel) : m_cancel(cancel), m_thread([this] { watch(); }) {}

CancelWatch::~CancelWatch() {
  m_quit = true;
  m_thread.join();
}

void CancelWatch::watch() {
  std::chrono::milliseconds waited{0};
  while (!m_quit) {
    std::this_thread::sleep_for(kLook);
    if (!m_cancel.cancelled()) continue;
    waited += kLook;
    if (waited < kPatience) continue;
    const std::lock_guard lock(m_mutex);
    if (m_abandon) std::exchange(m_abandon, nullptr)();
  }
}

CancelWatch::Section::Section(CancelWatch* watch, std::function<void()> abandon) : m_watch(watch) {
  if (!m_watch) return;
  const std::lock_guard lock(m_watch->m_mutex);
  m_watch->m_abandon = std::move(abandon);
}

CancelWatch::Section::~Section() {
  if (!m_watch) return;
  const std::lock_guard lock(m_watch->m_mutex);
  m_watch->m_abandon = nullptr;
}

}  // namespace spin
