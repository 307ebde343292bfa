// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/cover_reading.h"

#include <QMouseEvent>
#include <QTest>
#include <cmath>

#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

namespace {

/// The hill under `depth` m of snow of 200 kg/m3 at -4 degC; a fine grid with 1 m about (60, 60); 0.3 m on
/// the cube.
FramePointer snowed(const SceneSnapshot& scene, float depth) {
  auto layout = std::make_shared<CoverLayout>();
  CoverGrid coarse{"terrain", "terrain", scene.terrain->heights, {}};
  coarse.area = coarse.base.sameShape<float>(16.0f);
  CoverGrid fine{"terrain/fine0", "terrain", Raster<float>(16, 16, 56.5, 56.5, 0.5, 5.0f), {}};
  fine.area = fine.base.sameShape<float>(0.25f);
  CoverGrid top{"cube/0", "cube", Raster<float>(16, 16, -3.75, -3.75, 0.5, 8.0f), {}};
  top.area = top.base.sameShape<float>(0.25f);
  layout->grids = {coarse, fine, top};
  auto cover = std::make_shared<CoverPart>();
  cover->layout = layout;
  const float depths[] = {depth, 1.0f, 0.3f};
  for (std::size_t g = 0; g < layout->grids.size(); ++g) {
    const std::size_t cells = layout->grids[g].base.size();
    CoverPart::Values values;
    values.depth.assign(cells, depths[g]);
    values.swe.assign(cells, 200.0f * depths[g]);
    values.temperature.assign(cells, 269.15f);
    cover->values.push_back(values);
  }
  auto frame = std::make_shared<Frame>();
  frame->parts["cover"] = cover;
  return frame;
}

ViewRay down(double x, double y) {
  return {{x, y, 200.0}, {0.0, 0.0, -1.0}};
}

}  // namespace

