// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The import summaries against gdalinfo and assimp, and our files in foreign readers.
#include <cmath>

#include "tests/plugins/model_files.h"
#include "tests/plugins/raster_files.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::lineOf;
using test::outputOf;
using test::TempFolder;

bool haveProgram(const std::string& name) {
  return !outputOf("command -v " + name).empty();
}

/// The number behind a label: "Faces:   12" -> 12.
double numberAfter(const std::string& text, const std::string& label) {
  const std::size_t at = text.find(label);
  EXPECT_NE(at, std::string::npos) << label << " not in: " << text;
  if (at == std::string::npos) return std::nan("");
  return std::strtod(text.c_str() + text.find_first_of("-0123456789", at + label.size()), nullptr);
}

void expectAgreesWithGdalinfo(const std::string& path, const ImportOptions& options) {
  const auto import = test::readTerrain(path, options);
  ASSERT_TRUE(import.ok()) << import.error().text();
  const Raster<float>& h = import->terrain->heights;
  const GeoReference& geo = import->terrain->geo;
  const std::string info = outputOf("gdalinfo -mm '" + path + "'");
  EXPECT_NE(info.find("Driver: " + lineOf(import->summary, "Format") + "/"), std::string::npos) << info;
  EXPECT_NE(info.find("Size is " + std::to_string(h.width) + ", " + std::to_string(h.height) + "\n"),
            std::string::npos);
  EXPECT_EQ(lineOf(import->summary, "Size"),
            std::to_string(h.width) + " x " + std::to_string(h.height) + " cells");
  const std::string lower = info.substr(info.find("Lower Left"));
  char corner[64];
  std::snprintf(corner, sizeof corner, "(%12.3f,%12.3f)", geo.origin.x - 0.5 * h.cellSize,
                geo.origin.y - 0.5 * h.cellSize);
  EXPECT_NE(lower.find(corner), std::string::npos) << corner << " not in " << lower;
  EXPECT_NEAR(numberAfter(info, "Pixel Size = ("), h.cellSize, 1e-9);
  // "Computed Min/Max=1234.560,2345.670"
  const std::size_t at = info.find("Computed Min/Max=");
  ASSERT_NE(at, std::string::npos) << info;
  char* end = nullptr;
  const double low = std::strtod(info.c_str() + at + 17, &end);
  const double high = std::strtod(end + 1, nullptr);
  char range[64];
  std::snprintf(range, sizeof range, "%.3f to %.3f m", low, high);
  EXPECT_EQ(lineOf(import->summary, "Heights"), range);
}

TEST(Interop, TerrainSummaryAgreesWithGdalinfo) {
  if (!haveProgram("gdalinfo")) GTEST_SKIP() << "gdalinfo is not installed (package gdal-bin)";
  const TempFolder folder;
  expectAgreesWithGdalinfo(test::writeTiff(folder.file("dem.tif"), {}), {});
  expectAgreesWithGdalinfo(test::writeBytes(folder.file("dem.asc"), test::smallAsc()), {});
  ImportOptions options;
  options.epsg = 31287;
  expectAgreesWithGdalinfo(SPIN_SOURCE_DIR "/resources/scenes/kontertal.assets/dem_5m.asc", options);
}

TEST(Interop, ExampleTerrainIsWhatItsCreditSays) {
  ImportOptions options;
  options.epsg = 31287;
  const auto import =
      test::readTerrain(SPIN_SOURCE_DIR "/resources/scenes/kontertal.assets/dem_5m.asc", options);
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_EQ(import->terrain->heights.width, 438);
  EXPECT_EQ(import->terrain->heights.height, 516);
  EXPECT_EQ(import->terrain->geo.epsg, 31287);
  EXPECT_EQ(import->terrain->credit, "Datenquelle: Land Tirol - data.tirol.gv.at");
  EXPECT_TRUE(import->summary.warnings.empty()) << import->summary.warnings.front();
}

void expectAgreesWithAssimp(const std::string& path) {
  const auto import = test::readModel(path);
  ASSERT_TRUE(import.ok()) << import.error().text();
  const std::string info = outputOf("assimp info '" + path + "'");
  EXPECT_EQ(std::stod(lineOf(import->summary, "Meshes")), numberAfter(info, "Meshes:")) << info;
  EXPECT_EQ(std::stod(lineOf(import->summary, "Triangles")), numberAfter(info, "Faces:"));
  // "Minimum point      (-1.0 2.0 3.0)": in the file's axes, so extents are compared as a set.
  const auto point = [&](const char* label) {
    Vec3d p;
    const char* at = info.c_str() + info.find('(', info.find(label)) + 1;
    char* end = nullptr;
    p.x = std::strtod(at, &end);
    p.y = std::strtod(end, &end);
    p.z = std::strtod(end, &end);
    return p;
  };
  const Vec3d low = point("Minimum point"), high = point("Maximum point");
  const Vec3d size = import->model->bounds().size();
  const bool yUp = lineOf(import->summary, "Up axis")[0] == 'y';
  EXPECT_NEAR(size.x, high.x - low.x, 1e-3);
  EXPECT_NEAR(size.y, yUp ? high.z - low.z : high.y - low.y, 1e-3);
  EXPECT_NEAR(size.z, yUp ? high.y - low.y : high.z - low.z, 1e-3);
}

TEST(Interop, ModelSummaryAgreesWithAssimp) {
  if (!haveProgram("assimp")) GTEST_SKIP() << "assimp is not installed (package assimp-utils)";
  const TempFolder folder;
  test::writeBytes(folder.file("box.mtl"), test::boxMtl(""));
  expectAgreesWithAssimp(test::writeBytes(folder.file("box.ply"), test::boxPly()));
  expectAgreesWithAssimp(test::writeBytes(folder.file("box.obj"), test::boxObj()));
  expectAgreesWithAssimp(test::writeBytes(folder.file("box.glb"), test::boxGlb()));
}

/// Files made by another program: STL (z up, no unit) and FBX (centimetres, y up).
TEST(Interop, StlAndFbxMadeByAssimpAreRead) {
  if (!haveProgram("assimp")) GTEST_SKIP() << "assimp is not installed (package assimp-utils)";
  const TempFolder folder;
  test::writeBytes(folder.file("box.mtl"), test::boxMtl(""));
  test::writeBytes(folder.file("box.obj"), test::boxObj());
  for (const char* name : {"box.stl", "box.fbx"}) {
    // Assimp 5.2.5 cannot read its own binary FBX, so the text form is made.
    const char* format = std::string(name) == "box.fbx" ? "-ffbxa" : "-fstl";
    outputOf("assimp export '" + folder.file("box.obj") + "' '" + folder.file(name) + "' " + format);
    const auto import = test::readModel(folder.file(name));
    ASSERT_TRUE(import.ok()) << import.error().text();
    const bool fbx = std::string(name) == "box.fbx";
    const Vec3d size = import->model->bounds().size(),
                expected = fbx ? Vec3d{0.02, 0.03, 0.01} : Vec3d{2, 1, 3};
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(size[axis], expected[axis], 1e-5) << name << " axis " << axis;
    EXPECT_EQ(import->model->triangleCount(), 12u);
    EXPECT_EQ(lineOf(import->summary, "Unit"), fbx ? "0.01 m" : "1 m");
  }
}

}  // namespace
}  // namespace spin
