// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

class QApplication;

namespace spin {

/// The program's own dark look: calm greys, one accent colour, text at least 4.5 : 1 against its ground.
void applyDarkLook(QApplication& application);

}  // namespace spin
