// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/frame_fetcher.h"

#include <QMetaObject>
#include <utility>

namespace spin {

FrameFetcher::FrameFetcher(QObject* parent) : QObject(parent) {
  m_pool.setMaxThreadCount(1);
}

FrameFetcher::~FrameFetcher() {
  {
    const std::lock_guard lock(m_mutex);
    m_wish.reset();
  }
  m_pool.waitForDone();
}

void FrameFetcher::request(std::shared_ptr<FrameStore> store, int frame) {
  const std::lock_guard lock(m_mutex);
  m_wish = Wish{std::move(store), frame};
  if (m_working) return;
  m_working = true;
  m_pool.start([this] { work(); });
}

void FrameFetcher::work() {
  while (true) {
    Wish wish;
    {
      const std::lock_guard lock(m_mutex);
      if (!m_wish) {
        m_working = false;
        return;
      }
      wish = *std::exchange(m_wish, std::nullopt);
    }
    const FramePointer frame = wish.store->nearest(wish.frame);
    QMetaObject::invokeMethod(this, [this, wanted = wish.frame, frame] { Q_EMIT fetched(wanted, frame); });
  }
}

}  // namespace spin
