// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/asset_library.h"

#include <fmt/format.h>

#include <QFile>
#include <algorithm>
#include <mutex>
#include <optional>

#include "core/fields/content_hash.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/scene/asset_file.h"
#include "core/sim/model_copies.h"

namespace spin {
namespace {

/// Decoded files that no recent snapshot used are dropped above this number.
constexpr std::size_t kMaxEntries = 256;

struct Entry {
  std::shared_ptr<const TerrainData> terrain;
  std::shared_ptr<const ModelData> model;
  std::shared_ptr<const WeatherSeries> weather;
  Hash128 content;  ///< as decoded
  Hash128 file;     ///< bytes on disk
  std::uint64_t lastUsed = 0;
};

std::shared_ptr<const TerrainData> scaled(const std::shared_ptr<const TerrainData>& terrain, double factor) {
  if (factor == 1.0) return terrain;
  auto copy = std::make_shared<TerrainData>(*terrain);
  for (float& height : copy->heights.values)
    height = static_cast<float>(static_cast<double>(height) * factor);
  return copy;
}

/// Text files are read here: no library that could fall over has a part in it.
Result<WeatherSeries> readWeatherFile(const std::string& path) {
  constexpr qint64 kMostBytes = 1 << 30;
  QFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::ReadOnly))
    return badInput("The weather could not be read", path, file.errorString().toStdString(),
                    "Check that the file is there and may be read");
  if (file.size() > kMostBytes)
    return badInput("The weather could not be read", path, "it is larger than 1 GiB", "Cut out the season");
  const QByteArray bytes = file.readAll();
  return readWeather({bytes.constData(), static_cast<std::size_t>(bytes.size())}, path);
}

void takeWeather(const SceneNode& node, const std::shared_ptr<const WeatherSeries>& weather,
                 SceneSnapshot& snapshot, std::vector<AssetLibrary::Issue>& issues) {
  if (snapshot.first<WeatherNode>() != &node) return;
  snapshot.weather = weather;
  const std::string gaps = weather->gapReport();
  if (!gaps.empty())
    issues.push_back({node.id,
                      badInput("The weather record has gaps", node.id, gaps,
                               "Nothing falls in gaps; the rest comes from the hours and days beside them"),
                      true});
}

/// Columns and rows of a painted layer; {0, 0} where nothing is painted.
std::pair<int, int> sizeOf(const PaintedLayer& layer) {
  if (const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&layer))
    return {types->width(), types->height()};
  if (const auto* kelvin = std::get_if<TiledRaster<float>>(&layer))
    return {kelvin->width(), kelvin->height()};
  return {0, 0};
}

/// A layer of another size than the terrain cannot be used: its cells mean other places.
void checkLayerSizes(SceneSnapshot& snapshot, std::vector<AssetLibrary::Issue>& issues) {
  for (SceneNode& node : snapshot.nodes) {
    if (std::holds_alternative<std::monostate>(node.painted) || !snapshot.terrain) continue;
    const Raster<float>& heights = snapshot.terrain->heights;
    const auto [columns, rows] = sizeOf(node.painted);
    if (columns == heights.width && rows == heights.height) continue;
    node.painted = std::monostate{};
    issues.push_back(
        {node.id,
         badInput("The painted layer does not fit", node.id,
                  fmt::format("it was painted on a terrain of {} x {} cells, the terrain now "
                              "has {} x {}, so that it is left out",
                              columns, rows, heights.width, heights.height),
                  "Bring back the terrain it was painted on, or delete the layer and paint anew"),
         false});
  }
}

}  // namespace

struct AssetLibrary::State {
  std::shared_ptr<AssetReader> reader;
  mutable std::mutex mutex;  ///< guards all below
  PathPolicy policy;
  std::map<std::string, Hash128> expected;
  std::map<std::string, Hash128> fileHashes;
  std::map<std::string, Entry> entries;
  std::map<std::pair<const TerrainData*, double>, std::shared_ptr<const TerrainData>> scaledTerrains;
  /// A model with its copies, by all that they depend on.
  struct Copied {
    std::shared_ptr<const ModelData> model;
    std::shared_ptr<const TerrainData> terrain;
    Hash128 node;
    std::shared_ptr<const ModelData> copied;
  };
  std::map<std::string, Copied> copied;  ///< by node id
  std::uint64_t snapshots = 0;
  std::mutex reading;  ///< one file at a time, so that none is read twice

