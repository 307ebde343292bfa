// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/brush_stroke.h"

#include <QTest>
#include <cmath>

#include "core/nodes/ground_nodes.h"
#include "tests/editor/support/strict.h"

using namespace spin;

namespace {

constexpr std::uint8_t kOld = kUnpaintedGround;
constexpr std::uint8_t kNew = 4;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

Raster<float> grid(int width = 200, int height = 150, double cell = 2.0) {
  return Raster<float>(width, height, 10.0, -20.0, cell, 0.0f);
}

TiledRaster<std::uint8_t> typesOf(const Raster<float>& raster) {
  return {raster.width, raster.height, kOld};
}

StrokeTask task(double radius, double value, BrushMode mode = BrushMode::Paint) {
  StrokeTask task;
  task.mode = mode;
  task.tip.radius = radius;
  task.value = value;
  return task;
}

BrushStroke typeStroke(const Raster<float>& raster, double radius, std::uint8_t value = kNew) {
  return {typesOf(raster), raster, *paintedKind(kGroundTypeLayerType), task(radius, value)};
}

const TiledRaster<std::uint8_t>& types(const BrushStroke& stroke) {
  return std::get<TiledRaster<std::uint8_t>>(stroke.layer());
}

const TiledRaster<float>& measures(const BrushStroke& stroke) {
  return std::get<TiledRaster<float>>(stroke.layer());
}

BrushStroke depthStroke(const Raster<float>& raster, const StrokeTask& task, float before = kNone) {
  return {TiledRaster<float>(raster.width, raster.height, before), raster, *paintedKind(kSnowDepthLayerType),
          task};
}

bool near(double a, double b, double tolerance = 1e-5) {
  return std::abs(a - b) <= tolerance;
}

}  // namespace

class BrushStrokeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// Exactly the cells whose centres lie within the radius are painted.
  void dabIsARoundDisc() {
    const Raster<float> raster = grid();
    BrushStroke stroke = typeStroke(raster, 9.0);
    stroke.moveTo({101.0, 77.0});
    QVERIFY(stroke.changed());
    for (int j = 0; j < raster.height; ++j)
      for (int i = 0; i < raster.width; ++i) {
        const double distance = std::hypot(raster.x(i) - 101.0, raster.y(j) - 77.0);
        if (std::abs(distance - 9.0) < 1e-9) continue;
        const bool inside = distance < 9.0 || (i == raster.column(101.0) && j == raster.row(77.0));
        QCOMPARE(types(stroke).at(i, j), inside ? kNew : kOld);
      }
  }

  /// A fast pointer leaves no gaps: the way between two positions is painted at full width.
  void fastStrokesHaveNoGaps() {
    const Raster<float> raster = grid();
    BrushStroke stroke = typeStroke(raster, 5.0);
    stroke.moveTo({30.0, 0.0});
    stroke.moveTo({330.0, 120.0});
    for (int k = 0; k <= 300; ++k) {
      const double t = k / 300.0;
      QCOMPARE(types(stroke).at(raster.column(30.0 + 300.0 * t), raster.row(120.0 * t)), kNew);
    }
  }

  /// A brush smaller than a cell still paints the cell under the pointer.
  void tinyBrushPaintsOneCell() {
    const Raster<float> raster = grid();
    BrushStroke stroke = typeStroke(raster, 0.1);
    stroke.moveTo({50.7, 30.6});
    int painted = 0;
    for (int j = 0; j < raster.height; ++j)
      for (int i = 0; i < raster.width; ++i) painted += types(stroke).at(i, j) == kNew ? 1 : 0;
    QCOMPARE(painted, 1);
    QCOMPARE(types(stroke).at(raster.column(50.7), raster.row(30.6)), kNew);
    BrushStroke depth = depthStroke(raster, task(0.1, 0.75));
    depth.moveTo({50.7, 30.6});
    QVERIFY(near(measures(depth).at(raster.column(50.7), raster.row(30.6)), 0.75));
  }

  /// Off the edge of the terrain, even far off, nothing breaks.
  void paintsAcrossTheEdge() {
    const Raster<float> raster = grid();
    BrushStroke stroke = typeStroke(raster, 20.0);
    stroke.moveTo({-1e7, -1e7});
    QVERIFY(!stroke.changed());
    stroke.moveTo({10.0, -20.0});
    QVERIFY(stroke.changed());
    QCOMPARE(types(stroke).at(0, 0), kNew);
    QCOMPARE(types(stroke).at(199, 149), kOld);
  }

  /// Tiles the stroke does not touch stay shared with the layer before, so an undo step is small; the layer
  /// before is not changed.
  void untouchedTilesStayShared() {
    const Raster<float> raster = grid();
    const TiledRaster<std::uint8_t> before = typesOf(raster);
    BrushStroke stroke(before, raster, *paintedKind(kGroundTypeLayerType), task(5.0, kNew));
    stroke.moveTo({20.0, -10.0});
    int changed = 0;
    for (std::size_t t = 0; t < before.tileCount(); ++t)
      if (types(stroke).tile(t) != before.tile(t)) ++changed;
    QCOMPARE(changed, 1);
    QCOMPARE(before.at(5, 5), kOld);
  }

  /// Painting what is there already is no change.
  void paintingTheSameIsNoChange() {
    const Raster<float> raster = grid();
    BrushStroke stroke = typeStroke(raster, 9.0, kOld);
    stroke.moveTo({101.0, 77.0});
    QVERIFY(!stroke.changed());
    BrushStroke depth = depthStroke(raster, task(9.0, 0.5), 0.5f);
    depth.moveTo({101.0, 77.0});
    QVERIFY(!depth.changed());
  }

  /// The hard core has the strength; outside it falls to nothing at the radius, from what holds there.
  void measuresHaveASoftEdge() {
    const Raster<float> raster = grid();
    StrokeTask soft = task(40.0, 2.0);
    soft.tip.hardness = 0.25;
    soft.tip.strength = 0.5;
    soft.base = 1.0;
    BrushStroke stroke = depthStroke(raster, soft);
    stroke.moveTo({200.0, 100.0});
    const auto at = [&](double x) { return measures(stroke).at(raster.column(x), raster.row(100.0)); };
    QVERIFY(near(at(200.0), 1.5));
    QVERIFY(near(at(208.0), 1.5));
    QVERIFY(near(at(226.0), 1.0 + 0.5 * soft.tip.weight(26.0)));
    QVERIFY(at(236.0) < at(226.0) && at(236.0) > 1.0f);
    QVERIFY(std::isnan(at(242.0)));
  }

  /// Neither slowness nor going over it again within a stroke adds anything.
  void aStrokeDoesNotPileUp() {
    const Raster<float> raster = grid();
    StrokeTask half = task(10.0, 1.0);
    half.tip.strength = 0.5;
    BrushStroke once = depthStroke(raster, half, 0.0f), often = depthStroke(raster, half, 0.0f);
    once.moveTo({50.0, 50.0});
    once.moveTo({90.0, 50.0});
    for (int k = 0; k <= 80; ++k) often.moveTo({50.0 + 0.5 * k, 50.0});
    for (int k = 80; k >= 0; --k) often.moveTo({50.0 + 0.5 * k, 50.0});
    for (double x = 42.0; x < 98.0; x += 2.0)
      QVERIFY(near(measures(once).at(raster.column(x), raster.row(50.0)),
                   measures(often).at(raster.column(x), raster.row(50.0)), 2e-2));
    QVERIFY(near(measures(often).at(raster.column(70.0), raster.row(50.0)), 0.5));
  }

  void pressureThinsAndNarrows() {
    const Raster<float> raster = grid();
    BrushStroke stroke = depthStroke(raster, task(20.0, 1.0), 0.0f);
    stroke.moveTo({100.0, 60.0}, {0.25, 0.5});
    QVERIFY(near(measures(stroke).at(raster.column(100.0), raster.row(60.0)), 0.25));
    QCOMPARE(measures(stroke).at(raster.column(112.0), raster.row(60.0)), 0.0f);
  }

  void erasingLeadsBackToNothing() {
    const Raster<float> raster = grid();
    StrokeTask erase = task(20.0, 0.0, BrushMode::Erase);
    BrushStroke stroke = depthStroke(raster, erase, 1.0f);
    stroke.moveTo({100.0, 60.0});
    QVERIFY(std::isnan(measures(stroke).at(raster.column(100.0), raster.row(60.0))));
    const float edge = measures(stroke).at(raster.column(116.0), raster.row(60.0));
    QVERIFY(edge > 0.0f && edge < 1.0f);
    BrushStroke mask(TiledRaster<float>(raster.width, raster.height, 0.8f), raster,
                     *paintedKind(kKeepClearLayerType), erase);
    mask.moveTo({100.0, 60.0});
    QCOMPARE(measures(mask).at(raster.column(100.0), raster.row(60.0)), 0.0f);
    BrushStroke types(TiledRaster<std::uint8_t>(raster.width, raster.height, 3), raster,
                      *paintedKind(kGroundTypeLayerType), erase);
    types.moveTo({100.0, 60.0});
    QCOMPARE(::types(types).at(raster.column(100.0), raster.row(60.0)), kUnpaintedGround);
  }

  /// A step becomes a ramp; its mean stays; where nothing is painted nothing comes.
  void smoothingMakesARampOfAStep() {
    const Raster<float> raster = grid();
    TiledRaster<float> step(raster.width, raster.height, kNone);
    for (int j = 0; j < raster.height; ++j)
      for (int i = 20; i < raster.width; ++i) step.set(i, j, i < 100 ? 0.0f : 1.0f);
    BrushStroke stroke(step, raster, *paintedKind(kSnowDepthLayerType), task(32.0, 0.0, BrushMode::Smooth));
    stroke.moveTo({raster.x(100), raster.y(70)});
    const auto at = [&](int i) { return measures(stroke).at(i, 70); };
    for (int i = 93; i < 107; ++i) QVERIFY(at(i) <= at(i + 1));
    QVERIFY(near(at(99) + at(100), 1.0, 1e-4));
    QVERIFY(at(99) > 0.2f && at(99) < 0.5f);
    QCOMPARE(at(60), 0.0f);
    BrushStroke rim(step, raster, *paintedKind(kSnowDepthLayerType), task(32.0, 0.0, BrushMode::Smooth));
    rim.moveTo({raster.x(20), raster.y(70)});
    QVERIFY(std::isnan(measures(rim).at(19, 70)));
    QCOMPARE(measures(rim).at(20, 70), 0.0f);
  }

  /// Single cells of another type vanish, straight borders stay.
  void smoothingTypesTakesTheCommonest() {
    const Raster<float> raster = grid();
    TiledRaster<std::uint8_t> layer(raster.width, raster.height, 2);
    for (int j = 0; j < raster.height; ++j)
      for (int i = 100; i < raster.width; ++i) layer.set(i, j, 5);
    layer.set(90, 70, 5);
    layer.set(106, 70, 3);
    BrushStroke stroke(layer, raster, *paintedKind(kGroundTypeLayerType), task(30.0, 0.0, BrushMode::Smooth));
    stroke.moveTo({raster.x(100), raster.y(70)});
    QCOMPARE(int{types(stroke).at(90, 70)}, 2);
    QCOMPARE(int{types(stroke).at(106, 70)}, 5);
    QCOMPARE(int{types(stroke).at(99, 70)}, 2);
    QCOMPARE(int{types(stroke).at(100, 70)}, 5);
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
