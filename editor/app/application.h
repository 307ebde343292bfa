// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spin {

/// The whole program: command line, look, language, window. Returns the exit code.
int runEditor(int argc, char** argv);

}  // namespace spin
