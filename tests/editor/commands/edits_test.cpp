// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/commands/edits.h"

#include <QSignalSpy>
#include <QTest>

#include "core/nodes/camera_node.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/node_registry.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "tests/support/fake_asset_reader.h"
#include "tests/support/node_data.h"

using namespace spin;

namespace {

/// The whole scene as text: what is equal here is equal in the file.
std::string textOf(const SceneDocument& document) {
  return writeSceneText(document.scene());
}

Value otherValue(const NodeType& type, const PropertyInfo& property) {
  const Value value = defaultValue(type, property);
  if (const auto* flag = std::get_if<bool>(&value)) return !*flag;
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    return *integer == 0 ? *integer + 1 : *integer - 1;
  const double inside = property.min + 0.37 * (property.max - property.min);
  if (std::holds_alternative<double>(value)) return inside;
  if (std::holds_alternative<Vec3d>(value)) return Vec3d{inside, property.min, property.max};
  if (std::holds_alternative<PlanPoints>(value))
    return PlanPoints{{inside, 0.0}, {property.min, property.max}};
  return std::string("changed");
}

}  // namespace

class EditsTest : public QObject {
  Q_OBJECT
 private:
  std::shared_ptr<FakeAssetReader> m_reader = std::make_shared<FakeAssetReader>();

 private Q_SLOTS:
  void everyPropertyUndoesAndRedoes_data();
  void everyPropertyUndoesAndRedoes();
  void structureUndoesAndRedoes();
  void aDragIsOneStep();
  void anEditBackToTheStartLeavesNoStep();
  void otherThingsDoNotMerge();
  void keysFollowTheRules();
  void movedKeysKeepTheirValues();
  void animatedPropertiesGetKeys();
  void refusalsChangeNothing();
  void eventsNameWhatChanged();
  void strokesKeepOnlyTheirTiles();
  void aStrokeOnNothingIsUndoneToNothing();
  void badStrokesAreRefused();
  void theFirstTerrainSetsTheSceneUp();
  void whatIsSetUpStays();
  void anotherTerrainLeavesNothingOfTheOldOne();
};

void EditsTest::everyPropertyUndoesAndRedoes_data() {
  QTest::addColumn<QString>("type");
  QTest::addColumn<QString>("property");
  for (const NodeType* type : nodeTypes())
    for (const PropertyRow& row : type->properties)
      QTest::addRow("%s.%s", type->id, row.id) << QString::fromUtf8(type->id) << QString::fromUtf8(row.id);
}

void EditsTest::everyPropertyUndoesAndRedoes() {
  QFETCH(QString, type);
  QFETCH(QString, property);
  SceneDocument document(m_reader);
  const NodeType& nodeType = *findNodeType(type.toStdString());
  const PropertyInfo& info = *nodeType.find(property.toStdString());
  const SceneNode* there = document.scene().firstOf(nodeType);
  const std::string node = there ? there->id : *edit::addNode(document, nodeType, {});
  std::vector<std::string> states{textOf(document)};
  const int first = document.undoStack()->index();

  QVERIFY(edit::setValue(document, node, info.id, otherValue(nodeType, info)).ok());
  states.push_back(textOf(document));
  QVERIFY(states[1] != states[0]);
  QVERIFY(!document.undoStack()->undoText().isEmpty());
  if (info.animatable) {
    QVERIFY(edit::setKey(document, node, info.id, 1.0, otherValue(nodeType, info)).ok());
    states.push_back(textOf(document));
    QVERIFY(
        edit::setKey(document, node, info.id, 2.0, defaultValue(nodeType, info), Interpolation::Smooth).ok());
    states.push_back(textOf(document));
    QVERIFY(edit::removeKey(document, node, info.id, 1.0).ok());
    states.push_back(textOf(document));
  } else {
    QVERIFY(!edit::setKey(document, node, info.id, 1.0, otherValue(nodeType, info)).ok());
  }
  QVERIFY(edit::revert(document, node, info.id).ok());
  states.push_back(textOf(document));
  QVERIFY(states.back() == states.front());

  QCOMPARE(document.undoStack()->index() - first, static_cast<int>(states.size()) - 1);
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    document.undoStack()->undo();
    QCOMPARE(textOf(document), states[i - 1]);
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    document.undoStack()->redo();
    QCOMPARE(textOf(document), states[i]);
  }
}

