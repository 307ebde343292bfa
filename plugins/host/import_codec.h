// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/scene/asset_library.h"
#include "core/sim/serialize.h"

/// Binary form of what travels between the program and its import helper. Encoders and decoders are of one
/// build, so there are no versions; decoders trust nothing: sizes are bounded by the bytes that are there and
/// the results have passed import_checks.h.
namespace spin {

enum class ImportTask : std::uint8_t { ReadTerrain, ReadModel, ReadLayer, ReadRaster, WriteLayer };

/// What the helper is asked to do.
struct HelperRequest {
  ImportTask task = ImportTask::ReadTerrain;
  std::string path;  ///< absolute
  ImportOptions options;
  PaintedLayer layer;   ///< WriteLayer only
  LayerFormat format;   ///< WriteLayer only
  TerrainData terrain;  ///< WriteLayer only: shape and georeference, no heights
};

std::vector<char> encodeRequest(const HelperRequest& request);
Result<HelperRequest> decodeRequest(const char* data, std::size_t size);

void encode(ByteWriter& out, const Error& error);
void encode(ByteWriter& out, const TerrainImport& import);
void encode(ByteWriter& out, const ModelImport& import);
void encode(ByteWriter& out, const PaintedLayer& layer);
void encode(ByteWriter& out, const RasterImport& import);

Error decodeError(ByteReader& in);
Result<TerrainImport> decodeTerrain(ByteReader& in, const std::string& path);
Result<ModelImport> decodeModel(ByteReader& in, const std::string& path);
Result<PaintedLayer> decodeLayer(ByteReader& in, const std::string& path);
Result<RasterImport> decodeRaster(ByteReader& in, const std::string& path);

/// An answer is a seal (magic number, size, content hash) and then a flag (1 = value, 0 = Error) with the
/// encoded rest, so that a half-written or accidental file is told from an answer.
std::vector<char> sealAnswer(const std::vector<char>& payload);
/// Start of the payload within the data; an Error if the seal is broken.
Result<std::size_t> openAnswer(const char* data, std::size_t size, const std::string& path);

}  // namespace spin