  std::optional<Entry> cached(const std::string& stamp) {
    const std::lock_guard lock(mutex);
    const auto found = entries.find(stamp);
    if (found == entries.end()) return {};
    found->second.lastUsed = snapshots;
    return found->second;
  }

  Result<Entry> decode(const SceneNode& node, const std::string& path, const CancelToken& cancel) {
    Entry entry;
    if (node.as<TerrainNode>()) {
      Result<TerrainImport> read = reader->readTerrain(path, importOptionsOf(node), cancel);
      if (!read) return read.error();
      entry.terrain = read->terrain;
      entry.content = contentHash(*entry.terrain);
    } else if (node.as<WeatherNode>()) {
      Result<WeatherSeries> read = readWeatherFile(path);
      if (!read) return read.error();
      entry.weather = std::make_shared<const WeatherSeries>(std::move(*read));
      entry.content = contentHash(*entry.weather);
    } else {
      Result<ModelImport> read = reader->readModel(path, importOptionsOf(node), cancel);
      if (!read) return read.error();
      entry.model = read->model;
      entry.content = contentHash(*entry.model);
    }
    entry.file = hashFile(path);
    return entry;
  }

  Result<Entry> load(const SceneNode& node, const std::string& path, const CancelToken& cancel) {
    const std::lock_guard one(reading);
    const std::string stamp = std::string(node.type->id) + "|" + stampOf(path, importOptionsOf(node));
    if (std::optional<Entry> known = cached(stamp)) return *known;
    Result<Entry> entry = decode(node, path, cancel);
    if (!entry) return entry;
    const std::lock_guard lock(mutex);
    entry->lastUsed = snapshots;
    entries[stamp] = *entry;
    return entry;
  }

  std::shared_ptr<const TerrainData> scaledTerrain(const std::shared_ptr<const TerrainData>& terrain,
                                                   double factor) {
    const std::lock_guard lock(mutex);
    std::shared_ptr<const TerrainData>& known = scaledTerrains[{terrain.get(), factor}];
    if (!known) known = scaled(terrain, factor);
    return known;
  }

  std::shared_ptr<const ModelData> modelWithCopies(const std::shared_ptr<const ModelData>& model,
                                                   const SceneSnapshot& scene, const SceneNode& node) {
    Hasher hasher;
    scene.hashNode(node, 0.0, hasher);
    const Hash128 key = hasher.digest();
    const std::lock_guard lock(mutex);
    Copied& known = copied[node.id];
    if (known.model != model || known.terrain != scene.terrain || known.node != key)
      known = {model, scene.terrain, key, withCopies(model, scene, node)};
    return known.copied;
  }

  void dropUnused() {
    const std::lock_guard lock(mutex);
    if (entries.size() > kMaxEntries)
      std::erase_if(entries, [this](const auto& e) { return e.second.lastUsed != snapshots; });
    std::erase_if(scaledTerrains, [this](const auto& s) {
      const bool alive = std::any_of(entries.begin(), entries.end(), [&](const auto& e) {
        return e.second.terrain.get() == s.first.first && e.second.lastUsed == snapshots;
      });
      return !alive;
    });
  }
};

AssetLibrary::AssetLibrary(std::shared_ptr<AssetReader> reader, PathPolicy policy)
    : m_state(std::make_unique<State>()) {
  SPIN_CHECK(reader, "asset library without a reader");
  m_state->reader = std::move(reader);
  m_state->policy = std::move(policy);
}
AssetLibrary::~AssetLibrary() = default;

