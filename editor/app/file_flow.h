// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <functional>

#include "editor/document/scene_document.h"

class QMenu;
class QWidget;

namespace spin {

/// New, open, save and close with their questions. The questions are functions, so that tests answer them
/// without dialogs.
class FileFlow : public QObject {
  Q_OBJECT
 public:
  enum class Unsaved { Save, Discard, Cancel };
  enum class Overwrite { Overwrite, SaveAs, Cancel };

  FileFlow(SceneDocument* document, QWidget* window);

  std::function<Unsaved()> askUnsaved;
  std::function<Overwrite()> askOverwrite;             ///< the file is no longer what was opened
  std::function<QString()> askOpenPath;                ///< empty = cancelled
  std::function<QString(const QString&)> askSavePath;  ///< suggestion -> path; empty = cancelled
  std::function<void(const QString&)> showError;

  /// Each is false if the user cancelled or it failed.
  bool newScene();
  bool open();
  bool openPath(const QString& path);
  bool save();
  bool saveAs();
  /// Saves and waits until the file is there.
  bool saveNow();
  /// True if the scene may be given up: nothing unsaved, saved now, or not wanted.
  bool mayDiscard();
  void fillRecent(QMenu* menu);

 private:
  Overwrite showOverwriteQuestion();

  QString m_lastFolder;
  SceneDocument* m_document;
  QWidget* m_window;
};

}  // namespace spin