void EditsTest::structureUndoesAndRedoes() {
  SceneDocument document(m_reader);
  std::vector<std::string> states{textOf(document)};
  const auto step = [&](bool ok) {
    QVERIFY(ok);
    states.push_back(textOf(document));
    QVERIFY(states[states.size() - 1] != states[states.size() - 2]);
  };
  step(edit::addNode(document, kModelType, QStringLiteral("Hut"), "hut").ok());
  step(edit::setValue(document, "hut", "position_m", Vec3d{1, 2, 3}).ok());
  step(edit::duplicateNode(document, "hut").ok());
  step(edit::renameNode(document, "hut_2", QStringLiteral("Sch\u00e4ferh\u00fctte")).ok());
  step(edit::setNodeEnabled(document, "hut_2", false).ok());
  step(edit::moveNode(document, 0, 3).ok());
  step(edit::moveNode(document, 5, 1).ok());
  step(edit::removeNode(document, "hut").ok());
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    document.undoStack()->undo();
    QCOMPARE(textOf(document), states[i - 1]);
  }
  QVERIFY(!document.isModified());
  for (std::size_t i = 1; i < states.size(); ++i) {
    document.undoStack()->redo();
    QCOMPARE(textOf(document), states[i]);
  }
}

void EditsTest::aDragIsOneStep() {
  SceneDocument document(m_reader);
  const std::string before = textOf(document);
  const edit::Session drag = edit::newSession();
  for (int i = 1; i <= 20; ++i)
    QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 2.0 + i, drag).ok());
  QCOMPARE(document.undoStack()->count(), 1);
  QCOMPARE(test::dataOf<WeatherNode>(document.node("weather")).windSpeed, 22.0);
  document.undoStack()->undo();
  QCOMPARE(textOf(document), before);
}

void EditsTest::anEditBackToTheStartLeavesNoStep() {
  SceneDocument document(m_reader);
  const edit::Session drag = edit::newSession();
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 9.0, drag).ok());
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 2.0, drag).ok());
  QCOMPARE(document.undoStack()->count(), 0);
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 2.0).ok());
  QCOMPARE(document.undoStack()->count(), 0);
}

void EditsTest::otherThingsDoNotMerge() {
  SceneDocument document(m_reader);
  const edit::Session one = edit::newSession(), two = edit::newSession();
  QVERIFY(one != two);
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 3.0, one).ok());
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 4.0, two).ok());
  QVERIFY(edit::setValue(document, "weather", "cloud_cover", 1.0, two).ok());
  QVERIFY(edit::setValue(document, "weather", "cloud_cover", 0.5).ok());
  QVERIFY(edit::setValue(document, "weather", "cloud_cover", 0.25).ok());
  QCOMPARE(document.undoStack()->count(), 5);
}

void EditsTest::keysFollowTheRules() {
  SceneDocument document(m_reader);
  const char* const wind = "wind_speed_m_s";
  const auto keys = [&] { return document.node("weather")->curves.at(wind).keys(); };
  QVERIFY(edit::setKey(document, "weather", wind, 0.0, 1.0, Interpolation::Smooth).ok());
  QVERIFY(edit::setKey(document, "weather", wind, 2.0, 5.0).ok());
  QCOMPARE(keys().back().interpolation, Interpolation::Smooth);
  QVERIFY(edit::setKey(document, "weather", wind, 2.0, 6.0, Interpolation::Step).ok());
  QCOMPARE(keys().size(), 2u);
  QVERIFY(edit::setKey(document, "weather", wind, 2.0, 7.0).ok());
  QCOMPARE(keys().back().interpolation, Interpolation::Step);
  QVERIFY(!edit::removeKey(document, "weather", wind, 1.0).ok());
  QVERIFY(edit::removeKey(document, "weather", wind, 0.0).ok());
  QVERIFY(edit::removeKey(document, "weather", wind, 2.0).ok());
  QVERIFY(document.node("weather")->curves.empty());
  QCOMPARE(test::dataOf<WeatherNode>(document.node("weather")).windSpeed, 7.0);
  QVERIFY(!edit::setKey(document, "weather", wind, std::nan(""), 1.0).ok());
}

