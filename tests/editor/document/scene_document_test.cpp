// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/scene_document.h"

#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "core/nodes/flow_nodes.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "editor/commands/edits.h"
#include "editor/document/time_context.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;

class SceneDocumentTest : public QObject {
  Q_OBJECT
 private:
  std::shared_ptr<FakeAssetReader> m_reader;
  std::unique_ptr<QTemporaryDir> m_folder;
  QString path(const char* name) const { return m_folder->filePath(QString::fromUtf8(name)); }
  static void write(const QString& file, const QByteArray& text) {
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(text);
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    m_reader = std::make_shared<FakeAssetReader>();
    m_folder = std::make_unique<QTemporaryDir>();
  }
  void savesAndOpens();
  void savingTellsTheOutcomeLater();
  void anEditDuringASaveStaysModified();
  void changesOnDiskAreSeen();
  void aFailedOpenKeepsTheScene();
  void paintedLayersAreSavedAndRead();
  void unchangedLayersAreNotWrittenAgain();
  void savingElsewhereRebasesFiles();
  void assetsFromOutsideAreAllowedByTheUser();
  void newcomersAreAdvised();
  void onlyFoldersInUseAreNeeded();
  void filesAreCopiedAtTheFirstSave();
  void aFileThatCannotBeCopiedDoesNotHinderTheSave();
  void filesOutsideAreAnIssue();
  void issuesAreGatheredBySource();
  void selectionFollowsTheScene();
  void recentFilesAreNewestFirst();
  void timeFollowsTheFrameRate();
};

void SceneDocumentTest::savesAndOpens() {
  SceneDocument document(m_reader);
  QVERIFY(document.path().isEmpty());
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 7.0).ok());
  QVERIFY(document.isModified());
  document.saveAs(path("a.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QVERIFY(!document.isModified());
  QCOMPARE(document.displayName(), QStringLiteral("a"));
  document.undoStack()->undo();
  QVERIFY(document.isModified());
  SceneDocument other(m_reader);
  QSignalSpy changes(&other, &SceneDocument::changed);
  QVERIFY(other.open(path("a.spindrift")).ok());
  QCOMPARE(changes.count(), 1);
  QCOMPARE(other.node("weather")->as<WeatherNode>()->windSpeed, 7.0);
  QVERIFY(!other.isModified());
  other.newScene();
  QVERIFY(other.path().isEmpty());
  QCOMPARE(other.node("weather")->as<WeatherNode>()->windSpeed, 2.0);
}

void SceneDocumentTest::savingTellsTheOutcomeLater() {
  SceneDocument document(m_reader);
  QSignalSpy finished(&document, &SceneDocument::saveFinished);
  document.save();
  QCOMPARE(finished.count(), 1);
  QCOMPARE(finished.takeFirst().at(0).toBool(), false);
  document.saveAs(path("none/a.spindrift"));
  QVERIFY(document.isSaving());
  QTRY_COMPARE(finished.count(), 1);
  QCOMPARE(finished.at(0).at(0).toBool(), false);
  QVERIFY(finished.at(0).at(1).toString().contains(QStringLiteral("a.spindrift")));
  QVERIFY(document.path().isEmpty());
  document.saveAs(path("a.spindrift"));
  QTRY_COMPARE(finished.count(), 2);
  QCOMPARE(finished.at(1).at(0).toBool(), true);
  QVERIFY(QFile::exists(path("a.spindrift")));
}

void SceneDocumentTest::anEditDuringASaveStaysModified() {
  SceneDocument document(m_reader);
  const edit::Session drag = edit::newSession();
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 7.0, drag).ok());
  document.saveAs(path("a.spindrift"));
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 8.0, drag).ok());
  QVERIFY(document.finishSaving().ok());
  QVERIFY2(document.isModified(), "the merged step has the same index as the saved one");
}

void SceneDocumentTest::changesOnDiskAreSeen() {
  SceneDocument document(m_reader);
  QVERIFY(!document.isChangedOnDisk());
  document.saveAs(path("a.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QVERIFY(!document.isChangedOnDisk());
  SceneDocument other(m_reader);
  QVERIFY(other.open(path("a.spindrift")).ok());
  QVERIFY(!other.isChangedOnDisk());
  QVERIFY(edit::setValue(other, "weather", "wind_speed_m_s", 7.0).ok());
  other.save();
  QVERIFY(other.finishSaving().ok());
  QVERIFY(!other.isChangedOnDisk());
  QVERIFY(document.isChangedOnDisk());
  document.save();
  QVERIFY(document.finishSaving().ok());
  QVERIFY(!document.isChangedOnDisk());
  QVERIFY(other.isChangedOnDisk());
  QVERIFY(QFile::remove(path("a.spindrift")));
  QVERIFY2(!other.isChangedOnDisk(), "nothing would be overwritten");
}

void SceneDocumentTest::aFailedOpenKeepsTheScene() {
  SceneDocument document(m_reader);
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 7.0).ok());
  write(path("bad.spindrift"), "{\"format\": \"spindrift-scene\"");
  QVERIFY(!document.open(path("bad.spindrift")).ok());
  QVERIFY(!document.open(path("none.spindrift")).ok());
  QCOMPARE(document.node("weather")->as<WeatherNode>()->windSpeed, 7.0);
  QVERIFY(document.isModified());
}

