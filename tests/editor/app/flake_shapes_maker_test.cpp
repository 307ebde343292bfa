// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/flake_shapes_maker.h"

#include <QFileInfo>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/nodes/weather_nodes.h"
#include "editor/commands/edits.h"
#include "editor/document/scene_document.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;
using Atlas = std::shared_ptr<const FlakeAtlas>;

class FlakeShapesMakerTest : public QObject {
  Q_OBJECT
 private:
  std::shared_ptr<FakeAssetReader> m_reader = std::make_shared<FakeAssetReader>();

 private Q_SLOTS:
  void shapesFollowTheScene();
  void growthCanBeStopped();
  void aSavedSceneKeepsItsShapes();
};

namespace {

void addSnow(SceneDocument& document) {
  QVERIFY(edit::addNode(document, kSnowfallType, QStringLiteral("Snow")).ok());
}
std::string addSmallFlakes(SceneDocument& document) {
  const auto id = edit::addNode(document, kFlakeType, QStringLiteral("Flakes"));
  const Status set = edit::setValues(
      document, *id,
      {{"shapes", std::int64_t{2}}, {"largest_radius_m", 0.5e-3}, {"detail", std::int64_t{0}}});
  return set ? *id : std::string();
}

}  // namespace

void FlakeShapesMakerTest::shapesFollowTheScene() {
  SceneDocument document(m_reader);
  FlakeShapesMaker maker(&document);
  std::vector<Atlas> told;
  connect(&maker, &FlakeShapesMaker::ready, this, [&](const Atlas& atlas) { told.push_back(atlas); });
  const std::string id = addSmallFlakes(document);
  QVERIFY(!id.empty());
  QTest::qWait(2 * FlakeShapesMaker::kDebounceMilliseconds);
  QVERIFY2(told.empty() && !maker.growing(), "without snowfall nothing grows");
  addSnow(document);
  QTRY_COMPARE_WITH_TIMEOUT(told.size(), std::size_t{1}, 30000);
  QCOMPARE(told[0]->flakes(), 2);
  QVERIFY(edit::setValues(document, id, {{"shapes", std::int64_t{3}}}).ok());
  QTRY_COMPARE_WITH_TIMEOUT(told.size(), std::size_t{2}, 30000);
  QCOMPARE(told[1]->flakes(), 3);
  // What does not change the shapes grows nothing.
  QVERIFY(edit::setValues(document, "weather", {{"wind_speed_m_s", 3.0}}).ok());
  QTest::qWait(2 * FlakeShapesMaker::kDebounceMilliseconds);
  QCOMPARE(told.size(), std::size_t{2});
}

void FlakeShapesMakerTest::growthCanBeStopped() {
  SceneDocument document(m_reader);
  FlakeShapesMaker maker(&document);
  QSignalSpy ready(&maker, &FlakeShapesMaker::ready);
  addSnow(document);
  const auto id = edit::addNode(document, kFlakeType, QStringLiteral("Flakes"));
  QVERIFY(edit::setValues(document, *id, {{"shapes", std::int64_t{32}}, {"largest_radius_m", 4.6e-3}}).ok());
  QTRY_VERIFY_WITH_TIMEOUT(maker.growing(), 10000);
  maker.cancel();
  QVERIFY(!maker.growing());
  QTest::qWait(300);
  QCOMPARE(ready.size(), 0);
}

void FlakeShapesMakerTest::aSavedSceneKeepsItsShapes() {
  QTemporaryDir folder;
  SceneDocument document(m_reader);
  FlakeShapesMaker maker(&document);
  Atlas atlas;
  connect(&maker, &FlakeShapesMaker::ready, this, [&](const Atlas& grown) { atlas = grown; });
  QVERIFY(!addSmallFlakes(document).empty());
  addSnow(document);
  QTRY_VERIFY_WITH_TIMEOUT(atlas, 30000);
  document.saveAs(folder.filePath(QStringLiteral("winter.spindrift")));
  QVERIFY(document.finishSaving().ok());
  const auto* node = document.scene().firstOf(kFlakeType)->as<FlakeNode>();
  const std::string file = flakeAtlasFile(folder.filePath(QStringLiteral("winter.cache")).toStdString(),
                                          flakeAtlasKey(atlasSettingsOf(*node)));
  QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(QString::fromStdString(file)), 10000);
}

QTEST_MAIN(FlakeShapesMakerTest)
#include "flake_shapes_maker_test.moc"