void EditsTest::movedKeysKeepTheirValues() {
  SceneDocument document(m_reader);
  QVERIFY(edit::setKey(document, "weather", "wind_speed_m_s", 1.0, 5.0).ok());
  QVERIFY(edit::setKey(document, "weather", "cloud_cover", 1.0, 0.5).ok());
  QVERIFY(edit::setKey(document, "weather", "cloud_cover", 3.0, 1.0).ok());
  const int count = document.undoStack()->count();
  const edit::Session drag = edit::newSession();
  QVERIFY(edit::moveKeys(document, "weather", 1.0, 1.5, drag).ok());
  QVERIFY(edit::moveKeys(document, "weather", 1.5, 2.0, drag).ok());
  QCOMPARE(document.undoStack()->count(), count + 1);
  const SceneNode& weather = *document.node("weather");
  QVERIFY(weather.curves.at("wind_speed_m_s").keyAt(2.0));
  QCOMPARE(weather.curves.at("cloud_cover").keys().size(), 2u);
  QVERIFY(!weather.curves.at("cloud_cover").keyAt(1.0));
  document.undoStack()->undo();
  QVERIFY(document.node("weather")->curves.at("wind_speed_m_s").keyAt(1.0));
}

void EditsTest::animatedPropertiesGetKeys() {
  SceneDocument document(m_reader);
  QVERIFY(edit::setValueAt(document, "weather", {{"wind_speed_m_s", 3.0}}, 1.0).ok());
  QVERIFY(document.node("weather")->curves.empty());
  QVERIFY(edit::setKey(document, "weather", "wind_speed_m_s", 0.0, 3.0).ok());
  QVERIFY(edit::setValueAt(document, "weather", {{"wind_speed_m_s", 8.0}, {"cloud_cover", 1.0}}, 1.0).ok());
  QCOMPARE(document.node("weather")->curves.at("wind_speed_m_s").keys().size(), 2u);
  QCOMPARE(test::dataOf<WeatherNode>(document.node("weather")).cloudCover, 1.0);
  document.undoStack()->undo();
  QCOMPARE(document.node("weather")->curves.at("wind_speed_m_s").keys().size(), 1u);
  QCOMPARE(test::dataOf<WeatherNode>(document.node("weather")).cloudCover, 0.4);
}

void EditsTest::refusalsChangeNothing() {
  SceneDocument document(m_reader);
  const std::string before = textOf(document);
  QVERIFY(!edit::setValue(document, "weather", "wind_speed_m_s", 1000.0).ok());
  QVERIFY(!edit::setValue(document, "weather", "wind_speed_m_s", true).ok());
  QVERIFY(!edit::setValue(document, "weather", "nothing", 1.0).ok());
  QVERIFY(!edit::setValue(document, "nobody", "wind_speed_m_s", 1.0).ok());
  QVERIFY(!edit::setValues(document, "weather", {{"cloud_cover", 1.0}, {"wind_speed_m_s", -1.0}}).ok());
  QVERIFY(!edit::addNode(document, kWeatherType, {}).ok());
  QVERIFY(!edit::renameNode(document, "weather", QStringLiteral("  ")).ok());
  QVERIFY(!edit::renameNode(document, "weather", QString(1000, QLatin1Char('x'))).ok());
  QVERIFY(!edit::removeNode(document, "nobody").ok());
  QVERIFY(!edit::moveNode(document, 0, 99).ok());
  QCOMPARE(textOf(document), before);
  QCOMPARE(document.undoStack()->count(), 0);
}

