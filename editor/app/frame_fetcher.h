// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <memory>
#include <mutex>
#include <optional>

#include "core/sim/frame_store.h"

namespace spin {

/// Reads frames from the store on a thread. Asked for many while the user scrubs, it reads only the latest.
class FrameFetcher : public QObject {
  Q_OBJECT
 public:
  explicit FrameFetcher(QObject* parent = nullptr);
  ~FrameFetcher() override;

  /// The frame of this number, or the nearest there is; fetched() answers.
  void request(std::shared_ptr<FrameStore> store, int frame);

 Q_SIGNALS:
  /// Null where the store holds nothing yet.
  void fetched(int wanted, const spin::FramePointer& frame);

 private:
  struct Wish {
    std::shared_ptr<FrameStore> store;
    int frame = 0;
  };
  void work();

  QThreadPool m_pool;
  std::mutex m_mutex;
  std::optional<Wish> m_wish;
  bool m_working = false;
};

}  // namespace spin
