// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/draw_budget.h"

#include <QTest>
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

  /// What happens while moving does not make still pictures worse.
  void movingAndStillAreApart() {
    DrawBudget budget;
    for (int k = 0; k < 10; ++k) budget.report(true, 1.0);
    QCOMPARE(budget.effort(false), DrawBudget::Effort{});
  }
};

QTEST_APPLESS_MAIN(DrawBudgetTest)
#include "draw_budget_test.moc"
