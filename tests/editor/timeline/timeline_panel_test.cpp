// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/timeline/timeline_panel.h"

#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include "tests/editor/support/strict.h"

using namespace spin;

class TimelinePanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// Buttons, spin box and ruler show the same frame.
  void buttonsStep() {
    TimelinePanel panel;
    panel.setFilm(5, 20, 24.0);
    QCOMPARE(panel.current(), 5);
    auto* spin = panel.findChild<QSpinBox*>(QStringLiteral("currentFrame"));
    panel.findChild<QToolButton*>(QStringLiteral("nextFrame"))->click();
    QCOMPARE(panel.current(), 6);
    QCOMPARE(spin->value(), 6);
    panel.findChild<QToolButton*>(QStringLiteral("toLast"))->click();
    QCOMPARE(panel.current(), 20);
    panel.findChild<QToolButton*>(QStringLiteral("nextFrame"))->click();
    QCOMPARE(panel.current(), 20);
    panel.findChild<QToolButton*>(QStringLiteral("toFirst"))->click();
    QCOMPARE(panel.current(), 5);
    spin->setValue(11);
    QCOMPARE(panel.bar()->current(), 11);
  }

  /// Each change is told once.
  void tellsOnlyChanges() {
    TimelinePanel panel;
    panel.setFilm(0, 50, 24.0);
    QSignalSpy spy(&panel, &TimelinePanel::currentChanged);
    panel.setCurrent(7);
    panel.setCurrent(7);
    panel.setCurrent(500);
    QCOMPARE(spy.count(), 2);
    QCOMPARE(spy[1][0].toInt(), 50);
  }

  /// A shorter film moves the current frame into it.
  void shorterFilmKeepsTheFrameInside() {
    TimelinePanel panel;
    panel.setFilm(0, 100, 24.0);
    panel.setCurrent(90);
    QSignalSpy spy(&panel, &TimelinePanel::currentChanged);
    panel.setFilm(0, 60, 24.0);
    QCOMPARE(panel.current(), 60);
    QCOMPARE(spy.count(), 1);
  }

  /// Playing goes on by itself, round and round, until it is stopped.
  void plays() {
    TimelinePanel panel;
    panel.setFilm(0, 3, 100.0);
    QSignalSpy spy(&panel, &TimelinePanel::currentChanged);
    panel.findChild<QToolButton*>(QStringLiteral("play"))->click();
    QVERIFY(panel.playing());
    QTRY_VERIFY(spy.count() >= 6);
    panel.togglePlaying();
    QVERIFY(!panel.playing());
    const int frame = panel.current();
    QTest::qWait(60);
    QCOMPARE(panel.current(), frame);
  }

  /// While frames are simulated playing shows each as it comes, and never runs ahead of them.
  void waitsForWhatIsSimulated() {
    TimelinePanel panel;
    panel.setFilm(0, 50, 200.0);
    std::vector<FrameState> states(51, FrameState::Missing);
    std::fill(states.begin(), states.begin() + 6, FrameState::Ready);
    panel.bar()->setStates(states);
    panel.setGrowing(true);
    panel.setPlaying(true);
    QTRY_COMPARE(panel.current(), 5);
    QTest::qWait(60);
    QCOMPARE(panel.current(), 5);
    std::fill(states.begin(), states.begin() + 9, FrameState::Ready);
    panel.bar()->setStates(states);
    QTRY_COMPARE(panel.current(), 8);
    // From where nothing is yet it begins anew.
    panel.setCurrent(30);
    QTRY_COMPARE(panel.current(), 8);
    // Without a run it plays on as before: there is nothing to wait for.
    panel.setGrowing(false);
    QTRY_VERIFY(panel.current() > 20);
  }
};

QTEST_MAIN(TimelinePanelTest)
#include "timeline_panel_test.moc"
