// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/cancel.h"
#include "core/fields/mesh.h"
#include "core/fields/raster.h"
#include "core/scene/scene_file.h"
#include "core/sim/snapshot.h"

namespace spin {

/// One line of what an import found: {"Cell size", "5 m"}.
struct SummaryLine {
  std::string label;
  std::string value;
};

/// Shown or printed before an import is accepted.
struct ImportSummary {
  std::vector<SummaryLine> lines;
  std::vector<std::string> warnings;
};

struct TerrainImport {
  std::shared_ptr<const TerrainData> terrain;
  ImportSummary summary;
};
struct ModelImport {
  std::shared_ptr<const ModelData> model;
  ImportSummary summary;
};

struct ImportOptions {
  int epsg = 0;  ///< overrides the file's coordinate system
  double noDataValue =
      std::numeric_limits<double>::quiet_NaN();  ///< for files that cannot name one (16-bit PNG); NaN = none
  double heightScale = 1.0;  ///< m per unit for files without a vertical unit (16-bit PNG)
  double cellSize = 0.0;     ///< m, for files without georeference; 0 = 1 m
  int upAxis = 0;            ///< 0 = as the format says, 1 = y, 2 = z
  double unitScale = 0.0;    ///< m per unit; 0 = as the format says
};

/// How a painted layer stands in a file; the path's ending says whether that is a PNG or a GeoTIFF.
struct LayerFormat {
  std::string name;  ///< of the values, for those formats that keep it: "ground temperature"
  std::string unit;  ///< "K"; empty for plain numbers
  /// A float layer as a grey PNG: 8 or 16 bits, black for `low` and less and for what is not painted, white
  /// for `high` and more.
  int bits = 8;
  double low = 0.0, high = 1.0;
};

/// A raster file read as plain numbers, to be laid over the terrain.
struct RasterImport {
  Raster<float> values;  ///< NaN where the file has no data; without georeference its cells are 1 m
  GeoReference geo;
  bool georeferenced = false;
  int bits = 0;  ///< 8 or 16: whole numbers from 0 to 2^bits - 1; 0: real numbers
};

/// Reads foreign files. plugins/host implements it by a helper process with memory and time limits, so that a
/// crash in a library is an Error; tests may use their own.
class AssetReader {
 public:
  virtual ~AssetReader() = default;
  virtual Result<TerrainImport> readTerrain(const std::string& path, const ImportOptions& options,
                                            const CancelToken& cancel) = 0;
  virtual Result<ModelImport> readModel(const std::string& path, const ImportOptions& options,
                                        const CancelToken& cancel) = 0;
  /// 8-bit single-channel PNG or float GeoTIFF as a painted layer, north row first in the file.
  virtual Result<PaintedLayer> readLayer(const std::string& path, const CancelToken& cancel) = 0;
  /// Any raster with one band of numbers (PNG, GeoTIFF, ESRI ASCII, XYZ).
  virtual Result<RasterImport> readRaster(const std::string& path, const CancelToken& cancel) = 0;
  /// Writes a painted layer as PNG or as GeoTIFF with the terrain's georeference: numbers of types as they
  /// are, 8-bit; measures as floats in a GeoTIFF, and as the format says in a PNG.
  virtual Status writeLayer(const PaintedLayer& layer, const LayerFormat& format, const TerrainData& terrain,
                            const std::string& path) = 0;
};

/// Decoded files of a scene, kept by content, so that a snapshot after an edit costs nothing. Thread-safe.
class AssetLibrary {
 public:
  explicit AssetLibrary(std::shared_ptr<AssetReader> reader, PathPolicy policy = {});
  ~AssetLibrary();

  /// Freezes the scene with its files. Missing or unreadable files become entries in `issues` (by node id)
  /// and the node stays without data; the call itself fails only when cancelled.
  struct Issue {
    std::string node;
    Error error;
    bool usable = false;  ///< a remark: the node has its data all the same
  };
  Result<SnapshotPointer> snapshot(const Scene& scene, const std::string& sceneFile,
                                   std::vector<Issue>& issues, const CancelToken& cancel = {});
  AssetReader& reader();
  /// Folders the user allowed since; for later snapshots.
  void setPolicy(PathPolicy policy);
  PathPolicy policy() const;
  /// Hashes by node id of the files as they were last known: of several files with a moved one's name the
  /// one with its hash is taken.
  void setExpectedHashes(std::map<std::string, Hash128> hashes);
  /// Hashes by node id of the files that the last snapshot used.
  std::map<std::string, Hash128> fileHashes() const;
  /// Forgets decoded files, e.g. after they changed on disk.
  void clear();

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

/// How a terrain or model node wants its file read.
ImportOptions importOptionsOf(const SceneNode& node);
/// The path in the node's `source`; empty where the type has none.
std::string sourceOf(const SceneNode& node);
/// Checks a layer against its node: kind and range of values (PaintedKind); blank cells and NaN are always
/// good.
Status checkLayer(const SceneNode& node, const PaintedLayer& layer);

/// Loads the painted layers that the nodes name into scene.nodes()[..].painted; problems become issues.
/// Fails only when cancelled.
Status loadPaintedLayers(Scene& scene, const std::string& sceneFile, AssetReader& reader,
                         const PathPolicy& policy, std::vector<AssetLibrary::Issue>& issues,
                         const CancelToken& cancel = {});
/// Writes painted layers to NAME.assets/ beside the scene and sets the nodes' `source`; through temporary
/// files.
Status savePaintedLayers(Scene& scene, const std::string& sceneFile, const TerrainData& terrain,
                         AssetReader& reader);

}  // namespace spin
