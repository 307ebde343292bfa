// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/import_flow.h"

#include <QAction>
#include <QCheckBox>
#include <QFile>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

#include "editor/app/file_flow.h"
#include "editor/app/import_dialog.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/viewport/viewport.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"
#include "tests/support/node_data.h"

using namespace spin;

namespace {

struct Fixture {
  Fixture() : window(std::make_shared<test::FakeReader>()) {
    window.simulation().setAutomatic(false);
    window.files().showError = [this](const QString& text) { errors << text; };
    window.files().askUnsaved = [] { return FileFlow::Unsaved::Discard; };
    window.files().askSavePath = [this](const QString&) {
      return folder.filePath(QStringLiteral("valley.spindrift"));
    };
  }
  SceneDocument& document() { return window.document(); }
  const Scene& scene() { return window.document().scene(); }
  void trigger(const char* name) { window.actions().findChild<QAction*>(QLatin1String(name))->trigger(); }
  /// A file outside the scene's folder.
  QString write(const char* name) {
    QFile file(elsewhere.filePath(QLatin1String(name)));
    if (file.open(QIODevice::WriteOnly)) file.write(name);
    return file.fileName();
  }
  bool save() {
    QSignalSpy saved(&document(), &SceneDocument::saveFinished);
    trigger("fileSave");
    return QTest::qWaitFor([&] { return saved.count() == 1; }) && saved[0][0].toBool();
  }
  /// As the user does it: accepts the dialog once the file was read.
  bool import(const QString& file, bool copy = true) {
    window.imports().import(file);
    ImportDialog* dialog = nullptr;
    for (ImportDialog* there : window.findChildren<ImportDialog*>())
      if (there->isVisible()) dialog = there;
    if (!dialog || !QTest::qWaitFor([&] { return dialog->ready(); })) return false;
    if (!copy) dialog->findChild<QCheckBox*>(QStringLiteral("copyBeside"))->setChecked(false);
    dialog->findChild<QPushButton*>(QStringLiteral("importAccept"))->click();
    return true;
  }
  /// Imports the hill and waits until the view has gone there.
  bool importTerrain() {
    const auto arrived = [this] {
      return window.viewport().context().scene && window.viewport().context().scene->terrain &&
             length(window.viewport().camera().target - Vec3d{128, 128, 15}) < 2.0;
    };
    return import(write("hill.asc")) && QTest::qWaitFor(arrived);
  }
  const ModelNode* selectedModel() {
    const SceneNode* node = document().node(document().selected());
    return node && node->as<ModelNode>() ? &test::dataOf<ModelNode>(node) : nullptr;
  }
  bool hasIssue(const QString& words) {
    for (const DocumentIssue& issue : document().issues())
      if (issue.text.contains(words)) return true;
    return false;
  }

  QTemporaryDir folder, elsewhere;
  MainWindow window;
  QStringList errors;
};

}  // namespace

class ImportFlowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() {
    QSettings().clear();
    test::failOnWarnings();
  }

  /// A first terrain makes a scene in which it snows visibly, seen by camera and view; one undo step.
  void aFirstTerrainSnows() {
    Fixture f;
    QVERIFY(f.importTerrain());
    QVERIFY(f.scene().firstOf(kSnowfallType));
    QCOMPARE(test::dataOf<SimulationNode>(f.scene().firstOf(kSimulationType)).timeScale, 2880.0);
    QCOMPARE(f.scene().firstOf(kTerrainType)->name, std::string("hill"));
    const auto* camera = &test::dataOf<CameraNode>(f.scene().firstOf(kCameraType));
    QVERIFY(length(camera->target - Vec3d{128, 128, 30}) < 1.0);
    QCOMPARE(f.document().undoStack()->count(), 1);
    f.trigger("editUndo");
    QVERIFY(!f.scene().firstOf(kTerrainType));
    QVERIFY(!f.scene().firstOf(kSnowfallType));
    QVERIFY(!f.document().isModified());
  }

  void modelsStandWhereTheViewLooks() {
    Fixture f;
    QVERIFY(f.importTerrain());
    f.window.viewport().setCamera({{60, -40, 120}, {60, 60, 10}, 45});
    QVERIFY(f.import(f.write("hut.glb")));
    const ModelNode* hut = f.selectedModel();
    QVERIFY(hut);
    QVERIFY(hut->onGround);
    QCOMPARE(hut->position.x, 60.0);
    QVERIFY2(std::abs(hut->position.y - 64.0) < 5.0, qPrintable(QString::number(hut->position.y)));
    QCOMPARE(hut->position.z, 0.0);
    // Into the sky: where the scene's camera looks.
    f.window.viewport().setCamera({{128, -200, 50}, {128, -400, 150}, 45});
    QVERIFY(f.import(f.write("tree.glb")));
    const ModelNode* tree = f.selectedModel();
    QVERIFY(tree);
    QVERIFY(length(tree->position - Vec3d{128, 128, 0}) < 1.0);
    // The view flies to what it does not show.
    QTRY_VERIFY(std::hypot(f.window.viewport().camera().target.x - 128,
                           f.window.viewport().camera().target.y - 128) < 3.0);
  }

  void filesOfASceneWithoutAFolderAreCopiedAtItsFirstSave() {
    Fixture f;
    QVERIFY(f.import(f.write("hut.glb")));
    const std::string id = f.document().selected();
    QCOMPARE(sourceOf(*f.document().node(id)), f.write("hut.glb").toStdString());
    QVERIFY(f.save());
    QCOMPARE(sourceOf(*f.document().node(id)), std::string("valley.assets/hut.glb"));
    QVERIFY(QFile::exists(f.folder.filePath(QStringLiteral("valley.assets/hut.glb"))));
    QVERIFY(!f.window.isWindowModified());
    QVERIFY(!f.hasIssue(QStringLiteral("outside")));
    QVERIFY(QSettings().value(QStringLiteral("allowedFolders")).toStringList().isEmpty());
  }

  void filesOfASavedSceneAreCopiedAtOnce() {
    Fixture f;
    QVERIFY(f.save());
    QVERIFY(f.import(f.write("hut.glb")));
    QTRY_VERIFY(f.selectedModel());
    QCOMPARE(test::dataOf<ModelNode>(f.document().node(f.document().selected())).source,
             std::string("valley.assets/hut.glb"));
    QVERIFY(f.window.statusBar()->currentMessage().contains(QStringLiteral("valley.assets")));
    QVERIFY(QSettings().value(QStringLiteral("allowedFolders")).toStringList().isEmpty());
    QVERIFY(!f.hasIssue(QStringLiteral("outside")));
  }

  /// Without a copy the issues warn of it until the files are collected, of which the status bar tells.
  void filesLeftOutsideAreAnIssueUntilCollected() {
    Fixture f;
    QVERIFY(f.import(f.write("hut.glb"), false));
    QVERIFY(f.window.statusBar()->currentMessage().contains(f.elsewhere.path()));
    QVERIFY(f.save());
    QVERIFY(f.hasIssue(QStringLiteral("Collect files")));
    f.trigger("fileCollect");
    QVERIFY(f.window.statusBar()->currentMessage().contains(QStringLiteral("valley.assets")));
    QVERIFY(!f.hasIssue(QStringLiteral("Collect files")));
    QCOMPARE(test::dataOf<ModelNode>(f.document().node(f.document().selected())).source,
             std::string("valley.assets/hut.glb"));
    f.trigger("fileCollect");
    QVERIFY(f.window.statusBar()->currentMessage().contains(QStringLiteral("nothing")));
    QCOMPARE(f.errors, QStringList());
  }

  void aSecondTerrainIsAskedFor() {
    Fixture f;
    QVERIFY(f.importTerrain());
    QVERIFY(edit::addNode(f.document(), kGroundTypeLayerType, QStringLiteral("Meadows")).ok());
    const std::string id = f.scene().firstOf(kTerrainType)->id;
    QVERIFY(edit::setValue(f.document(), id, "epsg", std::int64_t{31287}).ok());
    const int steps = f.document().undoStack()->count();
    QStringList asked;
    bool answer = false;
    f.window.imports().askReplace = [&](const QString& question, const QString& meaning) {
      asked << question << meaning;
      return answer;
    };
    QVERIFY(f.import(f.write("ridge.asc")));
    QCOMPARE(asked.size(), 2);
    QVERIFY(asked[0].contains(QStringLiteral("hill")));
    QVERIFY(asked[1].contains(QStringLiteral("Meadows")));
    QCOMPARE(f.document().undoStack()->count(), steps);
    QCOMPARE(f.document().node(id)->name, std::string("hill"));
    answer = true;
    QVERIFY(f.import(f.write("ridge.asc")));
    QCOMPARE(f.document().undoStack()->count(), steps + 1);
    QCOMPARE(f.document().node(id)->name, std::string("ridge"));
    QCOMPARE(test::dataOf<TerrainNode>(f.document().node(id)).epsg, 0);
    f.trigger("editUndo");
    QCOMPARE(f.document().node(id)->name, std::string("hill"));
    QCOMPARE(test::dataOf<TerrainNode>(f.document().node(id)).epsg, 31287);
  }
};

QTEST_MAIN(ImportFlowTest)
#include "import_flow_test.moc"
