// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>

#include "core/scene/asset_library.h"

class QWidget;

namespace spin {

class SceneDocument;

/// From a file to a node: choose, look at the summary, accept.
class ImportFlow : public QObject {
  Q_OBJECT
 public:
  ImportFlow(SceneDocument* document, std::shared_ptr<AssetReader> reader, QWidget* window);

  /// Lets the user choose files.
  void choose();
  /// Shows the import dialog for a file; its acceptance adds the node. The dialog does not block.
  void import(const QString& file);

 Q_SIGNALS:
  void message(const QString& text);

 private:
  SceneDocument* m_document;
  std::shared_ptr<AssetReader> m_reader;
  QWidget* m_window;
  QString m_lastFolder;
};

}  // namespace spin
