// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/view_frame.h"

#include <QTest>
#include "tests/editor/support/strict.h"

using namespace spin;

class ViewFrameTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  void rayAndProjectionAreInverse_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("centre") << 400.0 << 300.0;
    QTest::newRow("top left") << 0.0 << 0.0;
    QTest::newRow("right") << 799.0 << 120.0;
  }
  void rayAndProjectionAreInverse() {
    QFETCH(double, x);
    QFETCH(double, y);
    const ViewFrame view({{10, -30, 12}, {1, 2, 3}, 40}, 800, 600);
    const auto pixel = view.project(view.ray({x, y}).at(17.0));
    QVERIFY(pixel);
    QVERIFY(std::abs(pixel->x - x) < 1e-6);
    QVERIFY(std::abs(pixel->y - y) < 1e-6);
  }

  /// Up on screen is up in the world; east is right when looking north.
  void axesPointTheRightWay() {
    const ViewFrame view({{0, -10, 0}, {0, 0, 0}, 45}, 800, 600);
    QVERIFY(view.project({0, 0, 1})->y < 300);
    QVERIFY(view.project({1, 0, 0})->x > 400);
    QVERIFY(!view.project({0, -11, 0}));
  }

  /// Straight down there is no horizon, and north is up.
  void looksStraightDown() {
    const ViewFrame view({{0, 0, 50}, {0, 0, 0}, 45}, 800, 600);
    QVERIFY(view.project({0, 1, 0})->y < 300);
    QVERIFY(view.project({1, 0, 0})->x > 400);
  }

  void boxesAreHitFromOutsideAndInside() {
    Box3d box;
    box.extend(Vec3d{-1, -1, -1});
    box.extend(Vec3d{1, 1, 1});
    QVERIFY(std::abs(*intersectBox({{0, -5, 0}, {0, 1, 0}}, box) - 4.0) < 1e-12);
    QCOMPARE(*intersectBox({{0, 0, 0}, {0, 1, 0}}, box), 0.0);
    QVERIFY(!intersectBox({{0, -5, 0}, {0, -1, 0}}, box));
    QVERIFY(!intersectBox({{3, -5, 0}, {0, 1, 0}}, box));
    QVERIFY(!intersectBox({{0, 0, 0}, {0, 1, 0}}, Box3d{}));
  }

  void trianglesAreHitFromBothSides() {
    const Vec3d a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
    QVERIFY(std::abs(*intersectTriangle({{0.2, 0.2, 3}, {0, 0, -1}}, a, b, c) - 3.0) < 1e-12);
    QVERIFY(intersectTriangle({{0.2, 0.2, -3}, {0, 0, 1}}, a, b, c));
    QVERIFY(!intersectTriangle({{0.8, 0.8, 3}, {0, 0, -1}}, a, b, c));
    QVERIFY(!intersectTriangle({{0.2, 0.2, 3}, {0, 0, 1}}, a, b, c));
  }

  void planesBehindTheEyeAreMissed() {
    QVERIFY(intersectPlane({{0, 0, 5}, {0, 0, -1}}, {}, {0, 0, 1}));
    QVERIFY(!intersectPlane({{0, 0, 5}, {0, 0, 1}}, {}, {0, 0, 1}));
    QVERIFY(!intersectPlane({{0, 0, 5}, {1, 0, 0}}, {}, {0, 0, 1}));
  }
};

QTEST_APPLESS_MAIN(ViewFrameTest)
#include "view_frame_test.moc"
