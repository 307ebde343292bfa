// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

class QObject;

namespace spin {

/// What a plugin file says about itself (Q_PLUGIN_METADATA), read without loading its code.
struct PluginEntry {
  std::string path;                     ///< absolute
  std::string interfaceId;              ///< SPIN_..._IID
  std::vector<std::string> extensions;  ///< of importers: lower case, without the dot
};

struct PluginCatalogue {
  std::vector<PluginEntry> entries;   ///< in the order of file names, so that the choice never varies
  std::vector<std::string> warnings;  ///< files in a plugin folder that are no plugin
};

/// Folder of the running program's executable.
std::string programFolder();
/// SPIN_PLUGIN_PATH (folders separated by ':') if set, else "plugins" beside the program and
/// ../lib/spindrift/plugins from there.
std::vector<std::string> pluginFolders();
PluginCatalogue readPluginCatalogue(const std::vector<std::string>& folders);
/// First entry of an interface that lists the extension; nullptr if there is none.
const PluginEntry* findPlugin(const PluginCatalogue& catalogue, const std::string& interfaceId,
                              const std::string& extension);
/// Loads the plugin's code; the object lives until the program ends.
Result<QObject*> loadPlugin(const PluginEntry& entry);

}  // namespace spin
