// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <utility>

#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

namespace {

/// So long a picture may take on a busy machine with a software driver that compiles its shaders first.
constexpr int kWait = 60000;

int different(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); y += 4)
    for (int x = 0; x < a.width(); x += 4) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return count;
}

}  // namespace

/// The viewport with pictures drawn by a real OpenGL driver.
class ViewportGlTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// The scene is drawn: the picture is not one colour and changes with the camera.
  void drawsTheScene() {
    Viewport viewport;
    viewport.resize(640, 400);
    viewport.setScene(test::hillSnapshot());
    viewport.setCamera({{128, -80, 140}, {128, 128, 15}, 45});
    QSignalSpy drawn(&viewport, &Viewport::drawn);
    QSignalSpy failed(&viewport, &Viewport::failed);
    viewport.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewport));
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, kWait);
    QCOMPARE(failed.count(), 0);
    const QImage first = viewport.surface()->picture();
    QImage flat = first;
    flat.fill(first.pixelColor(first.width() / 2, first.height() / 2));
    QVERIFY(different(first, flat) > 100);
    const auto before = drawn.count();
    viewport.setCamera({{128, 20, 60}, {128, 128, 15}, 45});
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > before, kWait);
    QVERIFY(different(first, viewport.surface()->picture()) > 100);
  }

  /// Nothing changes, nothing is drawn; the overlay alone does not draw the scene.
  void drawsOnlyWhenNeeded() {
    Viewport viewport;
    viewport.resize(320, 200);
    viewport.setScene(test::hillSnapshot());
    QSignalSpy drawn(&viewport, &Viewport::drawn);
    viewport.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewport));
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, kWait);
    // Detail comes in a few more pictures; then it is quiet.
    auto before = drawn.count();
    for (int k = 0; k < 10; ++k) {
      QTest::qWait(500);
      if (std::exchange(before, drawn.count()) == before) break;
    }
    viewport.surface()->updateOverlay();
    QTest::qWait(200);
    QCOMPARE(drawn.count(), before);
  }

  /// A view that rests is drawn in full detail; one that moves again is not, until it rests again.
  void refinesWhenItRests() {
    PictureView surface;
    surface.resize(480, 300);
    surface.setScene(test::hillSnapshot());
    surface.setView({{128, -80, 140}, {128, 128, 15}, 45}, 0.0, {});
    QSignalSpy drawn(&surface, &PictureView::drawn);
    QSignalSpy refined(&surface, &PictureView::refined);
    surface.show();
    QVERIFY(QTest::qWaitForWindowExposed(&surface));
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, kWait);
    const QImage coarse = surface.picture();
    QTRY_COMPARE_WITH_TIMEOUT(refined.count(), 1, kWait);
    const QImage fine = surface.picture();
    QVERIFY(different(coarse, fine) > 50);
    surface.setView({{128, 20, 60}, {128, 128, 15}, 45}, 0.0, {});
    surface.setView({{128, -80, 140}, {128, 128, 15}, 45}, 0.0, {});
    QTRY_COMPARE_WITH_TIMEOUT(refined.count(), 2, kWait);
    QCOMPARE(different(fine, surface.picture()), 0);
  }

  /// Many requests in one go are few pictures: never more than about 30 a second.
  void limitsTheRate() {
    Viewport viewport;
    viewport.resize(160, 100);
    viewport.setScene(test::hillSnapshot());
    QSignalSpy drawn(&viewport, &Viewport::drawn);
    viewport.show();
    QVERIFY(QTest::qWaitForWindowExposed(&viewport));
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, kWait);
    const auto before = drawn.count();
    QElapsedTimer timer;
    timer.start();
    int step = 0;
    while (timer.elapsed() < 500) {
      viewport.setCamera({{128, -80 + 0.1 * ++step, 140}, {128, 128, 15}, 45});
      QTest::qWait(1);
    }
    QVERIFY(drawn.count() - before <= 18);
    QVERIFY(drawn.count() > before);
  }

  /// A hidden view asks for no pictures; shown again, it catches up.
  void hiddenViewsDrawNothing() {
    PictureView view;
    view.resize(200, 120);
    view.setScene(test::hillSnapshot());
    view.setView({{128, -80, 140}, {128, 128, 15}, 45}, 0.0, {});
    QSignalSpy drawn(&view, &PictureView::drawn);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, kWait);
    view.hide();
    QTest::qWait(100);
    const auto before = drawn.count();
    view.setView({{128, 20, 60}, {128, 128, 15}, 45}, 0.0, {});
    QTest::qWait(300);
    QCOMPARE(drawn.count(), before);
    const QImage old = view.picture();
    view.show();
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > before, kWait);
    QVERIFY(different(old, view.picture()) > 20);
  }

  /// The picture has the pixels of the screen and follows the widget's size.
  void followsTheSize() {
    PictureView view;
    view.resize(200, 120);
    view.setScene(test::hillSnapshot());
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    QTRY_COMPARE_WITH_TIMEOUT(view.picture().size(), QSize(200, 120), kWait);
    view.resize(333, 177);
    QTRY_COMPARE_WITH_TIMEOUT(view.picture().size(), QSize(333, 177), kWait);
  }

  /// A size the driver refuses is told, and the next one that fits is drawn.
  void refusedSizesAreTold() {
    PictureDrawer drawer;
    QSignalSpy drawn(&drawer, &PictureDrawer::drawn);
    QSignalSpy failed(&drawer, &PictureDrawer::failed);
    PictureRequest request;
    request.scene = test::hillSnapshot();
    request.options.width = 1 << 20;
    request.options.height = 16;
    drawer.request(request);
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, kWait);
    QVERIFY(failed[0][0].toString().contains(QStringLiteral("1048576")));
    QCOMPARE(drawn.count(), 0);
    request.options.width = 32;
    drawer.request(request);
    QTRY_COMPARE_WITH_TIMEOUT(drawn.count(), 1, kWait);
    QCOMPARE(drawn[0][0].value<QImage>().size(), QSize(32, 16));
  }

  /// A view may go at any time, also before the driver is ready or while a picture is drawn.
  void endsWhileDrawing() {
    for (const int wait : {0, 30, 300}) {
      PictureDrawer drawer;
      PictureRequest request;
      request.scene = test::hillSnapshot();
      request.options.width = 640;
      request.options.height = 400;
      drawer.request(request);
      QTest::qWait(wait);
    }
  }

  /// Another window takes the view over (a dock that floats): it still draws.
  void survivesReparenting() {
    QMainWindow a, b;
    auto* viewport = new Viewport;
    viewport->setScene(test::hillSnapshot());
    a.setCentralWidget(viewport);
    a.resize(320, 200);
    b.resize(320, 200);
    QSignalSpy drawn(viewport, &Viewport::drawn);
    a.show();
    QVERIFY(QTest::qWaitForWindowExposed(&a));
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > 0, kWait);
    const auto before = drawn.count();
    b.setCentralWidget(a.takeCentralWidget());
    b.show();
    QVERIFY(QTest::qWaitForWindowExposed(&b));
    viewport->setCamera({{128, -80, 140}, {128, 128, 15}, 45});
    QTRY_VERIFY_WITH_TIMEOUT(drawn.count() > before, kWait);
  }
};

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  ViewportGlTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "viewport_gl_test.moc"
