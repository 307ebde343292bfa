// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Models that are damaged, hostile or lack files: an error that says why, or the model with a warning.
#include "tests/plugins/model_files.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::expectError;
using test::TempFolder;

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

class ModelHostile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& bytes) {
    return test::writeBytes(m_folder.file(name), bytes);
  }
  /// The model comes without its texture and with a warning.
  void expectNoTexture(const std::string& path, const std::string& warning) {
    const auto import = test::readModel(path);
    ASSERT_TRUE(import.ok()) << import.error().text();
    EXPECT_EQ(import->model->textures.size(), 0u);
    EXPECT_EQ(import->model->materials.at(0).texture, -1);
    EXPECT_EQ(import->model->triangleCount(), 24u);
    EXPECT_TRUE(test::mentions(import->summary.warnings, warning))
        << (import->summary.warnings.empty() ? "no warning" : import->summary.warnings.front());
  }

  TempFolder m_folder;
};

TEST_F(ModelHostile, CutOffFiles) {
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"cut.glb", test::boxGlb()},
                                    {"cut.gltf", test::boxGltf("")},
                                    {"cut.ply", test::boxPly()}}) {
    for (const std::size_t size : {bytes.size() / 2, bytes.size() / 10}) {
      const std::string path = write(name, bytes.substr(0, size));
      expectError(test::readModel(path), ErrorKind::BadInput, path, {"The model could not be read"});
    }
  }
}

TEST_F(ModelHostile, TextUnderTheNameOfAModel) {
  for (const char* name : {"a.glb", "a.gltf", "a.obj", "a.ply", "a.stl", "a.fbx"}) {
    const std::string path = write(name, "It was a dark and stormy night.\n");
    expectError(test::readModel(path), ErrorKind::BadInput, path, {"The model could not be read"});
  }
}

TEST_F(ModelHostile, NumbersThatAreNone) {
  std::string path = write("nan.ply", replaced(test::boxPly(), "2 1 3\n", "2 nan 3\n"));
  expectError(test::readModel(path), ErrorKind::BadInput, path, {"finite"});
  path = write("inf.obj", replaced(test::boxObj(), "v 2 1 3", "v 2 1e400 3"));
  EXPECT_FALSE(test::readModel(path).ok());
  path = write("far.ply", replaced(test::boxPly(), "2 1 3\n", "2 1 3e9\n"));
  expectError(test::readModel(path), ErrorKind::BadInput, path, {"from its origin", "unit"});
  path = write("where.gltf", replaced(test::boxGltf(""), "[10,0,0]", "[1e300,0,0]"));
  EXPECT_FALSE(test::readModel(path).ok());
}

TEST_F(ModelHostile, ClaimsOfHugeSizes) {
  std::string path =
      write("faces.ply", replaced(test::boxPly(), "element vertex 8", "element vertex 2000000000"));
  EXPECT_FALSE(test::readModel(path, {}, {std::size_t{256} << 20, 20.0}).ok());
  expectError(test::readModel(path), ErrorKind::BadInput, path, {"promises", "cut off"});
  path = write("count.gltf", replaced(test::boxGltf(""), "\"count\":8", "\"count\":2000000000"));
  EXPECT_FALSE(test::readModel(path, {}, {std::size_t{256} << 20, 20.0}).ok());
  path = write("index.ply", replaced(test::boxPly(), "3 0 2 1", "3 0 2 100"));
  EXPECT_FALSE(test::readModel(path).ok());
}

TEST_F(ModelHostile, MoreThanTheMemoryAllowed) {
  std::string obj;
  constexpr int kEdge = 300;
  for (int i = 0; i < kEdge * kEdge; ++i)
    obj += "v " + std::to_string(i % kEdge) + " " + std::to_string(i % 7) + " " + std::to_string(i / kEdge) +
           "\n";
  for (int i = 1; i < kEdge * (kEdge - 1); ++i)
    obj += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + kEdge) + "\n";
  const std::string path = write("large.obj", obj);
  const std::size_t before = test::peakMemory();
  expectError(test::readModel(path, {}, {std::size_t{1} << 20, 60.0}), ErrorKind::OutOfResources, path,
              {"memory"});
  EXPECT_LT(test::peakMemory(), before + (std::size_t{32} << 20));
}

/// Nodes nested so deep that Assimp 5.2.5 overruns its stack.
std::string deeplyNested() {
  constexpr int kDepth = 100000;
  std::string nodes;
  for (int i = 1; i < kDepth; ++i) nodes += "{\"children\":[" + std::to_string(i) + "]},";
  return replaced(replaced(test::boxGltf(""), "[{\"name\":\"here\"", "[" + nodes + "{\"name\":\"here\""),
                  "\"nodes\":[0,1]", "\"nodes\":[0]");
}