Result<SnapshotPointer> AssetLibrary::snapshot(const Scene& scene, const std::string& sceneFile,
                                               std::vector<Issue>& issues, const CancelToken& cancel) {
  auto snapshot = std::make_shared<SceneSnapshot>();
  snapshot->nodes = scene.nodes();
  std::map<std::string, Hash128> expected, fileHashes;
  PathPolicy policy;
  {
    const std::lock_guard lock(m_state->mutex);
    ++m_state->snapshots;
    expected = m_state->expected;
    policy = m_state->policy;
  }
  for (const SceneNode& node : snapshot->nodes) {
    const bool hasAsset = node.as<TerrainNode>() || node.as<ModelNode>() || node.as<WeatherNode>();
    const std::string source = sourceOf(node);
    if (!hasAsset || !node.enabled || source.empty()) continue;
    const Error cancelled{ErrorKind::Cancelled, "Reading the scene's files was stopped", {}, {}, {}};
    if (cancel.cancelled()) return cancelled;
    Result<FoundAsset> found = findAsset(sceneFile, source, policy, expected[node.id]);
    Result<Entry> entry = found ? m_state->load(node, found->path, cancel) : Result<Entry>(found.error());
    if (cancel.cancelled()) return cancelled;
    if (!entry) {
      issues.push_back({node.id, entry.error(), false});
      continue;
    }
    if (found->moved) issues.push_back(movedRemark(node.id, source, found->path));
    const auto* terrain = node.as<TerrainNode>();
    if (terrain && entry->terrain)
      snapshot->terrain = m_state->scaledTerrain(entry->terrain, terrain->verticalScale);
    if (entry->model) snapshot->models[node.id] = entry->model;
    if (entry->weather) takeWeather(node, entry->weather, *snapshot, issues);
    snapshot->assetHashes[node.id] = entry->content;
    fileHashes[node.id] = entry->file;
  }
  // Copies stand on the ground, so they come when it is there.
  for (const SceneNode& node : snapshot->nodes)
    if (const auto model = snapshot->models.find(node.id); model != snapshot->models.end())
      model->second = m_state->modelWithCopies(model->second, *snapshot, node);
  checkLayerSizes(*snapshot, issues);
  m_state->dropUnused();
  const std::lock_guard lock(m_state->mutex);
  m_state->fileHashes = std::move(fileHashes);
  return SnapshotPointer(std::move(snapshot));
}

AssetReader& AssetLibrary::reader() {
  return *m_state->reader;
}

void AssetLibrary::setPolicy(PathPolicy policy) {
  const std::lock_guard lock(m_state->mutex);
  m_state->policy = std::move(policy);
}

PathPolicy AssetLibrary::policy() const {
  const std::lock_guard lock(m_state->mutex);
  return m_state->policy;
}

void AssetLibrary::setExpectedHashes(std::map<std::string, Hash128> hashes) {
  const std::lock_guard lock(m_state->mutex);
  m_state->expected = std::move(hashes);
}

std::map<std::string, Hash128> AssetLibrary::fileHashes() const {
  const std::lock_guard lock(m_state->mutex);
  return m_state->fileHashes;
}

void AssetLibrary::clear() {
  const std::lock_guard lock(m_state->mutex);
  m_state->entries.clear();
  m_state->copied.clear();
  m_state->scaledTerrains.clear();
}

ImportOptions importOptionsOf(const SceneNode& node) {
  ImportOptions options;
  if (const auto* terrain = node.as<TerrainNode>()) {
    options.epsg = terrain->epsg;
    options.cellSize = terrain->cellSize;
    options.heightScale = terrain->heightUnit;
    if (terrain->hasNoData) options.noDataValue = terrain->noData;
  }
  if (const auto* model = node.as<ModelNode>()) {
    options.upAxis = static_cast<int>(model->upAxis);
    options.unitScale = model->unitScale;
  }
  return options;
}

std::string sourceOf(const SceneNode& node) {
  const PropertyInfo* source = node.type->find("source");
  return source ? std::get<std::string>(plainValue(node, *source)) : std::string();
}

}  // namespace spin
