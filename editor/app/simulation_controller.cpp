// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/simulation_controller.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <thread>
#include <utility>

#include "core/cloud/cloud_estimate.h"
#include "core/flow/flow_estimate.h"
#include "core/nodes/settings_nodes.h"
#include "editor/document/scene_document.h"
#include "editor/document/time_context.h"
#ifdef SPIN_HAVE_EMBREE
#include "core/raycast/embree_ray_scene.h"
#endif

namespace spin {
namespace {

constexpr int kStatesMilliseconds = 100;

bool has(Affects value, Affects part) {
  return (static_cast<int>(value) & static_cast<int>(part)) != 0;
}

RunOptions runOptions(int lastFrame) {
  RunOptions options;
  options.lastFrame = lastFrame;
  // One core stays free for the window.
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
#ifdef SPIN_HAVE_EMBREE
  options.makeRayScene = makeEmbreeRayScene;
#endif
  return options;
}

}  // namespace

SimulationController::SimulationController(SceneDocument* document, TimeContext* time, QObject* parent)
    : QObject(parent), m_document(document), m_time(time), m_runner(std::make_unique<Runner>()) {
  m_cleaner.setMaxThreadCount(1);
  m_debounce.setSingleShot(true);
  m_debounce.setInterval(kDebounceMilliseconds);
  connect(&m_debounce, &QTimer::timeout, this, &SimulationController::readScene);
  m_statesTimer.setSingleShot(true);
  m_statesTimer.setInterval(kStatesMilliseconds);
  connect(&m_statesTimer, &QTimer::timeout, this, &SimulationController::statesChanged);
  connect(document, &SceneDocument::changed, this, &SimulationController::follow);
  connect(document, &SceneDocument::pathChanged, this, &SimulationController::openStore);
  connect(time, &TimeContext::frameChanged, this, &SimulationController::fetch);
  connect(&m_maker, &SnapshotMaker::ready, this, &SimulationController::takeSnapshot);
  connect(&m_fetcher, &FrameFetcher::fetched, this, [this](int, const FramePointer& frame) {
    m_shown = frame;
    Q_EMIT frameShown(frame);
  });
  openStore();
}

SimulationController::~SimulationController() {
  ++m_estimate, ++m_flowCheck;  // what waits is not begun
  m_runner->cancel();
  m_runner->wait();
  m_cleaner.waitForDone();
}

QString SimulationController::cacheFolderOf(const QString& scenePath) {
  if (scenePath.isEmpty()) return {};
  const QFileInfo file(scenePath);
  const QString folder = file.absoluteDir().filePath(file.completeBaseName() + QStringLiteral(".cache"));
  // Beside a scene that lies where nobody may write, frames live in memory only.
  const QFileInfo parent(file.absolutePath());
  return QFileInfo(folder).isWritable() || parent.isWritable() ? folder : QString();
}

QString SimulationController::cacheFolder() const {
  return cacheFolderOf(m_document->path());
}

QString SimulationController::deviceName() const {
  return QString::fromStdString(backendName("auto"));
}

void SimulationController::openStore() {
  const std::string folder = cacheFolder().toStdString();
  if (m_store && m_storeFolder == folder) return;
  m_runner->cancel();
  ++m_estimate, ++m_flowCheck;
  m_storeFolder = folder;
  m_store = std::make_shared<FrameStore>();
  m_storeReady = folder.empty();
  if (!m_storeReady) {
    // Taking in a large cache takes time; until it is there an empty store stands in.
    m_cleaner.start([this, folder] {
      FrameStoreOptions options;
      options.directory = folder;
      auto store = std::make_shared<FrameStore>(options);
      QMetaObject::invokeMethod(this, [this, store] { takeStore(store); });
    });
  }
  m_shown = nullptr;
  Q_EMIT frameShown(nullptr);
  Q_EMIT statesChanged();
  m_runWanted = m_automatic;
  m_debounce.start();
  fetch();  // lest an answer from the store before comes last
}

void SimulationController::takeStore(const std::shared_ptr<FrameStore>& store) {
  if (store->options().directory != m_storeFolder) return;
  m_store = store;
  m_storeReady = true;
  Q_EMIT statesChanged();
  fetch();
  if (m_runPending) run();
}

void SimulationController::setAutomatic(bool on) {
  m_automatic = on;
  if (on) start();
}

void SimulationController::start() {
  setPaused(false);
  m_runWanted = true;
  m_debounce.start(0);
}

void SimulationController::setPaused(bool on) {
  if (on == m_paused) return;
  m_paused = on;
  if (on)
    m_runner->cancel();
  else if (m_runWanted)
    m_debounce.start(0);
  Q_EMIT pausedChanged(on);
}

void SimulationController::stepFrame() {
  setPaused(true);
  m_stepTo = std::min(m_time->frame() + 1, lastFrame());
  m_time->setFrame(m_stepTo);
  m_runWanted = true;
  m_debounce.start(0);
}

void SimulationController::reset() {
  if (m_resetting || !m_storeReady) return;
  m_resetting = true;
  m_runner->cancel();
  m_cleaner.start([this, store = m_store] {
    m_runner->wait();
    // No frame has this key: all are stale.
    store->setKeys({Hash128{}});
    const Status status = store->purgeStale();
    QMetaObject::invokeMethod(this, [this, status] {
      m_resetting = false;
      if (!status.ok()) Q_EMIT message(QString::fromStdString(status.error().text()));
      m_shown = nullptr;
      Q_EMIT frameShown(nullptr);
      Q_EMIT statesChanged();
      m_time->setFrame(0);
      m_runWanted = true;
      m_debounce.start(0);
    });
  });
}

void SimulationController::stop() {
  m_runWanted = false;
  m_runner->cancel();
}

void SimulationController::follow(const ChangeEvent& event) {
  if (event.kind == ChangeKind::Moved || event.kind == ChangeKind::Renamed) return;
  if (event.kind == ChangeKind::Reset) {
    m_snapshot = nullptr;
    ++m_flowCheck;
    m_flowIssues.clear();
    m_runError.reset();
  }
  showLive();
  const SceneNode* node = m_document->node(event.node);
  const bool settings = node && node->as<SimulationNode>();
  const bool property = event.kind == ChangeKind::Property;
  if (property && !settings && !has(event.affects, Affects::Simulation)) return;
  if (m_automatic) m_runWanted = true;
  m_debounce.start(kDebounceMilliseconds);
}

void SimulationController::showLive() {
  // The nodes as they are now over the files as they were read last: an edit is seen at once.
  auto live = m_snapshot ? std::make_shared<SceneSnapshot>(*m_snapshot) : std::make_shared<SceneSnapshot>();
  live->nodes = m_document->scene().nodes();
  m_snapshot = live;
  Q_EMIT snapshotChanged(m_snapshot);
}

void SimulationController::readScene() {
  setState(State::Reading);
  m_maker.request(m_document->assets(), m_document->scene(), m_document->path().toStdString());
}

void SimulationController::takeSnapshot(const SnapshotPointer& snapshot,
                                        const std::vector<AssetLibrary::Issue>& issues) {
  std::vector<DocumentIssue> found;
  for (const AssetLibrary::Issue& issue : issues) found.push_back(issueOf(issue.error, issue.node));
  m_document->setIssues(QStringLiteral("assets"), std::move(found));
  if (!snapshot) {
    ++m_flowCheck;
    m_flowIssues.clear();
    showProblems();
    setState(State::Failed);
    return;
  }
  m_snapshot = snapshot;
  Q_EMIT snapshotChanged(m_snapshot);
  setState(State::Idle);
  estimate();
  checkFlow();
  if (m_runWanted) run();
}

/// On a thread: keys of many frames take a while.
void SimulationController::estimate() {
  if (!m_snapshot) return;
  const quint64 number = ++m_estimate;
  m_cleaner.start([this, number, scene = m_snapshot, store = m_store, options = runOptions(lastFrame())] {
    if (number != m_estimate) return;
    const RunEstimate need = estimateRun(*scene, *store, options);
    QMetaObject::invokeMethod(this, [this, number, need] {
      if (number == m_estimate) Q_EMIT estimated(need);
    });
  });
}

/// On a thread: it lays the slabs out and cuts bodies into particles. Of edits in quick succession only the
/// last one is looked at.
void SimulationController::checkFlow() {
  const quint64 number = ++m_flowCheck;
  m_cleaner.start([this, number, scene = m_snapshot] {
    if (number != m_flowCheck) return;
    std::vector<FlowIssue> found;
    if (sceneHasFlow(*scene)) found = findFlowIssues(*scene);
    const std::vector<FlowIssue> air = findCloudIssues(*scene);
    found.insert(found.end(), air.begin(), air.end());
    QMetaObject::invokeMethod(this, [this, number, found] {
      if (number != m_flowCheck) return;
      m_flowIssues = found;
      showProblems();
    });
  });
}

int SimulationController::lastFrame() const {
  return m_snapshot ? m_snapshot->settings<SimulationNode>(0.0).lastFrame : 0;
}

void SimulationController::run() {
  m_runPending = !m_storeReady;
  if (m_runPending || m_resetting || (m_paused && m_stepTo < 0)) return;
  const int last = m_stepTo >= 0 ? m_stepTo : lastFrame();
  m_stepTo = -1;
  const quint64 number = ++m_run;
  RunCallbacks callbacks;
  callbacks.progress = [this, number](const RunProgress& progress) {
    const SimulationProgress told{progress.frame,        progress.lastFrame,   progress.framesDone,
                                  progress.fractionDone, progress.secondsLeft, progress.timings.table()};
    QMetaObject::invokeMethod(this, [this, number, told] {
      if (number != m_run || m_state != State::Running) return;
      // By the first report the run has told the store which of its frames still hold.
      if (std::exchange(m_toldRun, number) != number) Q_EMIT statesChanged();
      Q_EMIT progressed(told);
    });
  };
  callbacks.frameReady = [this](const FramePointer& frame) {
    QMetaObject::invokeMethod(this, [this, n = frame->info.time.frame] { frameReady(n); });
  };
  m_runError.reset();
  showProblems();
  setState(State::Running);
  m_runner->start(m_snapshot, m_store, runOptions(last), std::move(callbacks),
                  [this, number](const Status& status) {
                    QMetaObject::invokeMethod(this, [this, number, status] { runFinished(status, number); });
                  });
  m_statesTimer.start();
}

void SimulationController::frameReady(int frame) {
  if (!m_statesTimer.isActive()) m_statesTimer.start();
  const bool exact = m_shown && m_shown->info.time.frame == m_time->frame();
  if (frame == m_time->frame() || !exact) fetch();
}

void SimulationController::runFinished(const Status& status, quint64 number) {
  if (number != m_run) return;
  Q_EMIT statesChanged();
  fetch();
  const bool cancelled = !status.ok() && status.error().kind == ErrorKind::Cancelled;
  if (m_state == State::Running) setState(status.ok() || cancelled ? State::Idle : State::Failed);
  reportRunError(status);
  estimate();
}

void SimulationController::reportRunError(const Status& status) {
  m_runError.reset();
  QString text;
  if (!status.ok() && status.error().kind != ErrorKind::Cancelled) {
    m_runError = status.error();
    text = QString::fromStdString(status.error().text());
  } else if (!status.ok()) {
    text = m_paused ? tr("Simulation held; P goes on.") : tr("Simulation stopped.");
  }
  showProblems();
  Q_EMIT finished(text);
}

/// What the flow cannot start with is found before a run and told by it again: it is listed once, with the
/// run's advice.
void SimulationController::showProblems() {
  std::vector<DocumentIssue> ofFlow, ofRun;
  for (const FlowIssue& issue : m_flowIssues) {
    if (m_runError && m_runError->why == issue.text) continue;
    QString text = QString::fromStdString(issue.text);
    text.replace(0, 1, text.left(1).toUpper());
    ofFlow.push_back({issue.fatal ? Severity::Error : Severity::Warning, issue.node, {}, text});
  }
  if (m_runError) {
    const std::string& where = m_runError->where;
    ofRun.push_back(issueOf(*m_runError, m_document->node(where) ? where : std::string()));
  }
  m_document->setIssues(QStringLiteral("flow"), std::move(ofFlow));
  m_document->setIssues(QStringLiteral("simulation"), std::move(ofRun));
}

void SimulationController::fetch() {
  m_fetcher.request(m_store, m_time->frame());
}

std::vector<FrameState> SimulationController::frameStates() const {
  return m_store->states(lastFrame() + 1);
}

FrameStore::Usage SimulationController::usage() const {
  return m_store->usage();
}

void SimulationController::purgeStale() {
  m_cleaner.start([this, store = m_store] {
    const Status status = store->purgeStale();
    QMetaObject::invokeMethod(this, [this, status] {
      Q_EMIT message(status.ok() ? tr("Stale frames deleted.")
                                 : QString::fromStdString(status.error().text()));
      Q_EMIT statesChanged();
    });
  });
}

void SimulationController::setState(State state) {
  if (state == m_state) return;
  m_state = state;
  Q_EMIT stateChanged(state);
}

}  // namespace spin
