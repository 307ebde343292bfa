// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/host/codec_lists.h"
#include "plugins/host/import_checks.h"
#include "plugins/host/import_codec.h"

namespace spin {
namespace {

void encodeMesh(ByteWriter& out, const Mesh& mesh) {
  out.put(mesh.name);
  out.putArray(mesh.positions);
  out.putArray(mesh.normals);
  out.putArray(mesh.uvs);
  out.putArray(mesh.indices);
  out.put(mesh.material);
}

Mesh decodeMesh(ByteReader& in) {
  Mesh mesh;
  mesh.name = in.getText();
  mesh.positions = in.getArray<Vec3f>();
  mesh.normals = in.getArray<Vec3f>();
  mesh.uvs = in.getArray<Vec2f>();
  mesh.indices = in.getArray<std::uint32_t>();
  mesh.material = in.get<int>();
  return mesh;
}

void encodeMaterial(ByteWriter& out, const Material& material) {
  out.put(material.name);
  out.put(material.baseColour);
  out.put(material.texture);
  out.put(material.roughness);
  out.put(material.alphaCutout);
  out.put(material.doubleSided);
}

Material decodeMaterial(ByteReader& in) {
  Material material;
  material.name = in.getText();
  material.baseColour = in.get<Vec4f>();
  material.texture = in.get<int>();
  material.roughness = in.get<float>();
  material.alphaCutout = in.get<std::uint8_t>() != 0;
  material.doubleSided = in.get<std::uint8_t>() != 0;
  return material;
}

void encodeImage(ByteWriter& out, const Image8& image) {
  out.put(image.width);
  out.put(image.height);
  out.putArray(image.rgba);
}

Image8 decodeImage(ByteReader& in) {
  Image8 image;
  image.width = in.get<int>();
  image.height = in.get<int>();
  image.rgba = in.getArray<std::uint8_t>();
  return image;
}

void encodeInstance(ByteWriter& out, const MeshInstance& instance) {
  out.put(instance.mesh);
  out.put(instance.transform);
}

MeshInstance decodeInstance(ByteReader& in) {
  MeshInstance instance;
  instance.mesh = in.get<int>();
  instance.transform = in.get<Transform>();
  return instance;
}

}  // namespace

void encode(ByteWriter& out, const ModelImport& import) {
  const ModelData& model = *import.model;
  encodeAll(out, model.textures, encodeImage);
  encodeAll(out, model.materials, encodeMaterial);
  encodeAll(out, model.meshes, encodeMesh);
  encodeAll(out, model.instances, encodeInstance);
  encodeTexts(out, model.warnings);
  encodeSummary(out, import.summary);
}

Result<ModelImport> decodeModel(ByteReader& in, const std::string& path) {
  auto model = std::make_shared<ModelData>();
  model->textures = decodeAll(in, decodeImage);
  model->materials = decodeAll(in, decodeMaterial);
  model->meshes = decodeAll(in, decodeMesh);
  model->instances = decodeAll(in, decodeInstance);
  model->warnings = decodeTexts(in);
  ImportSummary summary = decodeSummary(in);
  if (!in.ok() || !in.atEnd())
    return Error{ErrorKind::Failed, "The import failed", path, "the import helper's answer is damaged",
                 "Try again; if it happens again, report the file to the makers of the program"};
  if (Status status = checkModel(*model, path); !status) return status.error();
  return ModelImport{model, std::move(summary)};
}

}  // namespace spin
