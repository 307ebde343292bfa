// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/languages.h"

#include <QCoreApplication>
#include <QTest>

#include "editor/app/export_dialog.h"
#include "tests/editor/support/strict.h"

using namespace spin;

/// Texts come in the chosen language, with its plural forms.
class LanguagesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  void languagesAreFound() {
    QVERIFY(availableLanguages().contains(QStringLiteral("cs")));
    QVERIFY(availableLanguages().contains(QStringLiteral("zh_CN")));
  }

  void unknownLanguagesLeaveEnglish() {
    QVERIFY(!loadLanguage(*QCoreApplication::instance(), QStringLiteral("fi")));
    QCOMPARE(ExportDialog::tr("Export"), QStringLiteral("Export"));
    QCOMPARE(ExportDialog::tr("Folder"), QStringLiteral("Folder"));
  }

  /// Later ones win, so each row may load its language on top.
  void textsAreTranslated_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("property");
    QTest::addColumn<QStringList>("frames");
    QTest::newRow("en") << QStringLiteral("en") << QStringLiteral("Folder") << QStringLiteral("Wind speed")
                        << QStringList{QStringLiteral("1 frame, about x on disk"),
                                       QStringLiteral("2 frames, about x on disk"),
                                       QStringLiteral("5 frames, about x on disk")};
    QTest::newRow("cs") << QStringLiteral("cs") << QStringLiteral(u"Slo\u017eka")
                        << QStringLiteral(u"Rychlost v\u011btru")
                        << QStringList{QStringLiteral(u"1 sn\u00edmek, asi x na disku"),
                                       QStringLiteral(u"2 sn\u00edmky, asi x na disku"),
                                       QStringLiteral(u"5 sn\u00edmk\u016f, asi x na disku")};
    QTest::newRow("zh_CN") << QStringLiteral("zh_CN") << QStringLiteral(u"\u6587\u4ef6\u5939")
                           << QStringLiteral(u"\u98ce\u901f")
                           << QStringList{QStringLiteral(u"1 \u5e27\uff0c\u78c1\u76d8\u4e0a\u7ea6 x"),
                                          QStringLiteral(u"2 \u5e27\uff0c\u78c1\u76d8\u4e0a\u7ea6 x"),
                                          QStringLiteral(u"5 \u5e27\uff0c\u78c1\u76d8\u4e0a\u7ea6 x")};
  }
  void textsAreTranslated() {
    QFETCH(QString, language);
    QFETCH(QString, folder);
    QFETCH(QString, property);
    QFETCH(QStringList, frames);
    QVERIFY(loadLanguage(*QCoreApplication::instance(), language));
    QCOMPARE(ExportDialog::tr("Folder"), folder);
    QCOMPARE(QCoreApplication::translate("Properties", "Wind speed"), property);
    const int counts[] = {1, 2, 5};
    for (int k = 0; k < 3; ++k)
      QCOMPARE(ExportDialog::tr("%n frame(s), about %1 on disk", nullptr, counts[k]).arg(QStringLiteral("x")),
               frames[k]);
  }
};

QTEST_MAIN(LanguagesTest)
#include "languages_test.moc"
