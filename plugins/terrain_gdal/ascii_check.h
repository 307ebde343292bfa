// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/result.h"

namespace spin {

/// GDAL reads words in a text grid as 0; this refuses them. Streams through the file, no matter how long its
/// lines are.
Status checkAsciiGrid(const std::string& path);

}  // namespace spin
