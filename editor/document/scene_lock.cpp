// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/scene_lock.h"

#include <QDir>
#include <QFileInfo>
#include <QLockFile>

#include "core/base/hash.h"
#include "editor/document/autosave.h"
#include "editor/document/scene_document.h"

namespace spin {
namespace {

const QString kSource = QStringLiteral("lock");

/// One name per file, whichever way it was reached.
QString lockName(const QString& scene) {
  const QString real = QFileInfo(scene).canonicalFilePath();
  const std::string name = (real.isEmpty() ? scene : real).toStdString();
  return QString::fromStdString(Hasher().add(name).digest().hex()) + QStringLiteral(".lock");
}

}  // namespace

SceneLock::SceneLock(SceneDocument* document, const QString& stateDirectory, QObject* parent)
    : QObject(parent),
      m_document(document),
      m_root(stateDirectory.isEmpty()
                 ? QFileInfo(Autosave::defaultStateDirectory()).dir().filePath(QStringLiteral("open"))
                 : stateDirectory) {
  connect(document, &SceneDocument::pathChanged, this, &SceneLock::follow);
  // The other instance may have gone, and a new file has its real name only now.
  connect(document, &SceneDocument::saveFinished, this, &SceneLock::follow);
  follow();
}

SceneLock::~SceneLock() = default;

void SceneLock::follow() {
  const QString scene = m_document->path();
  const QString file = scene.isEmpty() ? QString() : QDir(m_root).filePath(lockName(scene));
  if (file == m_file && (m_lock || file.isEmpty())) return;
  m_lock.reset();
  m_file = file;
  std::vector<DocumentIssue> issues;
  if (!file.isEmpty()) {
    QDir().mkpath(m_root);
    m_lock = std::make_unique<QLockFile>(file);
    m_lock->setStaleLockTime(0);
    if (!m_lock->tryLock(0)) {
      // Without a place for locks there is nothing to tell.
      const bool taken = m_lock->error() == QLockFile::LockFailedError;
      m_lock.reset();
      if (taken)
        issues.push_back({Severity::Warning,
                          {},
                          {},
                          tr("This scene is open in another window of the program too. Whoever saves last "
                             "overwrites what the other has saved.")});
    }
  }
  m_document->setIssues(kSource, std::move(issues));
}

}  // namespace spin
