// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/main_window.h"

#include <QCloseEvent>
#include <QDateTime>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <cmath>
#include <utility>

#include "core/nodes/camera_node.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/node_registry.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "core/scene/first_view.h"
#include "editor/app/brush_bar.h"
#include "editor/app/export_dialog.h"
#include "editor/app/file_flow.h"
#include "editor/app/flake_shapes_maker.h"
#include "editor/app/flow_defaults.h"
#include "editor/app/import_flow.h"
#include "editor/app/import_job.h"
#include "editor/app/layer_tools.h"
#include "editor/app/main_actions.h"
#include "editor/app/scene_tools.h"
#include "editor/app/status_panel.h"
#include "editor/document/autosave.h"
#include "editor/document/scene_lock.h"
#include "editor/panels/flake_panel.h"
#include "editor/panels/issues_panel.h"
#include "editor/panels/outliner_panel.h"
#include "editor/panels/property_panel.h"
#include "editor/panels/stage_panel.h"
#include "editor/timeline/timeline_panel.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/scene_picker.h"
#include "editor/viewport/viewport.h"
#include "plugins/host/plugin_host.h"

namespace spin {
namespace {

constexpr int kLayoutVersion = 3;
constexpr int kMessageMilliseconds = 8000;

/// Settings of the only node of a type; defaults without one.
template <typename T>
T settingsOf(const Scene& scene, const NodeType& type) {
  const SceneNode* node = scene.firstOf(type);
  const T* data = node ? node->as<T>() : nullptr;
  return data ? *data : T{};
}

}  // namespace

MainWindow::MainWindow(std::shared_ptr<AssetReader> reader, QWidget* parent)
    : QMainWindow(parent),
      m_document(new SceneDocument(reader, this)),
      m_time(new TimeContext(m_document, this)),
      m_viewport(new Viewport(this)),
      m_simulation(new SimulationController(m_document, m_time, this)),
      m_timeline(new TimelinePanel(this)),
      m_tools(new SceneTools(m_document, m_time, m_viewport, this)),
      m_flakes(new FlakeShapesMaker(m_document, this)),
      m_files(new FileFlow(m_document, this)),
      m_imports(new ImportFlow(m_document, reader, this)),
      m_autosave(new Autosave(m_document, {}, 5000, this)),
      m_sceneLock(new SceneLock(m_document, {}, this)),
      m_plugins(std::make_unique<PluginHost>()),
      m_layers(new LayerTools(m_document, std::move(reader), m_plugins.get(), m_viewport, this)) {
  setObjectName("mainWindow");
  askRecovery = [this](const Recovery& found) { return showRecoveryQuestion(found); };
  setAcceptDrops(true);
  resize(1440, 900);
  setDockNestingEnabled(true);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  setCentralWidget(m_viewport);
  addDocks();
  m_actions = new MainActions(this);
  new StatusPanel(statusBar(), m_simulation, m_viewport, m_flakes);
  joinTimeline();
  joinViewport();
  connect(m_document, &SceneDocument::pathChanged, this, &MainWindow::showTitle);
  connect(m_document, &SceneDocument::modifiedChanged, this, &MainWindow::showTitle);
  connect(m_tools, &SceneTools::message, this, &MainWindow::showMessage);
  connect(m_layers, &LayerTools::message, this, &MainWindow::showMessage);
  connect(m_imports, &ImportFlow::message, this, &MainWindow::showMessage);
  connect(m_imports, &ImportFlow::firstTerrainAdded, this, [this] { m_lookWanted = m_wholeWanted = true; });
  connect(m_imports, &ImportFlow::modelAdded, this, [this](const std::string& node) { m_newModel = node; });
  m_imports->sight = [this] {
    const ViewSight seen = sightOf(*m_viewport);
    return ImportFlow::Sight{seen.place, seen.terrain};
  };
  connect(m_viewport, &Viewport::failed, this, &MainWindow::showMessage);
  connect(m_document, &SceneDocument::saveFinished, this, [this](bool ok, const QString&) {
    if (ok) showMessage(tr("Saved."));
  });
  m_defaultLayout = saveState(kLayoutVersion);
  restoreLayout();
  m_document->newScene();
  showTitle();
}

MainWindow::~MainWindow() {
  // Before the document and the store that its thread uses, and the plugins that filter.
  delete m_simulation;
  delete m_layers;
}

void MainWindow::addDocks() {
  const auto dock = [this](const char* name, const QString& title, QWidget* content,
                           Qt::DockWidgetArea area) {
    auto* made = new QDockWidget(title, this);
    made->setObjectName(name);
    made->setWidget(content);
    addDockWidget(area, made);
    return made;
  };
  auto* outliner = new OutlinerPanel(m_document);
  outliner->addNode = [this](const NodeType& type) { m_actions->addNode(type); };
  outliner->extendMenu = [this](QMenu* menu, const SceneNode& node) {
    if (!isPaintedType(*node.type) || node.as<AvalancheReleaseNode>()) return;
    BrushBar::fillLayerMenu(menu, m_layers);
    menu->addSeparator();
  };
  auto* properties = new PropertyPanel(m_document, m_time);
  connect(properties, &PropertyPanel::editRefused, this, &MainWindow::showMessage);
  connect(properties, &PropertyPanel::bodyWanted, m_tools, &SceneTools::makeRigidBody);
  connect(properties, &PropertyPanel::entered, this, [this] { m_viewport->surface()->setFocus(); });
  QDockWidget* left = dock("outlinerDock", tr("Scene"), outliner, Qt::RightDockWidgetArea);
  QDockWidget* right = dock("propertiesDock", tr("Properties"), properties, Qt::RightDockWidgetArea);
  QDockWidget* issues =
      dock("issuesDock", tr("Issues"), new IssuesPanel(m_document), Qt::RightDockWidgetArea);
  auto* stages = new StagePanel;
  connect(m_simulation, &SimulationController::frameShown, stages, &StagePanel::setFrame);
  QDockWidget* stageDock = dock("stagesDock", tr("Stages"), stages, Qt::RightDockWidgetArea);
  auto* flakes = new FlakePanel(m_document);
  connect(flakes, &FlakePanel::editRefused, this, &MainWindow::showMessage);
  QDockWidget* flakeDock = dock("flakeDock", tr("Flake"), flakes, Qt::RightDockWidgetArea);
  QDockWidget* bottom = dock("timelineDock", tr("Timeline"), m_timeline, Qt::BottomDockWidgetArea);
  splitDockWidget(left, right, Qt::Vertical);
  splitDockWidget(right, issues, Qt::Vertical);
  tabifyDockWidget(issues, stageDock);
  // The flake's picture needs height; its settings stand below it, so the properties may be behind.
  tabifyDockWidget(right, flakeDock);
  right->raise();
  issues->raise();
  resizeDocks({left, right, issues}, {240, 440, 140}, Qt::Vertical);
  // As wide as the widest node's properties: the view keeps its size when another node is selected.
  resizeDocks({right}, {430}, Qt::Horizontal);
  resizeDocks({bottom}, {96}, Qt::Vertical);
}

void MainWindow::joinTimeline() {
  connect(m_timeline, &TimelinePanel::currentChanged, m_time, &TimeContext::setFrame);
  connect(m_time, &TimeContext::frameChanged, m_timeline, &TimelinePanel::setCurrent);
  connect(m_timeline->bar(), &TimelineBar::keyMoved, m_tools, &SceneTools::moveKeys);
  connect(m_simulation, &SimulationController::statesChanged, this,
          [this] { m_timeline->bar()->setStates(m_simulation->frameStates()); });
  connect(m_simulation, &SimulationController::stateChanged, this, [this](SimulationController::State state) {
    m_timeline->setGrowing(state == SimulationController::State::Running);
  });
  connect(m_document, &SceneDocument::changed, this, [this](const ChangeEvent& event) {
    const SceneNode* node = m_document->node(event.node);
    if (event.kind == ChangeKind::Reset || (node && node->as<SimulationNode>())) updateFilm();
    updateKeys();
    if (event.kind != ChangeKind::Reset) return;
    m_lookWanted = true;
    m_timeline->setPlaying(false);
    m_timeline->toFirst();
  });
  connect(m_document, &SceneDocument::selectionChanged, this, &MainWindow::updateKeys);
}

void MainWindow::joinViewport() {
  connect(m_simulation, &SimulationController::snapshotChanged, m_viewport, &Viewport::setScene);
  connect(m_simulation, &SimulationController::snapshotChanged, this, &MainWindow::firstLook);
  connect(m_simulation, &SimulationController::frameShown, m_viewport, &Viewport::setFrame);
  connect(m_flakes, &FlakeShapesMaker::ready, m_viewport, &Viewport::setFlakeAtlas);
  connect(m_document, &SceneDocument::selectionChanged, m_viewport, &Viewport::setSelected);
  connect(m_time, &TimeContext::frameChanged, this, [this] { m_viewport->setFilmTime(m_time->filmTime()); });
  m_viewport->setEmptyHint(tr("Drop an elevation model here"),
                           tr("or use File > Import. It snows on the first terrain of a scene; "
                              "models (glTF, OBJ, PLY) are placed where the view looks."));
}

void MainWindow::firstLook(const SnapshotPointer& snapshot) {
  lookAtNewModel(snapshot);
  if (!m_lookWanted || !snapshot || sceneBounds(*snapshot, 0.0).empty()) return;
  m_lookWanted = false;
  const auto* node = snapshot->first<CameraNode>();
  const RenderCamera camera = cameraOf(*snapshot, m_time->filmTime());
  const CameraNode untouched;
  // A camera that was placed shows the scene best; the default one knows nothing of it.
  const auto whole = std::exchange(m_wholeWanted, false) && snapshot->terrain
                         ? wholeViewOf(snapshot->terrain->heights)
                         : std::nullopt;
  if (whole) return m_viewport->setCamera({whole->position, whole->target, camera.fovDegrees});
  const bool placed = node && !(camera.position == untouched.position && camera.target == untouched.target);
  if (placed)
    m_viewport->setCamera(camera);
  else
    m_viewport->frameAll();
}

/// A hut in a valley that is seen as a whole would be a dot that nobody finds; the view flies to it, as to
/// what it does not show at all.
void MainWindow::lookAtNewModel(const SnapshotPointer& snapshot) {
  constexpr double kFoundPixels = 40.0;
  if (m_newModel.empty() || !snapshot) return;
  const Box3d box = nodeBounds(*snapshot, m_newModel, m_time->filmTime());
  if (box.empty()) return;
  m_newModel.clear();
  const ViewFrame view = m_viewport->context().view;
  const auto at = view.project(box.centre());
  const bool inside = at && at->x > 0.0 && at->y > 0.0 && at->x < view.width() && at->y < view.height();
  if (!inside || length(box.size()) < kFoundPixels * view.metresPerPixel(box.centre()))
    m_viewport->frameSelection();
}

void MainWindow::updateFilm() {
  const auto settings = settingsOf<SimulationNode>(m_document->scene(), kSimulationType);
  m_timeline->setFilm(settings.firstFrame, settings.lastFrame, settings.frameRate);
  m_time->setFrame(m_timeline->current());
  m_viewport->setFilmTime(m_time->filmTime());
}

void MainWindow::updateKeys() {
  m_timeline->bar()->setKeyFrames(m_tools->keyFrames());
}

void MainWindow::showTitle() {
  setWindowTitle(tr("%1[*] - Spindrift").arg(m_document->displayName()));
  setWindowModified(m_document->isModified());
  setWindowFilePath(m_document->path());
}

void MainWindow::showMessage(const QString& text) {
  statusBar()->showMessage(text, kMessageMilliseconds);
}

void MainWindow::openOrImport(const QString& path) {
  if (QFileInfo(path).suffix().toLower() == QLatin1String("spindrift"))
    m_files->openPath(path);
  else
    m_imports->import(path);
}

void MainWindow::start(const QStringList& files) {
  if (!offerRecovery()) {
    for (const QString& file : files) openOrImport(file);
  } else if (!files.isEmpty()) {
    // Opening them would put the recovered work up for discarding.
    showMessage(tr("The recovered scene is open; %n file(s) of the command line were not opened.", nullptr,
                   static_cast<int>(files.size())));
  }
}

MainWindow::RecoveryAnswer MainWindow::showRecoveryQuestion(const Recovery& found) {
  QMessageBox box(QMessageBox::Question, tr("Unsaved work found"),
                  tr("\"%1\" was not saved. Its last changes were kept on %2.")
                      .arg(found.displayName, locale().toString(found.written, QLocale::ShortFormat)),
                  QMessageBox::NoButton, this);
  QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
  QPushButton* discard = box.addButton(tr("Delete it"), QMessageBox::DestructiveRole);
  box.addButton(tr("Later"), QMessageBox::RejectRole);
  box.exec();
  return box.clickedButton() == recover   ? RecoveryAnswer::Recover
         : box.clickedButton() == discard ? RecoveryAnswer::Discard
                                          : RecoveryAnswer::Later;
}

bool MainWindow::offerRecovery() {
  for (const Recovery& recovery : m_autosave->recoverable()) {
    const RecoveryAnswer answer = askRecovery(recovery);
    if (answer == RecoveryAnswer::Discard) m_autosave->discard(recovery);
    if (answer != RecoveryAnswer::Recover) continue;
    const Status status = m_autosave->recover(recovery);
    if (status.ok()) return true;
    m_files->showError(QString::fromStdString(status.error().text()));
  }
  return false;
}

void MainWindow::showExportDialog() {
  if (m_document->path().isEmpty() || m_document->isModified()) {
    const auto answer = QMessageBox::question(this, tr("Save first"),
                                              tr("Exports are made from the saved scene. Save it now?"),
                                              QMessageBox::Save | QMessageBox::Cancel);
    if (answer != QMessageBox::Save || !m_files->saveNow()) return;
  }
  const Scene& scene = m_document->scene();
  ExportDialog::Defaults defaults;
  defaults.scene = m_document->path();
  const auto film = settingsOf<SimulationNode>(scene, kSimulationType);
  const auto picture = settingsOf<RenderNode>(scene, kRenderType);
  defaults.firstFrame = film.firstFrame;
  defaults.lastFrame = film.lastFrame;
  defaults.width = picture.width;
  defaults.height = picture.height;
  if (const SceneNode* node = scene.firstOf(kRenderType))
    defaults.pictureNode = QString::fromStdString(node->id);
  for (const std::string& folder : m_document->neededFolders())
    defaults.allowedFolders << QString::fromStdString(folder);
  if (const SnapshotPointer& snapshot = m_simulation->snapshot(); snapshot && snapshot->terrain)
    defaults.coverCells = static_cast<double>(snapshot->terrain->heights.size());
  if (scene.firstOf(kSnowfallType))
    defaults.particlesPerFrame = settingsOf<SnowfallNode>(scene, kSnowfallType).flakeCount;
  auto* dialog = new ExportDialog(exportFormats(*m_plugins), defaults, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ExportDialog::ended, this, &MainWindow::showMessage);
  dialog->show();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  for (ExportDialog* dialog : findChildren<ExportDialog*>())
    if (dialog->job().running() && !dialog->close()) return event->ignore();
  if (!m_files->mayDiscard()) {
    event->ignore();
    return;
  }
  if (m_document->isModified()) m_autosave->forget();
  saveLayout();
  m_simulation->stop();
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  for (const QUrl& url : event->mimeData()->urls()) {
    const QString file = url.toLocalFile();
    if (file.endsWith(QLatin1String(".spindrift"), Qt::CaseInsensitive) ||
        importKindOf(file) != ImportKind::Unknown)
      return event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  for (const QUrl& url : event->mimeData()->urls()) {
    // After the drop is over: dialogs inside it would freeze the program that the file comes from.
    const QString file = url.toLocalFile();
    QMetaObject::invokeMethod(
        this, [this, file] { openOrImport(file); }, Qt::QueuedConnection);
  }
}

void MainWindow::resetLayout() {
  restoreState(m_defaultLayout, kLayoutVersion);
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  restoreGeometry(settings.value("window/geometry").toByteArray());
  restoreState(settings.value("window/layout").toByteArray(), kLayoutVersion);
}

void MainWindow::saveLayout() {
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  settings.setValue("window/layout", saveState(kLayoutVersion));
}

}  // namespace spin
