// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spin {

/// Ids by which QUndoStack finds commands that may merge.
enum CommandId { kChangePropertiesId = 1, kPaintTilesId = 2 };

}  // namespace spin
