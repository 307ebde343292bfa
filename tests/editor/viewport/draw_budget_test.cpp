// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/draw_budget.h"

#include <QTest>
#include "editor/viewport/band_plan.h"
#include "tests/editor/support/strict.h"

using namespace spin;

class DrawBudgetTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// A machine that needs 400 ms for the full picture: a few pictures later each takes less than its budget.
  void slowMachinesGetQuickPictures_data() {
    QTest::addColumn<bool>("moving");
    QTest::newRow("moving") << true;
    QTest::newRow("still") << false;
  }
  void slowMachinesGetQuickPictures() {
    QFETCH(bool, moving);
    DrawBudget budget;
    double seconds = 0.0;
    for (int k = 0; k < 12; ++k) {
      const DrawBudget::Effort effort = budget.effort(moving);
      // Half of the work goes with the detail, all of it with the pixels.
      seconds = 0.4 * (0.5 + 0.5 * effort.quality) * effort.scale * effort.scale;
      budget.report(moving, seconds);
    }
    QVERIFY2(seconds <= 1.3 * (moving ? DrawBudget::kMovingSeconds : DrawBudget::kStillSeconds),
             qPrintable(QString::number(seconds)));
  }

  /// Detail is lost before resolution.
  void detailGoesFirst() {
    DrawBudget budget;
    budget.report(true, 0.045);
    QVERIFY(budget.effort(true).quality < 1.0);
    QCOMPARE(budget.effort(true).scale, 1.0);
  }

  /// Once pictures are quick again all detail comes back.
  void recovers() {
    DrawBudget budget;
    budget.report(true, 0.5);
    QVERIFY(budget.effort(true).quality < 1.0);
    for (int k = 0; k < 60; ++k) budget.report(true, 0.002);
    QCOMPARE(budget.effort(true), DrawBudget::Effort{});
  }

  /// Bands cover the picture without gap or overlap and come to the time they may take, whatever the driver.
  void bandsCoverThePicture_data() {
    QTest::addColumn<double>("secondsForAll");
    QTest::newRow("slow") << 2.0;
    QTest::newRow("medium") << 0.3;
    QTest::newRow("fast") << 0.001;
  }
  void bandsCoverThePicture() {
    QFETCH(double, secondsForAll);
    BandPlan plan;
    double last = 0.0;
    for (int picture = 0; picture < 4; ++picture) {
      double reached = 0.0;
      int bands = 0;
      for (plan.restart(); !plan.done(); ++bands) {
        const Vec2d band = plan.next();
        QCOMPARE(band.x, reached);
        QVERIFY(band.y > band.x && band.y <= 1.0);
        QVERIFY(bands < 40);
        reached = band.y;
        last = secondsForAll * (band.y - band.x);
        plan.report(last);
      }
      QCOMPARE(reached, 1.0);
    }
    QVERIFY(last <= 1.5 * std::max(BandPlan::kBandSeconds, secondsForAll * BandPlan::kLeastShare));
  }

  /// What happens while moving does not make still pictures worse.
  void movingAndStillAreApart() {
    DrawBudget budget;
    for (int k = 0; k < 10; ++k) budget.report(true, 1.0);
    QCOMPARE(budget.effort(false), DrawBudget::Effort{});
  }
};

QTEST_APPLESS_MAIN(DrawBudgetTest)
#include "draw_budget_test.moc"
