// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/export_job.h"

#include <QElapsedTimer>
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "editor/app/export_dialog.h"
#include "tests/editor/support/strict.h"

using namespace spin;

namespace {

/// A stand-in for the export program: a shell script.
QString script(const QTemporaryDir& folder, const char* body) {
  QFile file(folder.filePath(QStringLiteral("cli")));
  if (!file.open(QIODevice::WriteOnly)) return {};
  file.write("#!/bin/sh\n");
  file.write(body);
  file.close();
  file.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  qputenv("SPIN_CLI", file.fileName().toLocal8Bit());
  return file.fileName();
}

ExportPlan plan() {
  ExportPlan plan;
  plan.scene = QStringLiteral("/scenes/my hut.spindrift");
  plan.formats = QStringList{QStringLiteral("png8"), QStringLiteral("vtp")};
  plan.firstFrame = 3;
  plan.lastFrame = 17;
  plan.folder = QStringLiteral("/out");
  return plan;
}

}  // namespace

class ExportJobTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }
  void cleanup() { qunsetenv("SPIN_CLI"); }

  void argumentsAreTheCommandLines() {
    ExportPlan wanted = plan();
    QCOMPARE(exportArguments(wanted).join(QLatin1Char('|')),
             QStringLiteral(
                 "run|/scenes/my hut.spindrift|--frames|3:17|--output|/out|--format|png8|--format|vtp"));
    wanted.width = 640;
    wanted.pictureNode = QStringLiteral("render");
    wanted.allowedFolders = QStringList{QStringLiteral("/data")};
    QVERIFY(exportArguments(wanted)
                .join(QLatin1Char(' '))
                .endsWith(QStringLiteral("--set render.width_px=640 --allow /data")));
  }

  /// The shown command can be pasted into a shell.
  void shownCommandIsQuoted() {
    QVERIFY(commandText(plan()).startsWith(
        QStringLiteral("spindrift-cli run '/scenes/my hut.spindrift' --frames 3:17")));
  }

  /// Progress lines are told; other lines and broken ones are passed over.
  void progressIsRead() {
    const QTemporaryDir folder;
    script(folder,
           "echo '{\"stage\":\"simulate\",\"frame\":3,\"fraction\":0.25,\"seconds_left\":7.5}'\n"
           "echo 'not json'\n"
           "printf '{\"stage\":\"export\",\"fraction\":0.5,'\n"
           "sleep 0.05\n"
           "echo '\"seconds_left\":null}'\n"
           "echo a message >&2\n");
    ExportJob job;
    QSignalSpy progressed(&job, &ExportJob::progressed);
    QSignalSpy finished(&job, &ExportJob::finished);
    job.start(plan());
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(progressed.count(), 2);
    QCOMPARE(progressed[0][0].toDouble(), 0.25);
    QCOMPARE(progressed[0][1].toDouble(), 7.5);
    QCOMPARE(progressed[1][0].toDouble(), 0.5);
    QVERIFY(progressed[1][1].toDouble() < 0.0);
    QVERIFY(finished[0][0].toBool());
    QCOMPARE(finished[0][2].toString(), QStringLiteral("a message"));
  }

  void failuresSayWhy() {
    const QTemporaryDir folder;
    script(folder, "echo 'no room on the disk' >&2\nexit 4\n");
    ExportJob job;
    QSignalSpy finished(&job, &ExportJob::finished);
    job.start(plan());
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(!finished[0][0].toBool());
    QVERIFY(!finished[0][1].toBool());
    QCOMPARE(finished[0][2].toString(), QStringLiteral("no room on the disk"));
  }

  void missingProgramIsSaid() {
    qputenv("SPIN_CLI", "/nowhere/spindrift-cli");
    ExportJob job;
    QSignalSpy finished(&job, &ExportJob::finished);
    job.start(plan());
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(finished[0][2].toString().contains(QStringLiteral("/nowhere/spindrift-cli")));
  }

  /// A program that will not stop is ended within a second of cancel.
  void cancelEndsWithinASecond_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("obedient") << QByteArray("trap 'exit 5' TERM\nwhile :; do sleep 0.02; done\n");
    QTest::newRow("stubborn") << QByteArray("trap '' TERM\nwhile :; do sleep 0.02; done\n");
  }
  void cancelEndsWithinASecond() {
    QFETCH(QByteArray, body);
    const QTemporaryDir folder;
    script(folder, QByteArray("echo '{\"fraction\":0}'\n" + body).constData());
    ExportJob job;
    QSignalSpy progressed(&job, &ExportJob::progressed);
    QSignalSpy finished(&job, &ExportJob::finished);
    job.start(plan());
    QTRY_VERIFY(progressed.count() > 0);
    QElapsedTimer timer;
    timer.start();
    job.cancel();
    QTRY_COMPARE(finished.count(), 1);
    QVERIFY(timer.elapsed() < 1000);
    QVERIFY(finished[0][1].toBool());
  }

  /// A running export is given up only after a question, and how it ended is told.
  void closingAsksWhileItRuns() {
    const QTemporaryDir folder;
    script(folder, "trap 'exit 5' TERM\necho '{\"fraction\":0}'\nwhile :; do sleep 0.02; done\n");
    ExportDialog::Defaults defaults;
    defaults.scene = folder.filePath(QStringLiteral("a.spindrift"));
    ExportDialog dialog({{QStringLiteral("png8"), QStringLiteral("PNG"), true}}, defaults);
    int asked = 0;
    bool stop = false;
    dialog.askStop = [&] {
      ++asked;
      return stop;
    };
    QSignalSpy ended(&dialog, &ExportDialog::ended);
    QSignalSpy progressed(&dialog.job(), &ExportJob::progressed);
    dialog.show();
    dialog.findChild<QPushButton*>(QStringLiteral("exportStart"))->click();
    QTRY_VERIFY(progressed.count() > 0);
    QVERIFY(!dialog.close());
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QCOMPARE(asked, 2);
    QVERIFY(dialog.isVisible());
    QVERIFY(dialog.job().running());
    QCOMPARE(ended.count(), 0);
    stop = true;
    QVERIFY(dialog.close());
    QVERIFY(ended.count() > 0);
    QTRY_VERIFY(!dialog.job().running());
    dialog.show();
    QVERIFY(dialog.close());
    QCOMPARE(asked, 3);
  }

  void theEndIsTold_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<QString>("text");
    QTest::newRow("written") << QByteArray("exit 0\n") << QStringLiteral("Exported to ");
    QTest::newRow("failed") << QByteArray("exit 4\n") << QStringLiteral("The export failed.");
  }
  void theEndIsTold() {
    QFETCH(QByteArray, body);
    QFETCH(QString, text);
    const QTemporaryDir folder;
    script(folder, body.constData());
    ExportDialog::Defaults defaults;
    defaults.scene = folder.filePath(QStringLiteral("a.spindrift"));
    ExportDialog dialog({{QStringLiteral("png8"), QStringLiteral("PNG"), true}}, defaults);
    QSignalSpy ended(&dialog, &ExportDialog::ended);
    dialog.findChild<QPushButton*>(QStringLiteral("exportStart"))->click();
    QTRY_COMPARE(ended.count(), 1);
    QVERIFY2(ended[0][0].toString().startsWith(text), qPrintable(ended[0][0].toString()));
  }

  void durationsRead() {
    QCOMPARE(durationText(-1.0), QString());
    QCOMPARE(durationText(59.4), QStringLiteral("59 s"));
    QCOMPARE(durationText(125), QStringLiteral("2 min 5 s"));
    QCOMPARE(durationText(7260), QStringLiteral("2 h 1 min"));
  }
};

QTEST_MAIN(ExportJobTest)
#include "export_job_test.moc"
