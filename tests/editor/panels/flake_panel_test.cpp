// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/flake_panel.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>
#include <utility>

#include "editor/commands/edits.h"
#include "editor/document/scene_document.h"
#include "editor/panels/value_editor.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;

class FlakePanelTest : public QObject {
  Q_OBJECT
 private:
  std::shared_ptr<FakeAssetReader> m_reader = std::make_shared<FakeAssetReader>();

 private Q_SLOTS:
  void theFlakeIsSeenGrowing_data();
  void theFlakeIsSeenGrowing();
  void growthStopsAndTheWindowIsNeverHeldUp();
  void onlyWhatCountsIsShown();
  void applyingIsOneUndoStep();
  void theScenesFlakeIsTakenOver();
};

namespace {

template <class Widget>
Widget* find(FlakePanel& panel, const char* name) {
  return panel.findChild<Widget*>(QLatin1String(name));
}

double lightOf(const QImage& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
  return sum;
}

}  // namespace

void FlakePanelTest::theFlakeIsSeenGrowing_data() {
  QTest::addColumn<int>("growth");
  QTest::newRow("free") << static_cast<int>(FlakeGrowth::Free);
  QTest::newRow("six") << static_cast<int>(FlakeGrowth::SixArms);
  QTest::newRow("crystal") << static_cast<int>(FlakeGrowth::Crystal);
}

void FlakePanelTest::theFlakeIsSeenGrowing() {
  QFETCH(int, growth);
  SceneDocument document(m_reader);
  FlakePanel panel(&document);
  panel.show();
  std::vector<FlakeStage> stages;
  connect(&panel.watch(), &FlakeWatch::grown, this,
          [&](const FlakeStage& stage) { stages.push_back(stage); });
  QSignalSpy finished(&panel.watch(), &FlakeWatch::finished);
  FlakeNode node;
  node.growth = static_cast<FlakeGrowth>(growth);
  node.largest = 0.8e-3;
  node.cells = 40;
  panel.watch().start(node);
  QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, 30000);
  QVERIFY2(finished.front().front().toString().isEmpty(), qPrintable(finished.front().front().toString()));
  QVERIFY(stages.size() >= 5);
  for (std::size_t k = 1; k < stages.size(); ++k) {
    QVERIFY(stages[k].share >= stages[k - 1].share);
    QVERIFY(stages[k].particles >= stages[k - 1].particles);
  }
  QVERIFY(lightOf(stages.back().picture) > 3.0 * lightOf(stages.front().picture));
  QVERIFY(std::abs(stages.back().radius - 0.8e-3) < 0.05e-3);
  if (node.growth != FlakeGrowth::Crystal)
    QVERIFY(stages.back().dimension > 1.4 && stages.back().dimension < 2.0);
  QVERIFY(find<QLabel>(panel, "flakeMeasures")->text().contains(QStringLiteral("0.8")));
  QVERIFY(!find<QLabel>(panel, "flakePicture")->pixmap(Qt::ReturnByValue).isNull());
}

void FlakePanelTest::growthStopsAndTheWindowIsNeverHeldUp() {
  SceneDocument document(m_reader);
  FlakePanel panel(&document);
  panel.show();
  auto* grow = find<QPushButton>(panel, "flakeGrow");
  QSignalSpy grown(&panel.watch(), &FlakeWatch::grown);
  QTest::mouseClick(grow, Qt::LeftButton);
  QVERIFY(panel.watch().running());
  QTRY_VERIFY_WITH_TIMEOUT(grown.size() >= 2, 30000);
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(grow, Qt::LeftButton);
  QVERIFY2(clock.elapsed() < 100, "stopping waits for nothing");
  QTRY_VERIFY_WITH_TIMEOUT(!panel.watch().running(), 10000);
}

void FlakePanelTest::onlyWhatCountsIsShown() {
  SceneDocument document(m_reader);
  FlakePanel panel(&document);
  panel.show();
  const auto shown = [&](const char* id) {
    return find<ValueEditor>(panel, (std::string("flake_") + id).c_str())->isVisibleTo(&panel);
  };
  QVERIFY(shown("landings") && shown("particles") && !shown("crystal_form"));
  auto* growth = find<ValueEditor>(panel, "flake_growth");
  Q_EMIT growth->edited(static_cast<std::int64_t>(FlakeGrowth::Crystal), false);
  QVERIFY(!shown("landings") && !shown("particles") && shown("crystal_form"));
  Q_EMIT growth->edited(static_cast<std::int64_t>(FlakeGrowth::Free), false);
  QVERIFY(!shown("landings") && shown("particles") && !shown("crystal_form"));
  for (const QWidget* widget : panel.findChildren<QWidget*>())
    if (widget->objectName().startsWith(QLatin1String("flake")))
      QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
}

void FlakePanelTest::applyingIsOneUndoStep() {
  SceneDocument document(m_reader);
  FlakePanel panel(&document);
  Q_EMIT find<ValueEditor>(panel, "flake_growth")
      ->edited(static_cast<std::int64_t>(FlakeGrowth::Crystal), false);
  Q_EMIT find<ValueEditor>(panel, "flake_seed")->edited(std::int64_t{7}, false);
  QVERIFY(!document.scene().firstOf(kFlakeType));
  const int steps = document.undoStack()->count();
  find<QPushButton>(panel, "flakeApply")->click();
  const SceneNode* node = document.scene().firstOf(kFlakeType);
  QVERIFY(node);
  QCOMPARE(node->as<FlakeNode>()->growth, FlakeGrowth::Crystal);
  QCOMPARE(node->as<FlakeNode>()->seed, std::int64_t{7});
  QCOMPARE(document.undoStack()->count(), steps + 1);
  document.undoStack()->undo();
  QVERIFY(!document.scene().firstOf(kFlakeType));
  document.undoStack()->redo();
  QVERIFY(document.scene().firstOf(kFlakeType));
}

void FlakePanelTest::theScenesFlakeIsTakenOver() {
  SceneDocument document(m_reader);
  FlakePanel panel(&document);
  const auto id = edit::addNode(document, kFlakeType, QStringLiteral("Flakes"));
  QVERIFY(id.ok());
  QVERIFY(edit::setValues(document, *id, {{"landings", std::int64_t{3}}}).ok());
  QCOMPARE(panel.settings().landings, 3);
  // What is not applied yet outlives edits of other nodes.
  Q_EMIT find<ValueEditor>(panel, "flake_seed")->edited(std::int64_t{9}, false);
  QVERIFY(edit::setValues(document, "weather", {{"wind_speed_m_s", 3.0}}).ok());
  QCOMPARE(panel.settings().seed, std::int64_t{9});
}

QTEST_MAIN(FlakePanelTest)
#include "flake_panel_test.moc"
