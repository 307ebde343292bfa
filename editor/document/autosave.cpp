// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QLockFile>
#include <QThreadPool>
#include <QUuid>
#include <algorithm>

#include "editor/document/scene_document.h"

namespace spin {
namespace {

constexpr int kMaxIntervalMs = 10'000;

/// A lock counts until its program has ended, however long that takes.
std::unique_ptr<QLockFile> lockOf(const QString& folder) {
  auto lock = std::make_unique<QLockFile>(folder + QStringLiteral(".lock"));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

QString Autosave::defaultStateDirectory() {
  const QString state = qEnvironmentVariable("XDG_STATE_HOME");
  const QString base = state.isEmpty() ? QDir::home().filePath(QStringLiteral(".local/state")) : state;
  return QDir(base).filePath(QStringLiteral("spindrift/recovery"));
}

Autosave::Autosave(SceneDocument* document, const QString& stateDirectory, int intervalMs, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_root(stateDirectory.isEmpty() ? defaultStateDirectory() : stateDirectory),
      m_worker(std::make_unique<QThreadPool>()) {
  m_worker->setMaxThreadCount(1);
  m_timer.setSingleShot(true);
  m_timer.setInterval(std::clamp(intervalMs, 0, kMaxIntervalMs));
  connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
  connect(document, &SceneDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.kind == ChangeKind::Reset)
      removeOwnFiles();
    else
      schedule();
  });
  connect(document, &SceneDocument::saveFinished, this, [this](bool ok) {
    if (ok && !m_document->isModified()) removeOwnFiles();
  });
}

Autosave::~Autosave() {
  m_worker->waitForDone();
}

void Autosave::schedule() {
  // The running timer is left alone: the copy is never older than its interval.
  if (!m_timer.isActive()) m_timer.start();
}

bool Autosave::claim(const QString& folder) {
  if (m_folder == folder && m_lock) return true;
  QDir().mkpath(m_root);
  std::unique_ptr<QLockFile> lock = lockOf(folder);
  if (!lock->tryLock(0)) return false;
  m_lock = std::move(lock);
  m_folder = folder;
  return true;
}

void Autosave::write() {
  if (!m_document->isModified()) {
    removeOwnFiles();
    return;
  }
  const QString fresh = QDir(m_root).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces));
  if (!claim(m_folder.isEmpty() ? fresh : m_folder)) {
    Q_EMIT writeFailed(tr("The folder for recovery copies cannot be used: %1").arg(m_root));
    return;
  }
  RecoveryContent content{m_folder,
                          m_document->path(),
                          m_document->displayName(),
                          m_document->hashOnDisk(),
                          m_document->scene(),
                          m_document->extras(),
                          m_layersWritten};
  m_worker->start([this, content = std::move(content)] {
    const Status status = writeRecovery(content);
    QMetaObject::invokeMethod(this, [this, content, status] { finishWrite(content, status); });
  });
}

void Autosave::finishWrite(const RecoveryContent& content, const Status& status) {
  m_lastStatus = status;
  if (!status) {
    Q_EMIT writeFailed(QString::fromStdString(status.error().text()));
    return;
  }
  if (content.folder == m_folder)
    for (const SceneNode& node : content.scene.nodes()) m_layersWritten[node.id] = node.painted;
  Q_EMIT written();
}

Status Autosave::flush() {
  m_timer.stop();
  m_lastStatus = Status();
  if (!m_document->isModified()) return {};
  write();
  m_worker->waitForDone();
  QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
  return m_lastStatus;
}

/// In the worker's queue, behind a write that may be under way.
void Autosave::removeOwnFiles() {
  m_timer.stop();
  m_layersWritten.clear();
  if (m_folder.isEmpty()) return;
  m_worker->start([folder = m_folder, lock = std::shared_ptr<QLockFile>(std::move(m_lock))] {
    QDir(folder).removeRecursively();
    if (lock) lock->unlock();
  });
  m_folder.clear();
}

void Autosave::forget() {
  removeOwnFiles();
}

std::vector<Recovery> Autosave::recoverable() const {
  std::vector<Recovery> found;
  QDirIterator folders(m_root, QDir::Dirs | QDir::NoDotAndDotDot | QDir::NoSymLinks);
  while (folders.hasNext()) {
    const QString folder = folders.next();
    const Result<Recovery> recovery = readRecoveryInfo(folder);
    if (!recovery || folder == m_folder || !lockOf(folder)->tryLock(0)) continue;
    found.push_back(*recovery);
  }
  std::sort(found.begin(), found.end(),
            [](const Recovery& a, const Recovery& b) { return a.written > b.written; });
  return found;
}

Status Autosave::recover(const Recovery& recovery) {
  Result<LoadedScene> loaded = readRecovery(recovery);
  if (!loaded) return loaded.error();
  std::unique_ptr<QLockFile> lock = lockOf(recovery.folder);
  if (!lock->tryLock(0))
    return Error{ErrorKind::Failed,
                 "The scene cannot be recovered",
                 recovery.folder.toStdString(),
                 "another program has it open",
                 {}};
  m_document->takeOver(std::move(*loaded), recovery.scenePath, recovery.hashOnDisk.toStdString());
  // From here on the folder is this scene's own: it goes when the scene is saved or closed.
  m_folder = recovery.folder;
  m_lock = std::move(lock);
  return {};
}

void Autosave::discard(const Recovery& recovery) {
  std::unique_ptr<QLockFile> lock = lockOf(recovery.folder);
  if (recovery.folder == m_folder || !lock->tryLock(0)) return;
  QDir(recovery.folder).removeRecursively();
}

}  // namespace spin
