// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/languages.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace spin {
namespace {

QString folder() {
  return QCoreApplication::applicationDirPath() + QStringLiteral("/translations");
}

}  // namespace

QStringList availableLanguages() {
  QStringList languages{QStringLiteral("en")};
  const QDir lying(folder());
  for (const QString& name : lying.entryList({QStringLiteral("spindrift_*.qm")}, QDir::Files, QDir::Name))
    if (const QString code = name.mid(10).chopped(3); !languages.contains(code)) languages << code;
  return languages;
}

bool loadLanguage(QCoreApplication& application, const QString& language) {
  const QLocale locale = language.isEmpty() ? QLocale::system() : QLocale(language);
  QLocale::setDefault(locale);
  auto* own = new QTranslator(&application);
  // A name that Qt does not know becomes the C locale.
  const bool understood = language.isEmpty() || locale.language() != QLocale::C;
  // The C locale speaks English too, and English has plural forms to load.
  const QLocale spoken = locale.language() == QLocale::C ? QLocale(QLocale::English) : locale;
  if (!own->load(spoken, QStringLiteral("spindrift"), QStringLiteral("_"), folder())) {
    delete own;
    return false;
  }
  QCoreApplication::installTranslator(own);
  // Texts of Qt's own dialogs, where the system has them.
  auto* qt = new QTranslator(&application);
  if (qt->load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
               QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    QCoreApplication::installTranslator(qt);
  else
    delete qt;
  return understood;
}

}  // namespace spin
