// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <vector>

#include "editor/document/recovery_files.h"

class QLockFile;
class QThreadPool;

namespace spin {

class SceneDocument;

/// Keeps a copy of unsaved work in the state directory: at most 10 s behind, written on a thread. A lock
/// tells other instances that the scene is alive. The copy is removed once the scene is saved, replaced by
/// another one or closed on purpose.
class Autosave : public QObject {
  Q_OBJECT
 public:
  /// An empty state directory takes the user's own one. The interval is at most 10 s.
  explicit Autosave(SceneDocument* document, const QString& stateDirectory = {}, int intervalMs = 5000,
                    QObject* parent = nullptr);
  ~Autosave() override;

  /// Scenes that nobody has open and that were not saved; newest first.
  std::vector<Recovery> recoverable() const;
  /// Opens a recovered scene as a modified one. Its files go when the user has saved or declined it.
  Status recover(const Recovery& recovery);
  /// The user wants it no more.
  void discard(const Recovery& recovery);
  /// The user closes without saving: this scene needs no recovery.
  void forget();
  /// Writes now and waits, for tests and for an end by signal.
  Status flush();

  static QString defaultStateDirectory();

 Q_SIGNALS:
  void written();
  void writeFailed(const QString& message);

 private:
  void schedule();
  void write();
  void finishWrite(const RecoveryContent& content, const Status& status);
  bool claim(const QString& folder);
  void removeOwnFiles();

  SceneDocument* m_document;
  QString m_root;
  QString m_folder;
  std::unique_ptr<QLockFile> m_lock;  ///< of m_folder
  std::unique_ptr<QThreadPool> m_worker;
  QTimer m_timer;
  std::map<std::string, PaintedLayer> m_layersWritten;
  Status m_lastStatus;
};

}  // namespace spin