void EditsTest::eventsNameWhatChanged() {
  SceneDocument document(m_reader);
  std::vector<ChangeEvent> events;
  connect(&document, &SceneDocument::changed, this,
          [&](const ChangeEvent& event) { events.push_back(event); });
  QVERIFY(edit::setValue(document, "weather", "sun_azimuth_deg", 10.0).ok());
  QCOMPARE(events.size(), 1u);
  QVERIFY(events[0].kind == ChangeKind::Property && events[0].node == "weather");
  QVERIFY(events[0].property == "sun_azimuth_deg" && events[0].affects == Affects::Picture);
  document.undoStack()->undo();
  QCOMPARE(events.size(), 2u);
  QVERIFY(edit::renameNode(document, "weather", QStringLiteral("W")).ok());
  QVERIFY(events.back().kind == ChangeKind::Renamed && events.back().affects == Affects::Nothing);
}

void EditsTest::strokesKeepOnlyTheirTiles() {
  SceneDocument document(m_reader);
  const std::string node = *edit::addNode(document, kGroundTypeLayerType, {});
  TiledRaster<std::uint8_t> layer(300, 200, kUnpaintedGround);
  layer.set(0, 0, 1);
  QVERIFY(edit::paint(document, node, layer, edit::newSession()).ok());
  const PaintedLayer first = document.node(node)->painted;
  const int count = document.undoStack()->count();
  const edit::Session stroke = edit::newSession();
  for (int i = 0; i < 130; ++i) {
    layer.set(i, 10, 4);
    QVERIFY(edit::paint(document, node, layer, stroke).ok());
  }
  QCOMPARE(document.undoStack()->count(), count + 1);
  const auto& after = std::get<TiledRaster<std::uint8_t>>(document.node(node)->painted);
  QCOMPARE(after.at(129, 10), std::uint8_t{4});
  QCOMPARE(after.tile(after.tileIndex(299, 199)),
           std::get<TiledRaster<std::uint8_t>>(first).tile(after.tileIndex(299, 199)));
  const PaintedLayer painted = document.node(node)->painted;
  document.undoStack()->undo();
  QVERIFY(document.node(node)->painted == first);
  document.undoStack()->redo();
  QVERIFY(document.node(node)->painted == painted);
  QVERIFY(edit::paint(document, node, layer, stroke).ok());
  QCOMPARE(document.undoStack()->count(), count + 1);
}

void EditsTest::aStrokeOnNothingIsUndoneToNothing() {
  SceneDocument document(m_reader);
  const std::string node = *edit::addNode(document, kGroundTemperatureLayerType, {});
  TiledRaster<float> layer(100, 100, std::nanf(""));
  QVERIFY(edit::paint(document, node, layer, 0).ok());
  QVERIFY(std::holds_alternative<std::monostate>(document.node(node)->painted));
  layer.set(50, 50, 260.0f);
  QVERIFY(edit::paint(document, node, layer, 0).ok());
  QCOMPARE(std::get<TiledRaster<float>>(document.node(node)->painted).at(50, 50), 260.0f);
  document.undoStack()->undo();
  QVERIFY(std::holds_alternative<std::monostate>(document.node(node)->painted));
  document.undoStack()->redo();
  QCOMPARE(std::get<TiledRaster<float>>(document.node(node)->painted).at(50, 50), 260.0f);
}

void EditsTest::badStrokesAreRefused() {
  SceneDocument document(m_reader);
  const std::string node = *edit::addNode(document, kGroundTypeLayerType, {});
  TiledRaster<std::uint8_t> layer(10, 10, kUnpaintedGround);
  layer.set(1, 1, 200);
  QVERIFY(!edit::paint(document, node, layer, 0).ok());
  QVERIFY(!edit::paint(document, node, TiledRaster<float>(10, 10, 270.0f), 0).ok());
  QVERIFY(!edit::paint(document, "weather", TiledRaster<std::uint8_t>(10, 10, 1), 0).ok());
  QVERIFY(!edit::paint(document, "nobody", layer, 0).ok());
  layer.set(1, 1, 2);
  QVERIFY(edit::paint(document, node, layer, 0).ok());
  QVERIFY(!edit::paint(document, node, TiledRaster<std::uint8_t>(11, 10, 1), 0).ok());
}

