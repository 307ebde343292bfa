// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/content_hash.h"

#include <gtest/gtest.h>

namespace spin {
namespace {

TerrainData ramp() {
  TerrainData terrain;
  terrain.heights = Raster<float>(3, 2, 10.0, 20.0, 5.0, 1.0f);
  return terrain;
}

ModelData twoTriangles() {
  ModelData model;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.indices = {0, 1, 2, 2, 1, 3};
  model.meshes = {mesh};
  model.instances.resize(1);
  return model;
}

TEST(ContentHashTest, TerrainCountsByHeightsAndPlace) {
  const Hash128 key = contentHash(ramp());
  EXPECT_EQ(contentHash(ramp()), key);
  TerrainData other = ramp();
  other.credit = "somebody";
  other.geo.epsg = 31287;
  EXPECT_EQ(contentHash(other), key) << "what the simulation does not see";
  other.heights.at(2, 1) += 1e-3f;
  EXPECT_NE(contentHash(other), key);
  other = ramp();
  other.heights.cellSize = 5.5;
  EXPECT_NE(contentHash(other), key);
  other = ramp();
  other.heights.originX += 0.25;
  EXPECT_NE(contentHash(other), key);
  other = ramp();
  std::swap(other.heights.width, other.heights.height);
  EXPECT_NE(contentHash(other), key) << "the same values in another shape";
}

TEST(ContentHashTest, ModelCountsByGeometryAndInstances) {
  const Hash128 key = contentHash(twoTriangles());
  ModelData other = twoTriangles();
  other.meshes[0].name = "roof";
  other.warnings = {"one face is flat"};
  EXPECT_EQ(contentHash(other), key) << "what the simulation does not see";
  other.meshes[0].positions[3].z = 1e-3f;
  EXPECT_NE(contentHash(other), key);
  other = twoTriangles();
  std::swap(other.meshes[0].indices[1], other.meshes[0].indices[2]);
  EXPECT_NE(contentHash(other), key);
  other = twoTriangles();
  other.instances[0].transform.translation.z = 1e-9;
  EXPECT_NE(contentHash(other), key);
  other = twoTriangles();
  other.instances.push_back(other.instances[0]);
  EXPECT_NE(contentHash(other), key);
}

}  // namespace
}  // namespace spin
