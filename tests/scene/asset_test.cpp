// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>

#include "core/nodes/ground_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/scene/asset_file.h"
#include "tests/support/fake_asset_reader.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

class Assets : public testing::Test {
 protected:
  void SetUp() override {
    m_root = fs::temp_directory_path() / ("spin_assets_" + std::to_string(::getpid()));
    fs::remove_all(m_root);
    fs::create_directories(m_root / "scene" / "files");
    fs::create_directories(m_root / "other");
    m_scene = (m_root / "scene" / "s.spindrift").string();
    write("scene/files/dem.txt", "3 2 10\n1 2 3 4 5 6\n");
    write("scene/files/hut.txt", "2\n");
  }
  void TearDown() override { fs::remove_all(m_root); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(m_root / name) << text; }
  std::string absolute(const std::string& name) const { return (m_root / name).string(); }
  bool allowed(const std::string& path, const PathPolicy& policy = {}) const {
    return resolveAssetPath(m_scene, path, policy).ok();
  }
  std::string why(const std::string& path) const {
    const Result<std::string> resolved = resolveAssetPath(m_scene, path, {});
    return resolved ? "allowed as " + *resolved : resolved.error().text();
  }

  Scene scene(const std::string& terrain = "files/dem.txt",
              const std::string& model = "files/hut.txt") const {
    Scene s = makeDefaultScene();
    EXPECT_TRUE(s.append(makeNode(kTerrainType, "terrain", "Terrain")).ok());
    EXPECT_TRUE(s.append(makeNode(kModelType, "hut", "Hut")).ok());
    EXPECT_TRUE(s.append(makeNode(kGroundTypeLayerType, "ground", "Ground")).ok());
    EXPECT_TRUE(s.setFromText("terrain.source", terrain).ok());
    EXPECT_TRUE(s.setFromText("hut.source", model).ok());
    return s;
  }

  fs::path m_root;
  std::string m_scene;
  std::shared_ptr<FakeAssetReader> m_reader = std::make_shared<FakeAssetReader>();
};

TEST_F(Assets, PathsStayInTheFolder) {
  EXPECT_EQ(*resolveAssetPath(m_scene, "files/dem.txt", {}), absolute("scene/files/dem.txt"));
  EXPECT_TRUE(allowed("files/../files/dem.txt"));
  EXPECT_TRUE(allowed("not/there/yet.tif")) << "a missing file is looked for later";
  EXPECT_TRUE(allowed(absolute("scene/files/dem.txt"))) << "absolute, but inside";
  for (const char* path : {"../other/x.tif", "files/../../other/x.tif", "/etc/passwd", "..", "files/../.."})
    EXPECT_NE(why(path).find("outside"), std::string::npos) << path << ": " << why(path);
}

TEST_F(Assets, AllowedFoldersAreAllowed) {
  write("other/x.tif", "x");
  const PathPolicy policy{{absolute("other")}};
  EXPECT_TRUE(allowed("../other/x.tif", policy));
  EXPECT_TRUE(allowed(absolute("other/x.tif"), policy));
  EXPECT_FALSE(allowed(absolute("other2/x.tif"), policy)) << "a folder whose name only begins alike";
  EXPECT_FALSE(allowed("../other/../secret.tif", policy));
}

TEST_F(Assets, DevicesAddressesAndOddPathsAreRefused) {
  for (const char* path :
       {"/dev/zero", "/proc/self/mem", "CON", "files/nul.txt", "a/COM1.tif", "http://host/x.tif", "vsicurl:x",
        "file:///etc/passwd", "a\\b.tif", "", "a\nb", "\xff.tif"})
    EXPECT_FALSE(allowed(path)) << path;
  PathPolicy everything{{"/"}};
  EXPECT_FALSE(allowed("/dev/zero", everything)) << "no permission opens devices";
  EXPECT_FALSE(allowed("files", {})) << "a folder is no file";
}

TEST_F(Assets, LinksDoNotLeadOut) {
  write("other/secret.txt", "x");
  fs::create_symlink(m_root / "other" / "secret.txt", m_root / "scene" / "link.txt");
  fs::create_directory_symlink(m_root / "other", m_root / "scene" / "linked");
  fs::create_symlink("/dev/zero", m_root / "scene" / "zero");
  EXPECT_FALSE(allowed("link.txt"));
  EXPECT_FALSE(allowed("linked/secret.txt"));
  EXPECT_FALSE(allowed("zero"));
  EXPECT_TRUE(allowed("link.txt", {{absolute("other")}}));
}

TEST_F(Assets, UnsavedScenesTakeAbsolutePathsOnly) {
  EXPECT_FALSE(resolveAssetPath("", "files/dem.txt", {}).ok());
  EXPECT_TRUE(resolveAssetPath("", absolute("scene/files/dem.txt"), {{absolute("scene")}}).ok());
}

