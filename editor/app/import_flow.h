// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>

#include "editor/commands/edits.h"

class QWidget;

namespace spin {

class ImportDialog;

/// From a file to a node: choose, look at the summary, accept. Copies are made on a thread.
class ImportFlow : public QObject {
  Q_OBJECT
 public:
  ImportFlow(SceneDocument* document, std::shared_ptr<AssetReader> reader, QWidget* window);
  ~ImportFlow() override;

  /// What the view looks at; models are placed there.
  struct Sight {
    std::optional<Vec3d> ground;
    std::shared_ptr<const TerrainData> terrain;
  };
  std::function<Sight()> sight;
  /// Whether a terrain may take the place of the one there is: question and what it means. A function, so
  /// that tests answer without a dialog.
  std::function<bool(const QString& question, const QString& meaning)> askReplace;

  /// Lets the user choose files.
  void choose();
  /// Shows the import dialog for a file; its acceptance adds the node. The dialog does not block.
  void import(const QString& file);
  /// Copies the scene's files beside it and tells how many.
  Status collect();

 Q_SIGNALS:
  void message(const QString& text);
  /// The scene has got its first terrain: the view may go there.
  void firstTerrainAdded();
  /// A model was added; its file may still have to be read.
  void modelAdded(const std::string& node);

 private:
  struct Accepted {
    const NodeType* type;
    QString file;
    edit::AssetDetails details;
  };
  void accept(const QString& file, const ImportDialog& dialog);
  void copyAndAdd(const Accepted& accepted);
  void add(const Accepted& accepted);
  bool liesOutside(const QString& file) const;
  bool mayReplace(const SceneNode& terrain);
  std::optional<Vec3d> placeForModel() const;
  void showError(const Error& error);

  SceneDocument* m_document;
  std::shared_ptr<AssetReader> m_reader;
  QWidget* m_window;
  QString m_lastFolder;
  QThreadPool m_copier;
};

}  // namespace spin
