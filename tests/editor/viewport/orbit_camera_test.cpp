// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/orbit_camera.h"

#include <QTest>
#include <cmath>
#include "tests/editor/support/strict.h"

using namespace spin;

namespace {

double distanceOf(Vec2d a, Vec2d b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

class OrbitCameraTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// Taking over a camera and giving it back changes nothing.
  void keepsTheCameraItTakesOver() {
    const RenderCamera given{{30, -40, 25}, {5, 6, 7}, 38.0};
    const RenderCamera back = OrbitCamera::from(given).camera();
    QVERIFY(length(back.position - given.position) < 1e-9);
    QVERIFY(length(back.target - given.target) < 1e-12);
    QCOMPARE(back.fovDegrees, 38.0);
  }

  /// Turning keeps the distance and what is looked at; dragging down raises the eye.
  void orbitTurnsAboutThePivot() {
    OrbitCamera camera = OrbitCamera::from({{0, -50, 20}, {1, 2, 3}, 45});
    const double before = camera.distance();
    const double height = camera.camera().position.z;
    camera.orbit(40, 30);
    QVERIFY(std::abs(camera.distance() - before) < 1e-9);
    QVERIFY(length(camera.camera().target - Vec3d{1, 2, 3}) < 1e-12);
    QVERIFY(camera.camera().position.z > height);
  }

  /// The eye stops short of the zenith, where the horizon would flip.
  void orbitStopsAtTheZenith() {
    OrbitCamera camera;
    camera.orbit(0, 1e6);
    QCOMPARE(camera.pitchDegrees(), OrbitCamera::kMaxPitchDegrees);
    camera.orbit(0, -1e7);
    QCOMPARE(camera.pitchDegrees(), -OrbitCamera::kMaxPitchDegrees);
  }

  /// A point at the pivot's depth follows the pointer exactly.
  void panFollowsThePointer() {
    OrbitCamera camera = OrbitCamera::from({{20, -60, 35}, {3, 4, 5}, 50});
    const Vec3d point = camera.pivot();
    const auto before = ViewFrame(camera.camera(), 800, 600).project(point);
    camera.pan(37, -21, 600);
    const auto after = ViewFrame(camera.camera(), 800, 600).project(point);
    QVERIFY(before && after);
    QVERIFY(distanceOf(*after, {before->x + 37, before->y - 21}) < 1e-6);
  }

  /// Zooming to the pointer: the anchor stays at its pixel, the eye comes nearer to it.
  void zoomKeepsTheAnchorInPlace() {
    OrbitCamera camera = OrbitCamera::from({{20, -60, 35}, {3, 4, 5}, 50});
    const Vec3d anchor{12, -5, 9};
    const auto before = ViewFrame(camera.camera(), 800, 600).project(anchor);
    const double far = length(camera.camera().position - anchor);
    camera.zoom(3, anchor);
    const auto after = ViewFrame(camera.camera(), 800, 600).project(anchor);
    QVERIFY(before && after);
    QVERIFY(distanceOf(*before, *after) < 1e-6);
    QVERIFY(length(camera.camera().position - anchor) < far * 0.7);
  }

  void zoomStaysWithinItsLimits() {
    OrbitCamera camera;
    camera.zoom(1000, camera.pivot());
    QCOMPARE(camera.distance(), OrbitCamera::kMinDistance);
    camera.zoom(-1000, camera.pivot());
    QCOMPARE(camera.distance(), OrbitCamera::kMaxDistance);
  }

  /// After framing, all corners of the box are in the picture and it is not tiny.
  void frameShowsTheWholeBox() {
    OrbitCamera camera;
    Box3d box;
    box.extend(Vec3d{100, 200, 10});
    box.extend(Vec3d{160, 230, 40});
    camera.frame(box);
    const ViewFrame view(camera.camera(), 800, 600);
    double left = 1e9, right = -1e9;
    for (int corner = 0; corner < 8; ++corner) {
      const auto pixel =
          view.project({corner & 1 ? 160.0 : 100.0, corner & 2 ? 230.0 : 200.0, corner & 4 ? 40.0 : 10.0});
      QVERIFY(pixel);
      QVERIFY(pixel->x >= 0 && pixel->x <= 800 && pixel->y >= 0 && pixel->y <= 600);
      left = std::min(left, pixel->x);
      right = std::max(right, pixel->x);
    }
    QVERIFY(right - left > 200);
  }

  /// A camera that looked upward frames from above, from the same side.
  void frameLooksFromAbove() {
    OrbitCamera camera = OrbitCamera::from({{-40, 0, 2}, {0, 0, 30}, 45});
    QVERIFY(camera.pitchDegrees() < 0.0);
    Box3d box;
    box.extend(Vec3d{-5, -5, 0});
    box.extend(Vec3d{5, 5, 8});
    camera.frame(box);
    QCOMPARE(camera.pitchDegrees(), OrbitCamera::kMinFramePitchDegrees);
    const RenderCamera seen = camera.camera();
    QVERIFY(seen.position.z > box.max.z);
    QVERIFY(seen.position.x < 0.0);
    QVERIFY(std::abs(seen.position.y) < 1e-9);
    OrbitCamera steep = OrbitCamera::from({{0, -10, 40}, {0, 0, 0}, 45});
    const double pitch = steep.pitchDegrees();
    steep.frame(box);
    QCOMPARE(steep.pitchDegrees(), pitch);
  }

  /// Turning out of the ground keeps pivot and distance, lifting keeps the direction.
  void theFloorHoldsTheEye() {
    const EyeFloor slope = [](double x, double) { return 5.0 - 0.5 * x; };
    OrbitCamera camera = OrbitCamera::from({{-20, 0, -10}, {0, 0, 6}, 45});
    const double distance = camera.distance();
    OrbitCamera lifted = camera;
    camera.turnAbove(slope);
    const Vec3d eye = camera.camera().position;
    QVERIFY(eye.z >= slope(eye.x, eye.y));
    QVERIFY(eye.z < slope(eye.x, eye.y) + 0.1);
    QCOMPARE(camera.distance(), distance);
    QVERIFY(length(camera.pivot() - Vec3d{0, 0, 6}) < 1e-12);
    lifted.liftAbove(slope);
    QVERIFY(std::abs(lifted.camera().position.z - 15.0) < 1e-9);
    QVERIFY(std::abs(lifted.pivot().z - 31.0) < 1e-9);
    QVERIFY(std::abs(lifted.camera().position.x + 20.0) < 1e-9);
    // A pivot deep in the ground: no turn is enough.
    OrbitCamera buried = OrbitCamera::from({{0, -2, -50}, {0, 0, -50}, 45});
    buried.turnAbove(slope);
    const Vec3d out = buried.camera().position;
    QVERIFY(out.z >= slope(out.x, out.y) - 1e-9);
  }

  /// A flight starts and ends where it should and takes the short way round.
  void flightTakesTheShortWay() {
    const OrbitCamera a = OrbitCamera::from({{-50, -10, 10}, {0, 0, 0}, 45});
    const OrbitCamera b = OrbitCamera::from({{-50, 10, 10}, {0, 0, 0}, 45});
    QVERIFY(length(OrbitCamera::between(a, b, 0).camera().position - a.camera().position) < 1e-9);
    QVERIFY(length(OrbitCamera::between(a, b, 1).camera().position - b.camera().position) < 1e-9);
    QVERIFY(OrbitCamera::between(a, b, 0.5).camera().position.x < -45.0);
  }
};

QTEST_APPLESS_MAIN(OrbitCameraTest)
#include "orbit_camera_test.moc"
