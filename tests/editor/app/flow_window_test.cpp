// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "core/nodes/camera_node.h"
#include "core/nodes/cover_nodes.h"
#include "core/nodes/flow_nodes.h"
#include "editor/app/file_flow.h"
#include "editor/app/flow_defaults.h"
#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "editor/app/scene_tools.h"
#include "editor/app/status_panel.h"
#include "editor/document/autosave.h"
#include "editor/panels/stage_panel.h"
#include "editor/timeline/timeline_panel.h"
#include "editor/viewport/viewport.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"
#include "tests/support/node_data.h"

using namespace spin;

namespace {

struct Fixture {
  Fixture() : window(std::make_shared<test::FakeReader>()) { window.simulation().setAutomatic(false); }
  QAction* action(const char* name) { return window.actions().findChild<QAction*>(QLatin1String(name)); }
  SceneDocument& document() { return window.document(); }
  /// Adds an asset of the fake reader.
  std::string addAsset(const NodeType& type, const char* name) {
    QFile file(folder.filePath(QLatin1String(name)));
    if (file.open(QIODevice::WriteOnly)) file.write("stands for a file");
    file.close();
    const auto added = edit::addAssetNode(document(), type, file.fileName());
    return added.ok() ? *added : std::string();
  }
  const SimulationNode& film() {
    return test::dataOf<SimulationNode>(document().scene().firstOf(kSimulationType));
  }
  QTemporaryDir folder;
  MainWindow window;
};

std::shared_ptr<Frame> frameWithStages() {
  auto frame = std::make_shared<Frame>();
  frame->info.time.frame = 7;
  frame->info.backend = "cpu-test";
  frame->info.timings.add("density", 0.03);
  frame->info.timings.add("force", 0.01);
  frame->info.figures["flow_steps"] = 12;
  frame->info.figures["flow_particles"] = 4321;
  return frame;
}

}  // namespace

