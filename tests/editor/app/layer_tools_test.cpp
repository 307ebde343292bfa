// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/layer_tools.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "editor/app/main_actions.h"
#include "editor/app/main_window.h"
#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

namespace {

const PaintedKind& depths() {
  return *paintedKind(kSnowDepthLayerType);
}
const PaintedKind& masks() {
  return *paintedKind(kKeepClearLayerType);
}

struct Fixture {
  explicit Fixture(const PaintedKind& kind = depths())
      : reader(std::make_shared<test::FakeReader>()), window(reader) {
    window.simulation().setAutomatic(false);
    QFile file(folder.filePath(QStringLiteral("hill.asc")));
    if (file.open(QIODevice::WriteOnly)) file.write("stands for a file");
    file.close();
    (void)edit::addAssetNode(window.document(), kTerrainType, file.fileName());
    window.viewport().setBrushLayer(kind);
    window.viewport().setTool(Viewport::Tool::Brush);
  }
  /// The terrain is read on a thread.
  bool ready() {
    return QTest::qWaitFor([this] { return window.layers().possible(); });
  }
  bool idle() {
    return QTest::qWaitFor([this] { return !window.layers().busy(); });
  }
  template <class T>
  T* find(const char* name) {
    return window.findChild<T*>(QLatin1String(name));
  }
  int steps() { return window.document().undoStack()->index(); }
  const TiledRaster<float>* painted(const NodeType& type) {
    const SceneNode* node = window.document().scene().firstOf(type);
    return node ? std::get_if<TiledRaster<float>>(&node->painted) : nullptr;
  }
  const TiledRaster<float>* shown(const PaintedKind& kind) {
    const SnapshotPointer scene = window.viewport().context().scene;
    const SceneNode* node = paintedNode(*scene, kind, {});
    return node ? std::get_if<TiledRaster<float>>(&node->painted) : nullptr;
  }

  /// NaN where there is no such layer.
  float paintedAt(const NodeType& type, int i, int j) {
    const TiledRaster<float>* layer = painted(type);
    return layer ? layer->at(i, j) : std::numeric_limits<float>::quiet_NaN();
  }
  float shownAt(const PaintedKind& kind, int i, int j) {
    const TiledRaster<float>* layer = shown(kind);
    return layer ? layer->at(i, j) : std::numeric_limits<float>::quiet_NaN();
  }

  QTemporaryDir folder;
  std::shared_ptr<test::FakeReader> reader;
  MainWindow window;
};

}  // namespace

