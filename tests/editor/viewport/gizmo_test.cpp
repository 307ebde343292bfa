// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/gizmo.h"

#include <QTest>
#include <cmath>

#include "core/base/units.h"
#include "tests/editor/support/strict.h"

using namespace spin;

namespace {

const RenderCamera kCamera{{25, -40, 30}, {0, 0, 0}, 45};

ViewFrame view() {
  return ViewFrame(kCamera, 1000, 800);
}

Vec2d pixelOf(Vec3d point) {
  return *view().project(point);
}

bool near(Vec3d a, Vec3d b, double tolerance = 1e-6) {
  return length(a - b) < tolerance;
}

/// Drags a handle from one point in space to another.
GizmoPlacement dragged(GizmoMode mode, GizmoHandle handle, const GizmoPlacement& start, Vec3d from, Vec3d to,
                       bool snap = false, GizmoAxes axes = GizmoAxes::World) {
  const GizmoPose pose = GizmoPose::of(view(), start.position, start.rotationDegrees, mode, axes);
  GizmoDrag drag(pose, mode, handle, start, view(), pixelOf(from));
  return drag.update(view(), pixelOf(to), snap);
}

}  // namespace

class GizmoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// The pointer on a handle grabs that handle, in every mode.
  void picksEachHandle_data() {
    QTest::addColumn<int>("mode");
    for (const GizmoMode mode : {GizmoMode::Move, GizmoMode::Rotate, GizmoMode::Scale})
      QTest::addRow("mode %d", static_cast<int>(mode)) << static_cast<int>(mode);
  }
  void picksEachHandle() {
    QFETCH(int, mode);
    const auto m = static_cast<GizmoMode>(mode);
    const GizmoPose pose = GizmoPose::of(view(), {2, 3, 1}, {}, m, GizmoAxes::World);
    for (const GizmoHandle handle : gizmoHandles(m)) {
      const std::vector<Vec3d> outline = gizmoOutline(pose, m, handle);
      Vec3d grab = outline.back();
      if (outline.size() == 5) grab = (outline[0] + outline[2]) * 0.5;  // the middle of a plane handle
      if (outline.size() > 5) grab = outline[outline.size() / 5];       // a place on the ring
      QCOMPARE(static_cast<int>(pickGizmo(view(), pose, m, pixelOf(grab))), static_cast<int>(handle));
    }
    QCOMPARE(static_cast<int>(pickGizmo(view(), pose, m, {3, 3})), static_cast<int>(GizmoHandle::None));
  }

  /// Arms keep their size on the screen near and far.
  void armsHaveAConstantSize() {
    for (const Vec3d pivot : {Vec3d{0, 0, 0}, Vec3d{-60, 90, 0}}) {
      const GizmoPose pose = GizmoPose::of(view(), pivot, {}, GizmoMode::Move, GizmoAxes::World);
      QVERIFY(std::abs(pose.size / view().metresPerPixel(pivot) - 90.0) < 1e-6);
    }
  }

  /// Along an axis only that coordinate changes, and by what the pointer moved.
  void movesAlongAnAxis() {
    const GizmoPlacement start{{2, 3, 1}, {}, {1, 1, 1}};
    const GizmoPlacement end = dragged(GizmoMode::Move, GizmoHandle::AxisX, start, {4, 3, 1}, {9.25, 3, 1});
    QVERIFY(near(end.position, {7.25, 3, 1}));
    QCOMPARE(end.scale, start.scale);
  }

  void movesInAPlane() {
    const GizmoPlacement start{{2, 3, 1}, {}, {1, 1, 1}};
    const GizmoPlacement end =
        dragged(GizmoMode::Move, GizmoHandle::PlaneZ, start, {3, 4, 1}, {-2.5, 8.5, 1});
    QVERIFY(near(end.position, {-3.5, 7.5, 1}));
  }

  /// Local axes turn with the model.
  void movesAlongLocalAxes() {
    const GizmoPlacement start{{0, 0, 0}, {0, 0, 90}, {1, 1, 1}};
    const GizmoPlacement end =
        dragged(GizmoMode::Move, GizmoHandle::AxisX, start, {0, 2, 0}, {0, 6, 0}, false, GizmoAxes::Local);
    QVERIFY(near(end.position, {0, 4, 0}));
  }

  /// Ctrl moves by whole metres, counted from the start.
  void snapsMoves() {
    const GizmoPlacement start{{0.3, 0, 0}, {}, {1, 1, 1}};
    const GizmoPlacement end =
        dragged(GizmoMode::Move, GizmoHandle::AxisX, start, {1, 0, 0}, {3.4, 0, 0}, true);
    QVERIFY(near(end.position, {2.3, 0, 0}));
  }

  /// A quarter turn of the ring is a quarter turn of the model, to the left seen from above.
  void rotatesAboutAnAxis() {
    const GizmoPlacement start{{0, 0, 0}, {0, 0, 10}, {1, 1, 1}};
    const GizmoPlacement end = dragged(GizmoMode::Rotate, GizmoHandle::AxisZ, start, {5, 0, 0}, {0, 5, 0});
    QVERIFY(near(end.rotationDegrees, {0, 0, 100}, 1e-6));
  }

  /// Turning about a world axis composes with the rotation the model has.
  void rotationsCompose() {
    const GizmoPlacement start{{0, 0, 0}, {90, 0, 0}, {1, 1, 1}};
    const GizmoPlacement end = dragged(GizmoMode::Rotate, GizmoHandle::AxisZ, start, {5, 0, 0}, {0, 5, 0});
    const Transform expected = rotationOfDegrees({0, 0, 90}) * rotationOfDegrees({90, 0, 0});
    const Transform got = rotationOfDegrees(end.rotationDegrees);
    for (const Vec3d axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
      QVERIFY(near(got.vector(axis), expected.vector(axis), 1e-9));
  }

  void snapsRotations() {
    const GizmoPlacement end = dragged(GizmoMode::Rotate, GizmoHandle::AxisZ, {}, {5, 0, 0},
                                       {5 * std::cos(0.6), 5 * std::sin(0.6), 0}, true);
    QVERIFY(near(end.rotationDegrees, {0, 0, 30}, 1e-9));  // 0.6 rad = 34.4 degrees
  }

  /// Several turns add up: the pointer may go round and round.
  void countsFullTurns() {
    const GizmoPose pose = GizmoPose::of(view(), {}, {}, GizmoMode::Rotate, GizmoAxes::World);
    GizmoDrag drag(pose, GizmoMode::Rotate, GizmoHandle::AxisZ, {}, view(), pixelOf({5, 0, 0}));
    GizmoPlacement last;
    for (int degrees = 20; degrees <= 380; degrees += 20) {
      const double a = degreesToRadians(degrees);
      last = drag.update(view(), pixelOf({5 * std::cos(a), 5 * std::sin(a), 0}), false);
    }
    QVERIFY(near(last.rotationDegrees, {0, 0, 20}, 1e-6));
  }

  void scalesOneAxis() {
    const GizmoPlacement start{{0, 0, 0}, {}, {2, 3, 4}};
    const GizmoPlacement end = dragged(GizmoMode::Scale, GizmoHandle::AxisY, start, {0, 4, 0}, {0, 6, 0});
    QVERIFY(near(end.scale, {2, 4.5, 4}));
    QCOMPARE(end.position, start.position);
  }

  /// Scaling through zero stops at a small positive factor: a model never turns inside out.
  void scaleStaysPositive() {
    const GizmoPlacement end = dragged(GizmoMode::Scale, GizmoHandle::AxisX, {}, {4, 0, 0}, {-9, 0, 0});
    QVERIFY(near(end.scale, {GizmoDrag::kMinScale, 1, 1}));
  }

  void scalesAllAxesAlike() {
    const GizmoPlacement start{{0, 0, 0}, {}, {1, 2, 3}};
    const GizmoPose pose = GizmoPose::of(view(), {}, {}, GizmoMode::Scale, GizmoAxes::World);
    const Vec2d press = pixelOf({0, 0, 0});
    GizmoDrag drag(pose, GizmoMode::Scale, GizmoHandle::Centre, start, view(), press);
    const GizmoPlacement end = drag.update(view(), {press.x + 90, press.y}, false);
    QVERIFY(near(end.scale, {2, 4, 6}));
  }

  /// Angles of any rotation give the same rotation back, at the gimbal lock too.
  void eulerAnglesRoundTrip_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::newRow("plain") << 20.0 << -35.0 << 140.0;
    QTest::newRow("lock up") << 30.0 << 90.0 << 50.0;
    QTest::newRow("lock down") << -70.0 << -90.0 << 10.0;
  }
  void eulerAnglesRoundTrip() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    const Transform given = rotationOfDegrees({x, y, z});
    const Transform back = rotationOfDegrees(eulerDegreesOf(given.linear));
    for (std::size_t k = 0; k < 9; ++k) QVERIFY(std::abs(given.linear[k] - back.linear[k]) < 1e-9);
  }
};

QTEST_APPLESS_MAIN(GizmoTest)
#include "gizmo_test.moc"