TEST_F(Assets, StoredPathsAreRelativeWithSlashes) {
  EXPECT_EQ(storedAssetPath(m_scene, absolute("scene/files/dem.txt")), "files/dem.txt");
  EXPECT_EQ(storedAssetPath(m_scene, absolute("other/x.tif")), "../other/x.tif");
  EXPECT_EQ(storedAssetPath("", absolute("other/x.tif")), absolute("other/x.tif"));
}

TEST_F(Assets, SnapshotHoldsTheFilesAndReadsThemOnce) {
  AssetLibrary library(m_reader);
  std::vector<AssetLibrary::Issue> issues;
  Scene s = scene();
  const SnapshotPointer first = *library.snapshot(s, m_scene, issues);
  ASSERT_TRUE(issues.empty()) << issues.front().error.text();
  ASSERT_TRUE(first->terrain);
  EXPECT_EQ(first->terrain->heights.at(2, 1), 6.0f);
  EXPECT_TRUE(first->models.contains("hut"));
  EXPECT_EQ(first->assetHashes.size(), 2u);
  ASSERT_TRUE(s.setFromText("weather.wind_speed_m_s", "7").ok());
  const SnapshotPointer second = *library.snapshot(s, m_scene, issues);
  EXPECT_EQ(second->terrain, first->terrain) << "the same object, not a copy";
  EXPECT_EQ(m_reader->reads, 2);
}

TEST_F(Assets, AChangedFileOrOptionIsReadAgain) {
  AssetLibrary library(m_reader);
  std::vector<AssetLibrary::Issue> issues;
  Scene s = scene();
  const SnapshotPointer first = *library.snapshot(s, m_scene, issues);
  write("scene/files/dem.txt", "3 2 10\n1 2 3 4 5 60\n");
  const SnapshotPointer second = *library.snapshot(s, m_scene, issues);
  EXPECT_EQ(second->terrain->heights.at(2, 1), 60.0f);
  EXPECT_NE(second->assetHashes.at("terrain"), first->assetHashes.at("terrain"));
  EXPECT_EQ(second->assetHashes.at("hut"), first->assetHashes.at("hut"));
  ASSERT_TRUE(s.setFromText("hut.unit_m", "0.01").ok());
  ASSERT_TRUE(s.setFromText("hut.up_axis", "y").ok());
  ASSERT_TRUE(library.snapshot(s, m_scene, issues).ok());
  EXPECT_EQ(m_reader->reads, 4);
  EXPECT_EQ(m_reader->lastOptions.unitScale, 0.01);
  EXPECT_EQ(m_reader->lastOptions.upAxis, 1);
}

TEST_F(Assets, AChangedWorldFileIsReadAgain) {
  for (const char* companion : {"dem.tfw", "dem.pgw", "dem.wld", "dem.tif.msk"}) {
    const std::string name = std::string("scene/files/") + companion;
    const std::string before = stampOf(absolute("scene/files/dem.txt"), {});
    write(name, "5\n0\n0\n-5\n");
    const std::string with = stampOf(absolute("scene/files/dem.txt"), {});
    EXPECT_NE(before, with) << companion;
    write(name, "10\n0\n0\n-10\n");
    EXPECT_NE(stampOf(absolute("scene/files/dem.txt"), {}), with) << companion;
  }
}

TEST_F(Assets, VerticalScaleIsAppliedWithoutReadingAgain) {
  AssetLibrary library(m_reader);
  std::vector<AssetLibrary::Issue> issues;
  Scene s = scene();
  ASSERT_TRUE(library.snapshot(s, m_scene, issues).ok());
  ASSERT_TRUE(s.setFromText("terrain.vertical_scale", "2").ok());
  const SnapshotPointer scaled = *library.snapshot(s, m_scene, issues);
  EXPECT_EQ(scaled->terrain->heights.at(2, 1), 12.0f);
  EXPECT_EQ((*library.snapshot(s, m_scene, issues))->terrain, scaled->terrain);
  EXPECT_EQ(m_reader->reads, 2);
}

TEST_F(Assets, MissingCrashingAndDisabledFiles) {
  AssetLibrary library(m_reader);
  std::vector<AssetLibrary::Issue> issues;
  write("scene/files/bad.txt", "crash");
  Scene s = scene("gone.txt", "files/bad.txt");
  const Result<SnapshotPointer> snapshot = library.snapshot(s, m_scene, issues);
  ASSERT_TRUE(snapshot.ok());
  EXPECT_FALSE((*snapshot)->terrain);
  ASSERT_EQ(issues.size(), 2u);
  EXPECT_EQ(issues[0].node, "terrain");
  EXPECT_NE(issues[0].error.text().find("gone.txt"), std::string::npos);
  EXPECT_EQ(issues[1].node, "hut");
  s.find("hut")->enabled = false;
  s.find("terrain")->enabled = false;
  issues.clear();
  ASSERT_TRUE(library.snapshot(s, m_scene, issues).ok());
  EXPECT_TRUE(issues.empty()) << "what is switched off is not read";
}

