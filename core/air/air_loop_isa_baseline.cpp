// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Compiled for baseline only, see core/CMakeLists.txt.
#define SPIN_ISA isa_baseline
#include "core/air/air_loop_impl.h"