/// What lies under the pointer.
class CoverReadingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  void theGroundIsRead() {
    const SnapshotPointer scene = test::hillSnapshot();
    const FramePointer frame = snowed(*scene, 0.5f);
    const auto reading = readCover(*scene, frame.get(), 0.0, down(30, 200));
    QVERIFY(reading && reading->covered);
    QCOMPARE(reading->node, std::string("terrain"));
    QCOMPARE(reading->value(SnowDisplay::Depth), 0.5f);
    QCOMPARE(reading->value(SnowDisplay::Swe), 100.0f);
    QVERIFY(std::abs(reading->value(SnowDisplay::Density) - 200.0f) < 0.01f);
    QVERIFY(std::abs(reading->value(SnowDisplay::Temperature) + 4.0f) < 0.01f);
    QVERIFY(std::isnan(reading->value(SnowDisplay::Exposure)));
    QVERIFY(reading->type.has_value());
  }

  /// Of the terrain's grids the fine one counts; on a model its patch.
  void theGridOnTopCounts() {
    const SnapshotPointer scene = test::hillSnapshot();
    const FramePointer frame = snowed(*scene, 0.5f);
    QCOMPARE(readCover(*scene, frame.get(), 0.0, down(60, 60))->value(SnowDisplay::Depth), 1.0f);
    const auto cube = readCover(*scene, frame.get(), 0.0, down(128, 128));
    QVERIFY(cube.has_value());
    QCOMPARE(cube->node, std::string("cube"));
    QCOMPARE(cube->value(SnowDisplay::Depth), 0.3f);
  }

  /// A flat ray is stopped by the snow's surface, not by the ground far behind it.
  void aFlatRayIsReadWhereItMeetsTheSnow() {
    const SnapshotPointer scene = test::hillSnapshot();
    auto frame = std::make_shared<Frame>(*snowed(*scene, 2.0f));
    auto cover = std::make_shared<CoverPart>(*frame->part<CoverPart>("cover"));
    const Raster<float>& heights = scene->terrain->heights;
    for (int j = 0; j < heights.height; ++j)
      for (int i = 0; i < heights.width; ++i)
        if (heights.x(i) < 20.0) cover->values[0].depth[heights.index(i, j)] = 3.0f;
    frame->parts["cover"] = cover;
    // Meets the ground near x = 22, and snow 2 m above it 10 m before.
    const Vec3d ground{22.0, 200.0, static_cast<double>(heights.at(5, 50))};
    const Vec3d way = normalized(Vec3d{10.0, 0.0, -2.0});
    const auto reading = readCover(*scene, frame.get(), 0.0, {ground - way * 60.0, way});
    QVERIFY(reading.has_value());
    QCOMPARE(reading->value(SnowDisplay::Depth), 3.0f);
  }

  void nothingIsInventedWhereNothingLies() {
    const SnapshotPointer scene = test::hillSnapshot();
    QVERIFY(!readCover(*scene, nullptr, 0.0, {{0, 0, 200}, {0, 0, 1}}));
    const auto bare = readCover(*scene, nullptr, 0.0, down(30, 200));
    QVERIFY(bare && !bare->covered);
    QVERIFY(std::isnan(bare->value(SnowDisplay::Depth)));
    QVERIFY(!readingText(*bare).contains(QLatin1String("Snow")));
    const auto none = readCover(*scene, snowed(*scene, 0.0f).get(), 0.0, down(30, 200));
    QVERIFY(none && none->covered);
    QVERIFY(readingText(*none).startsWith(QLatin1String("No snow")));
    QVERIFY(readingText(*none).contains(QLatin1String("-4.0")) ||
            readingText(*none).contains(QLatin1String("\u22124.0")));
  }

  void zeroHasNoSign() {
    CoverReading reading;
    reading.values.fill(std::nanf(""));
    reading.values[static_cast<std::size_t>(SnowDisplay::Temperature)] = -0.01f;
    QVERIFY(readingText(reading).contains(QLatin1String(" 0.0")));
  }

  /// The line follows the pointer, and goes when the pointer leaves or the user does not want it.
  void theViewportTells() {
    const SnapshotPointer scene = test::hillSnapshot();
    Viewport viewport;
    viewport.resize(900, 700);
    viewport.setScene(scene);
    viewport.setFrame(snowed(*scene, 0.5f));
    viewport.setCamera({{128, -80, 140}, {128, 128, 15}, 45});
    viewport.show();
    const QPoint at(450, 560);
    QMouseEvent move(QEvent::MouseMove, at, viewport.surface()->mapToGlobal(at), Qt::NoButton, {}, {});
    QCoreApplication::sendEvent(viewport.surface(), &move);
    QTRY_VERIFY(viewport.reading().startsWith(QLatin1String("Snow 0.50 m")));
    viewport.setFrame(snowed(*scene, 0.75f));
    QTRY_VERIFY(viewport.reading().startsWith(QLatin1String("Snow 0.75 m")));
    viewport.setShowReading(false);
    QTRY_VERIFY(viewport.reading().isEmpty());
    viewport.setShowReading(true);
    QTRY_VERIFY(!viewport.reading().isEmpty());
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(viewport.surface(), &leave);
    QTRY_VERIFY(viewport.reading().isEmpty());
  }

  /// Colours of the cover have their legend here too.
  void theLegendOfTheCoverIsThere() {
    auto scene = std::make_shared<SceneSnapshot>(*test::hillSnapshot());
    SceneNode render = makeNode(kRenderType, "render", "render");
    RenderNode settings;
    settings.snowDisplay = SnowDisplay::Swe;
    render.data = std::make_shared<RenderNode>(settings);
    scene->nodes.push_back(render);
    Viewport viewport;
    viewport.setScene(scene);
    QVERIFY(!viewport.coverLegend());
    viewport.setFrame(snowed(*scene, 0.5f));
    QVERIFY(viewport.coverLegend());
    QCOMPARE(viewport.coverLegend()->unit, std::string("kg/m2"));
  }
};

QTEST_MAIN(CoverReadingTest)
#include "cover_reading_test.moc"
