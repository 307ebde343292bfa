// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "editor/app/scene_tools.h"
#include "editor/document/time_context.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;

Q_DECLARE_METATYPE(std::string)

namespace {

struct Fixture {
  explicit Fixture(SnapshotPointer scene = test::hillSnapshot()) {
    viewport.resize(900, 700);
    viewport.setScene(std::move(scene));
    viewport.setCamera({{128, -80, 140}, {128, 128, 15}, 45});
    viewport.show();
    viewport.setTool(Viewport::Tool::Scatter);
    viewport.setScatterDensity(0.05);
    viewport.setScatterDistance(1.0);
    viewport.setBrushRadius(12.0);
    QObject::connect(&viewport, &Viewport::copiesScattered, &viewport,
                     [this](const std::string& id, const PlanPoints& all) {
                       node = id;
                       copies = all;
                       ++edits;
                     });
  }
  QPoint pixel(double x, double y, double z = 0.0) const {
    const TerrainSurface surface(viewport.context().scene->terrain->heights);
    const auto p = viewport.context().view.project({x, y, surface.heightAt(x, y).value_or(0.0) + z});
    return p ? QPoint(static_cast<int>(std::lround(p->x)), static_cast<int>(std::lround(p->y)))
             : QPoint(-1, -1);
  }
  void click(double x, double y, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(viewport.surface(), Qt::LeftButton, keys, pixel(x, y));
  }
  void move(QPoint to, Qt::MouseButtons held) {
    QMouseEvent event(QEvent::MouseMove, to, viewport.surface()->mapToGlobal(to), Qt::NoButton, held, {});
    QCoreApplication::sendEvent(viewport.surface(), &event);
  }
  Viewport viewport;
  std::string node;
  PlanPoints copies;
  int edits = 0;
};

}  // namespace

