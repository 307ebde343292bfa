// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/scene/json.h"

namespace spin {

/// Brings the JSON of an older scene file to kSceneSchema, one schema at a time; each step tells what it
/// changed. A file of the current schema stays as it is. Values it does not understand are left for the
/// reader to refuse.
void migrate(JsonValue& root, int fromSchema, std::vector<std::string>& messages);

}  // namespace spin
