// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/model_files.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace spin::test {
namespace {

// Corners of the box: bit 0 = x, bit 1 = y, bit 2 = z.
float corner(int index, int axis) {
  const float size[] = {2.0f, 1.0f, 3.0f};
  return (index >> axis & 1) != 0 ? size[axis] : 0.0f;
}

// Outward triangles.
constexpr std::uint16_t kTriangles[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                          2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

/// Positions, texture coordinates, indices.
std::string boxBuffer() {
  std::string bytes;
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) put(corner(i, axis));
  for (int i = 0; i < 8; ++i) {
    put(static_cast<float>(i & 1));
    put(static_cast<float>(i >> 1 & 1) * 0.25f);
  }
  for (const std::uint16_t index : kTriangles) put(index);
  return bytes;
}

std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (int k = 3; k >= 0; --k) out += digits[word >> (6 * k) & 63];
  }
  for (std::size_t i = 0; i < (3 - bytes.size() % 3) % 3; ++i) out[out.size() - 1 - i] = '=';
  return out;
}

std::string boxJson(const std::string& bufferUri, const std::string& textureUri) {
  const std::string texture = textureUri.empty() ? "" : R"("baseColorTexture":{"index":0},)";
  const std::string images =
      textureUri.empty()
          ? ""
          : fmt::format(R"("images":[{{"uri":"{}"}}],"textures":[{{"source":0}}],)", textureUri);
  return fmt::format(R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0,1]}}],
"nodes":[{{"name":"here","mesh":0}},{{"name":"there","mesh":0,"translation":[10,0,0],"rotation":[0,0.70710678,0,0.70710678]}}],
"meshes":[{{"name":"box","primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1}},"indices":2,"material":0}}]}}],
"materials":[{{"name":"paint","pbrMetallicRoughness":{{{}"baseColorFactor":[1,0.5,0.25,1],"roughnessFactor":0.7}},"alphaMode":"MASK","doubleSided":true}}],{}
"accessors":[{{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,0],"max":[2,1,3]}},
{{"bufferView":1,"componentType":5126,"count":8,"type":"VEC2"}},{{"bufferView":2,"componentType":5123,"count":36,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":96}},{{"buffer":0,"byteOffset":96,"byteLength":64}},{{"buffer":0,"byteOffset":160,"byteLength":72}}],
"buffers":[{{{}"byteLength":232}}]}})",
                     texture, images, bufferUri);
}

}  // namespace

std::string boxGltf(const std::string& textureUri) {
  return boxJson("\"uri\":\"data:application/octet-stream;base64," + base64(boxBuffer()) + "\",", textureUri);
}

std::string boxGlb() {
  std::string json = boxJson("", "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = boxBuffer();
  std::string out;
  const auto put = [&](std::size_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    out.append(reinterpret_cast<const char*>(&word), 4);
  };
  out += "glTF";
  put(2);
  put(12 + 8 + json.size() + 8 + buffer.size());
  put(json.size());
  out += "JSON" + json;
  put(buffer.size());
  out += std::string("BIN\0", 4) + buffer;
  return out;
}

std::string boxObj() {
  std::string text = "mtllib box.mtl\no box\n";
  for (int i = 0; i < 8; ++i) text += fmt::format("v {} {} {}\n", corner(i, 0), corner(i, 1), corner(i, 2));
  text += "vt 0 0\nvt 1 0\nvt 0 0.25\nvt 1 0.25\nusemtl paint\n";
  for (int t = 0; t < 36; t += 3) {
    text += "f";
    for (int k = 0; k < 3; ++k)
      text += fmt::format(" {}/{}", kTriangles[t + k] + 1, kTriangles[t + k] % 4 + 1);
    text += "\n";
  }
  return text;
}

std::string boxMtl(const std::string& texture) {
  return "newmtl paint\nKd 0.9 0.8 0.7\n" + (texture.empty() ? "" : "map_Kd " + texture + "\n");
}

std::string boxPly() {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 12\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 8; ++i) text += fmt::format("{} {} {}\n", corner(i, 0), corner(i, 1), corner(i, 2));
  for (int t = 0; t < 36; t += 3)
    text += fmt::format("3 {} {} {}\n", kTriangles[t], kTriangles[t + 1], kTriangles[t + 2]);
  return text;
}

void writePaint(const std::string& path) {
  cv::Mat picture(2, 4, CV_8UC4);
  for (int x = 0; x < 4; ++x) {
    picture.at<cv::Vec4b>(0, x) = {0, 0, 255, static_cast<unsigned char>(x < 2 ? 255 : 0)};
    picture.at<cv::Vec4b>(1, x) = {255, 0, 0, 255};
  }
  cv::imwrite(path, picture);
}

}  // namespace spin::test
