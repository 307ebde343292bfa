// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QString>
#include <map>

#include "core/scene/asset_library.h"

namespace spin {

/// A scene that an earlier run of the program did not save.
struct Recovery {
  QString folder;       ///< where its files lie
  QString scenePath;    ///< the scene's own file; empty if it was never saved
  QString displayName;  ///< for the dialog
  QDateTime written;    ///< when the recovery file was last written
  QString hashOnDisk;   ///< of the scene's own file, SceneDocument::hashOnDisk()
};

/// What a recovery folder holds, frozen for a thread.
struct RecoveryContent {
  QString folder;
  QString scenePath;
  QString displayName;
  std::string hashOnDisk;
  Scene scene;
  SceneFileExtras extras;
  std::map<std::string, PaintedLayer> layersWritten;  ///< as in the folder already
};

/// Writes all files, each through a temporary one; layers that are in the folder already are left.
Status writeRecovery(const RecoveryContent& content);
/// The description of a folder; an Error where it is none or has none.
Result<Recovery> readRecoveryInfo(const QString& folder);
/// The scene with its painted layers; a damaged layer is left out with a message.
Result<LoadedScene> readRecovery(const Recovery& recovery);

}  // namespace spin
