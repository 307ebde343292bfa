// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMainWindow>
#include <functional>
#include <memory>

#include "editor/app/simulation_controller.h"
#include "editor/document/recovery_files.h"
#include "editor/document/scene_document.h"
#include "editor/document/time_context.h"

namespace spin {

class Autosave;
class FileFlow;
class FlakeShapesMaker;
class ImportFlow;
class MainActions;
class PluginHost;
class SceneLock;
class LayerTools;
class SceneTools;
class TimelinePanel;
class Viewport;

/// The window: viewport in the middle, panels round it. It joins the parts; what they do is theirs.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(std::shared_ptr<AssetReader> reader, QWidget* parent = nullptr);
  ~MainWindow() override;

  SceneDocument& document() { return *m_document; }
  TimeContext& time() { return *m_time; }
  SimulationController& simulation() { return *m_simulation; }
  Viewport& viewport() { return *m_viewport; }
  TimelinePanel& timeline() { return *m_timeline; }
  FileFlow& files() { return *m_files; }
  ImportFlow& imports() { return *m_imports; }
  SceneTools& tools() { return *m_tools; }
  LayerTools& layers() { return *m_layers; }
  MainActions& actions() { return *m_actions; }

  /// Opens a scene file or imports a terrain or model, by its ending.
  void openOrImport(const QString& path);
  /// What a started program does: offers what an earlier run did not save, or opens the files if nothing is
  /// recovered.
  void start(const QStringList& files);

  enum class RecoveryAnswer { Recover, Discard, Later };
  /// A function, so that tests answer without a dialog.
  std::function<RecoveryAnswer(const Recovery&)> askRecovery;
  void showExportDialog();
  /// In the status bar, for some seconds.
  void showMessage(const QString& text);
  void resetLayout();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void addDocks();
  void joinTimeline();
  void joinViewport();
  void showTitle();
  void updateFilm();
  void updateKeys();
  /// True if a scene was recovered.
  bool offerRecovery();
  RecoveryAnswer showRecoveryQuestion(const Recovery& found);
  void firstLook(const SnapshotPointer& snapshot);
  void lookAtNewModel(const SnapshotPointer& snapshot);
  void restoreLayout();
  void saveLayout();

  SceneDocument* m_document;
  TimeContext* m_time;
  Viewport* m_viewport;
  SimulationController* m_simulation;
  TimelinePanel* m_timeline;
  SceneTools* m_tools;
  FlakeShapesMaker* m_flakes;
  FileFlow* m_files;
  ImportFlow* m_imports;
  Autosave* m_autosave;
  SceneLock* m_sceneLock;
  MainActions* m_actions = nullptr;
  std::unique_ptr<PluginHost> m_plugins;
  LayerTools* m_layers;
  QByteArray m_defaultLayout;
  bool m_lookWanted = true;    ///< the next scene with a place moves the view there
  bool m_wholeWanted = false;  ///< and shows all of it
  std::string m_newModel;      ///< imported, not yet seen
};

}  // namespace spin