TEST_F(Assets, MovedFilesAreFoundByNameAndHash) {
  fs::create_directories(m_root / "scene" / "a");
  fs::create_directories(m_root / "scene" / "b" / "deep");
  write("scene/a/moved.txt", "3 2 10\n0 0 0 0 0 0\n");
  write("scene/b/deep/moved.txt", "3 2 10\n9 9 9 9 9 9\n");
  AssetLibrary library(m_reader);
  std::vector<AssetLibrary::Issue> issues;
  const Scene s = scene("old/moved.txt");
  const SnapshotPointer byName = *library.snapshot(s, m_scene, issues);
  ASSERT_TRUE(byName->terrain);
  EXPECT_EQ(byName->terrain->heights.at(0, 0), 0.0f);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_TRUE(issues[0].usable);
  library.setExpectedHashes({{"terrain", hashFile(absolute("scene/b/deep/moved.txt"))}});
  EXPECT_EQ((*library.snapshot(s, m_scene, issues))->terrain->heights.at(0, 0), 9.0f);
}

TEST_F(Assets, CancelStopsTheSnapshot) {
  AssetLibrary library(m_reader);
  std::vector<AssetLibrary::Issue> issues;
  CancelToken cancel;
  cancel.cancel();
  const Result<SnapshotPointer> snapshot = library.snapshot(scene(), m_scene, issues, cancel);
  ASSERT_FALSE(snapshot.ok());
  EXPECT_EQ(snapshot.error().kind, ErrorKind::Cancelled);
}

TEST_F(Assets, PaintedLayersRoundTripBesideTheScene) {
  Scene s = scene();
  TiledRaster<std::uint8_t> layer(3, 2, kUnpaintedGround);
  layer.set(1, 1, static_cast<std::uint8_t>(GroundType::Rock));
  s.find("ground")->painted = layer;
  TerrainData terrain;
  terrain.heights = Raster<float>(3, 2, 0, 0, 10);
  ASSERT_TRUE(savePaintedLayers(s, m_scene, terrain, *m_reader).ok());
  EXPECT_EQ(sourceOf(*s.find("ground")), "s.assets/ground.png");
  Scene loaded = s;
  loaded.find("ground")->painted = std::monostate{};
  std::vector<AssetLibrary::Issue> issues;
  ASSERT_TRUE(loadPaintedLayers(loaded, m_scene, *m_reader, {}, issues).ok());
  EXPECT_TRUE(issues.empty());
  EXPECT_EQ(loaded.find("ground")->painted, s.find("ground")->painted);
  int files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(m_root / "scene" / "s.assets")) ++files;
  EXPECT_EQ(files, 1) << "no temporary file is left";
}

TEST_F(Assets, BadLayersBecomeIssues) {
  Scene s = scene();
  ASSERT_TRUE(s.setFromText("ground.source", "files/l.txt").ok());
  std::vector<AssetLibrary::Issue> issues;
  const auto load = [&](const char* text) {
    write("scene/files/l.txt", text);
    issues.clear();
    EXPECT_TRUE(loadPaintedLayers(s, m_scene, *m_reader, {}, issues).ok());
    return issues.empty() ? std::string("no issue") : issues[0].error.text();
  };
  EXPECT_NE(load("types 2 1 1 37").find("37"), std::string::npos);
  EXPECT_NE(load("kelvin 2 1 270 271").find("whole numbers"), std::string::npos);
  EXPECT_NE(load("nonsense").find("crashed"), std::string::npos);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(s.find("ground")->painted));
  EXPECT_EQ(load("types 2 1 1 255"), "no issue");
}

TEST_F(Assets, ALayerOfAnotherSizeIsLeftOutOfTheSnapshot) {
  Scene s = scene();
  s.find("ground")->painted = TiledRaster<std::uint8_t>(5, 5, 1);
  AssetLibrary library(m_reader);
  std::vector<AssetLibrary::Issue> issues;
  const SnapshotPointer snapshot = *library.snapshot(s, m_scene, issues);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].node, "ground");
  for (const SceneNode& node : snapshot->nodes)
    EXPECT_TRUE(std::holds_alternative<std::monostate>(node.painted)) << node.id;
}

TEST(CheckLayer, TemperaturesMustBePlausible) {
  const SceneNode node = makeNode(kGroundTemperatureLayerType, "t", "T");
  EXPECT_TRUE(checkLayer(node, TiledRaster<float>(2, 2, 270.0f)).ok());
  EXPECT_TRUE(checkLayer(node, TiledRaster<float>(2, 2, std::nanf(""))).ok());
  EXPECT_FALSE(checkLayer(node, TiledRaster<float>(2, 2, -5.0f)).ok()) << "Celsius by mistake";
  EXPECT_FALSE(checkLayer(node, TiledRaster<float>(2, 2, INFINITY)).ok());
  EXPECT_FALSE(checkLayer(node, TiledRaster<std::uint8_t>(2, 2, 1)).ok());
}

}  // namespace
}  // namespace spin
