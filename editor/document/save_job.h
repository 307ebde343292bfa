// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/document/scene_document.h"

namespace spin {

/// Hash of a file's content in hexadecimal digits; empty where it cannot be read.
std::string contentOf(const QString& path);

/// Everything a save needs, frozen, so that it runs on a thread while the user goes on.
struct SceneDocument::SaveJob {
  QString path;
  QString oldPath;  ///< file the scene's relative paths refer to; empty if it was never saved
  Scene original;   ///< as it was when the save began
  Scene scene;      ///< with the files named as in the new place
  SceneFileExtras extras;
  std::set<QString> copied;  ///< files that are to be copied beside the scene
  std::map<std::string, PaintedLayer> layersOnDisk;
  quint64 edits = 0;
  quint64 generation = 0;
  Status status;
  std::string hashOnDisk;             ///< of the written file
  std::vector<DocumentIssue> issues;  ///< files that could not be copied; the scene is saved all the same

  void run(AssetLibrary& assets);

 private:
  void rebaseSources();
  void copyFiles();
  Status saveLayers(AssetLibrary& assets);
};

}  // namespace spin
