// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

class QCoreApplication;

namespace spin {

/// Codes of the languages that lie beside the program, English first: {"en", "cs", "zh_CN"}.
QStringList availableLanguages();
/// Translates the program: a code as above, or empty for the user's own language. Unknown ones leave English
/// and give false.
bool loadLanguage(QCoreApplication& application, const QString& language);

}  // namespace spin
