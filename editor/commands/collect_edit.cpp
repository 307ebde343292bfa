// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>

#include "core/scene/collect_files.h"
#include "editor/commands/edits.h"

namespace spin::edit {
namespace {

/// The copy's stored path, or the old one where the file lies in the scene's folder already.
Result<std::string> collected(const SceneDocument& document, const std::string& source) {
  const std::string scene = document.path().toStdString();
  if (resolveAssetPath(scene, source, {})) return source;
  const Result<std::string> path = resolveAssetPath(scene, source, document.pathPolicy());
  if (!path) return path.error();
  const Result<std::string> copy = copyBeside(*path, scene);
  if (!copy) return copy.error();
  return document.storedPath(QString::fromStdString(*copy));
}

}  // namespace

Result<int> collectFiles(SceneDocument& document) {
  if (document.path().isEmpty())
    return Error{ErrorKind::Usage,
                 "The files cannot be collected",
                 {},
                 "the scene has no folder yet",
                 "Save the scene first"};
  PropertyValues sources;
  for (const SceneNode& node : document.scene().nodes()) {
    const std::string source = sourceOf(node);
    if (source.empty()) continue;
    Result<std::string> stored = collected(document, source);
    if (!stored) return stored.error();
    if (*stored != source) sources.emplace_back(node.id, *stored);
  }
  if (sources.empty()) return 0;
  document.undoStack()->beginMacro(QCoreApplication::translate("Edits", "Collect files"));
  Status status;
  for (const auto& [node, stored] : sources)
    if (status) status = setValue(document, node, "source", stored);
  document.undoStack()->endMacro();
  if (!status) return status.error();
  return static_cast<int>(sources.size());
}

}  // namespace spin::edit
