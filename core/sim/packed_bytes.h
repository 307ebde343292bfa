// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace spin {

/// Makes arrays of floats smaller without loss (Blosc: bytes of one place of all floats together, then
/// Zstandard), in pieces, where the library is there; else as they are. Equal bytes give equal bytes.
std::vector<char> packBytes(const std::vector<char>& bytes);

/// The inverse; nothing if they are damaged or packed by a library that this program was built without. Takes
/// no more memory than what the pieces really hold.
std::optional<std::vector<char>> unpackBytes(const std::vector<char>& packed);

}  // namespace spin
