// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "editor/render/model_pass.h"
#include "editor/render/texel_code.h"

namespace spin {
namespace {

struct Vertex {
  Vec3f position, normal;
  Vec2f uv;
};

std::vector<Vec3f> smoothNormals(const Mesh& mesh) {
  std::vector<Vec3f> normals(mesh.positions.size());
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const Vec3f a = mesh.positions[mesh.indices[t]];
    const Vec3f face =
        cross(mesh.positions[mesh.indices[t + 1]] - a, mesh.positions[mesh.indices[t + 2]] - a);
    for (std::size_t k = 0; k < 3; ++k) normals[mesh.indices[t + k]] += face;
  }
  for (Vec3f& n : normals) n = normalized(n);
  return normals;
}

bool usable(const Mesh& mesh) {
  const auto inside = [&](std::uint32_t i) { return i < mesh.positions.size(); };
  return std::all_of(mesh.indices.begin(), mesh.indices.end(), inside);
}

void append(const Mesh& mesh, std::vector<Vertex>& vertices) {
  const bool hasNormals = mesh.normals.size() == mesh.positions.size();
  const std::vector<Vec3f> made = hasNormals ? std::vector<Vec3f>{} : smoothNormals(mesh);
  const std::vector<Vec3f>& normals = hasNormals ? mesh.normals : made;
  const bool hasUvs = mesh.uvs.size() == mesh.positions.size();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    vertices.push_back({mesh.positions[v], normals[v], hasUvs ? mesh.uvs[v] : Vec2f{}});
}

GlTexture uploadTexture(const Image8& image) {
  const auto size = static_cast<std::size_t>(std::max(image.width, 0)) *
                    static_cast<std::size_t>(std::max(image.height, 0));
  if (size == 0 || image.rgba.size() != size * 4) return {};
  std::array<std::uint8_t, 256> root{};
  for (std::size_t k = 0; k < root.size(); ++k)
    root[k] = encodeRoot(srgbToLinear(static_cast<std::uint8_t>(k)));
  std::vector<std::uint8_t> texels = image.rgba;
  for (std::size_t k = 0; k < texels.size(); ++k)
    if (k % 4 != 3) texels[k] = root[texels[k]];
  GlTexture texture = GlTexture::make(GLenum{GL_TEXTURE_2D});
  int levels = 1;
  while ((std::max(image.width, image.height) >> levels) > 0) ++levels;
  glTextureStorage2D(texture.id(), levels, GL_RGBA8, image.width, image.height);
  glTextureSubImage2D(texture.id(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      texels.data());
  glGenerateTextureMipmap(texture.id());
  setSampling(texture, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT);
  return texture;
}

}  // namespace

GpuModel GpuModel::upload(std::shared_ptr<const ModelData> model) {
  GpuModel gpu;
  gpu.bounds = model->bounds();
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  for (const Mesh& mesh : model->meshes) {
    Part part;
    part.material = mesh.material;
    if (usable(mesh)) {
      const auto first = static_cast<std::uint32_t>(vertices.size());
      part.firstIndex = indices.size();
      part.count = static_cast<GLsizei>(mesh.indices.size() / 3 * 3);
      append(mesh, vertices);
      for (const Vec3f& p : mesh.positions) part.bounds.extend(p.to<double>());
      for (const std::uint32_t i : mesh.indices) indices.push_back(first + i);
    }
    gpu.parts.push_back(part);
  }
  for (const Image8& image : model->textures) gpu.textures.push_back(uploadTexture(image));
  gpu.vertices = GlBuffer::make();
  gpu.indices = GlBuffer::make();
  if (!vertices.empty())
    glNamedBufferStorage(gpu.vertices.id(), static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                         vertices.data(), 0);
  if (!indices.empty())
    glNamedBufferStorage(gpu.indices.id(), static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                         indices.data(), 0);
  gpu.data = std::move(model);
  return gpu;
}

}  // namespace spin
