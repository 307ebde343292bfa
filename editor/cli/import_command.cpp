// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/nodes/camera_node.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/scene/collect_files.h"
#include "editor/cli/commands.h"
#include "editor/cli/first_view.h"
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

/// In real time nobody sees the cover grow: 5 s of film show four hours.
constexpr const char* kNewTimeScale = "2880";

/// The scene to add to; a new one gets all that snow needs.
Result<LoadedScene> sceneToFill(const std::string& file) {
  if (fs::exists(file)) return loadScene(file);
  LoadedScene made;
  made.scene = makeDefaultScene();
  if (Status added = made.scene.append(makeNode(kSnowfallType, "snowfall", "Snowfall")); !added)
    return added.error();
  if (Status set = made.scene.setFromText("simulation.time_scale", kNewTimeScale); !set) return set.error();
  std::printf(
      "made %s with weather, snowfall, camera, picture and simulation settings; a second of film shows "
      "%s s of weather (simulation.time_scale)\n",
      file.c_str(), kNewTimeScale);
  return made;
}

/// Copies the file with what it refers to into NAME.assets/ beside the scene.
Result<std::string> copyBeside(const std::string& file, const std::string& scene) {
  const fs::path path(scene);
  return copyWithCompanions(file, (path.parent_path() / (path.stem().string() + ".assets")).string());
}

/// A camera that nobody has moved looks at the new terrain.
void turnCamera(Scene& scene, const TerrainData& terrain) {
  const SceneNode* first = scene.firstOf(kCameraType);
  if (!first) return;
  SceneNode* camera = scene.find(first->id);
  const auto* now = camera->as<CameraNode>();
  const CameraNode untouched;
  if (!now || now->position != untouched.position || now->target != untouched.target) return;
  const std::optional<FirstView> view = firstViewOf(terrain.heights);
  if (!view) return;
  set(*camera, "position_m", view->position);
  set(*camera, "target_m", view->target);
  std::printf("turned the camera to the terrain\n");
}

/// Where the wish says; else on the ground that the camera looks at.
Status place(const ImportRequest& request, const Scene& scene, SceneNode& node) {
  if (!request.position.empty()) {
    Scene alone;
    const std::string path = node.id + ".position_m";
    if (Status added = alone.append(node); !added) return added;
    if (Status moved = alone.setFromText(path, request.position); !moved) {
      Error error = moved.error();
      error.kind = ErrorKind::Usage;
      error.advice = "Write --position 'X Y Z' in metres from the terrain's south-west corner";
      return error;
    }
    node = alone.nodes().front();
    return {};
  }
  const SceneNode* first = scene.firstOf(kCameraType);
  const auto* camera = first ? first->as<CameraNode>() : nullptr;
  if (!camera || !scene.firstOf(kTerrainType)) return {};
  const Vec3d at{std::round(camera->target.x), std::round(camera->target.y), 0.0};
  set(node, "position_m", at);
  std::printf("placed it at %g %g, on the ground that the camera looks at; --position places it elsewhere\n",
              at.x, at.y);
  return {};
}

/// What was imported, for the scene.
struct Imported {
  std::shared_ptr<const TerrainData> terrain;  ///< null: a model
};

Status addToScene(const ImportRequest& request, const Imported& imported) {
  const bool terrain = imported.terrain != nullptr;
  const std::string sceneFile = fs::absolute(request.into).lexically_normal().string();
  Result<LoadedScene> loaded = sceneToFill(sceneFile);
  if (!loaded) return loaded.error();
  std::string file = fs::absolute(request.file).lexically_normal().string();
  const std::string wish = terrain ? "terrain" : idFrom(fs::path(request.file).stem().string());
  SceneNode node = nodeFor(request, terrain, loaded->scene.freeId(wish));
  if (request.copy) {
    Result<std::string> copy = copyBeside(file, sceneFile);
    if (!copy) return copy.error();
    file = *copy;
    // The credit may stand in a file that stays where it is.
    if (terrain) set(node, "credit", imported.terrain->credit);
  }
  const std::string stored = storedAssetPath(sceneFile, file);
  if (Result<std::string> allowed = resolveAssetPath(sceneFile, stored, {request.allowedFolders}); !allowed) {
    Error error = allowed.error();
    error.advice =
        "Add --copy to copy it beside the scene, or --allow FOLDER, here and whenever the scene is opened, "
        "to "
        "use it where it is";
    return error;
  }
  set(node, "source", stored);
  if (Status valid = checkOptions(node); !valid) return valid;
  if (terrain)
    turnCamera(loaded->scene, *imported.terrain);
  else if (Status placed = place(request, loaded->scene, node); !placed)
    return placed;
  const std::string id = node.id;
  if (Status added = loaded->scene.append(std::move(node)); !added) return added;
  if (Status saved = saveScene(loaded->scene, loaded->extras, sceneFile); !saved) return saved;
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
  Imported imported;
  if (terrain) {
    const Result<TerrainImport> read = reader->readTerrain(request.file, request.options, cancel);
    if (!read) return read.error();
    printSummary(read->summary);
    imported.terrain = read->terrain;
  } else {
    const Result<ModelImport> read = reader->readModel(request.file, request.options, cancel);
    if (!read) return read.error();
    printSummary(read->summary);
  }
  return request.into.empty() ? Status() : addToScene(request, imported);
}

}  // namespace spin
