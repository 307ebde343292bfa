// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/math/transform.h"

namespace spin {

/// 8-bit image, rows from the top, 4 channels (RGBA, sRGB colour).
struct Image8 {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  bool empty() const { return rgba.empty(); }
};

struct Material {
  std::string name;
  Vec4f baseColour{0.8f, 0.8f, 0.8f, 1.0f};  ///< linear RGB and opacity
  int texture = -1;                          ///< index into ModelData::textures, -1 = none
  float roughness = 0.9f;
  bool alphaCutout = false;  ///< discard texels with alpha < 0.5
  bool doubleSided = true;
};

/// Triangles with one material. normals and uvs are empty or as long as positions.
struct Mesh {
  std::string name;
  std::vector<Vec3f> positions;  ///< m
  std::vector<Vec3f> normals;
  std::vector<Vec2f> uvs;              ///< (0, 0) is the image's top left
  std::vector<std::uint32_t> indices;  ///< 3 per triangle
  int material = 0;
};

struct MeshInstance {
  int mesh = 0;
  Transform transform;  ///< mesh to model space
};

/// An imported model: z up, metres.
struct ModelData {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Image8> textures;
  std::vector<MeshInstance> instances;
  std::vector<std::string> warnings;  ///< what the reader mended or left out

  /// Bounding box of all instances, model space.
  Box3d bounds() const;
  std::size_t triangleCount() const;
};

}  // namespace spin
