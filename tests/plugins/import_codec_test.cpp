// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/host/import_codec.h"

#include <cmath>
#include <functional>

#include "core/base/random.h"
#include "plugins/host/import_checks.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

TerrainImport someTerrain() {
  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = Raster<float>(3, 2, 0.0, 0.0, 5.0, 1.5f);
  terrain->heights.values[4] = std::nanf("");
  terrain->geo = {{176975.9368, 376240.3352, 1234.56}, 31287, "PROJCS[...]"};
  terrain->credit = "somebody";
  return {terrain, {{{"Size", "3 x 2 cells"}}, {"a warning"}}};
}

ModelImport someModel() {
  auto model = std::make_shared<ModelData>();
  Mesh mesh{"tri",
            {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
            {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
            {{0, 0}, {1, 0}, {0, 1}},
            {0, 1, 2},
            0};
  model->meshes = {mesh};
  model->materials = {Material{"bark", {0.1f, 0.2f, 0.3f, 1.0f}, 0, 0.5f, true, false}};
  model->textures = {Image8{1, 2, {1, 2, 3, 4, 5, 6, 7, 8}}};
  model->instances = {{0, Transform{}}, {0, translationOf({1, 2, 3})}};
  model->warnings = {"mended"};
  return {model, {{{"Meshes", "1"}}, {"mended"}}};
}

template <class T>
std::vector<char> bytesOf(const T& value) {
  ByteWriter out;
  encode(out, value);
  return out.take();
}

Result<ModelImport> modelFrom(const std::vector<char>& bytes) {
  ByteReader in(bytes.data(), bytes.size());
  return decodeModel(in, "m.glb");
}
Result<TerrainImport> terrainFrom(const std::vector<char>& bytes) {
  ByteReader in(bytes.data(), bytes.size());
  return decodeTerrain(in, "t.tif");
}

TEST(ImportCodec, TerrainComesBackAsItWent) {
  const TerrainImport before = someTerrain();
  const auto after = terrainFrom(bytesOf(before));
  ASSERT_TRUE(after.ok()) << after.error().text();
  EXPECT_TRUE(after->terrain->heights.hasShapeOf(before.terrain->heights));
  EXPECT_EQ(after->terrain->heights.values[0], 1.5f);
  EXPECT_TRUE(std::isnan(after->terrain->heights.values[4]));
  EXPECT_EQ(after->terrain->geo, before.terrain->geo);
  EXPECT_EQ(after->terrain->credit, "somebody");
  EXPECT_EQ(after->summary.lines.at(0).value, "3 x 2 cells");
  EXPECT_EQ(after->summary.warnings, before.summary.warnings);
}

TEST(ImportCodec, ModelComesBackAsItWent) {
  const ModelImport before = someModel();
  const auto after = modelFrom(bytesOf(before));
  ASSERT_TRUE(after.ok()) << after.error().text();
  const ModelData& model = *after->model;
  EXPECT_EQ(model.meshes.at(0).positions, before.model->meshes[0].positions);
  EXPECT_EQ(model.meshes[0].indices, before.model->meshes[0].indices);
  EXPECT_EQ(model.materials.at(0).name, "bark");
  EXPECT_TRUE(model.materials[0].alphaCutout);
  EXPECT_FALSE(model.materials[0].doubleSided);
  EXPECT_EQ(model.textures.at(0).rgba, before.model->textures[0].rgba);
  EXPECT_EQ(model.instances.at(1).transform, before.model->instances[1].transform);
}

TEST(ImportCodec, EveryCutOffAnswerIsAnError) {
  const std::vector<char> model = bytesOf(someModel()), terrain = bytesOf(someTerrain());
  for (std::size_t size = 0; size < model.size(); ++size)
    EXPECT_FALSE(modelFrom({model.begin(), model.begin() + static_cast<std::ptrdiff_t>(size)}).ok()) << size;
  for (std::size_t size = 0; size < terrain.size(); ++size)
    EXPECT_FALSE(terrainFrom({terrain.begin(), terrain.begin() + static_cast<std::ptrdiff_t>(size)}).ok())
        << size;
}

TEST(ImportCodec, DamagedAnswersGiveErrorsOrSoundData) {
  const std::vector<char> model = bytesOf(someModel());
  const CounterRandom random{7, 0};
  for (std::uint64_t variant = 0; variant < 3000; ++variant) {
    std::vector<char> bytes = model;
    const UInt4 words = random.words(variant);
    bytes[words.x % bytes.size()] = static_cast<char>(words.y);
    bytes[words.z % bytes.size()] = static_cast<char>(words.w);
    const auto result = modelFrom(bytes);
    if (result.ok()) {
      EXPECT_TRUE(checkModel(*result->model, "m").ok());
    }
  }
}

TEST(ImportCodec, RefusesModelsThatWouldReachOutOfBounds) {
  const auto refused = [](const std::function<void(ModelData&)>& spoil) {
    ModelImport import = someModel();
    ModelData model = *import.model;
    spoil(model);
    import.model = std::make_shared<ModelData>(model);
    return !modelFrom(bytesOf(import)).ok();
  };
  EXPECT_FALSE(refused([](ModelData&) {}));
  EXPECT_TRUE(refused([](ModelData& m) { m.meshes[0].indices[1] = 3; }));
  EXPECT_TRUE(refused([](ModelData& m) { m.meshes[0].indices.pop_back(); }));
  EXPECT_TRUE(refused([](ModelData& m) { m.meshes[0].positions[0].y = std::nanf(""); }));
  EXPECT_TRUE(refused([](ModelData& m) { m.meshes[0].normals.pop_back(); }));
  EXPECT_TRUE(refused([](ModelData& m) { m.meshes[0].uvs[0].x = INFINITY; }));
  EXPECT_TRUE(refused([](ModelData& m) { m.meshes[0].material = 1; }));
  EXPECT_TRUE(refused([](ModelData& m) { m.materials[0].texture = 1; }));
  EXPECT_TRUE(refused([](ModelData& m) { m.materials[0].baseColour.x = std::nanf(""); }));
  EXPECT_TRUE(refused([](ModelData& m) { m.textures[0].width = 2; }));
  EXPECT_TRUE(refused([](ModelData& m) { m.instances[0].mesh = -1; }));
  EXPECT_TRUE(refused([](ModelData& m) { m.instances[0].transform.linear = {}; }));
  EXPECT_TRUE(refused([](ModelData& m) { m.instances.clear(); }));
}

TEST(ImportCodec, RefusesTerrainsThatMakeNoSense) {
  const auto refused = [](const std::function<void(TerrainData&)>& spoil) {
    TerrainImport import = someTerrain();
    TerrainData terrain = *import.terrain;
    spoil(terrain);
    import.terrain = std::make_shared<TerrainData>(terrain);
    return !terrainFrom(bytesOf(import)).ok();
  };
  EXPECT_FALSE(refused([](TerrainData&) {}));
  EXPECT_TRUE(refused([](TerrainData& t) { t.heights.width = 4; }));
  EXPECT_TRUE(refused([](TerrainData& t) { t.heights.width = -3; }));
  EXPECT_TRUE(refused([](TerrainData& t) { t.heights.cellSize = 0.0; }));
  EXPECT_TRUE(refused([](TerrainData& t) { t.heights.values[0] = INFINITY; }));
  EXPECT_TRUE(refused([](TerrainData& t) { t.heights.values[0] = 1e6f; }));
  EXPECT_TRUE(refused([](TerrainData& t) { t.geo.origin.x = std::nan(""); }));
  EXPECT_TRUE(refused(
      [](TerrainData& t) { std::fill(t.heights.values.begin(), t.heights.values.end(), std::nanf("")); }));
}

TEST(ImportCodec, RastersArriveWholeAndDamageIsFound) {
  RasterImport before;
  before.values = Raster<float>(3, 2, 0.0, 0.0, 2.5, 7.0f);
  before.values.at(1, 1) = std::nanf("");
  before.geo = {{100.0, 200.0, 0.0}, 31287, "wkt"};
  before.georeferenced = true;
  before.bits = 16;
  const auto decoded = [&] {
    ByteWriter out;
    encode(out, before);
    const std::vector<char> bytes = out.take();
    ByteReader in(bytes.data(), bytes.size());
    return decodeRaster(in, "r.png");
  };
  const Result<RasterImport> after = decoded();
  ASSERT_TRUE(after.ok()) << after.error().text();
  EXPECT_EQ(after->values.at(2, 1), 7.0f);
  EXPECT_TRUE(std::isnan(after->values.at(1, 1)));
  EXPECT_EQ(after->geo, before.geo);
  EXPECT_TRUE(after->georeferenced);
  EXPECT_EQ(after->bits, 16);
  before.bits = 12;
  EXPECT_FALSE(decoded().ok());
  before.bits = 8;
  before.values.at(0, 0) = HUGE_VALF;
  EXPECT_FALSE(decoded().ok());
  before.values.at(0, 0) = 1.0f;
  before.values.values.pop_back();
  EXPECT_FALSE(decoded().ok());
}

TEST(ImportCodec, RequestCarriesThePaintedLayer) {
  TiledRaster<std::uint8_t> types(130, 70, 255);
  types.set(129, 69, 5);
  types.set(0, 0, 2);
  HelperRequest request{ImportTask::WriteLayer, "/a/b.png", {}, types, {"share", "m", 16, -1.5, 2.5},
                        *someTerrain().terrain};
  request.options.epsg = 31287;
  const std::vector<char> bytes = encodeRequest(request);
  const auto after = decodeRequest(bytes.data(), bytes.size());
  ASSERT_TRUE(after.ok()) << after.error().text();
  EXPECT_EQ(after->path, "/a/b.png");
  EXPECT_EQ(after->options.epsg, 31287);
  EXPECT_EQ(std::get<TiledRaster<std::uint8_t>>(after->layer), types);
  EXPECT_EQ(after->format.name, "share");
  EXPECT_EQ(after->format.unit, "m");
  EXPECT_EQ(after->format.bits, 16);
  EXPECT_EQ(after->format.low, -1.5);
  EXPECT_EQ(after->format.high, 2.5);
  // A layer of six tiles with two touched stays far below its 9100 cells.
  EXPECT_LT(bytes.size(), 9000u);
  EXPECT_FALSE(decodeRequest(bytes.data(), bytes.size() - 1).ok());
}

TEST(ImportCodec, SealTellsAnswersFromOtherBytes) {
  const std::vector<char> payload{1, 2, 3};
  std::vector<char> answer = sealAnswer(payload);
  answer.insert(answer.end(), payload.begin(), payload.end());
  const auto open = [&] { return openAnswer(answer.data(), answer.size(), "f"); };
  ASSERT_TRUE(open().ok());
  EXPECT_EQ(answer[*open()], 1);
  answer.back() = 4;
  EXPECT_FALSE(open().ok());
  answer.pop_back();
  EXPECT_FALSE(open().ok());
  EXPECT_FALSE(openAnswer("garbage", 7, "f").ok());
  EXPECT_FALSE(openAnswer(nullptr, 0, "f").ok());
}

}  // namespace
}  // namespace spin
