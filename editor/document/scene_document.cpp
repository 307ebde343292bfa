// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/scene_document.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QThreadPool>
#include <algorithm>

#include "core/nodes/node_registry.h"
#include "core/nodes/terrain_node.h"
#include "editor/document/save_job.h"
#include "editor/document/scene_checks.h"

namespace spin {
namespace {

constexpr qsizetype kMaxRecentFiles = 10;
const QString kRecentKey = QStringLiteral("recentFiles");
const QString kAllowedKey = QStringLiteral("allowedFolders");

PathPolicy storedPolicy() {
  PathPolicy policy;
  for (const QString& folder : QSettings().value(kAllowedKey).toStringList())
    policy.allowedFolders.push_back(folder.toStdString());
  return policy;
}

bool hasUnreadLayers(const Scene& scene) {
  return std::any_of(scene.nodes().begin(), scene.nodes().end(), [](const SceneNode& node) {
    return isPaintedType(*node.type) && std::holds_alternative<std::monostate>(node.painted) &&
           !sourceOf(node).empty();
  });
}

}  // namespace

SceneDocument::SceneDocument(std::shared_ptr<AssetReader> reader, QObject* parent)
    : QObject(parent),
      m_scene(makeDefaultScene()),
      m_reader(reader),
      m_assets(std::make_shared<AssetLibrary>(std::move(reader), storedPolicy())),
      m_worker(std::make_unique<QThreadPool>()) {
  m_worker->setMaxThreadCount(1);
  connect(&m_undo, &QUndoStack::cleanChanged, this, [this] { Q_EMIT modifiedChanged(isModified()); });
  checkOwnScene();
}

SceneDocument::~SceneDocument() {
  m_cancelLoading.cancel();
  m_worker->waitForDone();
  m_undo.disconnect(this);
}

QString SceneDocument::displayName() const {
  return m_path.isEmpty() ? tr("Untitled") : QFileInfo(m_path).completeBaseName();
}

bool SceneDocument::isModified() const {
  return m_recovered || !m_undo.isClean();
}

void SceneDocument::newScene() {
  reset({makeDefaultScene(), {}}, {});
}

Status SceneDocument::open(const QString& path) {
  const QString file = QFileInfo(path).absoluteFilePath();
  // Before it is read: a change in between is noticed later, not missed.
  const std::string hash = contentOf(file);
  Result<LoadedScene> loaded = loadScene(file.toStdString());
  if (!loaded) return loaded.error();
  reset(std::move(*loaded), file);
  m_hashOnDisk = hash;
  addRecentFile(file);
  return {};
}

void SceneDocument::takeOver(LoadedScene loaded, const QString& path, const std::string& hashOnDisk) {
  reset(std::move(loaded), path);
  m_hashOnDisk = hashOnDisk;
  // What was to be copied at the first save is known by the program that ended only.
  for (const SceneNode& node : m_scene.nodes()) {
    const std::string source = sourceOf(node);
    const bool imported = node.as<TerrainNode>() || node.as<ModelNode>();
    if (path.isEmpty() && imported && !source.empty() && !resolveAssetPath({}, source, pathPolicy()))
      copyOnSave(QString::fromStdString(source));
  }
  m_recovered = true;
  Q_EMIT modifiedChanged(true);
}

void SceneDocument::reset(LoadedScene loaded, const QString& path) {
  m_cancelLoading.cancel();
  m_cancelLoading = CancelToken();
  ++m_generation;
  ++m_edits;
  m_undo.clear();
  m_scene = std::move(loaded.scene);
  m_extras = std::move(loaded.extras);
  m_path = path;
  m_hashOnDisk.clear();
  m_recovered = false;
  m_loadingLayers = false;
  m_layersOnDisk.clear();
  m_copyOnSave.clear();
  m_issuesBySource.clear();
  m_issues.clear();
  m_assets->setExpectedHashes(m_extras.assetHashes);
  m_selected.clear();
  Q_EMIT selectionChanged(m_selected);
  Q_EMIT changed(ChangeEvent{});
  Q_EMIT pathChanged(m_path);
  Q_EMIT modifiedChanged(false);
  std::vector<DocumentIssue> remarks;
  for (const std::string& message : m_extras.messages)
    remarks.push_back({Severity::Information, {}, {}, QString::fromStdString(message)});
  setIssues(QStringLiteral("file"), std::move(remarks));
  Q_EMIT issuesChanged();
  checkOwnScene();
  checkFilePlaces();
  loadLayers();
}

void SceneDocument::notify(const ChangeEvent& event) {
  ++m_edits;
  if (event.kind == ChangeKind::Removed && event.node == m_selected) select({});
  Q_EMIT changed(event);
  if (event.kind != ChangeKind::Painted) checkOwnScene();
  const bool sameFiles = event.kind == ChangeKind::Painted || event.kind == ChangeKind::Moved ||
                         (event.kind == ChangeKind::Property && event.property != "source");
  if (!sameFiles) checkFilePlaces();
}

void SceneDocument::checkOwnScene() {
  setIssues(QStringLiteral("scene"), checkScene(m_scene));
}

void SceneDocument::checkFilePlaces() {
  setIssues(QStringLiteral("places"), filesOutside(m_scene, m_path.toStdString(), pathPolicy()));
}

void SceneDocument::setIssues(const QString& source, std::vector<DocumentIssue> issues) {
  if (m_issuesBySource[source] == issues) return;
  m_issuesBySource[source] = std::move(issues);
  m_issues.clear();
  for (const auto& [name, list] : m_issuesBySource) m_issues.insert(m_issues.end(), list.begin(), list.end());
  std::stable_sort(m_issues.begin(), m_issues.end(),
                   [](const DocumentIssue& a, const DocumentIssue& b) { return a.severity > b.severity; });
  Q_EMIT issuesChanged();
}

void SceneDocument::select(const std::string& id) {
  const std::string known = m_scene.find(id) ? id : std::string();
  if (known == m_selected) return;
  m_selected = known;
  Q_EMIT selectionChanged(m_selected);
}

void SceneDocument::reveal(const std::string& node, const std::string& property) {
  select(node);
  Q_EMIT revealRequested(node, property);
}

void SceneDocument::loadLayers() {
  if (!hasUnreadLayers(m_scene)) return;
  m_loadingLayers = true;
  m_worker->start([this, scene = m_scene, file = m_path.toStdString(), policy = pathPolicy(),
                   cancel = m_cancelLoading, generation = m_generation]() mutable {
    std::vector<AssetLibrary::Issue> found;
    if (!loadPaintedLayers(scene, file, *m_reader, policy, found, cancel)) return;
    QMetaObject::invokeMethod(this, [this, scene = std::move(scene), found = std::move(found), generation] {
      if (generation == m_generation) takeLayers(scene, found);
    });
  });
}

void SceneDocument::takeLayers(const Scene& loaded, const std::vector<AssetLibrary::Issue>& found) {
  m_loadingLayers = false;
  for (const SceneNode& read : loaded.nodes()) {
    SceneNode* node = m_scene.find(read.id);
    const bool hasLayer = !std::holds_alternative<std::monostate>(read.painted);
    if (!node || !hasLayer || !std::holds_alternative<std::monostate>(node->painted)) continue;
    node->painted = read.painted;
    m_layersOnDisk[read.id] = read.painted;
    Q_EMIT changed(ChangeEvent{ChangeKind::Painted, read.id, {}, Affects::Both});
  }
  std::vector<DocumentIssue> issues;
  for (const AssetLibrary::Issue& issue : found)
    issues.push_back(
        issueOf(issue.error, issue.node, issue.usable ? Severity::Information : Severity::Error));
  setIssues(QStringLiteral("layers"), std::move(issues));
  Q_EMIT layersLoaded();
}

std::shared_ptr<SceneDocument::SaveJob> SceneDocument::makeSaveJob(const QString& path) const {
  auto job = std::make_shared<SaveJob>();
  job->path = QFileInfo(path).absoluteFilePath();
  job->original = m_scene;
  job->scene = m_scene;
  job->extras = m_extras;
  job->oldPath = m_path;
  job->copied = m_copyOnSave;
  job->layersOnDisk = m_layersOnDisk;
  job->edits = m_edits;
  job->generation = m_generation;
  return job;
}

void SceneDocument::saveAs(const QString& path) {
  if (m_saveJob || path.isEmpty()) {
    Q_EMIT saveFinished(false, path.isEmpty() ? tr("The scene has no file name yet.")
                                              : tr("The scene is being saved already."));
    return;
  }
  m_saveJob = makeSaveJob(path);
  m_worker->start([this, job = m_saveJob] {
    job->run(*m_assets);
    QMetaObject::invokeMethod(this, [this, job] { finishSave(job); });
  });
}

bool SceneDocument::isChangedOnDisk() const {
  if (m_path.isEmpty() || m_hashOnDisk.empty() || m_saveJob) return false;
  const std::string now = contentOf(m_path);
  return !now.empty() && now != m_hashOnDisk;
}

Status SceneDocument::finishSaving() {
  const std::shared_ptr<SaveJob> job = m_saveJob;
  if (!job) return {};
  m_worker->waitForDone();
  finishSave(job);
  return job->status;
}

void SceneDocument::finishSave(const std::shared_ptr<SaveJob>& job) {
  if (job != m_saveJob) return;
  m_saveJob.reset();
  if (job->status && job->generation == m_generation) {
    const bool sameFile = m_path == job->path;
    m_path = job->path;
    m_hashOnDisk = job->hashOnDisk;
    takeSources(*job);
    m_extras = job->extras;
    for (const SceneNode& node : job->original.nodes()) m_layersOnDisk[node.id] = node.painted;
    if (m_edits == job->edits) {
      m_recovered = false;
      m_undo.setClean();
      Q_EMIT modifiedChanged(false);
    }
    if (!sameFile) Q_EMIT pathChanged(m_path);
    setIssues(QStringLiteral("copies"), job->issues);
    checkFilePlaces();
    addRecentFile(m_path);
  }
  Q_EMIT saveFinished(job->status.ok(),
                      job->status ? QString() : QString::fromStdString(job->status.error().text()));
}

/// The saved scene names its files anew (painted layers, another folder): the open one follows, unless the
/// user changed the same name meanwhile. No undo step: the files are where they are.
void SceneDocument::takeSources(const SaveJob& job) {
  for (const SceneNode& saved : job.scene.nodes()) {
    SceneNode* node = m_scene.find(saved.id);
    const SceneNode* before = job.original.find(saved.id);
    const PropertyInfo* source = saved.type->find("source");
    if (!node || node->type != saved.type || !before || !source) continue;
    if (sourceOf(*node) != sourceOf(*before) || sourceOf(*node) == sourceOf(saved)) continue;
    setPlainValue(*node, *source, plainValue(saved, *source));
    Q_EMIT changed(ChangeEvent{ChangeKind::Property, saved.id, source->id, Affects::Nothing});
  }
}

QStringList SceneDocument::recentFiles() const {
  QStringList files = QSettings().value(kRecentKey).toStringList();
  files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
  return files;
}

void SceneDocument::addRecentFile(const QString& path) {
  QStringList files = recentFiles();
  files.removeAll(path);
  files.prepend(path);
  QSettings().setValue(kRecentKey, QStringList(files.mid(0, kMaxRecentFiles)));
  Q_EMIT recentFilesChanged();
}

void SceneDocument::allowFolder(const QString& folder) {
  QStringList folders = QSettings().value(kAllowedKey).toStringList();
  const QString path = QFileInfo(folder).absoluteFilePath();
  if (!folders.contains(path)) QSettings().setValue(kAllowedKey, folders << path);
  permit(path);
}

void SceneDocument::copyOnSave(const QString& file) {
  const QString path = QDir::cleanPath(QFileInfo(file).absoluteFilePath());
  m_copyOnSave.insert(path);
  permit(QFileInfo(path).absolutePath());
}

void SceneDocument::permit(const QString& folder) {
  PathPolicy policy = m_assets->policy();
  policy.allowedFolders.push_back(folder.toStdString());
  m_assets->setPolicy(std::move(policy));
}

PathPolicy SceneDocument::pathPolicy() const {
  return m_assets->policy();
}

std::vector<std::string> SceneDocument::neededFolders() const {
  const std::string scene = m_path.toStdString();
  const PathPolicy all = pathPolicy();
  std::vector<std::string> needed;
  for (const std::string& folder : all.allowedFolders) {
    PathPolicy only;
    only.allowedFolders = {folder};
    const bool used = std::any_of(m_scene.nodes().begin(), m_scene.nodes().end(), [&](const SceneNode& node) {
      const std::string source = sourceOf(node);
      return !source.empty() && !resolveAssetPath(scene, source, {}) && resolveAssetPath(scene, source, only);
    });
    if (used && std::find(needed.begin(), needed.end(), folder) == needed.end()) needed.push_back(folder);
  }
  return needed;
}

std::string SceneDocument::storedPath(const QString& absolutePath) const {
  return storedAssetPath(m_path.toStdString(), absolutePath.toStdString());
}

}  // namespace spin