/// As the command line's import does: camera, snowfall and time scale, in one step with the terrain.
void EditsTest::theFirstTerrainSetsTheSceneUp() {
  SceneDocument document(m_reader);
  const std::string before = textOf(document);
  edit::AssetDetails details;
  details.view = FirstView{{5, -20, 30}, {5, 6, 7}};
  details.credit = "Measured by nobody";
  const auto added = edit::addAssetNode(document, kTerrainType, QStringLiteral("/tmp/Valley 1.asc"), details);
  QVERIFY(added.ok());
  QCOMPARE(*added, std::string("terrain"));
  QCOMPARE(document.selected(), *added);
  QCOMPARE(document.node(*added)->name, std::string("Valley 1"));
  QCOMPARE(test::dataOf<TerrainNode>(document.node(*added)).credit, std::string("Measured by nobody"));
  QVERIFY(document.scene().firstOf(kSnowfallType));
  QCOMPARE(test::dataOf<SimulationNode>(document.node("simulation")).timeScale, 2880.0);
  QVERIFY(test::dataOf<CameraNode>(document.node("camera")).position == (Vec3d{5, -20, 30}));
  QVERIFY(test::dataOf<CameraNode>(document.node("camera")).target == (Vec3d{5, 6, 7}));
  QCOMPARE(document.undoStack()->count(), 1);
  document.undoStack()->undo();
  QCOMPARE(textOf(document), before);
}

void EditsTest::whatIsSetUpStays() {
  SceneDocument document(m_reader);
  QVERIFY(edit::setValue(document, "simulation", "time_scale", 60.0).ok());
  QVERIFY(edit::setValue(document, "camera", "position_m", Vec3d{1, 2, 3}).ok());
  edit::AssetDetails details;
  details.view = FirstView{{5, -20, 30}, {5, 6, 7}};
  QVERIFY(edit::addAssetNode(document, kTerrainType, QStringLiteral("/tmp/valley.asc"), details).ok());
  QVERIFY(!document.scene().firstOf(kSnowfallType));
  QCOMPARE(test::dataOf<SimulationNode>(document.node("simulation")).timeScale, 60.0);
  QVERIFY(test::dataOf<CameraNode>(document.node("camera")).position == (Vec3d{1, 2, 3}));
}

void EditsTest::anotherTerrainLeavesNothingOfTheOldOne() {
  SceneDocument document(m_reader);
  edit::AssetDetails first;
  first.options.epsg = 31287;
  first.options.cellSize = 5.0;
  first.options.noDataValue = -1.0;
  first.credit = "Old survey";
  const auto id = edit::addAssetNode(document, kTerrainType, QStringLiteral("/tmp/old.asc"), first);
  QVERIFY(id.ok());
  QVERIFY(edit::setValues(document, *id, {{"vertical_scale", 2.0}, {"cover_detail_cell_m", 1.0}}).ok());
  const std::string before = textOf(document);
  const int steps = document.undoStack()->count();
  edit::AssetDetails second;
  second.credit = "New survey";
  QCOMPARE(*edit::addAssetNode(document, kTerrainType, QStringLiteral("/tmp/new.asc"), second), *id);
  const SceneNode& node = *document.node(*id);
  const auto& terrain = test::dataOf<TerrainNode>(&node);
  QCOMPARE(node.name, std::string("new"));
  QCOMPARE(terrain.source, std::string("/tmp/new.asc"));
  QCOMPARE(terrain.credit, std::string("New survey"));
  QCOMPARE(terrain.epsg, 0);
  QCOMPARE(terrain.cellSize, 0.0);
  QVERIFY(!terrain.hasNoData);
  QCOMPARE(terrain.noData, 0.0);
  QCOMPARE(terrain.verticalScale, 1.0);
  QCOMPARE(terrain.coverDetailCell, 1.0);
  QCOMPARE(document.undoStack()->count(), steps + 1);
  document.undoStack()->undo();
  QCOMPARE(textOf(document), before);
}

QTEST_MAIN(EditsTest)
#include "edits_test.moc"
