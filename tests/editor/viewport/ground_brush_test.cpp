// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QPointingDevice>
#include <QSignalSpy>
#include <QTabletEvent>
#include <QTest>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "editor/viewport/overlay_painter.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

namespace {

const PaintedKind& depths() {
  return *paintedKind(kSnowDepthLayerType);
}

struct Fixture {
  Fixture() {
    auto scene = std::make_shared<SceneSnapshot>(*test::hillSnapshot());
    for (const char* id : {"road", "yard"}) scene->nodes.push_back(makeNode(kKeepClearLayerType, id, id));
    viewport.resize(900, 700);
    viewport.setScene(scene);
    viewport.setCamera({{128, -80, 140}, {128, 128, 15}, 45});
    viewport.show();
    viewport.setTool(Viewport::Tool::Brush);
    QObject::connect(&viewport, &Viewport::layerPainted, &viewport,
                     [this](const PaintedKind& kind, const std::string& node, const PaintedLayer& painted) {
                       paintedOn = &kind;
                       paintedNode = node;
                       layer = painted;
                     });
  }
  QPoint pixel(double x, double y) const {
    const TerrainSurface surface(viewport.context().scene->terrain->heights);
    const auto p = viewport.context().view.project({x, y, surface.heightAt(x, y).value_or(0.0)});
    return p ? QPoint(static_cast<int>(std::lround(p->x)), static_cast<int>(std::lround(p->y)))
             : QPoint(-1, -1);
  }
  void move(QPoint to, Qt::MouseButtons held = {}, Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(QEvent::MouseMove, to, viewport.surface()->mapToGlobal(to), Qt::NoButton, held, keys);
    QCoreApplication::sendEvent(viewport.surface(), &event);
  }
  void click(double x, double y, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(viewport.surface(), Qt::LeftButton, keys, pixel(x, y));
  }
  void key(QEvent::Type type, Qt::KeyboardModifiers keys = {}) {
    QKeyEvent event(type, Qt::Key_F, keys);
    QCoreApplication::sendEvent(viewport.surface(), &event);
  }
  void pen(QEvent::Type type, QPoint at, double pressure) {
    static const QPointingDevice stylus(QStringLiteral("pen"), 7, QInputDevice::DeviceType::Stylus,
                                        QPointingDevice::PointerType::Pen, QInputDevice::Capability::Pressure,
                                        1, 1);
    const bool down = type != QEvent::TabletRelease;
    QTabletEvent event(type, &stylus, at, viewport.surface()->mapToGlobal(at), pressure, 0, 0, 0, 0, 0, {},
                       type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                       down ? Qt::LeftButton : Qt::NoButton);
    QCoreApplication::sendEvent(viewport.surface(), &event);
    QVERIFY(event.isAccepted());
  }
  float depthAt(double x, double y) const {
    const auto& reals = std::get<TiledRaster<float>>(layer);
    return reals.at(static_cast<int>(std::lround(x / 4.0)), static_cast<int>(std::lround(y / 4.0)));
  }

  Viewport viewport;
  const PaintedKind* paintedOn = nullptr;
  std::string paintedNode;
  PaintedLayer layer;
};

}  // namespace

