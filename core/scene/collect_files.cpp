// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/collect_files.h"

#include <fmt/format.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUrl>

#include "core/scene/json.h"
#include "core/scene/scene_file.h"

namespace spin {
namespace {

/// Model files are read whole up to here; their companions beyond it are not looked for.
constexpr qint64 kMaxText = 64 << 20;

QByteArray textOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) && file.size() <= kMaxText ? file.readAll() : QByteArray();
}

/// glTF 2.0, section 3.6.1.1 and 3.8.4: relative URIs, percent-encoded; "data:" holds the bytes itself.
QStringList gltfReferences(const QString& path) {
  QStringList names;
  const Result<JsonValue> root = parseJson(textOf(path).toStdString(), path.toStdString());
  if (!root) return names;
  for (const char* list : {"buffers", "images"}) {
    const JsonValue* entries = root->find(list);
    for (const JsonValue& entry : entries ? entries->items : std::vector<JsonValue>()) {
      const JsonValue* uri = entry.find("uri");
      if (uri && !uri->text.starts_with("data:"))
        names << QUrl::fromPercentEncoding(QByteArray::fromStdString(uri->text));
    }
  }
  return names;
}

/// Last word of each line that begins with one of the keys (OBJ: mtllib; MTL: map_Kd and its kin).
QStringList lineReferences(const QString& path, const QStringList& keys) {
  QStringList names;
  for (const QByteArray& line : textOf(path).split('\n')) {
    const QString text = QString::fromUtf8(line).trimmed();
    for (const QString& key : keys)
      if (text.startsWith(key, Qt::CaseInsensitive)) names << text.section(QLatin1Char(' '), -1);
  }
  return names;
}

QStringList objReferences(const QString& path) {
  QStringList names = lineReferences(path, {QStringLiteral("mtllib ")});
  const QDir folder = QFileInfo(path).dir();
  for (const QString& library : QStringList(names))
    names << lineReferences(folder.filePath(library), {QStringLiteral("map_"), QStringLiteral("bump ")});
  return names;
}

QStringList sideFiles(const QString& path) {
  QStringList names;
  const QFileInfo info(path);
  for (const char* ending : {".prj", ".tfw", ".pgw", ".hdr", ".aux.xml"})
    names << info.completeBaseName() + QLatin1String(ending) << info.fileName() + QLatin1String(ending);
  return names;
}

bool sameContent(const QString& a, const QString& b) {
  return QFileInfo(a).size() == QFileInfo(b).size() && hashFile(a.toStdString()) == hashFile(b.toStdString());
}

Status copyFile(const QString& from, const QString& to) {
  const QDir folder = QFileInfo(to).dir();
  if (QFile::exists(to) && sameContent(from, to)) return {};
  QFile source(from);
  if (folder.mkpath(QStringLiteral(".")) && source.copy(to)) return {};
  return Error{ErrorKind::Failed, "The file could not be copied", from.toStdString(),
               source.errorString().toStdString(),
               "Check the rights and the free space of the scene's folder"};
}

}  // namespace

std::vector<std::string> companionsOf(const std::string& path) {
  const QString file = QString::fromStdString(path);
  const QString ending = QFileInfo(file).suffix().toLower();
  QStringList names = sideFiles(file);
  if (ending == QLatin1String("gltf")) names << gltfReferences(file);
  if (ending == QLatin1String("obj")) names << objReferences(file);
  names.removeDuplicates();
  const QDir folder = QFileInfo(file).dir();
  std::vector<std::string> found;
  for (const QString& name : names) {
    const QString clean = QDir::cleanPath(name);
    const bool below = QDir::isRelativePath(clean) && !clean.startsWith(QLatin1String(".."));
    if (below && QFileInfo(folder.filePath(clean)).isFile()) found.push_back(clean.toStdString());
  }
  return found;
}

Result<std::string> copyWithCompanions(const std::string& path, const std::string& folder) {
  const QFileInfo info(QString::fromStdString(path));
  QDir target(QString::fromStdString(folder));
  // Companions keep their names, so a clash moves the whole family into a folder of its own.
  const auto clashes = [&] {
    const QString main = target.filePath(info.fileName());
    return QFile::exists(main) && !sameContent(info.filePath(), main);
  };
  for (int number = 2; clashes(); ++number)
    target.setPath(
        QStringLiteral("%1/%2_%3").arg(QString::fromStdString(folder), info.completeBaseName()).arg(number));
  for (const std::string& companion : companionsOf(path)) {
    const QString name = QString::fromStdString(companion);
    if (Status status = copyFile(info.dir().filePath(name), target.filePath(name)); !status)
      return status.error();
  }
  const QString copy = target.filePath(info.fileName());
  if (Status status = copyFile(info.filePath(), copy); !status) return status.error();
  return copy.toStdString();
}

std::string assetFolderOf(const std::string& sceneFile) {
  const QFileInfo info(QString::fromStdString(sceneFile));
  return info.absoluteDir().filePath(info.completeBaseName() + QStringLiteral(".assets")).toStdString();
}

Result<std::string> copyBeside(const std::string& path, const std::string& sceneFile) {
  return copyWithCompanions(path, assetFolderOf(sceneFile));
}

}  // namespace spin
