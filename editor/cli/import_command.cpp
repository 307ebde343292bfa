// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/scene/collect_files.h"
#include "core/scene/import_scene.h"
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

/// Errors of the words that were given are errors of use.
Error asUsage(Error error) {
  error.kind = ErrorKind::Usage;
  return error;
}

/// The scene to add to, and what to tell once it is saved.
struct FilledScene {
  std::string file;
  LoadedScene loaded;
  std::vector<std::string> messages;
};

/// A new scene gets all that snow needs.
Result<FilledScene> sceneToFill(const std::string& file) {
  FilledScene filled;
  filled.file = file;
  if (fs::exists(file)) {
    Result<LoadedScene> loaded = loadScene(file);
    if (!loaded) return loaded.error();
    filled.loaded = std::move(*loaded);
    return filled;
  }
  filled.loaded.scene = makeDefaultScene();
  applySetUp(snowSetUp(filled.loaded.scene), filled.loaded.scene);
  const auto* settings = filled.loaded.scene.firstOf(kSimulationType)->as<SimulationNode>();
  filled.messages.push_back(
      fmt::format("made {} with weather, snowfall, camera, picture and simulation settings; a second of film "
                  "shows {:g} s "
                  "of weather (simulation.time_scale)",
                  file, settings->timeScale));
  return filled;
}

/// A camera that nobody has moved looks at the new terrain.
void turnCamera(FilledScene& filled, const TerrainData& terrain) {
  const std::optional<FirstView> view = firstViewOf(terrain.heights);
  const SceneSetUp setUp = view ? cameraSetUp(filled.loaded.scene, *view) : SceneSetUp();
  applySetUp(setUp, filled.loaded.scene);
  if (!setUp.changes.empty()) filled.messages.push_back("turned the camera to the terrain");
}

/// Where the wish says; else on the ground that the camera looks at.
Status place(const ImportRequest& request, FilledScene& filled, SceneNode& node) {
  if (!request.position.empty()) {
    Scene alone;
    const std::string path = node.id + ".position_m";
    if (Status added = alone.append(node); !added) return added;
    if (Status moved = alone.setFromText(path, request.position); !moved) {
      Error error = asUsage(moved.error());
      error.advice = "Write --position 'X Y Z' in metres from the terrain's south-west corner";
      return error;
    }
    node = alone.nodes().front();
    return {};
  }
  const std::optional<Vec3d> target = cameraTarget(filled.loaded.scene);
  if (!target) return {};
  const Vec3d at = standingPlace(*target, nullptr);
  setProperty(node, "position_m", at);
  filled.messages.push_back(fmt::format(
      "placed it at {:g} {:g}, on the ground that the camera looks at; --position places it elsewhere", at.x,
      at.y));
  return {};
}

/// What was imported, for the scene.
struct Imported {
  std::shared_ptr<const TerrainData> terrain;  ///< null: a model
};

/// The path that the node stores; the file is copied first where that is wanted.
Result<std::string> storedSource(const ImportRequest& request, const std::string& sceneFile) {
  std::string file = fs::absolute(request.file).lexically_normal().string();
  if (request.copy) {
    Result<std::string> copy = copyBeside(file, sceneFile);
    if (!copy) return copy.error();
    file = *copy;
  }
  const std::string stored = storedAssetPath(sceneFile, file);
  if (Result<std::string> allowed = resolveAssetPath(sceneFile, stored, {request.allowedFolders}); !allowed) {
    Error error = allowed.error();
    error.advice =
        "Add --copy to copy it beside the scene, or --allow FOLDER, here and whenever the scene is opened, "
        "to use it where it is";
    return error;
  }
  return stored;
}

/// Everything that may be refused is looked at before a file is copied: a refusal leaves nothing behind.
Status addToScene(const ImportRequest& request, const Imported& imported) {
  const bool terrain = imported.terrain != nullptr;
  Result<FilledScene> filled = sceneToFill(fs::absolute(request.into).lexically_normal().string());
  if (!filled) return filled.error();
  Scene& scene = filled->loaded.scene;
  SceneNode node =
      importedNode(scene, terrain ? kTerrainType : kModelType, request.file, request.name, request.options);
  if (Status valid = checkProperties(node); !valid) return asUsage(valid.error());
  // The credit may stand in a file that stays where it is.
  if (terrain && request.copy) setProperty(node, "credit", imported.terrain->credit);
  if (terrain)
    turnCamera(*filled, *imported.terrain);
  else if (Status placed = place(request, *filled, node); !placed)
    return placed;
  const std::string id = node.id;
  if (Status added = scene.append(std::move(node)); !added) return added;
  const Result<std::string> stored = storedSource(request, filled->file);
  if (!stored) return stored.error();
  setProperty(*scene.find(id), "source", *stored);
  if (Status valid = checkProperties(*scene.find(id)); !valid) return valid;
  if (Status saved = saveScene(scene, filled->loaded.extras, filled->file); !saved) return saved;
  for (const std::string& message : filled->messages) std::printf("%s\n", message.c_str());
  std::printf("added node %s to %s\n", id.c_str(), filled->file.c_str());
  return {};
}

/// The ending tells scenes from the files of other programs, in the editor too.
Status checkSceneName(const std::string& file) {
  if (file.empty() || lowerCaseExtension(file) == "spindrift") return {};
  return Error{ErrorKind::Usage, "The scene cannot be made or changed", file,
               "its name does not end in .spindrift", "Name a scene file: --into NAME.spindrift"};
}

}  // namespace

Status importFile(const ImportRequest& request, const PluginHost& plugins, const CancelToken& cancel) {
  if (Status named = checkSceneName(request.into); !named) return named;
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
