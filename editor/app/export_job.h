// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QStringList>
#include <QTimer>

namespace spin {

/// What to write and where.
struct ExportPlan {
  QString scene;        ///< saved scene file
  QStringList formats;  ///< ids of image formats and cache exporters
  int firstFrame = 0;   ///< inclusive
  int lastFrame = 0;
  QString folder;
  int width = 0;  ///< pixels; 0 = the scene's
  int height = 0;
  QString pictureNode;         ///< id of the node that holds the picture size
  QStringList allowedFolders;  ///< besides the scene's own
};

/// Arguments of spindrift-cli for a plan: what the dialog shows and the job runs.
QStringList exportArguments(const ExportPlan& plan);
/// The command line as one would type it, quoted where needed.
QString commandText(const ExportPlan& plan);
/// spindrift-cli beside this program; SPIN_CLI names another one.
QString cliProgram();

/// Exports by running the command line as a child, so that both write the same bytes and a crash in an
/// encoder leaves the window alone.
class ExportJob : public QObject {
  Q_OBJECT
 public:
  static constexpr int kKillMilliseconds = 800;

  explicit ExportJob(QObject* parent = nullptr);
  ~ExportJob() override;

  void start(const ExportPlan& plan);
  /// Asks the child to stop, and ends it if it has not done so shortly after.
  void cancel();
  bool running() const { return m_process.state() != QProcess::NotRunning; }

 Q_SIGNALS:
  /// fraction 0..1; secondsLeft < 0 = not known yet.
  void progressed(double fraction, double secondsLeft, const QString& stage);
  /// message is what the program said on stderr, or empty.
  void finished(bool ok, bool cancelled, const QString& message);

 private:
  void readOutput();
  void readLine(const QByteArray& line);
  void end(int exitCode, QProcess::ExitStatus status);
  void failToStart(QProcess::ProcessError error);

  QProcess m_process;
  QTimer m_kill;
  QByteArray m_pending;
  QByteArray m_messages;
  bool m_cancelled = false;
};

}  // namespace spin
