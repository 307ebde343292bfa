// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "core/nodes/flow_nodes.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

Q_DECLARE_METATYPE(std::string)

namespace {

struct Fixture {
  explicit Fixture(bool withRelease) {
    auto scene = std::make_shared<SceneSnapshot>(*test::hillSnapshot());
    if (withRelease) {
      SceneNode node = makeNode(kAvalancheReleaseType, "slab", "Slab");
      AvalancheReleaseNode release;
      release.outline = {{100, 60}, {150, 60}, {150, 100}, {100, 100}};
      node.data = std::make_shared<AvalancheReleaseNode>(release);
      scene->nodes.push_back(std::move(node));
    }
    viewport.resize(900, 700);
    viewport.setScene(scene);
    viewport.setCamera({{128, -80, 140}, {128, 128, 15}, 45});
    viewport.show();
    QObject::connect(&viewport, &Viewport::shapeEdited, &viewport,
                     [this](const std::string& id, const ShapeGizmo::Values& values) {
                       edited = id;
                       outline = std::get<PlanPoints>(values.at(0).second);
                       ++edits;
                     });
  }
  QPoint pixel(double x, double y) const {
    const auto context = viewport.context();
    const auto p = context.view.project({x, y, groundHeight(*context.scene, x, y)});
    return p ? QPoint(static_cast<int>(std::lround(p->x)), static_cast<int>(std::lround(p->y)))
             : QPoint(-1, -1);
  }
  void move(QPoint to, Qt::MouseButton held = Qt::NoButton) {
    QMouseEvent event(QEvent::MouseMove, to, viewport.surface()->mapToGlobal(to), Qt::NoButton, held,
                      Qt::KeyboardModifiers());
    QCoreApplication::sendEvent(viewport.surface(), &event);
  }
  Viewport viewport;
  std::string edited;
  PlanPoints outline;
  int edits = 0;
};

}  // namespace

/// The tools for what flows, without a picture (platform offscreen).
class ShapeToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { qRegisterMetaType<std::string>("std::string"); }
  void init() { test::failOnWarnings(); }

  void theOutlineToolAsksForANewRelease() {
    Fixture f(false);
    f.viewport.setTool(Viewport::Tool::Outline);
    Vec2d wanted{};
    int asked = 0;
    connect(&f.viewport, &Viewport::outlineWanted, &f.viewport, [&](Vec2d corner) {
      wanted = corner;
      ++asked;
    });
    QSignalSpy clicked(&f.viewport, &Viewport::nodeClicked);
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(120, 70));
    QCOMPARE(asked, 1);
    QVERIFY(std::hypot(wanted.x - 120, wanted.y - 70) < 2.0);
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, QPoint(5, 5));
    QCOMPARE(asked, 1);
    QCOMPARE(clicked.count(), 0);
  }

  /// A click adds a corner and the drag that follows moves it: one edit.
  void clicksAddCornersToTheSelectedRelease() {
    Fixture f(true);
    f.viewport.setSelected("slab");
    f.viewport.setTool(Viewport::Tool::Outline);
    QSignalSpy started(&f.viewport, &Viewport::editStarted), finished(&f.viewport, &Viewport::editFinished);
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(80, 80));
    QCOMPARE(f.edited, std::string("slab"));
    QCOMPARE(f.outline.size(), std::size_t{5});
    f.move(f.pixel(84, 90), Qt::LeftButton);
    QTest::mouseRelease(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(84, 90));
    QCOMPARE(f.outline.size(), std::size_t{5});
    QVERIFY(std::hypot(f.outline[4].x - 84, f.outline[4].y - 90) < 2.0);
    QCOMPARE(started.count(), 1);
    QCOMPARE(finished.count(), 1);
  }

  void deleteTakesTheCornerUnderThePointerOut() {
    Fixture f(true);
    f.viewport.setSelected("slab");
    f.viewport.setTool(Viewport::Tool::Outline);
    QSignalSpy finished(&f.viewport, &Viewport::editFinished);
    f.move(f.pixel(120, 80));
    QTest::keyClick(f.viewport.surface(), Qt::Key_Delete);
    QCOMPARE(f.edits, 0);
    f.move(f.pixel(150, 60));
    QTest::keyClick(f.viewport.surface(), Qt::Key_Delete);
    QCOMPARE(f.edits, 1);
    QCOMPARE(f.outline.size(), std::size_t{3});
    QCOMPARE(finished.count(), 1);
    // In another tool the key is the window's.
    f.viewport.setTool(Viewport::Tool::Select);
    QTest::keyClick(f.viewport.surface(), Qt::Key_Delete);
    QCOMPARE(f.edits, 1);
  }

  void escapeTakesADragBack() {
    Fixture f(true);
    f.viewport.setSelected("slab");
    f.viewport.setTool(Viewport::Tool::Move);
    QSignalSpy cancelled(&f.viewport, &Viewport::editCancelled);
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(150, 100));
    f.move(f.pixel(160, 110), Qt::LeftButton);
    QCOMPARE(f.edits, 1);
    QTest::keyClick(f.viewport.surface(), Qt::Key_Escape);
    QCOMPARE(cancelled.count(), 1);
    QVERIFY(!f.viewport.shape().dragging());
  }

  /// While a release is selected the brush paints its area.
  void theBrushPaintsTheSelectedRelease() {
    Fixture f(true);
    f.viewport.setTool(Viewport::Tool::Brush);
    f.viewport.setBrushRadius(6.0);
    std::string node = "none";
    TiledRaster<std::uint8_t> layer(1, 1, 0);
    connect(&f.viewport, &Viewport::layerPainted, &f.viewport,
            [&](const PaintedKind&, const std::string& id, const PaintedLayer& painted) {
              node = id;
              layer = std::get<TiledRaster<std::uint8_t>>(painted);
            });
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(80, 80));
    QCOMPARE(node, std::string());
    f.viewport.setSelected("slab");
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(80, 80));
    QCOMPARE(node, std::string("slab"));
    QCOMPARE(layer.at(20, 20), kReleasePainted);
    QCOMPARE(layer.at(40, 40), kReleaseUnpainted);
    f.viewport.setBrushMode(BrushMode::Erase);
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(80, 80));
    QCOMPARE(layer.at(20, 20), kReleaseUnpainted);
    f.viewport.setSelected({});
    QCOMPARE(&f.viewport.brush().kind(), paintedKind(kGroundTypeLayerType));
  }

  /// The view flies to a node that is no model, not to the whole scene.
  void framingFindsTheShape() {
    Fixture f(true);
    f.viewport.setSelected("slab");
    f.viewport.frameSelection();
    QTRY_VERIFY(std::hypot(f.viewport.camera().target.x - 125, f.viewport.camera().target.y - 80) < 3.0);
    const double near = length(f.viewport.camera().position - f.viewport.camera().target);
    f.viewport.setSelected({});
    f.viewport.frameSelection();
    QTRY_VERIFY(length(f.viewport.camera().position - f.viewport.camera().target) > 2.0 * near);
  }

  void aClickOnALineSelectsItsNode() {
    Fixture f(true);
    std::string clicked;
    connect(&f.viewport, &Viewport::nodeClicked, &f.viewport, [&](const std::string& id) { clicked = id; });
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(125, 60));
    QCOMPARE(clicked, std::string("slab"));
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(125, 80));
    QCOMPARE(clicked, std::string("terrain"));
  }
};

QTEST_MAIN(ShapeToolsTest)
#include "shape_tools_test.moc"
