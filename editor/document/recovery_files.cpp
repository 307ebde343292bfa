// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/recovery_files.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "core/scene/json.h"
#include "editor/document/layer_blob.h"

namespace spin {
namespace {

const QString kSceneName = QStringLiteral("scene.spindrift");
const QString kInfoName = QStringLiteral("info.json");

QString layerName(const std::string& node) {
  return QStringLiteral("layer_%1.bin").arg(QString::fromStdString(node));
}

Status write(const QString& path, const QByteArray& bytes) {
  QSaveFile file(path);
  if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit()) return {};
  return Error{ErrorKind::Failed, "The recovery copy could not be written", path.toStdString(),
               file.errorString().toStdString(), "Save the scene"};
}

Status writeLayer(const RecoveryContent& content, const SceneNode& node) {
  const QString path = QDir(content.folder).filePath(layerName(node.id));
  const auto known = content.layersWritten.find(node.id);
  if (known != content.layersWritten.end() && known->second == node.painted && QFileInfo::exists(path))
    return {};
  if (std::holds_alternative<std::monostate>(node.painted)) {
    QFile::remove(path);
    return {};
  }
  return write(path, packLayer(node.painted));
}

QString textOf(const JsonValue& json, const char* key) {
  const JsonValue* value = json.find(key);
  return value ? QString::fromStdString(value->text) : QString();
}

}  // namespace

Status writeRecovery(const RecoveryContent& content) {
  const QDir folder(content.folder);
  if (!folder.mkpath(QStringLiteral(".")))
    return Error{ErrorKind::Failed, "The recovery copy could not be written", content.folder.toStdString(),
                 "the folder cannot be made", "Save the scene"};
  for (const SceneNode& node : content.scene.nodes())
    if (Status status = writeLayer(content, node); !status) return status;
  const std::string text = writeSceneText(content.scene, content.extras);
  if (Status status = write(folder.filePath(kSceneName), QByteArray::fromStdString(text)); !status)
    return status;
  JsonValue info = JsonValue::object();
  info.set("hash_on_disk", JsonValue::of(content.hashOnDisk));
  info.set("name", JsonValue::of(content.displayName.toStdString()));
  info.set("reason", JsonValue::of("unsaved changes"));
  info.set("scene", JsonValue::of(content.scenePath.toStdString()));
  info.set("written",
           JsonValue::of(QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString()));
  return write(folder.filePath(kInfoName), QByteArray::fromStdString(writeJson(info)));
}

Result<Recovery> readRecoveryInfo(const QString& folder) {
  constexpr qint64 kMaxInfoBytes = 65536;
  const std::string name = folder.toStdString();
  QFile file(QDir(folder).filePath(kInfoName));
  if (!file.open(QIODevice::ReadOnly))
    return badInput("There is nothing to recover", name, "it has no description");
  const Result<JsonValue> info = parseJson(file.read(kMaxInfoBytes).toStdString(), name);
  if (!info) return info.error();
  return Recovery{folder, textOf(*info, "scene"), textOf(*info, "name"),
                  QDateTime::fromString(textOf(*info, "written"), Qt::ISODateWithMs),
                  textOf(*info, "hash_on_disk")};
}

Result<LoadedScene> readRecovery(const Recovery& recovery) {
  const QDir folder(recovery.folder);
  Result<LoadedScene> loaded = loadScene(folder.filePath(kSceneName).toStdString());
  if (!loaded) return loaded;
  for (const SceneNode& listed : loaded->scene.nodes()) {
    QFile file(folder.filePath(layerName(listed.id)));
    if (!file.open(QIODevice::ReadOnly)) continue;
    Result<PaintedLayer> layer = unpackLayer(file.readAll(), listed.id);
    const Status status = layer ? checkLayer(listed, *layer) : Status(layer.error());
    if (status)
      loaded->scene.find(listed.id)->painted = std::move(*layer);
    else
      loaded->extras.messages.push_back(status.error().text());
  }
  return loaded;
}

}  // namespace spin
