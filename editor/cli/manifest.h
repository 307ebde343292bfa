// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/scene/json.h"
#include "editor/cli/job.h"

namespace spin {

/// The command line that gives the same files, run in the scene's folder: no --output, --threads, --cache, no
/// time. Allowed folders are told relative to the scene's.
std::string equivalentCommand(const OpenedScene& opened, const JobOptions& options, FrameRange frames);

/// Text of manifest.json: what was exported, in which units, where on the earth, from which scene, how to
/// repeat it.
std::string manifestText(const OpenedScene& opened, const JobOptions& options, FrameRange frames,
                         JsonValue outputs, const std::string& renderer);

}  // namespace spin
