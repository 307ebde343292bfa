// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/timeline/playback_clock.h"

#include <QTest>
#include "tests/editor/support/strict.h"

using namespace spin;

class PlaybackClockTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// The film's speed is kept: half a second at 24 frames a second is 12 frames, however often it is asked.
  void keepsFilmSpeed() {
    PlaybackClock clock;
    clock.start(0, 0, 119, 24.0, 100.0);
    QCOMPARE(clock.frameAt(100.0), 0);
    QCOMPARE(clock.frameAt(100.5), 12);
    QCOMPARE(clock.frameAt(100.0 + 119.0 / 24.0), 119);
  }

  /// After the last frame comes the first one of the range.
  void playsRoundAndRound() {
    PlaybackClock clock;
    clock.start(10, 8, 17, 10.0, 0.0);
    QCOMPARE(clock.frameAt(0.75), 17);
    QCOMPARE(clock.frameAt(0.85), 8);
    QCOMPARE(clock.frameAt(10.05), 10);
  }

  void startsInsideTheRange() {
    PlaybackClock clock;
    clock.start(500, 8, 17, 10.0, 0.0);
    QCOMPARE(clock.frameAt(0.0), 17);
    clock.start(3, 5, 5, 10.0, 0.0);
    QCOMPARE(clock.frameAt(7.0), 5);
  }

  void tellsWhenTheNextFrameIsDue() {
    PlaybackClock clock;
    clock.start(0, 0, 119, 25.0, 0.0);
    QVERIFY(std::abs(clock.untilNext(0.0) - 0.04) < 1e-9);
    QVERIFY(std::abs(clock.untilNext(0.05) - 0.03) < 1e-9);
  }
};

QTEST_APPLESS_MAIN(PlaybackClockTest)
#include "playback_clock_test.moc"