/// The brush for copies in the view, by synthetic events.
class ScatterToolTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { qRegisterMetaType<std::string>("std::string"); }
  void init() { test::failOnWarnings(); }

  /// Without a selection the scene's first model is copied.
  void scattersUnderThePointer() {
    Fixture f;
    f.click(60, 60);
    QCOMPARE(f.node, std::string("cube"));
    QVERIFY(f.copies.size() > 10);
    for (const Vec2d& p : f.copies) QVERIFY(std::hypot(p.x - 60, p.y - 60) < 13.0);
  }

  /// Strokes begin with what the document has; Shift takes away, and the mode that erases then adds.
  void shiftTakesAway() {
    Fixture f;
    f.viewport.copiesSource = [&](const std::string&) { return std::optional(f.copies); };
    f.click(60, 60);
    f.click(120, 60);
    const std::size_t both = f.copies.size();
    f.click(60, 60, Qt::ShiftModifier);
    QVERIFY(f.copies.size() < both && !f.copies.empty());
    for (const Vec2d& p : f.copies) QVERIFY(std::hypot(p.x - 60, p.y - 60) > 11.0);
    f.viewport.setScatterErases(true);
    f.click(120, 60);
    QVERIFY(f.copies.empty());
    f.click(60, 60, Qt::ShiftModifier);
    QVERIFY(!f.copies.empty());
  }

  /// A held key is read from the keyboard, too: the ring turns red before the pointer moves.
  void theRingFollowsHeldKeys() {
    Fixture f;
    f.move(f.pixel(60, 60), Qt::NoButton);
    const auto shot = [&] { return f.viewport.surface()->grab().toImage(); };
    const QImage plain = shot();
    QTest::keyPress(f.viewport.surface(), Qt::Key_Shift);
    const QImage held = shot();
    QTest::keyRelease(f.viewport.surface(), Qt::Key_Shift);
    QVERIFY(held != plain);
    QVERIFY(shot() == plain);
  }

  void aStrokeIsOneEditAndEscapeTakesItBack() {
    Fixture f;
    QSignalSpy started(&f.viewport, &Viewport::editStarted), finished(&f.viewport, &Viewport::editFinished),
        cancelled(&f.viewport, &Viewport::editCancelled);
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(60, 60));
    f.move(f.pixel(100, 60), Qt::LeftButton);
    QVERIFY(f.edits > 1);
    QTest::mouseRelease(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(100, 60));
    QCOMPARE(started.count(), 1);
    QCOMPARE(finished.count(), 1);
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(60, 120));
    QTest::keyClick(f.viewport.surface(), Qt::Key_Escape);
    QCOMPARE(cancelled.count(), 1);
    QVERIFY(!f.viewport.scatter().scattering());
  }

  void controlChoosesTheModel() {
    auto scene = std::make_shared<SceneSnapshot>(*test::hillSnapshot());
    SceneNode second = makeNode(kModelType, "second", "Second");
    ModelNode placed;
    placed.position = {60, 60, 0};
    second.data = std::make_shared<ModelNode>(placed);
    scene->nodes.push_back(second);
    scene->models["second"] = test::cube();
    Fixture f(scene);
    std::string clicked;
    connect(&f.viewport, &Viewport::nodeClicked, &f.viewport, [&](const std::string& id) { clicked = id; });
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, Qt::ControlModifier, f.pixel(60, 60, 4.0));
    QCOMPARE(clicked, std::string("second"));
    QCOMPARE(f.edits, 0);
    f.viewport.setSelected("second");
    f.click(90, 90);
    QCOMPARE(f.node, std::string("second"));
    // What is selected later and is no model leaves the choice.
    f.viewport.setSelected("terrain");
    QCOMPARE(f.viewport.scatter().node(), std::string("second"));
  }

  void withoutAModelNothingHappens() {
    auto scene = std::make_shared<SceneSnapshot>(*test::hillSnapshot());
    scene->nodes.pop_back();
    scene->models.clear();
    Fixture f(scene);
    QVERIFY(f.viewport.scatter().node().empty());
    f.click(60, 60);
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, Qt::ControlModifier, f.pixel(60, 60));
    QCOMPARE(f.edits, 0);
  }

  /// F, the brackets' radius and the wheel are those of the other brushes.
  void theRadiusIsTheBrushes() {
    Fixture f;
    QKeyEvent press(QEvent::KeyPress, Qt::Key_F, {});
    f.move(f.pixel(60, 60), Qt::NoButton);
    QCoreApplication::sendEvent(f.viewport.surface(), &press);
    f.move(f.pixel(60, 60) + QPoint(100, 0), Qt::NoButton);
    QVERIFY(std::abs(f.viewport.brush().tip().radius - 24.0) < 1e-9);
    QTest::mouseClick(f.viewport.surface(), Qt::RightButton, {}, f.pixel(60, 60));
    QCOMPARE(f.viewport.brush().tip().radius, 12.0);
  }

  /// In the document: one undo step a stroke.
  void aStrokeIsOneUndoStep() {
    auto reader = std::make_shared<FakeAssetReader>();
    SceneDocument document(reader);
    TimeContext time(&document);
    Fixture f;
    SceneTools tools(&document, &time, &f.viewport);
    QVERIFY(edit::addNode(document, kModelType, QStringLiteral("Cube"), "cube").ok());
    const int before = document.undoStack()->index();
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(60, 60));
    f.move(f.pixel(100, 60), Qt::LeftButton);
    f.move(f.pixel(100, 100), Qt::LeftButton);
    QTest::mouseRelease(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(100, 100));
    const auto copies = [&]() -> std::size_t {
      const SceneNode* node = document.node("cube");
      const auto* model = node ? node->as<ModelNode>() : nullptr;
      return model ? model->copies.size() : 0;
    };
    QCOMPARE(document.undoStack()->index(), before + 1);
    const std::size_t first = copies();
    QVERIFY(first > 20);
    f.click(60, 60, Qt::ShiftModifier);
    QVERIFY(copies() < first);
    QCOMPARE(document.undoStack()->index(), before + 2);
    document.undoStack()->undo();
    QCOMPARE(copies(), first);
    document.undoStack()->undo();
    QCOMPARE(copies(), std::size_t{0});
  }
};

QTEST_MAIN(ScatterToolTest)
#include "scatter_tool_test.moc"