/// Fill, filters, import, export and clearing of painted layers, as the user does it.
class LayerToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// The view shows the fill while the dialog is open; accepting is one undo step with the new layer.
  void fillShowsAPreviewAndIsOneStep() {
    Fixture f;
    QVERIFY(f.ready());
    const int before = f.steps();
    f.window.layers().fill();
    auto* dialog = f.find<FillDialog>("fillDialog");
    QVERIFY(dialog);
    f.find<QGroupBox>("fillAltitude")->setChecked(true);
    f.find<QDoubleSpinBox>("fillAltitudeFrom")->setValue(15.0);
    f.find<QDoubleSpinBox>("fillAltitudeSoft")->setValue(0.0);
    QVERIFY(f.idle());
    QTRY_VERIFY(f.shown(depths()));
    QVERIFY(std::abs(f.shownAt(depths(), 32, 32) - 0.5f) < 1e-5f);
    QVERIFY(std::isnan(f.shownAt(depths(), 0, 0)));
    QCOMPARE(f.steps(), before);
    QVERIFY(!f.painted(kSnowDepthLayerType));
    QTRY_VERIFY(f.find<QLabel>("fillExtent")->text().contains(QLatin1Char('%')));
    f.find<QPushButton>("fillAccept")->click();
    QTRY_VERIFY(f.painted(kSnowDepthLayerType));
    QCOMPARE(f.steps(), before + 1);
    QVERIFY(std::abs(f.paintedAt(kSnowDepthLayerType, 32, 32) - 0.5f) < 1e-5f);
    f.window.document().undoStack()->undo();
    QVERIFY(!f.window.document().scene().firstOf(kSnowDepthLayerType));
  }

  /// Accepting at once takes what was asked for last, though it is still being worked out.
  void acceptingWaitsForTheAnswer() {
    Fixture f;
    QVERIFY(f.ready());
    f.window.layers().fill();
    f.find<QDoubleSpinBox>("layerNumber");
    f.find<QPushButton>("fillAccept")->click();
    QTRY_VERIFY(f.painted(kSnowDepthLayerType));
    QVERIFY(std::abs(f.paintedAt(kSnowDepthLayerType, 0, 0) - 0.5f) < 1e-5f);
  }

  void cancellingTakesThePreviewAway() {
    Fixture f;
    QVERIFY(f.ready());
    const int before = f.steps();
    f.window.layers().fill();
    QTRY_VERIFY(f.shown(depths()));
    f.find<FillDialog>("fillDialog")->reject();
    QVERIFY(!f.shown(depths()));
    QCOMPARE(f.steps(), before);
  }

  void fillsJoinWhatIsThere() {
    Fixture f;
    QVERIFY(f.ready());
    const auto fill = [&](int combine) {
      f.window.layers().fill();
      f.find<QComboBox>("fillCombine")->setCurrentIndex(combine);
      f.find<QPushButton>("fillAccept")->click();
      QVERIFY(
          QTest::qWaitFor([&] { return !f.find<FillDialog>("fillDialog") && !f.window.layers().busy(); }));
    };
    fill(0);
    QTRY_VERIFY(f.painted(kSnowDepthLayerType));
    fill(2);
    QTRY_COMPARE(f.paintedAt(kSnowDepthLayerType, 3, 3), 1.0f);
    fill(1);
    QTest::qWait(50);
    QCOMPARE(f.paintedAt(kSnowDepthLayerType, 3, 3), 1.0f);
  }

  void facingsSetTheAspect() {
    FillDialog dialog(depths(), 1.0, 0.0, 100.0);
    auto* facing = dialog.findChild<QComboBox*>(QStringLiteral("fillFacing"));
    facing->setCurrentIndex(1);
    QCOMPARE(dialog.choice().rule.aspect.low, 315.0);
    QCOMPARE(dialog.choice().rule.aspect.high, 45.0);
    facing->setCurrentIndex(5);
    QCOMPARE(dialog.choice().rule.aspect.low, 135.0);
    QCOMPARE(dialog.choice().rule.aspect.high, 225.0);
    QVERIFY(!dialog.choice().rule.aspect.on);
  }

  void filtersWorkOnMasks() {
    Fixture f(masks());
    QVERIFY(f.ready());
    TiledRaster<float> dot(65, 65, 0.0f);
    dot.set(30, 30, 1.0f);
    Viewport& view = f.window.viewport();
    Q_EMIT view.editStarted();
    Q_EMIT view.layerPainted(masks(), {}, dot);
    Q_EMIT view.editFinished();
    const int before = f.steps();
    f.window.layers().filter();
#ifndef SPIN_HAS_FILTERS
    QCOMPARE(f.steps(), before);
    return;
#endif
    QVERIFY(f.find<FilterDialog>("filterDialog"));
    f.find<QComboBox>("filterKind")->setCurrentIndex(2);
    f.find<QDoubleSpinBox>("filterRadius")->setValue(8.0);
    f.find<QPushButton>("filterAccept")->click();
    QTRY_COMPARE(f.steps(), before + 1);
    QCOMPARE(f.paintedAt(kKeepClearLayerType, 32, 30), 1.0f);
    QCOMPARE(f.paintedAt(kKeepClearLayerType, 33, 30), 0.0f);
  }

  void importTellsWhatItDid() {
    Fixture f;
    QVERIFY(f.ready());
    f.reader->raster.values = Raster<float>(130, 130, 0.0, 0.0, 1.0, 51.0f);
    f.reader->raster.bits = 8;
    f.window.layers().askOpen = [](const QString&, const QString&) { return QStringLiteral("/x/mask.png"); };
    f.window.layers().importFile();
    auto* about = f.find<QLabel>("layerAbout");
    QVERIFY(about);
    QTRY_VERIFY2(about->text().contains(QStringLiteral("resampled")), qPrintable(about->text()));
    QVERIFY(about->text().contains(QStringLiteral("130 x 130")));
    f.find<QPushButton>("layerAccept")->click();
    QTRY_VERIFY(f.painted(kSnowDepthLayerType));
    QVERIFY(std::abs(f.paintedAt(kSnowDepthLayerType, 5, 5) - 0.4f) < 1e-5f);
  }

  void importThatFailsSaysWhyAndPaintsNothing() {
    Fixture f;
    QVERIFY(f.ready());
    const int before = f.steps();
    f.window.layers().askOpen = [](const QString&, const QString&) { return QStringLiteral("/x/mask.png"); };
    f.window.layers().importFile();
    auto* about = f.find<QLabel>("layerAbout");
    QTRY_VERIFY2(about->text().contains(QStringLiteral("No rasters here")), qPrintable(about->text()));
    f.find<QPushButton>("layerAccept")->click();
    QVERIFY(f.idle());
    QCOMPARE(f.steps(), before);
  }

  void exportWritesWithFormatAndRange() {
    Fixture f;
    QVERIFY(f.ready());
    QSignalSpy told(&f.window.layers(), &LayerTools::message);
    f.window.layers().askSave = [](const QString&, const QString& suggestion, const QString&) {
      return QStringLiteral("/x/") + suggestion;
    };
    f.window.layers().exportFile();
    f.find<QComboBox>("layerFormat")->setCurrentIndex(2);
    f.find<QPushButton>("layerAccept")->click();
    QTRY_COMPARE(told.count(), 1);
    QCOMPARE(f.reader->written.path, std::string("/x/snow_depth.png"));
    QCOMPARE(f.reader->written.format.bits, 16);
    QCOMPARE(f.reader->written.format.high, 2.0);
    QCOMPARE(f.reader->written.format.unit, std::string("m"));
    QVERIFY(std::holds_alternative<TiledRaster<float>>(f.reader->written.layer));
  }

  void clearingIsOneStep() {
    Fixture f(masks());
    QVERIFY(f.ready());
    Viewport& view = f.window.viewport();
    Q_EMIT view.editStarted();
    TiledRaster<float> mask(65, 65, 0.0f);
    mask.set(9, 9, 1.0f);
    Q_EMIT view.layerPainted(masks(), {}, mask);
    Q_EMIT view.editFinished();
    QCOMPARE(f.paintedAt(kKeepClearLayerType, 9, 9), 1.0f);
    const int before = f.steps();
    f.window.layers().clear();
    QCOMPARE(f.steps(), before + 1);
    QCOMPARE(f.paintedAt(kKeepClearLayerType, 9, 9), 0.0f);
    f.window.document().undoStack()->undo();
    QCOMPARE(f.paintedAt(kKeepClearLayerType, 9, 9), 1.0f);
  }

  void withoutTerrainAWordIsSaid() {
    MainWindow window(std::make_shared<test::FakeReader>());
    QSignalSpy told(&window.layers(), &LayerTools::message);
    window.layers().fill();
    window.layers().filter();
    window.layers().importFile();
    window.layers().exportFile();
    QCOMPARE(told.count(), 4);
  }
};

QTEST_MAIN(LayerToolsTest)
#include "layer_tools_test.moc"