/// What the window offers for flow: nodes, tools, holding and resetting, tables.
class FlowWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() {
    test::failOnWarnings();
    QDir(Autosave::defaultStateDirectory()).removeRecursively();
  }

  /// New nodes stand where the view looks, as large as suits it, turned downhill.
  void newNodesStandInSight() {
    ViewSight sight;
    sight.terrain = test::hill();
    sight.place = Vec3d{128, 60, 20};  // south of the top: down is -y
    sight.distance = 200.0;
    const auto release = placedDefaults(kAvalancheReleaseType, sight, {});
    QCOMPARE(release.size(), std::size_t{1});
    const auto outline = std::get<PlanPoints>(release[0].second);
    QCOMPARE(outline.size(), std::size_t{4});
    Vec2d middle{};
    for (const Vec2d& corner : outline) middle = middle + corner * 0.25;
    QVERIFY(std::hypot(middle.x - 128, middle.y - 60) < 0.01);
    const auto source = placedDefaults(kWaterSourceType, sight, {});
    const auto velocity = std::get<Vec3d>(source[2].second);
    QVERIFY(velocity.y < -1.9 && std::abs(velocity.x) < 0.2);
    const auto sink = placedDefaults(kFlowSinkType, sight, {});
    QVERIFY(std::get<Vec3d>(sink[0].second) == Vec3d(128, 60, 20));
    const auto heat = placedDefaults(kHeatSourceType, sight, {});
    QCOMPARE(heat.at(0).first, std::string("position_m"));
    QVERIFY(std::abs(std::get<Vec3d>(heat[0].second).x - sight.place->x) < 0.01);
    QVERIFY(std::get<double>(heat.at(1).second) >= 1.0);
    const auto camera = placedDefaults(kCameraType, sight, {});
    QCOMPARE(std::get<Vec3d>(camera.at(0).second), sight.eye);
    QVERIFY(placedDefaults(kWeatherType, sight, {}).empty());
    sight.place.reset();
    QVERIFY(placedDefaults(kAvalancheReleaseType, sight, {}).empty());
  }

  void everyFlowNodeCanBeAddedAndUndone() {
    Fixture f;
    for (const NodeType* type : {&kAvalancheReleaseType, &kWaterSourceType, &kFlowSinkType, &kRigidBodyType,
                                 &kFlowMaterialType, &kFlowSettingsType}) {
      const int before = f.document().undoStack()->index();
      const auto added = f.window.tools().addNode(*type, QStringLiteral("New"));
      QVERIFY(added.ok());
      QVERIFY(f.document().node(*added));
      QCOMPARE(f.document().selected(), *added);
      const bool flows = type == &kAvalancheReleaseType || type == &kWaterSourceType;
      QCOMPARE(f.document().scene().firstOf(kFlowSettingsType) != nullptr,
               flows || type == &kFlowSettingsType);
      QCOMPARE(f.document().undoStack()->index(), before + 1);
      f.action("editUndo")->trigger();
      QVERIFY(!f.document().node(*added));
    }
  }

  /// The first click makes the release with its first corner: one undo step; later clicks one each.
  void outlinesAreDrawnInUndoSteps() {
    Fixture f;
    Viewport& view = f.window.viewport();
    const int before = f.document().undoStack()->index();
    Q_EMIT view.outlineWanted({10, 20});
    QCOMPARE(f.document().undoStack()->index(), before + 1);
    const std::string id = f.document().selected();
    const auto outline = [&] { return test::dataOf<AvalancheReleaseNode>(f.document().node(id)).outline; };
    QCOMPARE(outline().size(), std::size_t{1});
    Q_EMIT view.editStarted();
    for (const double x : {30.0, 31.0, 32.0})
      Q_EMIT view.shapeEdited(id, {{"outline_m", PlanPoints{{10, 20}, {x, 20}}}});
    Q_EMIT view.editFinished();
    QCOMPARE(f.document().undoStack()->index(), before + 2);
    QCOMPARE(outline()[1].x, 32.0);
    f.action("editUndo")->trigger();
    QCOMPARE(outline().size(), std::size_t{1});
    f.action("editUndo")->trigger();
    QVERIFY(!f.document().node(id));
  }

  void aReleaseIsPaintedInOneUndoStep() {
    Fixture f;
    const auto added = f.window.tools().addNode(kAvalancheReleaseType, QStringLiteral("Slab"));
    QVERIFY(added.ok());
    const int before = f.document().undoStack()->index();
    TiledRaster<std::uint8_t> layer(65, 65, kReleaseUnpainted);
    Viewport& view = f.window.viewport();
    Q_EMIT view.editStarted();
    for (int i = 5; i < 9; ++i) {
      layer.set(i, 4, kReleasePainted);
      Q_EMIT view.layerPainted(*paintedKind(kAvalancheReleaseType), *added, layer);
    }
    Q_EMIT view.editFinished();
    QCOMPARE(f.document().undoStack()->index(), before + 1);
    const auto painted = [&] {
      const SceneNode* node = f.document().node(*added);
      return node && std::holds_alternative<TiledRaster<std::uint8_t>>(node->painted) &&
             std::get<TiledRaster<std::uint8_t>>(node->painted) == layer;
    };
    QVERIFY(painted());
    f.action("editUndo")->trigger();
    QVERIFY(!painted());
  }

  /// The brush's list follows the selection.
  void theBrushOffersWhatItPaints() {
    Fixture f;
    f.window.show();
    f.action("toolBrush")->trigger();
    auto* layer = f.window.findChild<QComboBox*>(QStringLiteral("brushLayer"));
    auto* value = f.window.findChild<QWidget*>(QStringLiteral("brushValue"));
    QTRY_VERIFY(value->isVisible());
    QCOMPARE(layer->currentIndex(), 0);
    f.addAsset(kTerrainType, "hill.asc");
    QVERIFY(f.window.tools().addNode(kAvalancheReleaseType, QStringLiteral("Slab")).ok());
    QTRY_VERIFY(!value->isVisible());
    QVERIFY(layer->isVisible());
    QCOMPARE(layer->currentIndex(), -1);
    f.action("brushErase")->trigger();
    QCOMPARE(f.window.viewport().brush().mode(), BrushMode::Erase);
  }

  void aModelIsMadeSolidOnce() {
    Fixture f;
    const std::string model = f.addAsset(kModelType, "rock.glb");
    f.document().select(model);
    auto* button = f.window.findChild<QPushButton*>(QStringLiteral("makeRigidBody"));
    QVERIFY(button);
    button->click();
    const std::string body = f.document().selected();
    QCOMPARE(test::dataOf<RigidBodyNode>(f.document().node(body)).model, model);
    const std::size_t nodes = f.document().scene().nodes().size();
    f.document().select(model);
    f.window.findChild<QPushButton*>(QStringLiteral("makeRigidBody"))->click();
    QCOMPARE(f.document().selected(), body);
    QCOMPARE(f.document().scene().nodes().size(), nodes);
  }

  /// The menu changes the scene's picture settings, and shows what they are.
  void theMenuSetsWhatFlowShows() {
    Fixture f;
    QVERIFY(f.action("flow_material")->isChecked());
    f.action("flow_speed")->trigger();
    const auto settings = [&]() -> const RenderNode& {
      return test::dataOf<RenderNode>(f.document().scene().firstOf(kRenderType));
    };
    QVERIFY(settings().flowDisplay == FlowDisplay::Speed);
    f.action("flowBoundary")->trigger();
    QVERIFY(settings().showFlowBoundary);
    f.action("editUndo")->trigger();
    QVERIFY(!f.action("flowBoundary")->isChecked());
    f.action("editUndo")->trigger();
    QVERIFY(f.action("flow_material")->isChecked());
  }

  /// So does the menu of the air.
  void theMenuSetsWhatAirShows() {
    Fixture f;
    QVERIFY(f.action("air_natural")->isChecked() && f.action("air_off")->isChecked());
    f.action("air_temperature")->trigger();
    f.action("air_across_y")->trigger();
    const auto settings = [&]() -> const RenderNode& {
      return test::dataOf<RenderNode>(f.document().scene().firstOf(kRenderType));
    };
    QVERIFY(settings().airDisplay == AirDisplay::Temperature);
    QVERIFY(settings().airSlice == AirSlice::AcrossY);
    f.action("editUndo")->trigger();
    QVERIFY(f.action("air_off")->isChecked() && f.action("air_temperature")->isChecked());
  }

  /// So does the menu of the snow.
  void theMenuSetsWhatSnowShows() {
    Fixture f;
    QVERIFY(f.action("snow_natural")->isChecked());
    f.action("snow_depth")->trigger();
    const auto settings = [&]() -> const RenderNode& {
      return test::dataOf<RenderNode>(f.document().scene().firstOf(kRenderType));
    };
    QVERIFY(settings().snowDisplay == SnowDisplay::Depth);
    f.action("snowPublished")->trigger();
    QVERIFY(settings().snowShading == SnowShading::BlinnPhong);
    f.action("editUndo")->trigger();
    QVERIFY(!f.action("snowPublished")->isChecked());
    QVERIFY(f.action("snow_depth")->isChecked());
    f.action("editUndo")->trigger();
    QVERIFY(f.action("snow_natural")->isChecked());
  }

  /// A process is held from the frame after the shown one on; what comes before stays.
  void aProcessIsHeldFromHere() {
    Fixture f;
    f.window.timeline().setCurrent(24);
    QAction* hold = f.action("simulatePauseFlow");
    QVERIFY(!hold->isChecked());
    hold->trigger();
    const auto heldAt = [&](int frame) {
      const SceneNode* node = f.document().scene().firstOf(kSimulationType);
      SPIN_CHECK(node, "the settings are there");
      return std::get<bool>(valueAt(*node, *node->type->find("pause_flow"), frame / f.film().frameRate));
    };
    QVERIFY(!heldAt(0) && !heldAt(24));
    QVERIFY(heldAt(25) && heldAt(100));
    f.window.timeline().setCurrent(10);
    QVERIFY(!hold->isChecked());
    f.window.timeline().setCurrent(60);
    QVERIFY(hold->isChecked());
    hold->trigger();
    QVERIFY(heldAt(60) && !heldAt(61));
    f.action("editUndo")->trigger();
    f.action("editUndo")->trigger();
    const SceneNode* film = f.document().scene().firstOf(kSimulationType);
    QVERIFY(film && film->curves.empty());
  }

  /// Single steps simulate one frame further and hold the run; Reset throws all away, after the question.
  void stepsAndResets() {
    Fixture f;
    SimulationController& simulation = f.window.simulation();
    QVERIFY(!f.addAsset(kTerrainType, "land.tif").empty());
    QTRY_VERIFY_WITH_TIMEOUT(simulation.snapshot() && simulation.snapshot()->terrain, 20000);
    const auto ready = [&] {
      const auto states = simulation.frameStates();
      return static_cast<int>(std::count(states.begin(), states.end(), FrameState::Ready));
    };
    f.action("simulateStep")->trigger();
    QVERIFY(simulation.paused());
    QVERIFY(f.action("simulatePause")->isChecked());
    QCOMPARE(f.window.time().frame(), 1);
    QTRY_COMPARE_WITH_TIMEOUT(ready(), 2, 60000);
    f.action("simulateStep")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(ready(), 3, 60000);
    QCOMPARE(f.window.time().frame(), 2);
    f.window.actions().mayReset = [] { return false; };
    f.action("simulateReset")->trigger();
    QCOMPARE(ready(), 3);
    f.window.actions().mayReset = [] { return true; };
    f.action("simulateReset")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(f.window.time().frame(), 0, 60000);
    QTRY_COMPARE_WITH_TIMEOUT(ready(), 0, 60000);
    simulation.stop();
  }

  /// What is wrong with flow is told with its node before a run, once, and goes when it is mended.
  void problemsOfFlowAreListed() {
    Fixture f;
    SimulationController& simulation = f.window.simulation();
    QVERIFY(!f.addAsset(kTerrainType, "land.tif").empty());
    const auto release = edit::addNode(f.document(), kAvalancheReleaseType, QStringLiteral("Slab"));
    QVERIFY(release.ok());
    const auto set = [&](const char* property, const Value& value) {
      QVERIFY(edit::setValue(f.document(), *release, property, value).ok());
    };
    const auto told = [&](Severity severity) {
      int count = 0;
      for (const DocumentIssue& issue : f.document().issues())
        count += issue.node == *release && issue.severity == severity ? 1 : 0;
      return count;
    };
    set("depth_m", 0.5);
    set("outline_m", PlanPoints{{100, 100}, {140, 100}, {140, 140}, {100, 140}});
    QTRY_COMPARE_WITH_TIMEOUT(told(Severity::Warning), 1, 20000);
    set("depth_m", 4.0);
    QTRY_COMPARE_WITH_TIMEOUT(told(Severity::Warning), 0, 20000);
    QCOMPARE(told(Severity::Error), 0);
    set("outline_m", PlanPoints{{9100, 100}, {9140, 100}, {9140, 140}});
    QTRY_COMPARE_WITH_TIMEOUT(told(Severity::Error), 1, 20000);
    QSignalSpy finished(&simulation, &SimulationController::finished);
    simulation.start();
    QTRY_VERIFY_WITH_TIMEOUT(finished.count() > 0, 20000);
    QCOMPARE(simulation.state(), SimulationController::State::Failed);
    QTest::qWait(100);
    QCOMPARE(told(Severity::Error), 1);
    set("outline_m", PlanPoints{{100, 100}, {140, 100}, {140, 140}, {100, 140}});
    simulation.start();
    QTRY_COMPARE_WITH_TIMEOUT(told(Severity::Error), 0, 20000);
    simulation.stop();
  }

  /// Another scene begins at its beginning, not where the last one was left.
  void anotherSceneBeginsAtItsFirstFrame() {
    Fixture f;
    f.window.files().askUnsaved = [] { return FileFlow::Unsaved::Discard; };
    f.window.time().setFrame(40);
    f.window.timeline().setPlaying(true);
    QVERIFY(f.window.files().newScene());
    QCOMPARE(f.window.time().frame(), 0);
    QVERIFY(!f.window.timeline().playing());
  }

  void theNeedIsToldBeforeTheRun() {
    RunEstimate need;
    QVERIFY(estimateText(need).isEmpty());
    need.framesToCompute = 12;
    need.memoryBytes = 3e9;
    QVERIFY(estimateText(need).contains(QStringLiteral("12")));
    QVERIFY(!estimateText(need).contains(QStringLiteral("disk")));
    need.diskBytes = 5e6;
    QVERIFY(estimateText(need).contains(QStringLiteral("disk")));
    QVERIFY(!estimateText(need).contains(QStringLiteral("particles")));
    need.particles = 34000;
    need.seconds = 200;
    QVERIFY(estimateText(need).contains(QStringLiteral("particles")));
    QVERIFY(estimateText(need).contains(QStringLiteral("about")));
    need.seconds = 5e5;
    QVERIFY2(estimateText(need).contains(QStringLiteral("5 days")), qPrintable(estimateText(need)));
    need.seconds = 1e9;
    QVERIFY2(estimateText(need).contains(QStringLiteral("31 years")), qPrintable(estimateText(need)));
    Fixture f;
    QSignalSpy told(&f.window.simulation(), &SimulationController::estimated);
    QVERIFY(!f.addAsset(kTerrainType, "land.tif").empty());
    QTRY_VERIFY_WITH_TIMEOUT(told.count() > 0, 20000);
  }

  /// The table of stages: time and share, figures, copied as text.
  void stagesAreListedAndCopied() {
    StagePanel panel;
    auto* stages = panel.findChild<QTableWidget*>(QStringLiteral("stages"));
    QCOMPARE(stages->rowCount(), 0);
    QVERIFY(!panel.findChild<QToolButton*>(QStringLiteral("copyStages"))->isEnabled());
    panel.setFrame(frameWithStages());
    QCOMPARE(stages->rowCount(), 3);
    QCOMPARE(stages->item(0, 0)->text(), QStringLiteral("density"));
    QCOMPARE(stages->item(0, 1)->text(), QStringLiteral("30.00 ms"));
    QCOMPARE(stages->item(0, 2)->text(), QStringLiteral("75.0 %"));
    QCOMPARE(stages->item(2, 1)->text(), QStringLiteral("40.00 ms"));
    panel.findChild<QToolButton*>(QStringLiteral("copyStages"))->click();
    const QString text = QGuiApplication::clipboard()->text();
    QVERIFY(text.contains(QStringLiteral("density\t30.00 ms\t75.0 %\t1")));
    QVERIFY(text.contains(QStringLiteral("flow_steps\t12")));
    panel.setFrame(nullptr);
    QCOMPARE(stages->rowCount(), 0);
  }
};

QTEST_MAIN(FlowWindowTest)
#include "flow_window_test.moc"
