// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/model_files.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::lineOf;
using test::TempFolder;

class ModelImportTest : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& bytes) {
    return test::writeBytes(m_folder.file(name), bytes);
  }
  ModelImport read(const std::string& path, const ImportOptions& options = {}) {
    auto import = test::readModel(path, options);
    EXPECT_TRUE(import.ok()) << import.error().text();
    return import.ok() ? *import : ModelImport{std::make_shared<ModelData>(), {}};
  }

  TempFolder m_folder;
};

void expectBox(const Box3d& box, Vec3d low, Vec3d high) {
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.min[axis], low[axis], 1e-5) << "axis " << axis;
    EXPECT_NEAR(box.max[axis], high[axis], 1e-5) << "axis " << axis;
  }
}

/// Six times the volume; positive if the triangles face outward.
double orientedVolume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const auto p = [&](std::size_t k) { return mesh.positions[mesh.indices[t + k]].to<double>(); };
    sum += dot(p(0), cross(p(1), p(2)));
  }
  return sum;
}

TEST_F(ModelImportTest, GltfStandsUprightInMetresWithItsInstances) {
  test::writePaint(m_folder.file("paint.png"));
  const ModelImport import = read(write("box.gltf", test::boxGltf("paint.png")));
  const ModelData& model = *import.model;
  ASSERT_EQ(model.meshes.size(), 1u);
  ASSERT_EQ(model.instances.size(), 2u);
  // 2 wide, 3 deep to the south, 1 high.
  Box3d box;
  for (const Vec3f& p : model.meshes[0].positions) box.extend(p.to<double>());
  expectBox(box, {0, -3, 0}, {2, 0, 1});
  EXPECT_NEAR(orientedVolume(model.meshes[0]), 6 * 6.0, 1e-4) << "turned inside out";
  EXPECT_EQ(model.instances[0].transform, Transform{});
  // A quarter turn about the vertical: the far corner (2, -3) goes to (3, 2) before it is moved 10 east.
  const Vec3d far = model.instances[1].transform.point({2, -3, 1});
  EXPECT_NEAR(far.x, 13.0, 1e-5);
  EXPECT_NEAR(far.y, 2.0, 1e-5);
  EXPECT_NEAR(far.z, 1.0, 1e-5);
  EXPECT_EQ(model.triangleCount(), 24u);
  EXPECT_EQ(lineOf(import.summary, "Triangles"), "12");
  EXPECT_EQ(lineOf(import.summary, "Instances"), "2 (24 triangles)");
  EXPECT_EQ(lineOf(import.summary, "Size"), "13.000 x 5.000 x 1.000 m");
  EXPECT_EQ(lineOf(import.summary, "Up axis"), "y, as glTF defines");
}

TEST_F(ModelImportTest, GltfMaterialAndTexture) {
  test::writePaint(m_folder.file("paint.png"));
  const ModelImport import = read(write("box.gltf", test::boxGltf("paint.png")));
  const ModelData& model = *import.model;
  ASSERT_EQ(model.materials.size(), 1u);
  const Material& paint = model.materials[0];
  EXPECT_EQ(paint.name, "paint");
  EXPECT_EQ(paint.baseColour, (Vec4f{1.0f, 0.5f, 0.25f, 1.0f}));
  EXPECT_FLOAT_EQ(paint.roughness, 0.7f);
  EXPECT_TRUE(paint.alphaCutout);
  EXPECT_TRUE(paint.doubleSided);
  ASSERT_EQ(paint.texture, 0);
  const Image8& image = model.textures.at(0);
  EXPECT_EQ(image.width, 4);
  EXPECT_EQ(image.height, 2);
  // Top row red, its right half transparent; bottom row blue.
  EXPECT_EQ((std::vector<std::uint8_t>(image.rgba.begin(), image.rgba.begin() + 4)),
            (std::vector<std::uint8_t>{255, 0, 0, 255}));
  EXPECT_EQ(image.rgba[15], 0);
  EXPECT_EQ(image.rgba[4 * 4 + 2], 255);
  // glTF's texture coordinates count from the top left as ours: 0.25 stays 0.25.
  float highest = 0.0f;
  for (const Vec2f& uv : model.meshes[0].uvs) highest = std::max(highest, uv.y);
  EXPECT_NEAR(highest, 0.25f, 1e-6f);
}

