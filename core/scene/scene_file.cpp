// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/scene_file.h"

#include <fmt/format.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "core/scene/json.h"

namespace spin {
namespace {

Error unreadable(const QString& path, const QString& why) {
  return badInput("The scene cannot be read", path.toStdString(), why.toStdString(),
                  "Check the path and its rights");
}

Error unwritable(const QString& path, const QString& why) {
  return Error{ErrorKind::Failed, "The scene could not be saved", path.toStdString(), why.toStdString(),
               "Check the rights and the free space of the folder, or save elsewhere"};
}

Result<std::string> readFile(const QString& path) {
  const QFileInfo info(path);
  if (info.exists() && !info.isFile()) return unreadable(path, QStringLiteral("it is no regular file"));
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return unreadable(path, file.errorString());
  const QByteArray bytes = file.read(static_cast<qint64>(kMaxSceneBytes) + 1);
  if (file.error() != QFileDevice::NoError) return unreadable(path, file.errorString());
  return bytes.toStdString();
}

/// Schema of the file that is about to be overwritten; 0 where there is none or it is no scene.
int schemaOf(const QString& path) {
  if (!QFileInfo::exists(path)) return 0;
  const Result<std::string> text = readFile(path);
  if (!text) return 0;
  const Result<JsonValue> root = parseJson(*text, path.toStdString());
  const JsonValue* schema = root ? root->find("schema") : nullptr;
  return schema && schema->number >= 1 && schema->number < 1e6 ? static_cast<int>(schema->number) : 0;
}

Status backUpOldSchema(const QString& path) {
  const int schema = schemaOf(path);
  if (schema == 0 || schema >= kSceneSchema) return {};
  const QFileInfo info(path);
  const QString backup =
      info.dir().filePath(QStringLiteral("%1.schema%2.bak").arg(info.completeBaseName()).arg(schema));
  if (QFileInfo::exists(backup)) return {};
  QFile old(path);
  if (!old.copy(backup)) return unwritable(backup, old.errorString());
  return {};
}

}  // namespace

Status saveScene(const Scene& scene, const SceneFileExtras& extras, const std::string& path) {
  const QString file = QString::fromStdString(path);
  if (Status status = backUpOldSchema(file); !status) return status;
  const std::string text = writeSceneText(scene, extras);
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) return unwritable(file, out.errorString());
  const bool written =
      out.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size());
  if (!written || !out.commit()) return unwritable(file, out.errorString());
  return {};
}

Result<LoadedScene> loadScene(const std::string& path) {
  const QString file = QString::fromStdString(path);
  Result<std::string> text = readFile(file);
  if (!text) return text.error();
  return readSceneText(*text, QFileInfo(file).fileName().toStdString());
}

}  // namespace spin
