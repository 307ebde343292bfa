// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QUndoStack>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "core/scene/asset_library.h"
#include "editor/document/change_event.h"
#include "editor/document/document_issue.h"

class QThreadPool;

namespace spin {

/// The open scene with its file, undo history, selection and issues. Lives on the GUI thread and is the only
/// writer of the scene; the edits themselves stand in editor/commands/edits.h. Files are written, and painted
/// layers read, on a thread of its own.
class SceneDocument : public QObject {
  Q_OBJECT
 public:
  explicit SceneDocument(std::shared_ptr<AssetReader> reader, QObject* parent = nullptr);
  ~SceneDocument() override;

  const Scene& scene() const { return m_scene; }
  const SceneNode* node(const std::string& id) const { return m_scene.find(id); }
  const SceneFileExtras& extras() const { return m_extras; }
  QUndoStack* undoStack() { return &m_undo; }
  /// Decoded files; thread-safe, so that a worker can take snapshots of a copy of scene().
  const std::shared_ptr<AssetLibrary>& assets() const { return m_assets; }

  /// File of the scene, absolute; empty while it was never saved.
  const QString& path() const { return m_path; }
  /// Name for title bars: the file's base name or "Untitled".
  QString displayName() const;
  bool isModified() const;

  /// Starts an empty scene with the default settings.
  void newScene();
  /// Reads a scene. Its painted layers follow from a thread (see isLoadingLayers()).
  Status open(const QString& path);
  /// Takes over a scene that comes from elsewhere (recovery); it counts as modified. hashOnDisk() goes on
  /// from where the scene was read or saved last.
  void takeOver(LoadedScene loaded, const QString& path, const std::string& hashOnDisk);
  /// True while painted layers are being read; painting waits for them.
  bool isLoadingLayers() const { return m_loadingLayers; }

  /// Saves to path() or to another file on a thread; saveFinished() tells the outcome. One save at a time.
  void save() { saveAs(m_path); }
  void saveAs(const QString& path);
  bool isSaving() const { return m_saveJob != nullptr; }
  /// Content of the file when it was last read or written here; empty if that is not known.
  const std::string& hashOnDisk() const { return m_hashOnDisk; }
  /// Another program has written the file meanwhile: saving would overwrite that.
  bool isChangedOnDisk() const;
  /// Waits for the save in progress, for closing the window and for tests.
  Status finishSaving();
  /// Files opened or saved last, newest first, existing ones only.
  QStringList recentFiles() const;
  /// Lets nodes use files from a folder outside the scene's; kept in the user's settings.
  void allowFolder(const QString& folder);
  /// Lets nodes use a file from elsewhere for now: a save copies it beside the scene with what it refers to,
  /// and the nodes then use the copy. For files imported before the scene has a folder.
  void copyOnSave(const QString& file);
  PathPolicy pathPolicy() const;
  /// Of the allowed folders those that a node's file lies in.
  std::vector<std::string> neededFolders() const;
  /// The form in which a node stores this file.
  std::string storedPath(const QString& absolutePath) const;

  const std::string& selected() const { return m_selected; }
  /// Selects a node by id; unknown or empty ids select nothing.
  void select(const std::string& id);
  /// Asks the panels to show a property of a node (issues panel: double click).
  void reveal(const std::string& node, const std::string& property);

  const std::vector<DocumentIssue>& issues() const { return m_issues; }
  /// Replaces all issues from one source ("assets", "simulation", ...); the document's own checks are
  /// another source.
  void setIssues(const QString& source, std::vector<DocumentIssue> issues);

 Q_SIGNALS:
  void changed(const spin::ChangeEvent& event);
  void pathChanged(const QString& path);
  void modifiedChanged(bool modified);
  void selectionChanged(const std::string& id);
  void revealRequested(const std::string& node, const std::string& property);
  void issuesChanged();
  void recentFilesChanged();
  void layersLoaded();
  void saveFinished(bool ok, const QString& message);

 private:
  friend struct EditAccess;
  struct SaveJob;

  void reset(LoadedScene loaded, const QString& path);
  void notify(const ChangeEvent& event);
  void checkOwnScene();
  void checkFilePlaces();
  void permit(const QString& folder);
  void loadLayers();
  void takeLayers(const Scene& loaded, const std::vector<AssetLibrary::Issue>& found);
  std::shared_ptr<SaveJob> makeSaveJob(const QString& path) const;
  void finishSave(const std::shared_ptr<SaveJob>& job);
  void takeSources(const SaveJob& job);
  void addRecentFile(const QString& path);

  Scene m_scene;
  SceneFileExtras m_extras;
  QUndoStack m_undo;
  std::shared_ptr<AssetReader> m_reader;
  std::shared_ptr<AssetLibrary> m_assets;
  std::unique_ptr<QThreadPool> m_worker;
  CancelToken m_cancelLoading;
  QString m_path;
  std::string m_hashOnDisk;
  std::string m_selected;
  std::map<QString, std::vector<DocumentIssue>> m_issuesBySource;
  std::vector<DocumentIssue> m_issues;
  std::set<QString> m_copyOnSave;                      ///< absolute paths
  std::map<std::string, PaintedLayer> m_layersOnDisk;  ///< by node id, as last read or written
  std::shared_ptr<SaveJob> m_saveJob;                  ///< in progress
  quint64 m_generation = 0;  ///< counts scenes: answers of threads for an older one are dropped
  quint64 m_edits = 0;       ///< counts changes, so that a save knows whether it is still up to date
  bool m_loadingLayers = false;
  bool m_recovered = false;  ///< modified although the undo stack is clean
};

}  // namespace spin