/// The brush on all painted layers: values, modes, keys and pens, by synthetic events.
class GroundBrushTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  void everyLayerHasItsOwnValue() {
    Fixture f;
    f.viewport.setBrushLayer(depths());
    f.viewport.setBrushValue(1.25);
    f.viewport.setBrushLayer(*paintedKind(kGroundTemperatureLayerType));
    f.viewport.setBrushValue(270.0);
    f.viewport.setBrushLayer(depths());
    QCOMPARE(f.viewport.brush().value(), 1.25);
    f.viewport.setBrushValue(1e9);
    QCOMPARE(f.viewport.brush().value(), depths().most);
  }

  void paintsMeasuresUnderThePointer() {
    Fixture f;
    f.viewport.setBrushLayer(depths());
    f.viewport.setBrushValue(0.75);
    f.viewport.setBrushTip({20.0, 1.0, 1.0});
    f.click(60, 60);
    QCOMPARE(f.paintedOn, &depths());
    QVERIFY(f.paintedNode.empty());
    QVERIFY(std::abs(f.depthAt(60, 60) - 0.75f) < 1e-5f);
    QVERIFY(std::isnan(f.depthAt(60, 120)));
  }

  /// A selected mask is what is painted; without a selection the chosen layer is.
  void theSelectedNodeIsPainted() {
    Fixture f;
    f.viewport.setBrushLayer(depths());
    f.viewport.setSelected("yard");
    f.click(60, 60);
    QCOMPARE(f.paintedNode, std::string("yard"));
    QCOMPARE(f.paintedOn, paintedKind(kKeepClearLayerType));
    f.viewport.setSelected("cube");
    QCOMPARE(&f.viewport.brush().kind(), &depths());
  }

  /// The stroke begins with what the document has, of which the snapshot may be behind.
  void strokesBeginWithTheDocumentsLayer() {
    Fixture f;
    f.viewport.setBrushLayer(depths());
    f.viewport.layerSource = [](const PaintedKind&, const std::string&) {
      return std::optional<PaintedLayer>(TiledRaster<float>(65, 65, 3.0f));
    };
    f.click(60, 60);
    QCOMPARE(f.depthAt(200, 200), 3.0f);
  }

  void controlPicksAndShiftSmooths() {
    Fixture f;
    f.viewport.setBrushLayer(depths());
    TiledRaster<float> step(65, 65, 0.25f);
    for (int j = 0; j < 65; ++j)
      for (int i = 15; i < 65; ++i) step.set(i, j, 2.0f);
    f.viewport.layerSource = [&](const PaintedKind&, const std::string&) {
      return std::optional<PaintedLayer>(step);
    };
    f.viewport.setBrushTip({24.0, 1.0, 1.0});
    f.click(60, 60, Qt::ShiftModifier);
    QVERIFY(f.depthAt(60, 60) > 0.5f && f.depthAt(60, 60) < 1.9f);
    QCOMPARE(f.depthAt(120, 120), 2.0f);
    // Nothing is painted in the snapshot: what holds there is no snow.
    f.paintedOn = nullptr;
    f.click(60, 60, Qt::ControlModifier);
    QVERIFY(!f.paintedOn);
    QCOMPARE(f.viewport.brush().value(), 0.0);
  }

  /// The eyedropper takes the value and goes back to painting.
  void thePickModePaintsNext() {
    Fixture f;
    auto scene = std::make_shared<SceneSnapshot>(*f.viewport.context().scene);
    SceneNode node = makeNode(kGroundTemperatureLayerType, "warm", "warm");
    TiledRaster<float> kelvin(65, 65, std::numeric_limits<float>::quiet_NaN());
    kelvin.set(15, 15, 281.5f);
    node.painted = kelvin;
    scene->nodes.push_back(node);
    f.viewport.setScene(scene);
    f.viewport.setBrushLayer(*paintedKind(kGroundTemperatureLayerType));
    f.viewport.setBrushMode(BrushMode::Pick);
    f.click(60, 60);
    QCOMPARE(f.viewport.brush().value(), 281.5);
    QCOMPARE(f.viewport.brush().mode(), BrushMode::Paint);
    f.click(160, 60, Qt::ControlModifier);
    QCOMPARE(f.viewport.brush().value(), 273.15);
  }

  /// F and the pointer change the radius, with Shift the strength; letting go keeps it, Escape does not.
  void theKeyFChangesTheTip() {
    Fixture f;
    f.viewport.setBrushLayer(depths());
    f.viewport.setBrushTip({10.0, 0.5, 1.0});
    f.move(f.pixel(60, 60));
    const QPoint from = f.pixel(60, 60);
    f.key(QEvent::KeyPress);
    f.move(from + QPoint(100, 0));
    QVERIFY(std::abs(f.viewport.brush().tip().radius - 20.0) < 1e-9);
    f.key(QEvent::KeyRelease);
    f.move(from + QPoint(150, 0));
    QVERIFY(std::abs(f.viewport.brush().tip().radius - 20.0) < 1e-9);

    f.move(from);
    f.key(QEvent::KeyPress, Qt::ShiftModifier);
    f.move(from - QPoint(100, 0));
    QVERIFY(std::abs(f.viewport.brush().tip().strength - 0.5) < 1e-9);
    QTest::keyClick(f.viewport.surface(), Qt::Key_Escape);
    QCOMPARE(f.viewport.brush().tip().strength, 1.0);

    // Tapped: the next click confirms and paints nothing.
    f.move(from);
    f.key(QEvent::KeyPress);
    f.key(QEvent::KeyRelease);
    f.move(from - QPoint(100, 0));
    QTest::mouseClick(f.viewport.surface(), Qt::LeftButton, {}, from - QPoint(100, 0));
    QVERIFY(std::abs(f.viewport.brush().tip().radius - 10.0) < 1e-9);
    QVERIFY(!f.paintedOn);
  }

  void aPenPaintsByItsPressure() {
    Fixture f;
    f.viewport.setBrushLayer(depths());
    f.viewport.setBrushValue(1.0);
    f.viewport.setBrushTip({20.0, 1.0, 1.0});
    QSignalSpy finished(&f.viewport, &Viewport::editFinished);
    f.pen(QEvent::TabletPress, f.pixel(60, 60), 0.25);
    QVERIFY(std::abs(f.depthAt(60, 60) - 0.25f) < 1e-5f);
    f.pen(QEvent::TabletMove, f.pixel(120, 60), 0.75);
    QVERIFY(std::abs(f.depthAt(120, 60) - 0.75f) < 1e-5f);
    f.pen(QEvent::TabletRelease, f.pixel(120, 60), 0.0);
    QCOMPARE(finished.count(), 1);
    f.viewport.setBrushPressure(false, true);
    f.pen(QEvent::TabletPress, f.pixel(60, 160), 0.5);
    QVERIFY(std::abs(f.depthAt(60, 160) - 1.0f) < 1e-5f);
    QVERIFY(std::isnan(f.depthAt(76, 160)));
    f.pen(QEvent::TabletRelease, f.pixel(60, 160), 0.0);
    // The mouse knows no pressure.
    f.click(200, 60);
    QVERIFY(std::abs(f.depthAt(200, 60) - 1.0f) < 1e-5f);
  }

  /// What is painted shows while the brush is the tool.
  void theGroundShowsThePaintedLayer() {
    Fixture f;
    f.viewport.setBrushLayer(depths());
    QCOMPARE(f.viewport.shownGround(), GroundDisplay::SnowDepth);
    f.viewport.setSelected("road");
    QCOMPARE(f.viewport.shownGround(), GroundDisplay::KeepClear);
    f.viewport.setTool(Viewport::Tool::Select);
    QCOMPARE(f.viewport.shownGround(), GroundDisplay::Natural);
    f.viewport.setTool(Viewport::Tool::Brush);
    f.viewport.setShowPainted(false);
    QCOMPARE(f.viewport.shownGround(), GroundDisplay::Natural);
  }

  void aPreviewStandsInForTheLayer() {
    Fixture f;
    const auto painted = [&](const PaintedKind& kind, const char* id) {
      const SnapshotPointer scene = f.viewport.context().scene;
      const SceneNode* node = paintedNode(*scene, kind, id);
      return node ? node->painted : PaintedLayer();
    };
    const PaintedLayer layer = TiledRaster<float>(65, 65, 0.5f);
    f.viewport.setPreview(Viewport::LayerPreview{&depths(), {}, layer});
    QVERIFY(painted(depths(), "") == layer);
    QCOMPARE(f.viewport.shownGround(), GroundDisplay::SnowDepth);
    f.viewport.setPreview(Viewport::LayerPreview{paintedKind(kKeepClearLayerType), "yard", layer});
    QVERIFY(painted(*paintedKind(kKeepClearLayerType), "yard") == layer);
    QVERIFY(painted(*paintedKind(kKeepClearLayerType), "road") == PaintedLayer());
    f.viewport.setPreview(std::nullopt);
    QVERIFY(painted(*paintedKind(kKeepClearLayerType), "yard") == PaintedLayer());
  }

  void valuesAreToldInTheirUnits() {
    QLocale::setDefault(QLocale::c());
    QCOMPARE(paintedText(*paintedKind(kGroundTemperatureLayerType), 263.15), QStringLiteral("-10.0 \u00b0C"));
    QCOMPARE(paintedText(depths(), 0.5), QStringLiteral("0.50 m"));
    QCOMPARE(paintedText(*paintedKind(kKeepClearLayerType), 0.25), QStringLiteral("25 %"));
    QCOMPARE(paintedText(*paintedKind(kGroundTypeLayerType), 4), QStringLiteral("Rock"));
  }
};

QTEST_MAIN(GroundBrushTest)
#include "ground_brush_test.moc"
