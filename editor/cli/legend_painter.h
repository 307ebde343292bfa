// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/render/value_scale.h"
#include "plugins/sdk/exporter.h"

namespace spin {

/// Draws a legend at the right rim of the picture, left of `taken` pixels there: a bar of the colours with
/// ticks, above it what they mean. Returns how many pixels are taken then; nothing is drawn where the picture
/// has no room for it.
int drawLegend(ImageFloat& image, const ValueLegend& legend, int taken = 0);

}  // namespace spin
