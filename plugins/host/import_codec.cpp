// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/host/import_codec.h"

#include "core/base/hash.h"
#include "plugins/host/codec_lists.h"
#include "plugins/host/import_checks.h"

namespace spin {
namespace {

constexpr std::uint64_t kAnswerMagic = 0x31504d494e495053ull;  // "SPINIMP1"

struct AnswerSeal {
  std::uint64_t magic;
  std::uint64_t size;
  std::uint64_t hashHigh;
  std::uint64_t hashLow;
};

AnswerSeal sealOf(const char* payload, std::size_t size) {
  const Hash128 hash = Hasher().addBytes(payload, size).digest();
  return {kAnswerMagic, size, hash.high, hash.low};
}

void encodeTerrain(ByteWriter& out, const TerrainData& terrain) {
  const Raster<float>& r = terrain.heights;
  out.put(r.width);
  out.put(r.height);
  out.put(r.originX);
  out.put(r.originY);
  out.put(r.cellSize);
  out.putArray(r.values);
  out.put(terrain.geo.origin);
  out.put(terrain.geo.epsg);
  out.put(terrain.geo.wkt);
  out.put(terrain.credit);
}

TerrainData decodeTerrainData(ByteReader& in) {
  TerrainData terrain;
  Raster<float>& r = terrain.heights;
  r.width = in.get<int>();
  r.height = in.get<int>();
  r.originX = in.get<double>();
  r.originY = in.get<double>();
  r.cellSize = in.get<double>();
  r.values = in.getArray<float>();
  terrain.geo.origin = in.get<Vec3d>();
  terrain.geo.epsg = in.get<int>();
  terrain.geo.wkt = in.getText();
  terrain.credit = in.getText();
  return terrain;
}

void encodeFormat(ByteWriter& out, const LayerFormat& format) {
  out.put(format.name);
  out.put(format.unit);
  out.put(format.bits);
  out.put(format.low);
  out.put(format.high);
}

LayerFormat decodeFormat(ByteReader& in) {
  LayerFormat format;
  format.name = in.getText();
  format.unit = in.getText();
  format.bits = in.get<int>();
  format.low = in.get<double>();
  format.high = in.get<double>();
  return format;
}

Error brokenAnswer(const std::string& path, const char* why) {
  return {ErrorKind::Failed, "The import failed", path, why,
          "Try again; if it happens again, report the file to the makers of the program"};
}

}  // namespace

std::vector<char> encodeRequest(const HelperRequest& request) {
  ByteWriter out;
  out.put(request.task);
  out.put(request.path);
  out.put(request.options);
  encode(out, request.layer);
  encodeFormat(out, request.format);
  encodeTerrain(out, request.terrain);
  return out.take();
}

Result<HelperRequest> decodeRequest(const char* data, std::size_t size) {
  ByteReader in(data, size);
  HelperRequest request;
  request.task = in.get<ImportTask>();
  request.path = in.getText();
  request.options = in.get<ImportOptions>();
  Result<PaintedLayer> layer = decodeLayer(in, request.path);
  if (!layer) return layer.error();
  request.layer = std::move(*layer);
  request.format = decodeFormat(in);
  request.terrain = decodeTerrainData(in);
  if (!in.ok() || !in.atEnd()) return brokenAnswer(request.path, "the request is damaged");
  return request;
}

void encode(ByteWriter& out, const Error& error) {
  out.put(static_cast<std::int32_t>(error.kind));
  out.put(error.what);
  out.put(error.where);
  out.put(error.why);
  out.put(error.advice);
  out.put(error.more);
}

Error decodeError(ByteReader& in) {
  Error error;
  const auto kind = in.get<std::int32_t>();
  error.kind = kind >= 0 && kind <= static_cast<int>(ErrorKind::Cancelled) ? static_cast<ErrorKind>(kind)
                                                                           : ErrorKind::Failed;
  error.what = in.getText();
  error.where = in.getText();
  error.why = in.getText();
  error.advice = in.getText();
  error.more = in.getText();
  return error;
}

void encode(ByteWriter& out, const TerrainImport& import) {
  encodeTerrain(out, *import.terrain);
  encodeSummary(out, import.summary);
}

Result<TerrainImport> decodeTerrain(ByteReader& in, const std::string& path) {
  auto terrain = std::make_shared<TerrainData>(decodeTerrainData(in));
  TerrainImport import{terrain, decodeSummary(in)};
  if (!in.ok() || !in.atEnd()) return brokenAnswer(path, "the import helper's answer is damaged");
  if (Status status = checkTerrain(*terrain, path); !status) return status.error();
  return import;
}

void encode(ByteWriter& out, const RasterImport& import) {
  encodeTerrain(out, {import.values, import.geo, {}});
  out.put(std::uint8_t{import.georeferenced});
  out.put(import.bits);
}

Result<RasterImport> decodeRaster(ByteReader& in, const std::string& path) {
  TerrainData data = decodeTerrainData(in);
  RasterImport import{std::move(data.heights), data.geo, in.get<std::uint8_t>() != 0, in.get<int>()};
  if (!in.ok() || !in.atEnd()) return brokenAnswer(path, "the import helper's answer is damaged");
  if (Status status = checkRaster(import.values, import.geo, path); !status) return status.error();
  if (import.bits != 0 && import.bits != 8 && import.bits != 16)
    return brokenAnswer(path, "the import helper's answer is damaged");
  return import;
}

std::vector<char> sealAnswer(const std::vector<char>& payload) {
  ByteWriter out;
  out.put(sealOf(payload.data(), payload.size()));
  return out.take();
}

Result<std::size_t> openAnswer(const char* data, std::size_t size, const std::string& path) {
  if (size == 0) return brokenAnswer(path, "the import helper gave no answer");
  ByteReader in(data, size);
  const auto seal = in.get<AnswerSeal>();
  if (!in.ok() || seal.magic != kAnswerMagic || seal.size != size - sizeof seal)
    return brokenAnswer(path, "the import helper gave an unusable answer");
  const AnswerSeal found = sealOf(data + sizeof seal, size - sizeof seal);
  if (found.hashHigh != seal.hashHigh || found.hashLow != seal.hashLow)
    return brokenAnswer(path, "the import helper's answer is damaged");
  return sizeof seal;
}

}  // namespace spin
