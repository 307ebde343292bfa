// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Marks a string for translation (translations/update.sh reads it; the text itself is the key). Context:
/// "Properties".
#define SPIN_TR(text) text
