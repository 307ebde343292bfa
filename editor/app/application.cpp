// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/application.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>
#include <cstdlib>
#include <cstring>

#include "core/base/log.h"
#include "core/base/result.h"
#include "editor/app/dark_look.h"
#include "editor/app/file_flow.h"
#include "editor/app/languages.h"
#include "editor/app/main_window.h"
#include "editor/app/tool_icons.h"
#include "editor/app/ui_measurement.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"
#include "plugins/host/plugin_host.h"

namespace spin {
namespace {

constexpr int kPictureDelayMilliseconds = 1500;

struct Options {
  QStringList files;
  QString language;
  QString measureFile;
  QString pictureFile;
};

Options parse(const QCoreApplication& application) {
  const auto text = [](const char* source) {
    return QCoreApplication::translate("spin::Application", source);
  };
  QCommandLineParser parser;
  parser.setApplicationDescription(
      text(QT_TRANSLATE_NOOP("spin::Application", "Editor and simulator of winter scenes.")));
  parser.addHelpOption();
  parser.addVersionOption();
  const QCommandLineOption language(
      QStringLiteral("language"),
      text(QT_TRANSLATE_NOOP("spin::Application", "Language of the window: en, cs or zh_CN.")),
      QStringLiteral("code"));
  const QCommandLineOption measure(
      QStringLiteral("measure-ui"),
      text(QT_TRANSLATE_NOOP(
          "spin::Application",
          "Simulates, plays and exports the scene, writes how long the window stood still to "
          "FILE as JSON, and ends.")),
      QStringLiteral("FILE"));
  const QCommandLineOption picture(
      QStringLiteral("screenshot"),
      text(
          QT_TRANSLATE_NOOP("spin::Application",
                            "Writes a picture of the window to FILE once the scene is simulated, and ends.")),
      QStringLiteral("FILE"));
  parser.addOptions({language, measure, picture});
  parser.addPositionalArgument(
      QStringLiteral("files"),
      text(QT_TRANSLATE_NOOP("spin::Application", "A scene to open, or terrains and models to import.")),
      QStringLiteral("[FILE...]"));
  parser.process(application);
  return {parser.positionalArguments(), parser.value(language), parser.value(measure), parser.value(picture)};
}

/// The language must be known before the texts of the options are made.
QString languageOf(int argc, char** argv) {
  for (int k = 1; k < argc; ++k) {
    const QString argument = QString::fromLocal8Bit(argv[k]);
    if (argument.startsWith(QLatin1String("--language="))) return argument.mid(11);
    if (argument == QLatin1String("--language") && k + 1 < argc) return QString::fromLocal8Bit(argv[k + 1]);
  }
  return {};
}

/// Help and version need no window, and so no display.
bool asksForText(int argc, char** argv) {
  for (int k = 1; k < argc; ++k)
    for (const char* word : {"-h", "--help", "--help-all", "-v", "--version"})
      if (std::strcmp(argv[k], word) == 0) return true;
  return false;
}

/// Qt ends the program where it finds no display; this says first what to do instead.
bool displayMissing(int argc, char** argv) {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (const char* value = std::getenv(name); value && *value) return false;
  for (int k = 1; k < argc; ++k)
    if (std::strcmp(argv[k], "-platform") == 0) return false;
  return true;
}

void describe(QCoreApplication& application) {
  application.setOrganizationName(QStringLiteral("Spindrift"));
  application.setApplicationName(QStringLiteral("spindrift"));
  application.setApplicationVersion(QStringLiteral(SPIN_VERSION));
}

int printText(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  describe(application);
  loadLanguage(application, languageOf(argc, argv));
  parse(application);
  return 0;
}

/// Nobody is there to answer: what fails ends the program.
void takePicture(MainWindow& window, const Options& options) {
  bool failed = false;
  window.files().showError = [&failed](const QString& text) {
    logError(text.toStdString());
    failed = true;
  };
  for (const QString& file : options.files) window.openOrImport(file);
  window.files().showError = [](const QString& text) { logError(text.toStdString()); };
  if (failed) return QCoreApplication::exit(exitCode(ErrorKind::BadInput));
  const auto save = [&window, file = options.pictureFile] {
    QTimer::singleShot(kPictureDelayMilliseconds, &window,
                       [&window, file] { QCoreApplication::exit(window.grab().save(file) ? 0 : 1); });
  };
  QObject::connect(&window.simulation(), &SimulationController::finished, &window, save);
}

}  // namespace

int runEditor(int argc, char** argv) {
  if (asksForText(argc, argv)) return printText(argc, argv);
  if (displayMissing(argc, argv)) {
    logError("There is no display for the editor. Start it in a desktop session, or use spindrift-cli");
    return exitCode(ErrorKind::Usage);
  }
  QApplication application(argc, argv);
  describe(application);
  QApplication::setWindowIcon(programIcon());
  const bool known = loadLanguage(application, languageOf(argc, argv));
  const Options options = parse(application);
  if (!known && !options.language.isEmpty() && !availableLanguages().contains(options.language)) {
    qWarning("spindrift: language %s is not there; known are: %s", qPrintable(options.language),
             qPrintable(availableLanguages().join(QStringLiteral(", "))));
    return exitCode(ErrorKind::Usage);
  }
  applyDarkLook(application);
  if (screenIsThere()) loadGraphicsDriver();

  MainWindow window(makeHelperAssetReader());
  window.show();
  if (!options.measureFile.isEmpty() && !options.files.isEmpty()) {
    auto* measurement = new UiMeasurement(&window, options.files.front(), options.measureFile);
    QObject::connect(measurement, &UiMeasurement::done, &application,
                     [](bool ok) { QCoreApplication::exit(ok ? 0 : 1); });
    QTimer::singleShot(0, measurement, &UiMeasurement::start);
    return QApplication::exec();
  }
  QTimer::singleShot(0, &window, [&window, &options] {
    if (options.pictureFile.isEmpty())
      window.start(options.files);
    else
      takePicture(window, options);
  });
  return QApplication::exec();
}

}  // namespace spin
