// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/result.h"

namespace spin {

/// Reads a PLY file's header and compares the rows it promises with the bytes that are there: Assimp does not
/// come back from a file that ends early.
Status checkPlyFile(const std::string& path);

}  // namespace spin
