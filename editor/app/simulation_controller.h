// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/timings.h"
#include "core/sim/runner.h"
#include "editor/app/frame_fetcher.h"
#include "editor/app/snapshot_maker.h"
#include "editor/document/change_event.h"

namespace spin {

class SceneDocument;
class TimeContext;
struct FlowIssue;

/// How far the run is, for the status bar.
struct SimulationProgress {
  int frame = 0;
  int lastFrame = 0;
  int framesDone = 0;  ///< by this run
  double fractionDone = 0.0;
  double secondsLeft = -1.0;       ///< < 0 = not known yet
  std::vector<StageTime> timings;  ///< of the run so far
};

/// Simulates the document in the background. After an edit it freezes the scene again and, where the edit
/// affects the simulation, runs anew from the last frame that still holds. Gives the frames to show.
class SimulationController : public QObject {
  Q_OBJECT
 public:
  static constexpr int kDebounceMilliseconds = 300;
  enum class State { Idle, Reading, Running, Failed };

  SimulationController(SceneDocument* document, TimeContext* time, QObject* parent = nullptr);
  ~SimulationController() override;

  State state() const { return m_state; }
  /// Held: nothing is simulated until it goes on, but for single steps.
  bool paused() const { return m_paused; }
  void setPaused(bool on);
  /// Simulates by itself after edits; otherwise only on start().
  bool automatic() const { return m_automatic; }
  void setAutomatic(bool on);
  /// The scene as drawn now; null before the first one is read.
  const SnapshotPointer& snapshot() const { return m_snapshot; }
  FramePointer shownFrame() const { return m_shown; }
  std::vector<FrameState> frameStates() const;
  FrameStore::Usage usage() const;
  /// Folder of the cache, empty for scenes that were never saved (they live in memory).
  QString cacheFolder() const;
  static QString cacheFolderOf(const QString& scenePath);
  /// "cpu-avx512" and so on.
  QString deviceName() const;

 public Q_SLOTS:
  /// Goes on where it was held.
  void start();
  void stop();
  /// Holds the run, simulates up to the frame after the shown one, and shows that.
  void stepFrame();
  /// Throws away all frames and checkpoints of this scene and starts again at the first one. The user was
  /// asked.
  void reset();
  /// Deletes stale frames from disk on a thread; the user asked for it.
  void purgeStale();

 Q_SIGNALS:
  void stateChanged(spin::SimulationController::State state);
  /// A new picture of the scene: at once after an edit, and again when files were read.
  void snapshotChanged(const spin::SnapshotPointer& snapshot);
  void frameShown(const spin::FramePointer& frame);
  void statesChanged();
  void progressed(const spin::SimulationProgress& progress);
  void pausedChanged(bool on);
  /// What the frames that are missing will take, each time the scene was read and a run ended.
  void estimated(const spin::RunEstimate& need);
  /// The run ended by itself; message is empty when all went well.
  void finished(const QString& message);
  void message(const QString& text);

 private:
  void follow(const ChangeEvent& event);
  void showLive();
  void takeSnapshot(const SnapshotPointer& snapshot, const std::vector<AssetLibrary::Issue>& issues);
  void readScene();
  void openStore();
  void takeStore(const std::shared_ptr<FrameStore>& store);
  void run();
  void frameReady(int frame);
  void runFinished(const Status& status, quint64 number);
  void fetch();
  void setState(State state);
  void reportRunError(const Status& status);
  void checkFlow();
  void showProblems();
  int lastFrame() const;
  void estimate();

  SceneDocument* m_document;
  TimeContext* m_time;
  SnapshotMaker m_maker;
  FrameFetcher m_fetcher;
  QThreadPool m_cleaner;
  std::shared_ptr<FrameStore> m_store;
  std::string m_storeFolder;
  bool m_storeReady = false;
  bool m_runPending = false;  ///< as soon as the store is ready
  SnapshotPointer m_snapshot;
  FramePointer m_shown;
  QTimer m_debounce;
  QTimer m_statesTimer;
  State m_state = State::Idle;
  bool m_automatic = true;
  bool m_runWanted = true;
  bool m_paused = false;
  bool m_resetting = false;
  int m_stepTo = -1;  ///< last frame of a single step
  quint64 m_run = 0;
  quint64 m_toldRun = 0;                 ///< last one of which a report came
  std::atomic<quint64> m_estimate = 0;   ///< number of the last one asked for
  std::atomic<quint64> m_flowCheck = 0;  ///< likewise
  std::vector<FlowIssue> m_flowIssues;
  std::optional<Error> m_runError;
  /// Last, so that its thread ends before what its callbacks use.
  std::unique_ptr<Runner> m_runner;
};

}  // namespace spin