TEST_F(ModelHostile, FileThatCrashesTheLibrary) {
  const std::string path = write("deep.gltf", deeplyNested());
#if defined(__SANITIZE_ADDRESS__)
  EXPECT_FALSE(test::readModel(path).ok());  // the sanitizer turns the crash into an exit code
#else
  expectError(test::readModel(path), ErrorKind::BadInput, path, {"the reader crashed", "Segmentation fault"});
#endif
  // The next file is read as if nothing had been.
  EXPECT_TRUE(test::readModel(write("box.glb", test::boxGlb())).ok());
}

TEST_F(ModelHostile, NothingToLayOnSnow) {
  const std::string path =
      write("points.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n0 0 0\n1 1 1\n");
  EXPECT_FALSE(test::readModel(path).ok());
  std::string flat = test::boxPly();
  for (int i = 0; i < 8; ++i) {
    const std::size_t start = flat.find("end_header\n") + 11;
    std::size_t at = start;
    for (int k = 0; k < i; ++k) at = flat.find('\n', at) + 1;
    flat.replace(at, flat.find('\n', at) - at, "1 1 1");
  }
  const std::string flatPath = write("flat.ply", flat);
  EXPECT_FALSE(test::readModel(flatPath).ok());
}

TEST_F(ModelHostile, MissingTexture) {
  expectNoTexture(write("box.gltf", test::boxGltf("nowhere.png")), "no such file beside the model");
}

TEST_F(ModelHostile, TextureThatIsText) {
  write("paint.png", "It was a dark and stormy night.\n");
  expectNoTexture(write("box.gltf", test::boxGltf("paint.png")), "no picture");
}

TEST_F(ModelHostile, TextureThatClaimsAHugeSize) {
  test::writePaint(m_folder.file("paint.png"));
  std::string png = test::readBytes(m_folder.file("paint.png"));
  png.replace(16, 8, std::string("\x00\x00\xEA\x60\x00\x00\xEA\x60", 8));  // 60000 x 60000
  write("paint.png", png);
  const std::size_t before = test::peakMemory();
  expectNoTexture(write("box.gltf", test::boxGltf("paint.png")), "paint.png is left out");
  EXPECT_LT(test::peakMemory(), before + (std::size_t{16} << 20));
}

TEST_F(ModelHostile, TexturesOutsideTheModelsFolderAreRefused) {
  std::filesystem::create_directory(m_folder.file("inner"));
  test::writePaint(m_folder.file("paint.png"));
  const std::string absolute = m_folder.file("paint.png");
  for (const std::string& uri :
       {std::string("../paint.png"), absolute, std::string("http://example.com/paint.png"),
        std::string("x/../../paint.png"), std::string("%2e%2e/paint.png")})
    expectNoTexture(write("inner/box.gltf", test::boxGltf(uri)), "is left out");
}

TEST_F(ModelHostile, OtherFilesOutsideTheModelsFolderAreRefused) {
  std::filesystem::create_directory(m_folder.file("inner"));
  write("box.mtl", test::boxMtl(""));
  const std::string path = write("inner/box.obj", replaced(test::boxObj(), "box.mtl", "../box.mtl"));
  const auto import = test::readModel(path);
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_TRUE(test::mentions(import->summary.warnings, "outside the model's folder"));
  const std::string uri = "\"uri\":\"../secret.bin\",\"byteLength\":232";
  std::string gltf = test::boxGltf("");
  const std::size_t from = gltf.find("\"uri\":\"data:"), to = gltf.find("\"byteLength\":232", from);
  gltf.replace(from, to + 16 - from, uri);
  write("secret.bin", std::string(232, '\x00'));
  const std::string gltfPath = write("inner/box.gltf", gltf);
  expectError(test::readModel(gltfPath), ErrorKind::BadInput, gltfPath, {});
}

TEST_F(ModelHostile, MeshesScaledToNothingAreLeftOut) {
  const auto import = test::readModel(
      write("flat.gltf", replaced(test::boxGltf(""), "\"translation\":[10,0,0]", "\"scale\":[1,0,1]")));
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_EQ(import->model->instances.size(), 1u);
  EXPECT_TRUE(test::mentions(import->summary.warnings, "scaled to nothing"));
}

TEST_F(ModelHostile, OptionsThatMakeNoSense) {
  const std::string path = write("box.ply", test::boxPly());
  ImportOptions options;
  options.upAxis = 7;
  expectError(test::readModel(path, options), ErrorKind::Usage, path, {"up axis"});
  options = {};
  options.unitScale = -1.0;
  expectError(test::readModel(path, options), ErrorKind::Usage, path, {"unit"});
}

}  // namespace
}  // namespace spin
