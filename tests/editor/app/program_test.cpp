// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

/// The program as scripts start it: what fails is told by the exit code.
class ProgramTest : public QObject {
  Q_OBJECT
 private:
  struct Outcome {
    int code = -1;
    QString errors;
  };
  static Outcome run(const QStringList& arguments) {
    QProcess program;
    program.start(QCoreApplication::applicationDirPath() + QStringLiteral("/spindrift"), arguments);
    if (!program.waitForFinished(60000) || program.exitStatus() != QProcess::NormalExit) return {};
    return {program.exitCode(), QString::fromUtf8(program.readAllStandardError())};
  }

 private Q_SLOTS:
  void aPictureOfAMissingSceneFails() {
    const QTemporaryDir folder;
    const QString picture = folder.filePath(QStringLiteral("x.png"));
    const Outcome outcome =
        run({QStringLiteral("--screenshot"), picture, folder.filePath(QStringLiteral("nothere.spindrift"))});
    QCOMPARE(outcome.code, 3);
    QVERIFY2(outcome.errors.contains(QStringLiteral("nothere.spindrift")), qPrintable(outcome.errors));
    QVERIFY(!QFile::exists(picture));
  }

  void unknownLanguagesAreRefused() {
    const Outcome outcome = run({QStringLiteral("--language"), QStringLiteral("xx")});
    QCOMPARE(outcome.code, 2);
    QVERIFY2(outcome.errors.contains(QStringLiteral("xx")), qPrintable(outcome.errors));
  }
};

QTEST_GUILESS_MAIN(ProgramTest)
#include "program_test.moc"
