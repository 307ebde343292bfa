// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/main_window.h"

#include <QAction>
#include <QFile>
#include <QFileInfo>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "editor/app/file_flow.h"
#include "editor/app/main_actions.h"
#include "editor/app/scene_tools.h"
#include "editor/timeline/timeline_panel.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

namespace {

struct Fixture {
  Fixture() : window(std::make_shared<test::FakeReader>()) {
    window.simulation().setAutomatic(false);
    window.files().showError = [this](const QString& text) { errors << text; };
    window.files().askUnsaved = [this] {
      ++asked;
      return answer;
    };
    window.files().askSavePath = [this](const QString&) { return path; };
    window.files().askOpenPath = [this] { return path; };
  }
  QAction* action(const char* name) { return window.actions().findChild<QAction*>(QLatin1String(name)); }
  /// A model that gives the scene something to work on.
  std::string addModel() {
    QFile file(folder.filePath(QStringLiteral("cube.glb")));
    if (file.open(QIODevice::WriteOnly)) file.write("stands for a model");
    file.close();
    const auto added = edit::addAssetNode(window.document(), kModelType, file.fileName());
    return added.ok() ? *added : std::string();
  }

  QTemporaryDir folder;
  MainWindow window;
  FileFlow::Unsaved answer = FileFlow::Unsaved::Discard;
  QString path;
  QStringList errors;
  int asked = 0;
};

}  // namespace

class MainWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { test::failOnWarnings(); }

  void opensEmptyAndUnmodified() {
    Fixture f;
    QVERIFY(!f.window.document().isModified());
    QVERIFY(f.window.windowTitle().contains(QStringLiteral("[*]")));
    QVERIFY(f.window.document().scene().firstOf(kSimulationType) != nullptr);
    QCOMPARE(f.window.timeline().bar()->last(), 119);
  }

  /// Undo and redo through the menu; title and modified mark follow.
  void editsAreUndone() {
    Fixture f;
    const std::string id = f.addModel();
    QVERIFY(!id.empty());
    QVERIFY(f.window.isWindowModified());
    f.action("editUndo")->trigger();
    QVERIFY(f.window.document().node(id) == nullptr);
    QVERIFY(!f.window.isWindowModified());
    f.action("editRedo")->trigger();
    QVERIFY(f.window.document().node(id) != nullptr);
  }

  void duplicateAndDeleteFollowTheSelection() {
    Fixture f;
    const std::string id = f.addModel();
    f.window.document().select({});
    QVERIFY(!f.action("editDelete")->isEnabled());
    f.window.document().select(id);
    f.action("editDuplicate")->trigger();
    QVERIFY(f.window.document().selected() != id);
    QVERIFY(f.window.document().node(f.window.document().selected())->as<ModelNode>());
    f.action("editDelete")->trigger();
    QVERIFY(f.window.document().node(id) != nullptr);
  }

  /// Save as, open again: the same scene; the window's title shows the file.
  void savesAndOpens() {
    Fixture f;
    const std::string id = f.addModel();
    f.path = f.folder.filePath(QStringLiteral("valley"));  // the ending is added
    QSignalSpy saved(&f.window.document(), &SceneDocument::saveFinished);
    f.action("fileSaveAs")->trigger();
    QTRY_COMPARE(saved.count(), 1);
    QVERIFY(QFileInfo::exists(f.path + QStringLiteral(".spindrift")));
    QVERIFY(!f.window.isWindowModified());
    QVERIFY(f.window.windowTitle().startsWith(QStringLiteral("valley")));
    f.action("fileNew")->trigger();
    QVERIFY(f.window.document().node(id) == nullptr);
    f.path += QStringLiteral(".spindrift");
    f.action("fileOpen")->trigger();
    QVERIFY(f.window.document().node(id) != nullptr);
    QCOMPARE(f.asked, 0);
    QCOMPARE(f.errors, QStringList());
  }

  /// Nothing unsaved is lost without a question, and Cancel keeps it.
  void asksBeforeGivingUpChanges() {
    Fixture f;
    const std::string id = f.addModel();
    f.answer = FileFlow::Unsaved::Cancel;
    f.action("fileNew")->trigger();
    QCOMPARE(f.asked, 1);
    QVERIFY(f.window.document().node(id) != nullptr);
    QVERIFY(!f.window.close());
    QCOMPARE(f.asked, 2);
    f.answer = FileFlow::Unsaved::Discard;
    f.action("fileNew")->trigger();
    QVERIFY(f.window.document().node(id) == nullptr);
  }

  /// Answering Save saves before the scene goes.
  void savesWhenAsked() {
    Fixture f;
    f.addModel();
    f.answer = FileFlow::Unsaved::Save;
    f.path = f.folder.filePath(QStringLiteral("kept.spindrift"));
    f.action("fileNew")->trigger();
    QVERIFY(QFileInfo::exists(f.path));
    QVERIFY(!f.window.document().isModified());
  }

  void brokenScenesAreAnError() {
    Fixture f;
    f.path = f.folder.filePath(QStringLiteral("bad.spindrift"));
    QFile file(f.path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{ this is no scene");
    file.close();
    f.action("fileOpen")->trigger();
    QCOMPARE(f.errors.size(), 1);
    QVERIFY(f.errors[0].contains(QStringLiteral("bad.spindrift")));
  }

  /// Settings of the simulation rule the timeline.
  void timelineFollowsTheScene() {
    Fixture f;
    const std::string id = f.window.document().scene().firstOf(kSimulationType)->id;
    QVERIFY(edit::setValue(f.window.document(), id, "last_frame", std::int64_t{47}).ok());
    QVERIFY(edit::setValue(f.window.document(), id, "frame_rate", 10.0).ok());
    QCOMPARE(f.window.timeline().bar()->last(), 47);
    QCOMPARE(f.window.timeline().frameRate(), 10.0);
    f.window.timeline().setCurrent(20);
    QCOMPARE(f.window.time().frame(), 20);
    QCOMPARE(f.window.time().filmTime(), 2.0);
  }

  /// K sets keys, the timeline shows them, dragging a mark moves them; all of it can be undone.
  void keysAreSetAndMoved() {
    Fixture f;
    const std::string id = f.addModel();
    f.window.document().select(id);
    f.window.timeline().setCurrent(12);
    f.action("editSetKeys")->trigger();
    QCOMPARE(f.window.timeline().bar()->keyFrames(), std::vector<double>{12.0});
    Q_EMIT f.window.timeline().bar()->keyMoved(12.0, 30);
    QCOMPARE(f.window.timeline().bar()->keyFrames(), std::vector<double>{30.0});
    f.action("editUndo")->trigger();
    QCOMPARE(f.window.timeline().bar()->keyFrames(), std::vector<double>{12.0});
    f.action("editUndo")->trigger();
    QVERIFY(f.window.timeline().bar()->keyFrames().empty());
  }

  /// A stroke on a scene without a ground type layer makes the layer and paints, in one undo step.
  void strokeIsOneUndoStep() {
    Fixture f;
    Viewport& view = f.window.viewport();
    const int before = f.window.document().undoStack()->index();
    TiledRaster<std::uint8_t> layer(65, 65, kUnpaintedGround);
    Q_EMIT view.editStarted();
    for (int i = 10; i < 20; ++i) {
      layer.set(i, 12, 4);
      Q_EMIT view.layerPainted(layer);
    }
    Q_EMIT view.editFinished();
    QCOMPARE(f.window.document().undoStack()->index(), before + 1);
    const SceneNode* node = f.window.document().scene().firstOf(kGroundTypeLayerType);
    QVERIFY(node);
    QVERIFY(std::get<TiledRaster<std::uint8_t>>(node->painted) == layer);
    f.action("editUndo")->trigger();
    QVERIFY(!f.window.document().scene().firstOf(kGroundTypeLayerType));
  }

  /// A drag of the gizmo is one undo step; Escape takes it back.
  void gizmoDragIsOneUndoStep() {
    Fixture f;
    const std::string id = f.addModel();
    Viewport& view = f.window.viewport();
    view.setTool(Viewport::Tool::Move);
    const int before = f.window.document().undoStack()->index();
    const auto x = [&] { return f.window.document().node(id)->as<ModelNode>()->position.x; };
    const auto drag = [&] {
      Q_EMIT view.editStarted();
      for (int k = 1; k <= 5; ++k)
        Q_EMIT view.placementEdited(id, GizmoPlacement{{1.0 * k, 0, 0}, {}, {1, 1, 1}});
    };
    drag();
    Q_EMIT view.editFinished();
    QCOMPARE(x(), 5.0);
    QCOMPARE(f.window.document().undoStack()->index(), before + 1);
    f.action("editUndo")->trigger();
    QCOMPARE(x(), 0.0);
    drag();
    Q_EMIT view.editCancelled();
    QCOMPARE(x(), 0.0);
    QCOMPARE(f.window.document().undoStack()->index(), before);
  }

  void cameraIsSetFromTheView() {
    Fixture f;
    f.window.viewport().setCamera({{10, -70, 33}, {1, 2, 3}, 40});
    f.action("viewSetCamera")->trigger();
    const auto* camera = f.window.document().scene().firstOf(kCameraType)->as<CameraNode>();
    QVERIFY(length(camera->position - Vec3d{10, -70, 33}) < 1e-9);
    QVERIFY(length(camera->target - Vec3d{1, 2, 3}) < 1e-9);
    QCOMPARE(camera->fovDegrees, 40.0);
  }

  /// No two actions share a shortcut.
  void shortcutsAreUnique() {
    Fixture f;
    QStringList seen;
    for (QAction* action : f.window.actions().withShortcuts())
      for (const QKeySequence& keys : action->shortcuts()) {
        QVERIFY2(!seen.contains(keys.toString()), qPrintable(keys.toString()));
        seen << keys.toString();
      }
    QVERIFY(seen.size() > 20);
  }

  /// The scene is simulated in the background and its frames can be shown.
  void simulatesInTheBackground() {
    Fixture f;
    const std::string simulation = f.window.document().scene().firstOf(kSimulationType)->id;
    QVERIFY(edit::setValue(f.window.document(), simulation, "last_frame", std::int64_t{5}).ok());
    QSignalSpy finished(&f.window.simulation(), &SimulationController::finished);
    f.action("simulateStart")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 20000);
    QCOMPARE(finished[0][0].toString(), QString());
    const std::vector<FrameState> states = f.window.simulation().frameStates();
    QCOMPARE(states.size(), std::size_t(6));
    for (const FrameState state : states) QVERIFY(state == FrameState::Ready);
    f.window.timeline().setCurrent(4);
    QTRY_VERIFY(f.window.simulation().shownFrame() &&
                f.window.simulation().shownFrame()->info.time.frame == 4);
  }
};

QTEST_MAIN(MainWindowTest)
#include "main_window_test.moc"
