// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/scatter_stroke.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace spin;

namespace {

double between(Vec2d a, Vec2d b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

ScatterTask task(double radius, double density, double distance) {
  ScatterTask made;
  made.radius = radius;
  made.density = density;
  made.distance = distance;
  made.own = {-1e4, -1e4};
  return made;
}

double nearestPair(const PlanPoints& copies) {
  double nearest = 1e9;
  for (std::size_t a = 0; a < copies.size(); ++a)
    for (std::size_t b = a + 1; b < copies.size(); ++b)
      nearest = std::min(nearest, between(copies[a], copies[b]));
  return nearest;
}

}  // namespace

class ScatterStrokeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// As dense as asked, within the tip, no nearer than asked.
  void fillsUpToTheDensity() {
    ScatterStroke free({}, task(50.0, 0.04, 0.0));
    QVERIFY(free.moveTo({200.0, 100.0}));
    const double wanted = 0.04 * 3.14159 * 50.0 * 50.0;
    QVERIFY(std::abs(free.change() - wanted) < 0.05 * wanted);
    for (const Vec2d& p : free.copies()) QVERIFY(between(p, {200, 100}) <= 50.01);
    ScatterStroke apart({}, task(50.0, 0.04, 3.0));
    apart.moveTo({200.0, 100.0});
    QVERIFY(nearestPair(apart.copies()) >= 2.98);
    QVERIFY2(apart.change() > 0.8 * wanted, "squares are 5 m wide: most find room");
  }

  /// The same way in one, in five and in many reports gives the same copies.
  void reportsOfThePointerDoNotMatter() {
    PlanPoints copies;
    for (const int reports : {1, 5, 173}) {
      ScatterStroke stroke({}, task(8.0, 0.1, 2.0));
      for (int k = 0; k <= reports; ++k) stroke.moveTo({10.0 + 80.0 * k / reports, 20.0});
      PlanPoints found = stroke.copies();
      std::sort(found.begin(), found.end(), [](Vec2d a, Vec2d b) { return a.x < b.x; });
      if (reports == 1) copies = found;
      QVERIFY(found.size() > 100);
      QVERIFY(found == copies);
    }
  }

  void goingOverItAgainAddsNothing() {
    ScatterStroke stroke({}, task(10.0, 0.1, 1.0));
    stroke.moveTo({0, 0});
    const int after = stroke.change();
    stroke.moveTo({30, 0});
    stroke.moveTo({0, 0});
    stroke.moveTo({30, 0});
    ScatterStroke second(stroke.copies(), task(10.0, 0.1, 1.0));
    second.moveTo({0, 0});
    second.moveTo({30, 0});
    QVERIFY(stroke.change() > after);
    QVERIFY2(second.change() <= 2, "only squares that had found no room may find some from elsewhere");
    ScatterStroke denser(stroke.copies(), task(10.0, 0.4, 0.0));
    denser.moveTo({0, 0});
    QVERIFY(denser.change() > after);
  }

  void erasesWhatTheTipPasses() {
    ScatterStroke stroke({}, task(30.0, 0.1, 1.0));
    stroke.moveTo({0, 0});
    ScatterTask wipe = task(5.0, 0.1, 1.0);
    wipe.erase = true;
    ScatterStroke eraser(stroke.copies(), wipe);
    eraser.moveTo({-30, 0});
    QVERIFY(eraser.moveTo({30, 0}));
    QVERIFY(eraser.change() < 0);
    for (const Vec2d& p : eraser.copies()) QVERIFY(std::abs(p.y) > 5.0);
    for (const Vec2d& p : stroke.copies())
      if (std::abs(p.y) > 5.0)
        QVERIFY(std::find(eraser.copies().begin(), eraser.copies().end(), p) != eraser.copies().end());
    QVERIFY(!eraser.moveTo({-30, 0}));
    // Turn and size go by number: no more copies get another one than went.
    int renumbered = 0;
    for (std::size_t k = 0; k < eraser.copies().size(); ++k)
      if (!(eraser.copies()[k] == stroke.copies()[k])) ++renumbered;
    QVERIFY(renumbered <= -eraser.change());
  }

  /// A click with a tip that is small beside the squares sets one copy; another click there does not.
  void aClickSetsASingleCopy() {
    for (int k = 0; k < 20; ++k) {
      const Vec2d place{37.0 * k, 11.0 * k};
      ScatterStroke stroke({}, task(0.5, 0.001, 2.0));
      QVERIFY(stroke.moveTo(place));
      QCOMPARE(stroke.copies().size(), std::size_t{1});
      QVERIFY(between(stroke.copies()[0], place) <= 0.51);
      ScatterStroke again(stroke.copies(), task(0.5, 0.001, 2.0));
      QVERIFY(!again.moveTo(place));
    }
  }

  /// Not where there is no ground, not on the model itself, not more than there may be.
  void keepsToItsLimits() {
    ScatterTask half = task(20.0, 0.1, 4.0);
    half.isGround = [](Vec2d p) { return p.x > 0.0; };
    half.own = {10.0, 0.0};
    ScatterStroke stroke({}, half);
    QVERIFY(stroke.moveTo({0, 0}));
    for (const Vec2d& p : stroke.copies()) QVERIFY(p.x >= 0.0 && between(p, half.own) >= 3.98);
    ScatterTask few = task(20.0, 0.1, 0.0);
    few.most = 7;
    ScatterStroke full({}, few);
    full.moveTo({0, 0});
    QCOMPARE(full.change(), 7);
    QVERIFY(full.full());
  }

  void anotherSeedGivesOtherPlaces() {
    ScatterStroke one({}, task(20.0, 0.1, 0.0));
    ScatterTask other = task(20.0, 0.1, 0.0);
    other.seed = 2;
    ScatterStroke two({}, other);
    one.moveTo({0, 0});
    two.moveTo({0, 0});
    QVERIFY(!(one.copies() == two.copies()));
  }
};

QTEST_APPLESS_MAIN(ScatterStrokeTest)
#include "scatter_stroke_test.moc"
