// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The project hides its symbols, but the static members of OpenVDB's templates must be those of its library:
// flags within functions are shared either way, and a tree whose name was made here would have none there.
#pragma GCC visibility push(default)
#include <openvdb/openvdb.h>
#pragma GCC visibility pop
