// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <map>

#include "editor/app/export_dialog.h"
#include "editor/app/main_window.h"
#include "editor/app/ui_watchdog.h"
#include "plugins/host/plugin_host.h"
#include "tests/editor/support/strict.h"

using namespace spin;

namespace {

/// So long a whole run may take on a busy machine with a software driver.
constexpr int kWait = 240000;

void writeText(const QString& path, const QByteArray& text) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write(text), text.size());
}

/// A small ramp with snowfall over it.
QString smallScene(const QTemporaryDir& folder) {
  QByteArray rows = "ncols 24\nnrows 20\nxllcorner 1000\nyllcorner 2000\ncellsize 4\nNODATA_value -9999\n";
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 24; ++i)
      rows += QByteArray::number(100.0 + 0.7 * i + 0.3 * j) + (i == 23 ? "\n" : " ");
  writeText(folder.filePath(QStringLiteral("ramp.asc")), rows);
  const QString scene = folder.filePath(QStringLiteral("ramp.spindrift"));
  writeText(scene, R"({
  "format": "spindrift-scene", "schema": 2, "min_reader": 1, "generator": "test",
  "nodes": [
    {"id": "terrain", "name": "Ramp", "type": "terrain", "properties": {"source": "ramp.asc", "epsg": 31287}},
    {"id": "weather", "name": "Weather", "type": "weather"},
    {"id": "snow", "name": "Snowfall", "type": "snowfall", "properties": {"flake_count": 300}},
    {"id": "camera", "name": "Camera", "type": "camera", "properties": {"position_m": [46, -40, 60], "target_m": [46, 40, 8]}},
    {"id": "render", "name": "Pictures", "type": "render", "properties": {"width_px": 96, "height_px": 64, "samples": 2}},
    {"id": "simulation", "name": "Simulation", "type": "simulation", "properties": {"last_frame": 3, "time_scale": 600, "exposure_rays": 16}}
  ]
})");
  return scene;
}

std::map<QString, QByteArray> filesIn(const QString& folder) {
  std::map<QString, QByteArray> files;
  QDirIterator all(folder, QDir::Files, QDirIterator::Subdirectories);
  while (all.hasNext()) {
    QFile file(all.next());
    if (file.open(QIODevice::ReadOnly))
      files[QDir(folder).relativeFilePath(file.fileName())] = file.readAll();
  }
  return files;
}

}  // namespace

/// The whole way with real plugins, drawing and the export program.
class ExportGlTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  /// What the window exports and what the command line exports are the same bytes, file for file. The window
  /// has simulated the scene before; the command line starts without a cache.
  void windowAndCommandLineExportTheSame() {
    const QTemporaryDir folder;
    const QString scene = smallScene(folder);
    MainWindow window(makeHelperAssetReader());
    window.resize(900, 600);
    window.show();
    UiWatchdog watchdog;
    QSignalSpy simulated(&window.simulation(), &SimulationController::finished);
    window.openOrImport(scene);
    QTRY_VERIFY_WITH_TIMEOUT(simulated.count() > 0, kWait);
    QCOMPARE(simulated.last()[0].toString(), QString());

    window.showExportDialog();
    auto* dialog = window.findChild<ExportDialog*>();
    QVERIFY(dialog);
    QCOMPARE(dialog->findChild<QSpinBox*>(QStringLiteral("exportLast"))->value(), 3);
    QSignalSpy exported(&dialog->job(), &ExportJob::finished);
    QPointer<ExportDialog> kept(dialog);
    dialog->findChild<QPushButton*>(QStringLiteral("exportStart"))->click();
    QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kWait);
    QVERIFY2(exported[0][0].toBool(), qPrintable(exported[0][2].toString()));
    const ExportPlan fromWindow = dialog->plan();

    // The same command from a shell, to another folder and with its own cache.
    ExportPlan fromShell = fromWindow;
    fromShell.folder = folder.filePath(QStringLiteral("shell"));
    QProcess shell;
    shell.start(cliProgram(),
                exportArguments(fromShell) +
                    QStringList{QStringLiteral("--cache"), folder.filePath(QStringLiteral("cold"))});
    QVERIFY(shell.waitForFinished(kWait));
    QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
    const auto a = filesIn(fromWindow.folder);
    const auto b = filesIn(fromShell.folder);
    QVERIFY(a.size() >= 4 * 4 + 1);
    QCOMPARE(a.size(), b.size());
    for (const auto& [name, bytes] : a) {
      QVERIFY2(b.count(name) == 1, qPrintable(name));
      QVERIFY2(b.at(name) == bytes, qPrintable(name));
    }
    qInfo("longest stand-still of the window: %.0f ms", watchdog.longestBlockSeconds() * 1e3);
  }
};

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  ExportGlTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "export_gl_test.moc"
