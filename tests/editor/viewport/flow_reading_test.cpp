// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/flow_reading.h"

#include <QTest>

#include "core/nodes/flow_nodes.h"
#include "editor/viewport/scene_picker.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"
#include "tests/render/flow_parts.h"

using namespace spin;

namespace {

/// 4 m x 4 m x 2 m of flow on level ground about the origin, with a speed of 3 m/s and 300 kg/m3.
FramePointer block() {
  ParticleSet set = test::particleBlock({-2, -2, 0}, {2, 2, 2}, 0.5, 300.0);
  for (std::size_t k = 0; k < set.size(); ++k) set.attributes[0].values[3 * k] = 3.0f;
  auto frame = std::make_shared<Frame>(*test::flowFrame(set));
  frame->info.figures["flow_spacing_m"] = 0.5;
  return frame;
}

ViewFrame above(double height) {
  return {RenderCamera{{0.01, 0.0, height}, {0.0, 0.0, 0.0}, 40.0}, 400, 400};
}

SceneSnapshot showing(FlowDisplay display) {
  auto settings = std::make_shared<RenderNode>();
  settings->flowDisplay = display;
  SceneNode node = makeNode(kRenderType, "render", "Pictures");
  node.data = settings;
  SceneSnapshot scene;
  scene.nodes.push_back(std::move(node));
  return scene;
}

}  // namespace

/// What flows under the pointer, and where flow is without terrain.
class FlowReadingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// The uppermost particle counts, with its height above the ground.
  void theSurfaceIsRead() {
    const FramePointer frame = block();
    const auto reading = readFlow(SceneSnapshot(), frame.get(), 0.0, above(10.0), {200, 200});
    QVERIFY(reading);
    QVERIFY(std::abs(reading->point.z - 1.75) < 1e-5);
    QVERIFY(std::abs(reading->speed - 3.0) < 1e-5);
    QVERIFY(std::abs(reading->density - 300.0) < 1e-5);
    QVERIFY(reading->high && std::abs(*reading->high - 2.0) < 1e-5);
    const QString text = readingText(*reading);
    QVERIFY2(text.contains(QStringLiteral("m/s")) && text.contains(QStringLiteral("300 kg/m")),
             qPrintable(text));
    QVERIFY(text.contains(QLocale().toString(2.0, 'f', 2)));
  }

  void besideTheFlowIsNothing() {
    const FramePointer frame = block();
    QVERIFY(!readFlow(SceneSnapshot(), frame.get(), 0.0, above(10.0), {5, 5}));
    QVERIFY(!readFlow(SceneSnapshot(), nullptr, 0.0, above(10.0), {200, 200}));
    QVERIFY(!readFlow(SceneSnapshot(), std::make_shared<Frame>().get(), 0.0, above(10.0), {200, 200}));
  }

  /// From 2 km a particle is a tenth of a pixel: the pointer need not meet one.
  void farAwayTheNearestCounts() {
    const FramePointer frame = block();
    QVERIFY(readFlow(SceneSnapshot(), frame.get(), 0.0, above(2000.0), {201, 201}));
    QVERIFY(!readFlow(SceneSnapshot(), frame.get(), 0.0, above(2000.0), {210, 200}));
  }

  /// What the colours show is told too.
  void theShownValueIsRead() {
    const FramePointer frame = block();
    const SceneSnapshot scene = showing(FlowDisplay::Neighbours);
    const auto reading = readFlow(scene, frame.get(), 0.0, above(10.0), {200, 200});
    QVERIFY(reading);
    QCOMPARE(reading->value, 30.0);
    QVERIFY(readingText(*reading).endsWith(QLocale().toString(30.0, 'f', 1)));
    const auto plain = readFlow(showing(FlowDisplay::Speed), frame.get(), 0.0, above(10.0), {200, 200});
    QVERIFY(!readingText(*plain).contains(QStringLiteral("30 ")) ||
            readingText(*plain).contains(QStringLiteral("300")));
  }

  /// A scene of water in a tank has a place, and is not taken for an empty one.
  void flowWithoutTerrainHasAPlace() {
    auto column = std::make_shared<AvalancheReleaseNode>();
    column->depth = 1.5;
    SceneNode release = makeNode(kAvalancheReleaseType, "column", "Column");
    release.data = column;
    SceneSnapshot scene;
    scene.nodes.push_back(release);
    QVERIFY(showsNothing(scene));
    QVERIFY(sceneBounds(scene, 0.0).empty());
    column = std::make_shared<AvalancheReleaseNode>(*column);
    column->outline = {{1, 1}, {3, 1}, {3, 2}};
    scene.nodes[0].data = column;
    QVERIFY(!showsNothing(scene));
    QCOMPARE(sceneBounds(scene, 0.0).max, (Vec3d{3, 2, 1.5}));
    auto tank = std::make_shared<FlowSettingsNode>();
    tank->closed = true;
    tank->domainMax = {10, 4, 8};
    SceneNode settings = makeNode(kFlowSettingsType, "flow_settings", "Flow");
    settings.data = tank;
    scene.nodes.push_back(settings);
    QCOMPARE(sceneBounds(scene, 0.0).max, (Vec3d{10, 4, 1.5}));
    scene.nodes[0].enabled = false;
    QVERIFY(showsNothing(scene));
  }
};

QTEST_MAIN(FlowReadingTest)
#include "flow_reading_test.moc"
