// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>

class QLockFile;

namespace spin {

class SceneDocument;

/// Tells other instances of the program that the document's file is open here, and warns in the issues where
/// one of them was first. The locks lie in the state directory: scenes may lie in folders that cannot be
/// written to.
class SceneLock : public QObject {
  Q_OBJECT
 public:
  /// An empty state directory takes the user's own one.
  explicit SceneLock(SceneDocument* document, const QString& stateDirectory = {}, QObject* parent = nullptr);
  ~SceneLock() override;

 private:
  void follow();

  SceneDocument* m_document;
  QString m_root;
  QString m_file;                     ///< of m_lock
  std::unique_ptr<QLockFile> m_lock;  ///< null where the scene has no file or another instance has it
};

}  // namespace spin
