// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>

namespace spin {

enum class TransportIcon { First, Previous, Play, Pause, Next, Last, HoldRun, StepRun, Reset };

/// Drawn in the colour of the text, because the style's own icons are too dark for a dark window.
QIcon transportIcon(TransportIcon icon, const QColor& colour);

}  // namespace spin
