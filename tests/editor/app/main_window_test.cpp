// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/main_window.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <utility>

#include "editor/app/file_flow.h"
#include "editor/app/main_actions.h"
#include "editor/app/scene_tools.h"
#include "editor/document/autosave.h"
#include "editor/panels/outliner_panel.h"
#include "editor/timeline/timeline_panel.h"
#include "editor/viewport/picture_view.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"
#include "tests/support/node_data.h"

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
 private:
  QTemporaryDir m_folder;
  QString saveEmptyScene() const {
    const QString file = m_folder.filePath(QStringLiteral("argument.spindrift"));
    SceneDocument document(std::make_shared<test::FakeReader>());
    document.saveAs(file);
    return document.finishSaving().ok() ? file : QString();
  }
  /// As after a crash.
  static void leaveUnsavedWork() {
    SceneDocument document(std::make_shared<test::FakeReader>());
    Autosave autosave(&document, {}, 0);
    QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 17.0).ok());
    QVERIFY(autosave.flush().ok());
  }

 private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() {
    test::failOnWarnings();
    // What earlier runs left must not be offered.
    QDir(Autosave::defaultStateDirectory()).removeRecursively();
  }

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

  /// What another program saved meanwhile is not overwritten without a question.
  void asksBeforeOverwritingOthersChanges() {
    Fixture f;
    f.path = f.folder.filePath(QStringLiteral("shared.spindrift"));
    FileFlow::Overwrite overwrite = FileFlow::Overwrite::Cancel;
    int conflicts = 0;
    f.window.files().askOverwrite = [&] {
      ++conflicts;
      return overwrite;
    };
    SceneDocument& document = f.window.document();
    const auto change = [&](double wind) {
      return edit::setValue(document, "weather", "wind_speed_m_s", wind).ok();
    };
    QVERIFY(change(3.0));
    QVERIFY(f.window.files().saveNow());
    QVERIFY(change(4.0));
    QVERIFY(f.window.files().saveNow());
    QCOMPARE(conflicts, 0);
    SceneDocument other(std::make_shared<test::FakeReader>());
    QVERIFY(other.open(f.path).ok());
    QVERIFY(edit::setValue(other, "weather", "wind_speed_m_s", 9.0).ok());
    other.save();
    QVERIFY(other.finishSaving().ok());
    QVERIFY(change(5.0));
    QVERIFY(!f.window.files().saveNow());
    QCOMPARE(conflicts, 1);
    QVERIFY(document.isModified());
    QVERIFY(!other.isChangedOnDisk());
    overwrite = FileFlow::Overwrite::SaveAs;
    const QString shared = std::exchange(f.path, f.folder.filePath(QStringLiteral("mine.spindrift")));
    QVERIFY(f.window.files().saveNow());
    QCOMPARE(document.path(), f.path);
    QVERIFY(!other.isChangedOnDisk());
    QVERIFY(f.window.files().openPath(shared));
    QVERIFY(edit::setValue(other, "weather", "wind_speed_m_s", 10.0).ok());
    other.save();
    QVERIFY(other.finishSaving().ok());
    QVERIFY(change(6.0));
    overwrite = FileFlow::Overwrite::Overwrite;
    QVERIFY(f.window.files().saveNow());
    QCOMPARE(conflicts, 3);
    QVERIFY(other.isChangedOnDisk());
  }

  /// After a recovery the files of the command line stay closed: opening them would offer to discard it.
  void recoveredWorkIsKeptFromTheArguments() {
    const QString file = saveEmptyScene();
    leaveUnsavedWork();
    Fixture f;
    int offers = 0;
    f.window.askRecovery = [&](const Recovery&) {
      ++offers;
      return MainWindow::RecoveryAnswer::Recover;
    };
    f.window.start({file});
    QCOMPARE(offers, 1);
    QCOMPARE(f.asked, 0);
    QVERIFY(f.window.document().path().isEmpty());
    QVERIFY(f.window.document().isModified());
    QCOMPARE(test::dataOf<WeatherNode>(f.window.document().node("weather")).windSpeed, 17.0);
    f.window.files().newScene();
  }

  void declinedRecoveriesOpenTheArguments() {
    const QString file = saveEmptyScene();
    leaveUnsavedWork();
    Fixture f;
    MainWindow::RecoveryAnswer answer = MainWindow::RecoveryAnswer::Later;
    int offers = 0;
    f.window.askRecovery = [&](const Recovery&) {
      ++offers;
      return answer;
    };
    f.window.start({file});
    QCOMPARE(f.window.document().path(), file);
    answer = MainWindow::RecoveryAnswer::Discard;
    f.window.start({file});
    f.window.start({file});
    QCOMPARE(offers, 2);
    QCOMPARE(f.errors, QStringList());
  }

  /// After Return in a field the keys of the window work again.
  void returnGivesTheKeysBackToTheView() {
    Fixture f;
    f.window.show();
    f.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&f.window));
    f.window.document().select("weather");
    auto* row = f.window.findChild<QWidget*>(QStringLiteral("wind_speed_m_s"));
    QVERIFY(row);
    auto* field = row->findChild<QWidget*>(QStringLiteral("number"));
    QVERIFY(field);
    const auto wind = [&] {
      return test::dataOf<WeatherNode>(f.window.document().node("weather")).windSpeed;
    };
    field->setFocus();
    QVERIFY(field->hasFocus());
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, QStringLiteral("7"));
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(wind(), 7.0);
    QTRY_VERIFY(f.window.viewport().surface()->hasFocus());
    QTest::keyClick(f.window.viewport().surface(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(wind(), 2.0);
    QTest::keyClick(f.window.viewport().surface(), Qt::Key_C);
    QVERIFY(f.window.viewport().lookThrough());
    // Without typing of its own a field leaves undo and redo to the scene.
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(wind(), 7.0);
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(wind(), 2.0);
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
      Q_EMIT view.layerPainted(*paintedKind(kGroundTypeLayerType), {}, layer);
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
    const auto x = [&] { return test::dataOf<ModelNode>(f.window.document().node(id)).position.x; };
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
    const auto* camera = &test::dataOf<CameraNode>(f.window.document().scene().firstOf(kCameraType));
    QVERIFY(length(camera->position - Vec3d{10, -70, 33}) < 1e-9);
    QVERIFY(length(camera->target - Vec3d{1, 2, 3}) < 1e-9);
    QCOMPARE(camera->fovDegrees, 40.0);
  }

  /// The list of nodes adds as the menu does: placed where the view looks, not at the origin; painted layers
  /// have what is done to them in their menu.
  void theOutlinerPlacesAndOffersLayerWork() {
    Fixture f;
    auto* outliner = f.window.findChild<OutlinerPanel*>(QStringLiteral("outliner"));
    QVERIFY(outliner);
    f.window.viewport().setCamera({{11, 12, 13}, {14, 15, 3}, 50});
    const std::string camera = f.window.document().scene().firstOf(kCameraType)->id;
    QVERIFY(edit::removeNode(f.window.document(), camera).ok());
    QMenu add;
    outliner->fillAddMenu(&add);
    add.findChild<QAction*>(QStringLiteral("add_camera"))->trigger();
    const auto* placed = &test::dataOf<CameraNode>(f.window.document().scene().firstOf(kCameraType));
    QVERIFY(length(placed->position - Vec3d{11, 12, 13}) < 0.02);
    add.findChild<QAction*>(QStringLiteral("add_keep_clear"))->trigger();
    QMenu layer, other;
    outliner->fillNodeMenu(&layer, f.window.document().selected());
    QVERIFY(layer.findChild<QAction*>(QStringLiteral("layerFill")));
    outliner->fillNodeMenu(&other, "weather");
    QVERIFY(!other.findChild<QAction*>(QStringLiteral("layerFill")));
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
