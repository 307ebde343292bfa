// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/export_job.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>

#include <sys/resource.h>

#include "core/base/result.h"

namespace spin {
namespace {

constexpr qsizetype kMaxMessages = 20000;
constexpr int kChildNiceness = 15;

QString quoted(const QString& word) {
  static const QString plain = QStringLiteral("-_./:=,+@%");
  bool safe = !word.isEmpty();
  for (const QChar c : word) safe = safe && (c.isLetterOrNumber() || plain.contains(c));
  if (safe) return word;
  return QStringLiteral("'") + QString(word).replace(QStringLiteral("'"), QStringLiteral("u'\\''")) +
         QStringLiteral("'");
}

}  // namespace

QStringList exportArguments(const ExportPlan& plan) {
  QStringList arguments{
      QStringLiteral("run"),      plan.scene,
      QStringLiteral("--frames"), QStringLiteral("%1:%2").arg(plan.firstFrame).arg(plan.lastFrame),
      QStringLiteral("--output"), plan.folder};
  for (const QString& format : plan.formats) arguments << QStringLiteral("--format") << format;
  const auto set = [&](const char* property, int value) {
    if (value > 0)
      arguments << QStringLiteral("--set")
                << QStringLiteral("%1.%2=%3").arg(plan.pictureNode, QLatin1String(property)).arg(value);
  };
  set("width_px", plan.width);
  set("height_px", plan.height);
  for (const QString& folder : plan.allowedFolders) arguments << QStringLiteral("--allow") << folder;
  return arguments;
}

QString commandText(const ExportPlan& plan) {
  QStringList words{QStringLiteral("spindrift-cli")};
  for (const QString& argument : exportArguments(plan)) words << quoted(argument);
  return words.join(u' ');
}

QString cliProgram() {
  const QString named = qEnvironmentVariable("SPIN_CLI");
  return named.isEmpty() ? QCoreApplication::applicationDirPath() + QStringLiteral("/spindrift-cli") : named;
}

ExportJob::ExportJob(QObject* parent) : QObject(parent) {
  m_kill.setSingleShot(true);
  m_kill.setInterval(kKillMilliseconds);
  // The window comes first where both want the processor.
  m_process.setChildProcessModifier([] { ::setpriority(PRIO_PROCESS, 0, kChildNiceness); });
  connect(&m_kill, &QTimer::timeout, &m_process, &QProcess::kill);
  connect(&m_process, &QProcess::readyReadStandardOutput, this, &ExportJob::readOutput);
  connect(&m_process, &QProcess::readyReadStandardError, this,
          [this] { m_messages = (m_messages + m_process.readAllStandardError()).right(kMaxMessages); });
  connect(&m_process, &QProcess::finished, this, &ExportJob::end);
  connect(&m_process, &QProcess::errorOccurred, this, &ExportJob::failToStart);
}

ExportJob::~ExportJob() {
  m_process.disconnect(this);
  if (!running()) return;
  m_process.terminate();
  if (m_process.waitForFinished(kKillMilliseconds)) return;
  m_process.kill();
  m_process.waitForFinished();
}

void ExportJob::start(const ExportPlan& plan) {
  m_pending.clear();
  m_messages.clear();
  m_cancelled = false;
  m_process.setProgram(cliProgram());
  m_process.setArguments(exportArguments(plan) +
                         QStringList{QStringLiteral("--progress"), QStringLiteral("json")});
  m_process.start();
}

void ExportJob::cancel() {
  if (!running()) return;
  m_cancelled = true;
  m_process.terminate();
  m_kill.start();
}

void ExportJob::readOutput() {
  m_pending += m_process.readAllStandardOutput();
  qsizetype end;
  while ((end = m_pending.indexOf('\n')) >= 0) {
    readLine(m_pending.left(end));
    m_pending.remove(0, end + 1);
  }
}

void ExportJob::readLine(const QByteArray& line) {
  const QJsonObject object = QJsonDocument::fromJson(line).object();
  if (!object.contains(QStringLiteral("fraction"))) return;
  Q_EMIT progressed(object.value(QStringLiteral("fraction")).toDouble(),
                    object.value(QStringLiteral("seconds_left")).toDouble(-1.0),
                    object.value(QStringLiteral("stage")).toString());
}

void ExportJob::end(int exitCode, QProcess::ExitStatus status) {
  m_kill.stop();
  readOutput();
  m_messages += m_process.readAllStandardError();
  const bool cancelled =
      m_cancelled || (status == QProcess::NormalExit && exitCode == spin::exitCode(ErrorKind::Cancelled));
  const bool ok = status == QProcess::NormalExit && exitCode == 0 && !m_cancelled;
  QString message = QString::fromUtf8(m_messages).trimmed();
  if (status == QProcess::CrashExit && !m_cancelled)
    message = tr("The export program ended unexpectedly.") + u'\n' + message;
  Q_EMIT finished(ok, cancelled, message.trimmed());
}

void ExportJob::failToStart(QProcess::ProcessError error) {
  if (error != QProcess::FailedToStart) return;
  Q_EMIT finished(false, false, tr("The export program could not be started: %1").arg(m_process.program()));
}

}  // namespace spin
