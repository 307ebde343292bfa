// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <array>

#include "core/property/text_check.h"
#include "core/scene/scene_file.h"

namespace spin {
namespace {

constexpr int kSearchDepth = 6;
constexpr int kSearchEntries = 20'000;

Error refused(const std::string& path, std::string why, std::string advice = {}) {
  return badInput("The file is refused", printable(path), std::move(why), std::move(advice));
}

bool isWithin(const QString& path, const QString& folder) {
  if (folder.isEmpty()) return false;
  const QString root = folder.endsWith(QLatin1Char('/')) ? folder : folder + QLatin1Char('/');
  return path.startsWith(root);
}

/// Names that Windows takes for devices in every folder, with or without an ending.
bool isDeviceName(const QString& component) {
  static const std::array<const char*, 4> kPlain{"con", "prn", "aux", "nul"};
  const QString stem = component.section(QLatin1Char('.'), 0, 0).trimmed().toLower();
  if (std::any_of(kPlain.begin(), kPlain.end(), [&](const char* n) { return stem == QLatin1String(n); }))
    return true;
  return stem.size() == 4 &&
         (stem.startsWith(QLatin1String("com")) || stem.startsWith(QLatin1String("lpt"))) &&
         stem[3].isDigit();
}

bool isSystemPath(const QString& path) {
  for (const char* root : {"/dev", "/proc", "/sys"})
    if (path == QLatin1String(root) || path.startsWith(QLatin1String(root) + QLatin1Char('/'))) return true;
  return false;
}

Status checkForm(const std::string& assetPath) {
  if (assetPath.empty()) return refused(assetPath, "no file is named", "Choose a file");
  if (!isCleanText(assetPath)) return refused(assetPath, "the path is not UTF-8 or has control characters");
  if (assetPath.find('\\') != std::string::npos)
    return refused(assetPath, "the path has backslashes", "Write the path with '/'");
  const std::size_t colon = assetPath.find(':');
  const bool driveLetter = colon == 1 && assetPath.size() > 2 && assetPath[2] == '/';
  if (colon != std::string::npos && colon < assetPath.find('/') && !driveLetter)
    return refused(assetPath, "it is an address, not a file", "Fetch the file and name the copy");
  const QStringList parts = QString::fromStdString(assetPath).split(QLatin1Char('/'));
  if (std::any_of(parts.begin(), parts.end(), isDeviceName)) return refused(assetPath, "it names a device");
  return {};
}

/// Follows links where the file exists, so that a link cannot lead out of an allowed folder unseen.
QString canonical(const QString& path) {
  const QString real = QFileInfo(path).canonicalFilePath();
  return real.isEmpty() ? path : real;
}

QString sceneFolder(const std::string& sceneFile) {
  if (sceneFile.empty()) return {};
  return QDir::cleanPath(QFileInfo(QString::fromStdString(sceneFile)).absolutePath());
}

bool isAllowed(const QString& path, const QString& folder, const PathPolicy& policy) {
  if (isWithin(path, folder) || isWithin(path, canonical(folder))) return true;
  return std::any_of(policy.allowedFolders.begin(), policy.allowedFolders.end(),
                     [&](const std::string& allowed) {
                       const QString root = QDir::cleanPath(QString::fromStdString(allowed));
                       return isWithin(path, root) || isWithin(path, canonical(root));
                     });
}

}  // namespace

Result<std::string> resolveAssetPath(const std::string& sceneFile, const std::string& assetPath,
                                     const PathPolicy& policy) {
  if (Status status = checkForm(assetPath); !status) return status.error();
  const QString folder = sceneFolder(sceneFile), asked = QString::fromStdString(assetPath);
  const bool absolute = QDir::isAbsolutePath(asked);
  if (!absolute && folder.isEmpty())
    return refused(assetPath, "the path is relative, but the scene has no folder yet",
                   "Save the scene first");
  const QString path = QDir::cleanPath(absolute ? asked : folder + QLatin1Char('/') + asked);
  const QString real = canonical(path);
  if (isSystemPath(path) || isSystemPath(real)) return refused(assetPath, "it names a device");
  if (!isAllowed(path, folder, policy) || !isAllowed(real, folder, policy))
    return refused(assetPath, "the file lies outside the scene's folder",
                   fmt::format("Allow the folder {} or collect the scene's files",
                               printable(QFileInfo(real).path().toStdString())));
  const QFileInfo info(real);
  if (info.exists() && !info.isFile()) return refused(assetPath, "it is no regular file");
  return path.toStdString();
}

std::string storedAssetPath(const std::string& sceneFile, const std::string& absolutePath) {
  const QString path = QDir::cleanPath(QString::fromStdString(absolutePath));
  const QString folder = sceneFolder(sceneFile);
  return (folder.isEmpty() ? path : QDir(folder).relativeFilePath(path)).toStdString();
}

Hash128 hashFile(const std::string& path) {
  QFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::ReadOnly)) return {};
  Hasher hasher;
  QByteArray block(1 << 20, Qt::Uninitialized);
  for (qint64 got = 0; (got = file.read(block.data(), block.size())) > 0;)
    hasher.addBytes(block.constData(), static_cast<std::size_t>(got));
  return file.error() == QFileDevice::NoError ? hasher.digest() : Hash128{};
}

std::optional<std::string> findMovedAsset(const std::string& sceneFile, const std::string& assetPath,
                                          const Hash128& expected) {
  const QString folder = sceneFolder(sceneFile);
  const QString name = QFileInfo(QString::fromStdString(assetPath)).fileName();
  if (folder.isEmpty() || name.isEmpty()) return {};
  std::vector<std::string> found;
  std::vector<std::pair<QString, int>> open{{folder, 0}};
  for (int seen = 0; !open.empty() && seen < kSearchEntries;) {
    const auto [path, depth] = open.back();
    open.pop_back();
    // Links are left alone: they could lead in circles or out of the folder.
    QDirIterator entries(path, QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot | QDir::NoSymLinks);
    while (entries.hasNext() && seen++ < kSearchEntries) {
      entries.next();
      const QFileInfo info = entries.fileInfo();
      if (info.isDir() && depth < kSearchDepth) open.emplace_back(info.filePath(), depth + 1);
      if (info.isFile() && info.fileName() == name) found.push_back(info.filePath().toStdString());
    }
  }
  if (found.empty()) return {};
  std::sort(found.begin(), found.end());
  if (!expected.isNull())
    for (const std::string& path : found)
      if (hashFile(path) == expected) return path;
  return found.front();
}

}  // namespace spin