TEST_F(ModelImportTest, ObjIsTurnedUprightAndReadsItsMaterial) {
  test::writePaint(m_folder.file("paint.png"));
  write("box.mtl", test::boxMtl("paint.png"));
  const ModelImport import = read(write("box.obj", test::boxObj()));
  expectBox(import.model->bounds(), {0, -3, 0}, {2, 0, 1});
  EXPECT_GT(orientedVolume(import.model->meshes.at(0)), 0.0);
  const Material& paint = import.model->materials.at(import.model->meshes[0].material >= 0 ? 0 : 1);
  EXPECT_NEAR(paint.baseColour.x, 0.9f, 1e-5f);
  ASSERT_EQ(paint.texture, 0);
  EXPECT_TRUE(paint.alphaCutout) << "the picture has holes";
  // OBJ counts from the bottom: 0.25 up is 0.75 down.
  float lowest = 1.0f;
  for (const Vec2f& uv : import.model->meshes[0].uvs) lowest = std::min(lowest, uv.y);
  EXPECT_NEAR(lowest, 0.75f, 1e-6f);
}

TEST_F(ModelImportTest, PlyIsZUpAndGetsNormals) {
  const ModelImport import = read(write("box.ply", test::boxPly()));
  expectBox(import.model->bounds(), {0, 0, 0}, {2, 1, 3});
  const Mesh& mesh = import.model->meshes.at(0);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    EXPECT_NEAR(length(mesh.normals[i]), 1.0f, 1e-5f);
    // At a corner of a box the normal points away from its middle.
    EXPECT_GT(dot(mesh.normals[i].to<double>(), mesh.positions[i].to<double>() - Vec3d{1, 0.5, 1.5}), 0.0);
  }
  EXPECT_TRUE(test::mentions(import.summary.warnings, "without normals"));
}

TEST_F(ModelImportTest, AxisAndUnitOfTheImportWin) {
  ImportOptions options;
  options.upAxis = 1;
  options.unitScale = 0.01;
  const ModelImport import = read(write("box.ply", test::boxPly()), options);
  expectBox(import.model->bounds(), {0, -0.03, 0}, {0.02, 0, 0.01});
  EXPECT_EQ(lineOf(import.summary, "Up axis"), "y, as chosen");
  EXPECT_EQ(lineOf(import.summary, "Unit"), "0.01 m");
  options.upAxis = 2;
  options.unitScale = 1.0;
  expectBox(read(write("box.obj", test::boxObj()), options).model->bounds(), {0, 0, 0}, {2, 1, 3});
}

TEST_F(ModelImportTest, GlbIsTheSameAsGltf) {
  const ModelImport glb = read(write("box.glb", test::boxGlb()));
  const ModelImport gltf = read(write("box.gltf", test::boxGltf("")));
  ASSERT_EQ(glb.model->meshes.size(), 1u);
  EXPECT_EQ(glb.model->meshes[0].positions, gltf.model->meshes.at(0).positions);
  EXPECT_EQ(glb.model->instances.size(), 2u);
  EXPECT_EQ(glb.model->materials.at(0).texture, -1);
}

TEST_F(ModelImportTest, EmptyTrianglesAreLeftOutAndCounted) {
  std::string ply = test::boxPly();
  ply.replace(ply.find("element face 12"), 15, "element face 14");
  const ModelImport import = read(write("box.ply", ply + "3 0 0 1\n3 5 5 5\n"));
  EXPECT_EQ(import.model->triangleCount(), 12u);
  EXPECT_TRUE(test::mentions(import.summary.warnings, "2 triangles without area"));
}

TEST_F(ModelImportTest, TrianglesAgainstTheirNormalsAreTurned) {
  // Normals up, corners clockwise seen from above.
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 1\n0 1 0 0 0 1\n1 0 0 0 0 1\n3 0 1 2\n";
  const ModelImport import = read(write("tri.ply", ply));
  const Mesh& mesh = import.model->meshes.at(0);
  const auto p = [&](std::size_t k) { return mesh.positions[mesh.indices[k]].to<double>(); };
  EXPECT_GT(cross(p(1) - p(0), p(2) - p(0)).z, 0.0);
  EXPECT_TRUE(test::mentions(import.summary.warnings, "1 triangles were wound against"));
}

TEST_F(ModelImportTest, NamesWithPercentSignsAndBackSlashesAreFound) {
  std::filesystem::create_directory(m_folder.file("my tex"));
  test::writePaint(m_folder.file("my tex/paint.png"));
  EXPECT_EQ(read(write("box.gltf", test::boxGltf("my%20tex/paint.png"))).model->textures.size(), 1u);
  write("box.mtl", test::boxMtl("my tex\\paint.png"));
  EXPECT_EQ(read(write("box.obj", test::boxObj())).model->textures.size(), 1u);
}

}  // namespace
}  // namespace spin
