// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QSet>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/scene_picker.h"
#include "editor/viewport/viewport.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

Q_DECLARE_METATYPE(std::string)

namespace {

struct Fixture {
  Fixture() {
    viewport.resize(900, 700);
    viewport.setScene(test::hillSnapshot());
    viewport.setCamera({{128, -80, 140}, {128, 128, 15}, 45});
    viewport.show();
  }
  QPoint pixel(Vec3d point) const {
    const auto p = viewport.context().view.project(point);
    return p ? QPoint(static_cast<int>(std::lround(p->x)), static_cast<int>(std::lround(p->y)))
             : QPoint(-1, -1);
  }
  void move(QPoint to, Qt::MouseButton held, Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(QEvent::MouseMove, to, viewport.surface()->mapToGlobal(to), Qt::NoButton, held, keys);
    QCoreApplication::sendEvent(viewport.surface(), &event);
  }
  Viewport viewport;
};

}  // namespace

/// The pointer's work in the view, without a picture (platform offscreen).
class ViewportToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { qRegisterMetaType<std::string>("std::string"); }
  void init() { test::failOnWarnings(); }

  void pickingFindsTheNearest() {
    const SnapshotPointer scene = test::hillSnapshot();
    const double top = *TerrainSurface(scene->terrain->heights).heightAt(128, 128);
    const auto model = pickScene(*scene, 0.0, {{128, 128, 300}, {0, 0, -1}});
    QVERIFY(model);
    QCOMPARE(model->node, std::string("cube"));
    QVERIFY(std::abs(model->point.z - (top + 8.0)) < 1e-3);
    const auto ground = pickScene(*scene, 0.0, {{30, 30, 300}, {0, 0, -1}});
    QVERIFY(ground);
    QCOMPARE(ground->node, std::string("terrain"));
    QVERIFY(!pickScene(*scene, 0.0, {{128, 128, 300}, {0, 0, 1}}));
  }

  void clickSelects() {
    Fixture f;
    QSignalSpy spy(&f.viewport, &Viewport::nodeClicked);
    const double top = *TerrainSurface(f.viewport.context().scene->terrain->heights).heightAt(128, 128);
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, f.pixel({128, 124, top + 4}));
    QCOMPARE(spy.count(), 1);
    QCOMPARE(spy[0][0].value<std::string>(), std::string("cube"));
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, {5, 5});
    QCOMPARE(spy[1][0].value<std::string>(), std::string());
  }

  /// The middle button turns, with Shift it shifts; neither selects.
  void navigates() {
    Fixture f;
    QSignalSpy clicked(&f.viewport, &Viewport::nodeClicked);
    const RenderCamera before = f.viewport.camera();
    QTest::mousePress(f.viewport.surface(), Qt::MiddleButton, {}, {400, 300});
    f.move({460, 320}, Qt::MiddleButton);
    QTest::mouseRelease(f.viewport.surface(), Qt::MiddleButton, {}, {460, 320});
    const RenderCamera turned = f.viewport.camera();
    QVERIFY(length(turned.position - before.position) > 1.0);
    QVERIFY(length(turned.target - before.target) < 1e-9);
    QTest::mousePress(f.viewport.surface(), Qt::MiddleButton, Qt::ShiftModifier, {400, 300});
    f.move({460, 320}, Qt::MiddleButton, Qt::ShiftModifier);
    QTest::mouseRelease(f.viewport.surface(), Qt::MiddleButton, Qt::ShiftModifier, {460, 320});
    QVERIFY(length(f.viewport.camera().target - turned.target) > 1.0);
    QCOMPARE(clicked.count(), 0);
  }

  /// The wheel zooms to what is under the pointer: it stays there.
  void wheelZoomsToThePointer() {
    Fixture f;
    const QPointF at(600, 500);
    const auto hit = pickScene(*f.viewport.context().scene, 0.0, f.viewport.context().view.ray({600, 500}));
    QVERIFY(hit);
    QWheelEvent wheel(at, f.viewport.surface()->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(f.viewport.surface(), &wheel);
    const auto after = f.viewport.context().view.project(hit->point);
    QVERIFY(after);
    QVERIFY(std::hypot(after->x - 600, after->y - 500) < 1e-6);
  }

  /// Dragging the arm of a model that stands on the ground moves it level; its height above ground stays.
  void gizmoMovesAModelAlongTheGround() {
    Fixture f;
    f.viewport.setSelected("cube");
    f.viewport.setTool(Viewport::Tool::Move);
    const auto pose = f.viewport.gizmo().pose(f.viewport.context());
    QVERIFY(pose);
    GizmoPlacement last;
    std::string id;
    int edits = 0;
    connect(&f.viewport, &Viewport::placementEdited, &f.viewport,
            [&](const std::string& node, const GizmoPlacement& p) {
              last = p;
              id = node;
              ++edits;
            });
    QSignalSpy started(&f.viewport, &Viewport::editStarted);
    QSignalSpy finished(&f.viewport, &Viewport::editFinished);
    const Vec3d grab = pose->pivot + Vec3d{pose->size * 0.8, 0, 0};
    const Vec3d drop = grab + Vec3d{20, 0, 0};
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(grab));
    f.move(f.pixel(drop), Qt::LeftButton);
    QTest::mouseRelease(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(drop));
    QCOMPARE(edits, 1);
    QCOMPARE(id, std::string("cube"));
    QCOMPARE(started.count(), 1);
    QCOMPARE(finished.count(), 1);
    QVERIFY(std::abs(last.position.x - 148.0) < 1.0);
    QCOMPARE(last.position.y, 128.0);
    QCOMPARE(last.position.z, 0.0);
  }

  /// The middle handle carries the model to the ground under the pointer.
  void gizmoCarriesAModelOverTheTerrain() {
    Fixture f;
    f.viewport.setSelected("cube");
    f.viewport.setTool(Viewport::Tool::Move);
    const ViewportContext seen = f.viewport.context();
    const auto pose = f.viewport.gizmo().pose(seen);
    QVERIFY(pose);
    GizmoPlacement last;
    connect(&f.viewport, &Viewport::placementEdited, &f.viewport,
            [&](const std::string&, const GizmoPlacement& p) { last = p; });
    const TerrainSurface surface(seen.scene->terrain->heights);
    const Vec3d goal{80, 60, *surface.heightAt(80, 60)};
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(pose->pivot));
    f.move(f.pixel(goal), Qt::LeftButton);
    QVERIFY2(std::hypot(last.position.x - 80, last.position.y - 60) < 2.0,
             qPrintable(QStringLiteral("%1 %2").arg(last.position.x).arg(last.position.y)));
    QCOMPARE(last.position.z, 0.0);
    QTest::mouseRelease(f.viewport.surface(), Qt::LeftButton, {}, f.pixel(goal));
  }

  /// Escape takes a drag back.
  void escapeCancels() {
    Fixture f;
    f.viewport.setTool(Viewport::Tool::Brush);
    QSignalSpy cancelled(&f.viewport, &Viewport::editCancelled);
    QSignalSpy finished(&f.viewport, &Viewport::editFinished);
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, f.pixel({60, 60, 2}));
    QTest::keyClick(f.viewport.surface(), Qt::Key_Escape);
    QCOMPARE(cancelled.count(), 1);
    QTest::mouseRelease(f.viewport.surface(), Qt::LeftButton, {}, f.pixel({60, 60, 2}));
    QCOMPARE(finished.count(), 0);
  }

  /// A stroke paints the type under the pointer, between the moves too, and tells begin and end once.
  void brushPaints() {
    Fixture f;
    f.viewport.setTool(Viewport::Tool::Brush);
    f.viewport.setBrushRadius(6.0);
    f.viewport.setBrushValue(static_cast<double>(GroundType::Ice));
    TiledRaster<std::uint8_t> layer;
    connect(&f.viewport, &Viewport::layerPainted, &f.viewport,
            [&](const PaintedKind&, const std::string&, const PaintedLayer& l) {
              layer = std::get<TiledRaster<std::uint8_t>>(l);
            });
    QSignalSpy finished(&f.viewport, &Viewport::editFinished);
    const TerrainSurface surface(f.viewport.context().scene->terrain->heights);
    const auto on = [&](double x, double y) { return f.pixel({x, y, *surface.heightAt(x, y)}); };
    QTest::mousePress(f.viewport.surface(), Qt::LeftButton, {}, on(40, 40));
    f.move(on(100, 40), Qt::LeftButton);
    QTest::mouseRelease(f.viewport.surface(), Qt::LeftButton, {}, on(100, 40));
    QCOMPARE(finished.count(), 1);
    QCOMPARE(layer.width(), 65);
    for (const int column : {10, 17, 25})
      QCOMPARE(layer.at(column, 10), static_cast<std::uint8_t>(GroundType::Ice));
    QCOMPARE(layer.at(10, 30), kUnpaintedGround);
  }

  void brushKeysAndLookThrough() {
    Fixture f;
    QSignalSpy radius(&f.viewport, &Viewport::brushRadiusChanged);
    f.viewport.setBrushRadius(20);
    f.viewport.setBrushRadius(20);
    QCOMPARE(radius.count(), 1);
    f.viewport.setLookThrough(true);
    QVERIFY(f.viewport.lookThrough());
    QTest::mousePress(f.viewport.surface(), Qt::MiddleButton, {}, {400, 300});
    QVERIFY(!f.viewport.lookThrough());
    QTest::mouseRelease(f.viewport.surface(), Qt::MiddleButton, {}, {400, 300});
  }

  /// No way of moving takes the eye into the ground.
  void theEyeStaysAboveTheGround() {
    Fixture f;
    const TerrainSurface surface(f.viewport.context().scene->terrain->heights);
    const auto above = [&] {
      const Vec3d eye = f.viewport.camera().position;
      return eye.z - surface.nearestHeight(eye.x, eye.y);
    };
    const auto drag = [&](QPoint to, Qt::KeyboardModifiers keys) {
      QTest::mousePress(f.viewport.surface(), Qt::MiddleButton, keys, {400, 300});
      f.move(to, Qt::MiddleButton, keys);
      QTest::mouseRelease(f.viewport.surface(), Qt::MiddleButton, keys, to);
    };
    drag({400, -900}, {});
    QVERIFY2(above() > 0.1, qPrintable(QString::number(above())));
    QVERIFY(length(f.viewport.camera().target - Vec3d{128, 128, 15}) < 1e-9);
    drag({400, -900}, Qt::ShiftModifier);
    QVERIFY2(above() > 0.1, qPrintable(QString::number(above())));
    const QPointF at(450, 350);
    for (int k = 0; k < 40; ++k) {
      QWheelEvent wheel(at, f.viewport.surface()->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {},
                        Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(f.viewport.surface(), &wheel);
      QVERIFY2(above() > 0.1, qPrintable(QString::number(above())));
    }
  }

  /// From a camera near the ground that looks up, framing ends above what it shows.
  void frameEndsAboveTheGround() {
    Fixture f;
    f.viewport.setCamera({{128, 20, 2}, {128, 128, 60}, 45});
    f.viewport.setSelected("cube");
    f.viewport.frameSelection();
    const Box3d box = nodeBounds(*f.viewport.context().scene, "cube", 0.0);
    QTRY_VERIFY(length(f.viewport.camera().target - box.centre()) < 1e-6);
    const Vec3d eye = f.viewport.camera().position;
    const double elevation =
        std::atan2(eye.z - box.centre().z, std::hypot(eye.x - box.centre().x, eye.y - box.centre().y));
    QVERIFY(elevation > 14.9 * M_PI / 180.0);
    QVERIFY(eye.y < box.centre().y);
  }

  /// Far views lose haze, near ones and those through the camera do not.
  void farViewsHaveLessHaze() {
    Fixture f;
    auto snowy = std::make_shared<SceneSnapshot>(*f.viewport.context().scene);
    snowy->nodes.push_back(makeNode(kSnowfallType, "snowfall", "Snowfall"));
    f.viewport.setScene(snowy);
    f.viewport.setCamera({{128, 100, 60}, {128, 128, 30}, 45});
    QCOMPARE(f.viewport.hazeScale(), 1.0);
    f.viewport.setCamera({{128, -8000, 3000}, {128, 128, 15}, 45});
    const double far = f.viewport.hazeScale();
    QVERIFY2(far < 0.2, qPrintable(QString::number(far)));
    f.viewport.setLookThrough(true);
    QCOMPARE(f.viewport.hazeScale(), 1.0);
  }

  /// Framing flies to the selected model and ends close to it.
  /// Every tool says what it does, and what is missing.
  void toolsSayWhatTheyDo() {
    Fixture f;
    QSet<QString> hints;
    for (const auto tool : {Viewport::Tool::Select, Viewport::Tool::Move, Viewport::Tool::Brush,
                            Viewport::Tool::Outline, Viewport::Tool::Scatter}) {
      f.viewport.setTool(tool);
      QVERIFY(!f.viewport.toolHint().isEmpty());
      hints << f.viewport.toolHint();
    }
    QCOMPARE(hints.size(), 5);
    f.viewport.setTool(Viewport::Tool::Move);
    const QString without = f.viewport.toolHint();
    f.viewport.setSelected("cube");
    QVERIFY(f.viewport.toolHint() != without);
    f.viewport.setTool(Viewport::Tool::Select);
    QVERIFY(f.viewport.toolHint().contains(QStringLiteral("W")));
    f.viewport.setTool(Viewport::Tool::Brush);
    const QString painting = f.viewport.toolHint();
    f.viewport.setScene(std::make_shared<SceneSnapshot>());
    QVERIFY(f.viewport.toolHint() != painting);
  }

  /// Looking through the camera shows the whole width of the picture, in any shape of the view.
  void thePicturesFrameLiesInTheView() {
    Fixture f;
    auto scene = std::make_shared<SceneSnapshot>(*f.viewport.context().scene);
    SceneNode camera = makeNode(kCameraType, "camera", "Camera");
    CameraNode placed;
    placed.position = {10, 10, 60};
    placed.target = {128, 128, 20};
    placed.fovDegrees = 40.0;
    camera.data = std::make_shared<CameraNode>(placed);
    SceneNode picture = makeNode(kRenderType, "render", "Pictures");
    RenderNode wide;
    wide.width = 2000;
    wide.height = 1000;
    picture.data = std::make_shared<RenderNode>(wide);
    scene->nodes.push_back(camera);
    scene->nodes.push_back(picture);
    f.viewport.setScene(scene);
    f.viewport.setLookThrough(true);
    for (const QSize size : {QSize(900, 700), QSize(1200, 300)}) {
      f.viewport.resize(size);
      QTRY_COMPARE(f.viewport.surface()->size(), size);
      const QRectF frame = f.viewport.pictureFrame();
      QVERIFY(std::abs(frame.width() - 2.0 * frame.height()) < 1e-6);
      QVERIFY(QRectF(f.viewport.surface()->rect()).contains(frame));
      // What the picture has at its upper edge stands at the frame's.
      const ViewFrame made({placed.position, placed.target, 40.0}, 2000, 1000);
      const ViewRay edge = made.ray({500, 0});
      const auto seen = f.viewport.context().view.project(edge.at(100.0));
      QVERIFY(seen);
      QVERIFY(std::abs(seen->y - frame.top()) < 0.5);
      QVERIFY(std::abs(seen->x - (frame.left() + 0.25 * frame.width())) < 0.5);
    }
    // Leaving it takes over the camera's own angle.
    f.viewport.resize(300, 700);
    QTRY_COMPARE(f.viewport.surface()->width(), 300);
    QVERIFY(f.viewport.camera().fovDegrees > 90.0);
    f.viewport.frameAll();
    QVERIFY(!f.viewport.lookThrough());
    QCOMPARE(f.viewport.camera().fovDegrees, 40.0);
  }

  void frameFlies() {
    Fixture f;
    f.viewport.setSelected("cube");
    f.viewport.frameSelection();
    const Box3d box = nodeBounds(*f.viewport.context().scene, "cube", 0.0);
    QTRY_VERIFY(length(f.viewport.camera().target - box.centre()) < 1e-6);
    QVERIFY(length(f.viewport.camera().position - box.centre()) < 40.0);
  }
};

QTEST_MAIN(ViewportToolsTest)
#include "viewport_tools_test.moc"
