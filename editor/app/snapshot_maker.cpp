// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/snapshot_maker.h"

#include <QMetaObject>
#include <utility>

namespace spin {

SnapshotMaker::SnapshotMaker(QObject* parent) : QObject(parent) {
  m_pool.setMaxThreadCount(1);
}

SnapshotMaker::~SnapshotMaker() {
  m_cancel.cancel();
  m_pool.waitForDone();
}

void SnapshotMaker::request(std::shared_ptr<AssetLibrary> assets, Scene scene, std::string sceneFile) {
  m_cancel.cancel();
  m_cancel = CancelToken();
  m_busy = true;
  const quint64 number = ++m_number;
  m_pool.start([this, number, cancel = m_cancel, library = std::move(assets), frozen = std::move(scene),
                file = std::move(sceneFile)] {
    std::vector<AssetLibrary::Issue> issues;
    Result<SnapshotPointer> result = library->snapshot(frozen, file, issues, cancel);
    if (!result.ok() && result.error().kind == ErrorKind::Cancelled) return;
    if (!result.ok()) issues.push_back({std::string(), result.error()});
    const SnapshotPointer snapshot = result.ok() ? *result : nullptr;
    QMetaObject::invokeMethod(this, [this, number, snapshot, issues] { answer(number, snapshot, issues); });
  });
}

void SnapshotMaker::answer(quint64 number, SnapshotPointer snapshot,
                           const std::vector<AssetLibrary::Issue>& issues) {
  if (number != m_number) return;
  m_busy = false;
  Q_EMIT ready(snapshot, issues);
}

}  // namespace spin
