// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>

#include "plugins/host/helper_process.h"
#include "plugins/host/import_codec.h"
#include "plugins/host/plugin_catalogue.h"
#include "plugins/host/plugin_host.h"

namespace spin {
namespace {

std::string helperProgram() {
  if (const char* given = std::getenv("SPIN_IMPORT_HELPER"); given && *given) return given;
  return (std::filesystem::path(programFolder()) / "spindrift-import-helper").string();
}

/// The commonest mistakes are told without starting anything.
Status checkReadable(const std::string& path) {
  const auto bad = [&](const std::string& why, const char* advice) {
    return Status(badInput("The file could not be read", path, why, advice));
  };
  struct stat about {};
  if (path.empty()) return bad("no file is named", "Choose a file");
  if (stat(path.c_str(), &about) != 0)
    return bad(errno == ENOENT ? "there is no such file" : std::strerror(errno),
               "Check the name, or choose where the file lies now");
  if (S_ISDIR(about.st_mode)) return bad("it is a folder", "Choose a file in it");
  if (!S_ISREG(about.st_mode)) return bad("it is a device, not a file", "Choose a file");
  if (access(path.c_str(), R_OK) != 0) return bad(std::strerror(errno), "Give yourself the right to read it");
  if (about.st_size == 0) return bad("it is empty", "Export or copy it again");
  return {};
}

class HelperAssetReader final : public AssetReader {
 public:
  explicit HelperAssetReader(ImportLimits limits) : m_limits(limits) {}

  Result<TerrainImport> readTerrain(const std::string& path, const ImportOptions& options,
                                    const CancelToken& cancel) override {
    return read<TerrainImport>({ImportTask::ReadTerrain, path, options, {}, {}, {}}, cancel, decodeTerrain);
  }
  Result<ModelImport> readModel(const std::string& path, const ImportOptions& options,
                                const CancelToken& cancel) override {
    return read<ModelImport>({ImportTask::ReadModel, path, options, {}, {}, {}}, cancel, decodeModel);
  }
  Result<PaintedLayer> readLayer(const std::string& path, const CancelToken& cancel) override {
    return read<PaintedLayer>({ImportTask::ReadLayer, path, {}, {}, {}, {}}, cancel, decodeLayer);
  }

  Result<RasterImport> readRaster(const std::string& path, const CancelToken& cancel) override {
    return read<RasterImport>({ImportTask::ReadRaster, path, {}, {}, {}, {}}, cancel, decodeRaster);
  }

  Status writeLayer(const PaintedLayer& layer, const LayerFormat& format, const TerrainData& terrain,
                    const std::string& path) override {
    const std::string absolute = std::filesystem::absolute(path).string();
    HelperRequest request{ImportTask::WriteLayer, absolute, {}, layer, format, {}};
    const Raster<float>& r = terrain.heights;
    request.terrain.heights.width = r.width;
    request.terrain.heights.height = r.height;
    request.terrain.heights.originX = r.originX;
    request.terrain.heights.originY = r.originY;
    request.terrain.heights.cellSize = r.cellSize;
    request.terrain.geo = terrain.geo;
    const auto nothing = [](ByteReader&, const std::string&) { return Result<bool>(true); };
    const Result<bool> done = ask<bool>(request, CancelToken(), nothing);
    return done ? Status() : Status(done.error());
  }

 private:
  template <class T, class Decode>
  Result<T> read(HelperRequest request, const CancelToken& cancel, Decode decode) const {
    if (Status status = checkReadable(request.path); !status) return status.error();
    request.path = std::filesystem::absolute(request.path).string();
    return ask<T>(request, cancel, decode);
  }

  template <class T, class Decode>
  Result<T> ask(const HelperRequest& request, const CancelToken& cancel, Decode decode) const {
    const std::string& path = request.path;
    try {
      SharedBytes answer;
      if (Status s = runHelper(helperProgram(), encodeRequest(request), m_limits, cancel, path, answer); !s)
        return s.error();
      const Result<std::size_t> start = openAnswer(answer.data(), answer.size(), path);
      if (!start) return start.error();
      ByteReader in(answer.data() + *start, answer.size() - *start);
      if (in.get<std::uint8_t>() == 0) return decodeError(in);
      return decode(in, path);
    } catch (const std::bad_alloc&) {
      return Error{ErrorKind::OutOfResources, "The file could not be read", path,
                   "there is not enough memory for what it holds",
                   "Close other programs, or reduce the file"};
    }
  }

  ImportLimits m_limits;
};

}  // namespace

std::shared_ptr<AssetReader> makeHelperAssetReader(ImportLimits limits) {
  return std::make_shared<HelperAssetReader>(limits);
}

}  // namespace spin
