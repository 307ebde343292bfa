// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/brush_stroke.h"

#include <QTest>
#include <cmath>
#include "tests/editor/support/strict.h"

using namespace spin;

namespace {

constexpr std::uint8_t kOld = 255;
constexpr std::uint8_t kNew = 4;

Raster<float> grid(int width = 200, int height = 150, double cell = 2.0) {
  return Raster<float>(width, height, 10.0, -20.0, cell, 0.0f);
}

TiledRaster<std::uint8_t> layerOf(const Raster<float>& raster) {
  return {raster.width, raster.height, kOld};
}

}  // namespace

class BrushStrokeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// Exactly the cells whose centres lie within the radius are painted.
  void dabIsARoundDisc() {
    const Raster<float> raster = grid();
    BrushStroke stroke(layerOf(raster), raster, 9.0, kNew);
    stroke.moveTo({101.0, 77.0});
    QVERIFY(stroke.changed());
    for (int j = 0; j < raster.height; ++j)
      for (int i = 0; i < raster.width; ++i) {
        const double distance = std::hypot(raster.x(i) - 101.0, raster.y(j) - 77.0);
        if (std::abs(distance - 9.0) < 1e-9) continue;
        const bool near = distance < 9.0 || (i == raster.column(101.0) && j == raster.row(77.0));
        QCOMPARE(stroke.layer().at(i, j), near ? kNew : kOld);
      }
  }

  /// A fast pointer leaves no gaps: the way between two positions is painted at full width.
  void fastStrokesHaveNoGaps() {
    const Raster<float> raster = grid();
    BrushStroke stroke(layerOf(raster), raster, 5.0, kNew);
    stroke.moveTo({30.0, 0.0});
    stroke.moveTo({330.0, 120.0});
    for (int k = 0; k <= 300; ++k) {
      const double t = k / 300.0;
      QCOMPARE(stroke.layer().at(raster.column(30.0 + 300.0 * t), raster.row(120.0 * t)), kNew);
    }
  }

  /// A brush smaller than a cell still paints the cell under the pointer.
  void tinyBrushPaintsOneCell() {
    const Raster<float> raster = grid();
    BrushStroke stroke(layerOf(raster), raster, 0.1, kNew);
    stroke.moveTo({50.7, 30.6});
    int painted = 0;
    for (int j = 0; j < raster.height; ++j)
      for (int i = 0; i < raster.width; ++i) painted += stroke.layer().at(i, j) == kNew ? 1 : 0;
    QCOMPARE(painted, 1);
    QCOMPARE(stroke.layer().at(raster.column(50.7), raster.row(30.6)), kNew);
  }

  /// Off the edge of the terrain, even far off, nothing breaks.
  void paintsAcrossTheEdge() {
    const Raster<float> raster = grid();
    BrushStroke stroke(layerOf(raster), raster, 20.0, kNew);
    stroke.moveTo({-1e7, -1e7});
    QVERIFY(!stroke.changed());
    stroke.moveTo({10.0, -20.0});
    QVERIFY(stroke.changed());
    QCOMPARE(stroke.layer().at(0, 0), kNew);
    QCOMPARE(stroke.layer().at(199, 149), kOld);
  }

  /// Tiles the stroke does not touch stay shared with the layer before, so an undo step is small; the layer
  /// before is not changed.
  void untouchedTilesStayShared() {
    const Raster<float> raster = grid();
    const TiledRaster<std::uint8_t> before = layerOf(raster);
    BrushStroke stroke(before, raster, 5.0, kNew);
    stroke.moveTo({20.0, -10.0});
    int changed = 0;
    for (std::size_t t = 0; t < before.tileCount(); ++t)
      if (stroke.layer().tile(t) != before.tile(t)) ++changed;
    QCOMPARE(changed, 1);
    QCOMPARE(before.at(5, 5), kOld);
  }

  /// Painting what is there already is no change.
  void paintingTheSameIsNoChange() {
    const Raster<float> raster = grid();
    BrushStroke stroke(layerOf(raster), raster, 9.0, kOld);
    stroke.moveTo({101.0, 77.0});
    QVERIFY(!stroke.changed());
  }

  void radiusSteps() {
    QVERIFY(steppedBrushRadius(10, 1) > 10);
    QVERIFY(std::abs(steppedBrushRadius(steppedBrushRadius(10, 1), -1) - 10) < 1e-9);
    QCOMPARE(steppedBrushRadius(400, 5), 500.0);
    QCOMPARE(steppedBrushRadius(0.6, -5), 0.5);
  }
};

QTEST_APPLESS_MAIN(BrushStrokeTest)
#include "brush_stroke_test.moc"
