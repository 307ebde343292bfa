// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>

#include "editor/viewport/viewport.h"

namespace spin {

/// Drawn, not loaded: they follow the palette and any resolution.
QIcon toolIcon(Viewport::Tool tool, const QColor& colour);
QIcon brushIcon(BrushMode mode, const QColor& colour);
/// The program's icon: flakes over a ridge.
QIcon programIcon();

}  // namespace spin
