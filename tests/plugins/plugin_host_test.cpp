// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/host/plugin_host.h"

#include <algorithm>

#include "plugins/host/plugin_catalogue.h"
#include "plugins/sdk/importer.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::ScopedEnvironment;
using test::TempFolder;

bool isLoaded(const std::string& library) {
  return test::readBytes("/proc/self/maps").find(library) != std::string::npos;
}

bool has(const std::vector<std::string>& list, const std::string& item) {
  return std::count(list.begin(), list.end(), item) == 1;
}

TEST(PluginHost, ListsImportersWithoutLoadingTheirCode) {
  const PluginHost host;
  EXPECT_TRUE(has(host.terrainExtensions(), "asc"));
  EXPECT_TRUE(has(host.terrainExtensions(), "tif"));
  EXPECT_TRUE(has(host.modelExtensions(), "glb"));
  EXPECT_TRUE(has(host.modelExtensions(), "obj"));
  EXPECT_FALSE(host.imageFormats().empty());
  EXPECT_TRUE(isLoaded("images_opencv.so"));
  EXPECT_FALSE(isLoaded("terrain_gdal.so"));
  EXPECT_FALSE(isLoaded("model_assimp.so"));
  EXPECT_TRUE(host.warnings().empty()) << host.warnings().front();
}

std::vector<std::string> builtExporters() {
  std::vector<std::string> ids{"cover_tif", "ply"};
#ifdef SPIN_HAVE_OPENVDB
  ids.push_back("vdb");
#endif
  ids.push_back("vtp");
  return ids;
}

TEST(PluginHost, MakesEveryExporterItLists) {
  const PluginHost host;
  EXPECT_EQ(host.exporterIds(), builtExporters());
  for (const std::string& id : host.exporterIds()) {
    const auto exporter = host.makeExporter(id);
    ASSERT_TRUE(exporter) << id;
    EXPECT_EQ(exporter->id(), id);
    EXPECT_EQ(exporter->label(), host.exporterLabel(id));
  }
  EXPECT_EQ(host.makeExporter("nonsense"), nullptr);
  EXPECT_EQ(host.imageWriter("nonsense"), nullptr);
  for (const ImageFormat& format : host.imageFormats()) EXPECT_NE(host.imageWriter(format.id), nullptr);
}

TEST(PluginHost, WarnsOfWhatDoesNotLoadAndKeepsTheRest) {
  const TempFolder folder;
  for (const auto& entry : std::filesystem::directory_iterator(programFolder() + "/plugins"))
    std::filesystem::create_symlink(entry.path(), folder.file(entry.path().filename()));
  std::filesystem::create_symlink(SPIN_BROKEN_PLUGIN, folder.file("broken.so"));
  test::writeBytes(folder.file("text.so"), "this is no library\n");
  const ScopedEnvironment path("SPIN_PLUGIN_PATH", folder.path());
  const PluginHost host;
  EXPECT_EQ(host.exporterIds(), builtExporters());
  ASSERT_EQ(host.warnings().size(), 2u);
  EXPECT_TRUE(test::mentions(host.warnings(), "text.so"));
  EXPECT_TRUE(test::mentions(host.warnings(), "spinSymbolThatNobodyDefines"));
}

TEST(PluginHost, WorksWithNoPluginAtAll) {
  const TempFolder folder;
  const ScopedEnvironment path("SPIN_PLUGIN_PATH", folder.path());
  const PluginHost host;
  EXPECT_TRUE(host.imageFormats().empty());
  EXPECT_TRUE(host.terrainExtensions().empty());
  EXPECT_EQ(host.makeExporter("ply"), nullptr);
  const std::string file = test::writeBytes(folder.file("a.tif"), "x");
  test::expectError(test::readTerrain(file), ErrorKind::BadInput, file, {"no plugin", "Install"});
}

TEST(PluginCatalogue, FindsByInterfaceAndEnding) {
  const PluginCatalogue catalogue = readPluginCatalogue(pluginFolders());
  EXPECT_NE(findPlugin(catalogue, SPIN_TERRAIN_IMPORTER_IID, "png"), nullptr);
  EXPECT_EQ(findPlugin(catalogue, SPIN_MODEL_IMPORTER_IID, "png"), nullptr);
  EXPECT_EQ(findPlugin(catalogue, SPIN_TERRAIN_IMPORTER_IID, ""), nullptr);
}

}  // namespace
}  // namespace spin
