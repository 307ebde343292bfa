// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace spin {

/// Files that a model or raster file refers to, relative to it with '/', as far as its text names them:
/// buffers and images of glTF, material libraries of OBJ and their textures, and side files of rasters with
/// the same stem. Only files that exist beside or below it.
std::vector<std::string> companionsOf(const std::string& path);

/// Copies a file and its companions into a folder; a file of the same content that is there already is kept,
/// one of other content makes the copy take another name. Returns the path of the copied file.
Result<std::string> copyWithCompanions(const std::string& path, const std::string& folder);

/// The folder of a scene's own files: "kontertal.spindrift" has them in "kontertal.assets".
std::string assetFolderOf(const std::string& sceneFile);
/// Copies a file and its companions into the scene's folder of files; returns the path of the copy.
Result<std::string> copyBeside(const std::string& path, const std::string& sceneFile);

}  // namespace spin