void SceneDocumentTest::paintedLayersAreSavedAndRead() {
  SceneDocument document(m_reader);
  const std::string node = *edit::addNode(document, kGroundTypeLayerType, {});
  TiledRaster<std::uint8_t> layer(70, 5, kUnpaintedGround);
  layer.set(69, 4, 5);
  QVERIFY(edit::paint(document, node, layer, 0).ok());
  document.saveAs(path("a.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QVERIFY(QFile::exists(path("a.assets/ground_type.png")));
  QCOMPARE(sourceOf(*document.node(node)), std::string("a.assets/ground_type.png"));
  QVERIFY(!document.isModified());
  SceneDocument other(m_reader);
  QSignalSpy loaded(&other, &SceneDocument::layersLoaded);
  QVERIFY(other.open(path("a.spindrift")).ok());
  QVERIFY(other.isLoadingLayers());
  QVERIFY2(!edit::paint(other, node, layer, 0).ok(), "painting waits for the file");
  QTRY_COMPARE(loaded.count(), 1);
  QVERIFY(!other.isModified());
  QVERIFY(other.node(node)->painted == document.node(node)->painted);
}

void SceneDocumentTest::unchangedLayersAreNotWrittenAgain() {
  SceneDocument document(m_reader);
  const std::string node = *edit::addNode(document, kGroundTypeLayerType, {});
  TiledRaster<std::uint8_t> layer(10, 5, kUnpaintedGround);
  layer.set(1, 1, 5);
  QVERIFY(edit::paint(document, node, layer, 0).ok());
  document.saveAs(path("a.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 7.0).ok());
  document.save();
  QVERIFY(document.finishSaving().ok());
  QCOMPARE(m_reader->layerWrites.load(), 1);
  layer.set(2, 1, 5);
  QVERIFY(edit::paint(document, node, layer, 0).ok());
  document.save();
  QVERIFY(document.finishSaving().ok());
  QCOMPARE(m_reader->layerWrites.load(), 2);
  document.saveAs(path("b.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QVERIFY(QFile::exists(path("b.assets/ground_type.png")));
}

void SceneDocumentTest::savingElsewhereRebasesFiles() {
  write(path("dem.txt"), "1 1 1 5");
  QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("sub")));
  SceneDocument document(m_reader);
  QVERIFY(edit::addAssetNode(document, kTerrainType, path("dem.txt")).ok());
  QCOMPARE(sourceOf(*document.node("terrain")), path("dem.txt").toStdString());
  document.saveAs(path("a.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QCOMPARE(sourceOf(*document.node("terrain")), std::string("dem.txt"));
  document.saveAs(path("sub/b.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QCOMPARE(sourceOf(*document.node("terrain")), std::string("../dem.txt"));
  std::vector<AssetLibrary::Issue> issues;
  const auto snapshot = document.assets()->snapshot(document.scene(), document.path().toStdString(), issues);
  QVERIFY(issues.empty());
  QVERIFY((*snapshot)->terrain);
}

void SceneDocumentTest::assetsFromOutsideAreAllowedByTheUser() {
  write(path("dem.txt"), "1 1 1 5");
  SceneDocument document(m_reader);
  const Result<std::string> first = edit::addAssetNode(document, kTerrainType, path("dem.txt"));
  QVERIFY(first.ok());
  QCOMPARE(document.selected(), *first);
  write(path("dem2.txt"), "1 1 1 6");
  edit::AssetDetails details;
  details.options.epsg = 31287;
  const Result<std::string> second = edit::addAssetNode(document, kTerrainType, path("dem2.txt"), details);
  QVERIFY(second.ok());
  QCOMPARE(*second, *first);
  QCOMPARE(document.node(*first)->as<TerrainNode>()->epsg, 31287);
  QVERIFY(!edit::addAssetNode(document, kModelType, QStringLiteral("/dev/zero")).ok());
  SceneDocument later(m_reader);
  QCOMPARE(later.pathPolicy().allowedFolders.size(), document.pathPolicy().allowedFolders.size());
}

/// A hut that an avalanche runs through, and a forest with fine cover, are told of; until they are mended.
void SceneDocumentTest::newcomersAreAdvised() {
  SceneDocument document(m_reader);
  const auto told = [&](const char* node, const QString& words) {
    const auto issues = document.issues();
    return std::any_of(issues.begin(), issues.end(), [&](const DocumentIssue& issue) {
      return issue.severity == Severity::Information && issue.node == node && issue.text.contains(words);
    });
  };
  QVERIFY(edit::addNode(document, kModelType, QStringLiteral("Hut"), "hut").ok());
  QVERIFY(!told("hut", QStringLiteral("rigid body")));
  QVERIFY(edit::addNode(document, kAvalancheReleaseType, QStringLiteral("Slab"), "slab").ok());
  QTRY_VERIFY(told("hut", QStringLiteral("rigid body")));
  QVERIFY(edit::addNode(document, kRigidBodyType, QStringLiteral("Body"), "body").ok());
  QTRY_VERIFY(!told("hut", QStringLiteral("rigid body")));
  QVERIFY(edit::setValue(document, "hut", "copies_m", PlanPoints(100, Vec2d{1, 2})).ok());
  QTRY_VERIFY(told("hut", QStringLiteral("100 copies")));
  QVERIFY(edit::setValue(document, "hut", "fine_cover", false).ok());
  QTRY_VERIFY(!told("hut", QStringLiteral("copies")));
}

/// Exports name the folders that the scene's files lie in, not all that were ever allowed.
void SceneDocumentTest::onlyFoldersInUseAreNeeded() {
  const QTemporaryDir first, second;
  write(first.filePath(QStringLiteral("hut.obj")), "3");
  write(second.filePath(QStringLiteral("tree.obj")), "3");
  SceneDocument document(m_reader);
  document.saveAs(path("used.spindrift"));
  QVERIFY(document.finishSaving().ok());
  const auto hut = edit::addAssetNode(document, kModelType, first.filePath(QStringLiteral("hut.obj")));
  const auto tree = edit::addAssetNode(document, kModelType, second.filePath(QStringLiteral("tree.obj")));
  QVERIFY(hut.ok() && tree.ok());
  QCOMPARE(document.neededFolders().size(), std::size_t{2});
  QVERIFY(edit::removeNode(document, *hut).ok());
  QCOMPARE(document.neededFolders(), std::vector<std::string>{second.path().toStdString()});
  QVERIFY(edit::removeNode(document, *tree).ok());
  QVERIFY(document.neededFolders().empty());
}

void SceneDocumentTest::filesAreCopiedAtTheFirstSave() {
  const QTemporaryDir elsewhere;
  write(elsewhere.filePath(QStringLiteral("hut.obj")), "3");
  SceneDocument document(m_reader);
  edit::AssetDetails details;
  details.copyOnSave = true;
  const auto added =
      edit::addAssetNode(document, kModelType, elsewhere.filePath(QStringLiteral("hut.obj")), details);
  QVERIFY(added.ok());
  QVERIFY(edit::duplicateNode(document, *added).ok());
  QVERIFY2(SceneDocument(m_reader).pathPolicy().allowedFolders.empty(), "nothing is allowed for good");
  std::vector<AssetLibrary::Issue> issues;
  QVERIFY(document.assets()->snapshot(document.scene(), {}, issues).ok());
  QVERIFY2(issues.empty(), "the file is shown before it is copied");
  document.saveAs(path("a.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QVERIFY(QFile::exists(path("a.assets/hut.obj")));
  QCOMPARE(sourceOf(*document.node(*added)), std::string("a.assets/hut.obj"));
  QCOMPARE(sourceOf(*document.node(*added + "_2")), std::string("a.assets/hut.obj"));
  QVERIFY(document.issues().empty());
  QVERIFY(!document.isModified());
  // Undo and redo bring the first path back; the next save copies again.
  document.undoStack()->undo();
  document.undoStack()->undo();
  document.undoStack()->redo();
  document.save();
  QVERIFY(document.finishSaving().ok());
  QCOMPARE(sourceOf(*document.node(*added)), std::string("a.assets/hut.obj"));
}

void SceneDocumentTest::aFileThatCannotBeCopiedDoesNotHinderTheSave() {
  const QTemporaryDir elsewhere;
  const QString hut = elsewhere.filePath(QStringLiteral("hut.obj"));
  write(hut, "3");
  SceneDocument document(m_reader);
  edit::AssetDetails details;
  details.copyOnSave = true;
  QVERIFY(edit::addAssetNode(document, kModelType, hut, details).ok());
  QVERIFY(QFile::remove(hut));
  document.saveAs(path("a.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QVERIFY(QFile::exists(path("a.spindrift")));
  const auto& issues = document.issues();
  QVERIFY(std::any_of(issues.begin(), issues.end(), [](const DocumentIssue& issue) {
    return issue.text.contains(QStringLiteral("could not be copied"));
  }));
}

void SceneDocumentTest::filesOutsideAreAnIssue() {
  const QTemporaryDir elsewhere;
  write(elsewhere.filePath(QStringLiteral("hut.obj")), "3");
  SceneDocument document(m_reader);
  const auto added = edit::addAssetNode(document, kModelType, elsewhere.filePath(QStringLiteral("hut.obj")));
  QVERIFY(added.ok());
  QVERIFY2(document.issues().empty(), "the scene has no folder yet");
  document.saveAs(path("a.spindrift"));
  QVERIFY(document.finishSaving().ok());
  QCOMPARE(document.issues().size(), 1u);
  QVERIFY(document.issues()[0].severity == Severity::Warning);
  QCOMPARE(document.issues()[0].node, *added);
  QVERIFY(document.issues()[0].text.contains(QStringLiteral("hut.obj")));
  QVERIFY(document.issues()[0].text.contains(QStringLiteral("Collect files")));
  SceneDocument other(m_reader);
  QVERIFY(other.open(path("a.spindrift")).ok());
  QCOMPARE(other.issues().size(), 1u);
  const Result<int> collected = edit::collectFiles(document);
  QVERIFY(collected.ok());
  QCOMPARE(*collected, 1);
  QVERIFY(document.issues().empty());
  QCOMPARE(*edit::collectFiles(document), 0);
  document.undoStack()->undo();
  QCOMPARE(document.issues().size(), 1u);
}

void SceneDocumentTest::issuesAreGatheredBySource() {
  SceneDocument document(m_reader);
  QVERIFY(document.issues().empty());
  QSignalSpy changes(&document, &SceneDocument::issuesChanged);
  QVERIFY(edit::setValue(document, "simulation", "first_frame", std::int64_t{500}).ok());
  QCOMPARE(document.issues().size(), 1u);
  QCOMPARE(document.issues()[0].property, std::string("last_frame"));
  document.setIssues(QStringLiteral("simulation"), {{Severity::Warning, {}, {}, QStringLiteral("slow")}});
  document.setIssues(QStringLiteral("assets"), {{Severity::Error, "weather", {}, QStringLiteral("bad")}});
  QCOMPARE(document.issues().size(), 3u);
  QVERIFY(document.issues()[2].severity == Severity::Warning);
  QCOMPARE(changes.count(), 3);
  document.setIssues(QStringLiteral("assets"), {{Severity::Error, "weather", {}, QStringLiteral("bad")}});
  QCOMPARE(changes.count(), 3);
  document.undoStack()->undo();
  QCOMPARE(document.issues().size(), 2u);
}

void SceneDocumentTest::selectionFollowsTheScene() {
  SceneDocument document(m_reader);
  QSignalSpy selections(&document, &SceneDocument::selectionChanged);
  document.select("nobody");
  QCOMPARE(selections.count(), 0);
  document.select("weather");
  document.select("weather");
  QCOMPARE(selections.count(), 1);
  QVERIFY(edit::removeNode(document, "weather").ok());
  QVERIFY(document.selected().empty());
  document.select("camera");
  document.newScene();
  QVERIFY(document.selected().empty());
}

void SceneDocumentTest::recentFilesAreNewestFirst() {
  SceneDocument document(m_reader);
  for (const char* name : {"a.spindrift", "b.spindrift", "a.spindrift"}) {
    document.saveAs(path(name));
    QVERIFY(document.finishSaving().ok());
  }
  QCOMPARE(document.recentFiles(), (QStringList{path("a.spindrift"), path("b.spindrift")}));
  QFile::remove(path("a.spindrift"));
  QCOMPARE(document.recentFiles(), QStringList{path("b.spindrift")});
}

void SceneDocumentTest::timeFollowsTheFrameRate() {
  SceneDocument document(m_reader);
  TimeContext time(&document);
  time.setFrame(48);
  QCOMPARE(time.filmTime(), 2.0);
  QVERIFY(edit::setValue(document, "simulation", "frame_rate", 48.0).ok());
  QCOMPARE(time.filmTime(), 1.0);
  time.setFrame(-3);
  QCOMPARE(time.frame(), 0);
}

QTEST_MAIN(SceneDocumentTest)
#include "scene_document_test.moc"
