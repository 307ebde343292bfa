// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/host/plugin_catalogue.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QPluginLoader>
#include <QString>
#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace spin {

namespace fs = std::filesystem;

std::string programFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? std::string(".") : program.parent_path().string();
}

std::vector<std::string> pluginFolders() {
  std::vector<std::string> folders;
  if (const char* given = std::getenv("SPIN_PLUGIN_PATH"); given && *given) {
    const std::string list = given;
    for (std::size_t at = 0; at <= list.size();) {
      const std::size_t end = std::min(list.find(':', at), list.size());
      if (end > at) folders.push_back(list.substr(at, end - at));
      at = end + 1;
    }
    return folders;
  }
  const fs::path program = programFolder();
  return {(program / "plugins").string(), (program / "../lib/spindrift/plugins").lexically_normal().string()};
}

namespace {

std::vector<fs::path> pluginFiles(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".so") files.push_back(fs::absolute(entry.path()));
  std::sort(files.begin(), files.end());
  return files;
}

PluginEntry entryOf(const fs::path& file, const QJsonObject& about) {
  PluginEntry entry{file.string(), about.value(QLatin1String("IID")).toString().toStdString(), {}};
  const QJsonObject own = about.value(QLatin1String("MetaData")).toObject();
  for (const QJsonValue& extension : own.value(QLatin1String("extensions")).toArray())
    entry.extensions.push_back(extension.toString().toStdString());
  return entry;
}

}  // namespace

PluginCatalogue readPluginCatalogue(const std::vector<std::string>& folders) {
  PluginCatalogue catalogue;
  for (const std::string& folder : folders) {
    for (const fs::path& file : pluginFiles(folder)) {
      const QJsonObject about = QPluginLoader(QString::fromStdString(file.string())).metaData();
      if (about.isEmpty())
        catalogue.warnings.push_back("The plugin " + file.string() + " is left out: it is not a Qt plugin");
      else
        catalogue.entries.push_back(entryOf(file, about));
    }
  }
  return catalogue;
}

const PluginEntry* findPlugin(const PluginCatalogue& catalogue, const std::string& interfaceId,
                              const std::string& extension) {
  for (const PluginEntry& entry : catalogue.entries)
    if (entry.interfaceId == interfaceId &&
        std::count(entry.extensions.begin(), entry.extensions.end(), extension))
      return &entry;
  return nullptr;
}

Result<QObject*> loadPlugin(const PluginEntry& entry) {
  QPluginLoader loader(QString::fromStdString(entry.path));
  QObject* object = loader.instance();
  if (!object)
    return Error{ErrorKind::Failed, "The plugin could not be loaded", entry.path,
                 loader.errorString().toStdString(), "Install the program again"};
  return object;
}

}  // namespace spin
