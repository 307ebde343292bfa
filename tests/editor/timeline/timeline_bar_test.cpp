// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/timeline/timeline_bar.h"

#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include "tests/editor/support/strict.h"

using namespace spin;

namespace {

QPoint at(const TimelineBar& bar, double frame, int y) {
  return {static_cast<int>(std::lround(bar.xOf(frame))), y};
}

constexpr int kRulerY = 10;
constexpr int kKeysY = 27;

}  // namespace

class TimelineBarTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  void positionsAndFramesAreInverse() {
    TimelineBar bar;
    bar.resize(700, 46);
    bar.setRange(20, 140);
    for (int frame = 20; frame <= 140; ++frame) QCOMPARE(bar.frameAt(bar.xOf(frame)), frame);
    QCOMPARE(bar.frameAt(-100), 20);
    QCOMPARE(bar.frameAt(9999), 140);
  }

  /// Press and drag scrub, frame by frame.
  void draggingScrubs() {
    TimelineBar bar;
    bar.resize(700, 46);
    bar.setRange(0, 100);
    connect(&bar, &TimelineBar::frameRequested, &bar, &TimelineBar::setCurrent);
    QSignalSpy spy(&bar, &TimelineBar::frameRequested);
    QTest::mousePress(&bar, Qt::LeftButton, {}, at(bar, 30, kRulerY));
    QCOMPARE(bar.current(), 30);
    QMouseEvent drag(QEvent::MouseMove, at(bar, 55, kRulerY), at(bar, 55, kRulerY), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(&bar, &drag);
    QCOMPARE(bar.current(), 55);
    QCOMPARE(spy.count(), 2);
    QTest::mouseRelease(&bar, Qt::LeftButton, {}, at(bar, 55, kRulerY));
    QCOMPARE(spy.count(), 2);
  }

  /// Dragging a key mark moves the key and does not scrub.
  void draggingAMarkMovesTheKey() {
    TimelineBar bar;
    bar.resize(700, 46);
    bar.setRange(0, 100);
    bar.setKeyFrames({10.0, 40.5});
    QSignalSpy moved(&bar, &TimelineBar::keyMoved);
    QSignalSpy scrubbed(&bar, &TimelineBar::frameRequested);
    QTest::mousePress(&bar, Qt::LeftButton, {}, at(bar, 40.5, kKeysY));
    QMouseEvent drag(QEvent::MouseMove, at(bar, 60, kKeysY), at(bar, 60, kKeysY), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(&bar, &drag);
    QTest::mouseRelease(&bar, Qt::LeftButton, {}, at(bar, 60, kKeysY));
    QCOMPARE(moved.count(), 1);
    QCOMPARE(moved[0][0].toDouble(), 40.5);
    QCOMPARE(moved[0][1].toInt(), 60);
    QCOMPARE(scrubbed.count(), 0);
  }

  /// The three states look different, and each is painted over its own frames.
  void statesHaveTheirColours() {
    TimelineBar bar;
    bar.resize(728, 46);
    bar.setRange(0, 99);
    std::vector<FrameState> states(100, FrameState::Missing);
    for (std::size_t k = 0; k < 30; ++k) states[k] = FrameState::Ready;
    for (std::size_t k = 30; k < 60; ++k) states[k] = FrameState::Stale;
    bar.setStates(states);
    const QImage image = bar.grab().toImage();
    const auto colour = [&](int frame) { return image.pixel(at(bar, frame, 39)); };
    QCOMPARE(colour(5), colour(25));
    QCOMPARE(colour(35), colour(55));
    QCOMPARE(colour(65), colour(95));
    QVERIFY(colour(25) != colour(35));
    QVERIFY(colour(55) != colour(65));
    QVERIFY(colour(25) != colour(65));
  }

  void rulerLabelsStayApart_data() {
    QTest::addColumn<double>("pixels");
    QTest::addColumn<int>("step");
    QTest::newRow("wide") << 60.0 << 1;
    QTest::newRow("usual") << 6.0 << 10;
    QTest::newRow("long film") << 0.06 << 1000;
  }
  void rulerLabelsStayApart() {
    QFETCH(double, pixels);
    QFETCH(int, step);
    QCOMPARE(rulerStep(pixels, 56.0), step);
  }
};

QTEST_MAIN(TimelineBarTest)
#include "timeline_bar_test.moc"
