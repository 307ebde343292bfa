// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <memory>
#include <vector>

#include "core/scene/asset_library.h"

namespace spin {

/// Freezes scenes with their files on a thread, so that reading never stops the window. Only the answer to
/// the latest request is told; older ones are cancelled.
class SnapshotMaker : public QObject {
  Q_OBJECT
 public:
  explicit SnapshotMaker(QObject* parent = nullptr);
  ~SnapshotMaker() override;

  void request(std::shared_ptr<AssetLibrary> assets, Scene scene, std::string sceneFile);
  bool busy() const { return m_busy; }

 Q_SIGNALS:
  void ready(const spin::SnapshotPointer& snapshot, const std::vector<spin::AssetLibrary::Issue>& issues);

 private:
  void answer(quint64 number, SnapshotPointer snapshot, const std::vector<AssetLibrary::Issue>& issues);

  QThreadPool m_pool;
  CancelToken m_cancel;
  quint64 m_number = 0;
  bool m_busy = false;
};

}  // namespace spin
