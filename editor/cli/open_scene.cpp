// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/cli/open_scene.h"

#include <fmt/format.h>

#include <filesystem>

#include "core/base/log.h"

namespace spin {

Status assign(Scene& scene, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    return Error{ErrorKind::Usage, "The setting makes no sense", assignment, "there is no '=' in it",
                 "Write --set node.property=value, for instance --set weather.wind_speed_m_s=6"};
  Status set = scene.setFromText(assignment.substr(0, equals), assignment.substr(equals + 1));
  if (set) return set;
  // Whatever is wrong with it, it came from the command line.
  Error error = set.error();
  error.kind = ErrorKind::Usage;
  return error;
}

Result<OpenedScene> openScene(const SceneRequest& request, std::shared_ptr<AssetReader> reader,
                              const CancelToken& cancel) {
  OpenedScene opened;
  opened.file = std::filesystem::absolute(request.file).lexically_normal().string();
  Result<LoadedScene> loaded = loadScene(opened.file);
  if (!loaded) return loaded.error();
  opened.scene = std::move(loaded->scene);
  opened.extras = std::move(loaded->extras);
  for (const std::string& message : opened.extras.messages) logInfo(message);
  for (const std::string& assignment : request.assignments)
    if (Status set = assign(opened.scene, assignment); !set) return set.error();

  const PathPolicy policy{request.allowedFolders};
  if (Status layers = loadPaintedLayers(opened.scene, opened.file, *reader, policy, opened.issues, cancel);
      !layers)
    return layers.error();
  AssetLibrary library(std::move(reader), policy);
  library.setExpectedHashes(opened.extras.assetHashes);
  Result<SnapshotPointer> snapshot = library.snapshot(opened.scene, opened.file, opened.issues, cancel);
  if (!snapshot) return snapshot.error();
  opened.snapshot = *snapshot;
  return opened;
}

Status requireFiles(const OpenedScene& opened) {
  const AssetLibrary::Issue* first = nullptr;
  for (const AssetLibrary::Issue& issue : opened.issues) {
    logWarning(fmt::format("node {}: {}", issue.node, issue.error.text()));
    if (!issue.usable && !first) first = &issue;
  }
  if (!first) return {};
  Error error = first->error;
  error.where = error.where.empty() ? fmt::format("node {}", first->node)
                                    : fmt::format("node {}, {}", first->node, error.where);
  return error;
}

}  // namespace spin
