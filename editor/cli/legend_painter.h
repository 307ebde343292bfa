// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/render/flow_scale.h"
#include "plugins/sdk/exporter.h"

namespace spin {

/// Draws a legend at the right rim of the picture: a bar of the colours with ticks, above it what they mean.
/// Nothing where the picture has no room for it.
void drawLegend(ImageFloat& image, const FlowLegend& legend);

}  // namespace spin
