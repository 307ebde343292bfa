// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/nodes/terrain_node.h"
#include "editor/cli/commands.h"
#include "plugins/host/plugin_host.h"
#include "plugins/sdk/file_name.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void printSummary(const ImportSummary& summary) {
  for (const SummaryLine& line : summary.lines)
    std::printf("%s: %s\n", line.label.c_str(), line.value.c_str());
  for (const std::string& warning : summary.warnings) std::printf("warning: %s\n", warning.c_str());
}

/// "Hut (2).glb" gives "hut_2".
std::string idFrom(const std::string& name) {
  std::string id;
  for (const char c : name) {
    const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool plain = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
    if (plain)
      id += lower;
    else if (!id.empty() && id.back() != '_')
      id += '_';
  }
  while (!id.empty() && id.back() == '_') id.pop_back();
  return id.empty() || (id[0] >= '0' && id[0] <= '9') ? "node_" + id : id;
}

void set(SceneNode& node, const char* property, const Value& value) {
  const PropertyInfo* info = node.type->find(property);
  SPIN_CHECK(info, std::string("no property ") + property);
  setPlainValue(node, *info, value);
}

Status checkOptions(const SceneNode& node) {
  for (const PropertyRow& row : node.type->properties)
    if (Status valid = validate(row, plainValue(node, row)); !valid) {
      Error error = valid.error();
      error.kind = ErrorKind::Usage;
      return error;
    }
  return {};
}

SceneNode nodeFor(const ImportRequest& request, bool terrain, const std::string& id) {
  const std::string name = request.name.empty() ? fs::path(request.file).stem().string() : request.name;
  SceneNode node = makeNode(terrain ? kTerrainType : kModelType, id, name);
  const ImportOptions& o = request.options;
  if (terrain) {
    set(node, "epsg", static_cast<std::int64_t>(o.epsg));
    set(node, "cell_size_m", o.cellSize);
    set(node, "height_unit_m", o.heightScale);
    set(node, "has_no_data", !std::isnan(o.noDataValue));
    if (!std::isnan(o.noDataValue)) set(node, "no_data", o.noDataValue);
  } else {
    set(node, "up_axis", static_cast<std::int64_t>(o.upAxis));
    set(node, "unit_m", o.unitScale);
  }
  return node;
}

/// Copies the file and those of the same name with other endings (world files, buffers, materials).
Result<std::string> copyBeside(const std::string& file, const std::string& scene) {
  const fs::path source(file),
      target = fs::path(scene).parent_path() / (fs::path(scene).stem().string() + ".assets");
  std::error_code error;
  fs::create_directories(target, error);
  for (const auto& entry : fs::directory_iterator(source.parent_path(), error)) {
    if (entry.path().stem() != source.stem() || !entry.is_regular_file(error)) continue;
    fs::copy_file(entry.path(), target / entry.path().filename(), fs::copy_options::overwrite_existing,
                  error);
    if (error) break;
  }
  const fs::path copy = target / source.filename();
  if (error || !fs::exists(copy))
    return Error{ErrorKind::Failed, "The file could not be copied", target.string(), error.message(),
                 "Check the folder's rights"};
  return copy.string();
}

Status addToScene(const ImportRequest& request, bool terrain) {
  const std::string sceneFile = fs::absolute(request.into).lexically_normal().string();
  LoadedScene loaded;
  if (fs::exists(sceneFile)) {
    Result<LoadedScene> read = loadScene(sceneFile);
    if (!read) return read.error();
    loaded = std::move(*read);
  } else {
    loaded.scene = makeDefaultScene();
  }
  std::string file = fs::absolute(request.file).lexically_normal().string();
  if (request.copy) {
    Result<std::string> copy = copyBeside(file, sceneFile);
    if (!copy) return copy.error();
    file = *copy;
  }
  const std::string stored = storedAssetPath(sceneFile, file);
  if (Result<std::string> allowed = resolveAssetPath(sceneFile, stored, {request.allowedFolders}); !allowed) {
    Error error = allowed.error();
    error.advice = "Add --copy to copy it beside the scene, or --allow FOLDER to use it where it is";
    return error;
  }
  const std::string wish = terrain ? "terrain" : idFrom(fs::path(request.file).stem().string());
  SceneNode node = nodeFor(request, terrain, loaded.scene.freeId(wish));
  set(node, "source", stored);
  if (Status valid = checkOptions(node); !valid) return valid;
  const std::string id = node.id;
  if (Status added = loaded.scene.append(std::move(node)); !added) return added;
  if (Status saved = saveScene(loaded.scene, loaded.extras, sceneFile); !saved) return saved;
  std::printf("added node %s to %s\n", id.c_str(), sceneFile.c_str());
  return {};
}

}  // namespace

Status importFile(const ImportRequest& request, const PluginHost& plugins, const CancelToken& cancel) {
  const std::string extension = lowerCaseExtension(request.file);
  const bool terrain = contains(plugins.terrainExtensions(), extension);
  if (!terrain && !contains(plugins.modelExtensions(), extension))
    return badInput("The file cannot be imported", request.file,
                    "no importer reads files ending in '." + extension + "'",
                    fmt::format("Terrains: {}; models: {}", join(plugins.terrainExtensions()),
                                join(plugins.modelExtensions())));
  const std::shared_ptr<AssetReader> reader = makeHelperAssetReader();
  if (terrain) {
    const Result<TerrainImport> read = reader->readTerrain(request.file, request.options, cancel);
    if (!read) return read.error();
    printSummary(read->summary);
  } else {
    const Result<ModelImport> read = reader->readModel(request.file, request.options, cancel);
    if (!read) return read.error();
    printSummary(read->summary);
  }
  return request.into.empty() ? Status() : addToScene(request, terrain);
}

}  // namespace spin
