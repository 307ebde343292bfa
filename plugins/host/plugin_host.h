// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/scene/asset_library.h"
#include "plugins/sdk/exporter.h"
#include "plugins/sdk/layer_filter.h"

namespace spin {

/// Finds and loads plugins from the program's plugin folder (SPIN_PLUGIN_PATH overrides it). A plugin that
/// does not load is a warning, not an error. Importer plugins are only listed here, their code is loaded by
/// the import helper.
class PluginHost {
 public:
  PluginHost();
  ~PluginHost();

  std::vector<ImageFormat> imageFormats() const;
  /// nullptr if no writer knows the format.
  ImageWriter* imageWriter(const std::string& formatId) const;
  std::vector<std::string> exporterIds() const;
  std::string exporterLabel(const std::string& id) const;
  std::unique_ptr<CacheExporter> makeExporter(const std::string& id) const;
  /// Filters on painted layers, of all plugins in turn.
  std::vector<LayerFilterInfo> layerFilters() const;
  /// nullptr if no plugin knows the filter.
  const LayerFilter* layerFilter(const std::string& filterId) const;
  std::vector<std::string> terrainExtensions() const;
  std::vector<std::string> modelExtensions() const;
  const std::vector<std::string>& warnings() const;

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

struct ImportLimits {
  std::size_t memoryBytes = std::size_t{4} << 30;
  double seconds = 120.0;
};

/// Reads files by starting `spindrift-import-helper` for each (found beside the program; SPIN_IMPORT_HELPER
/// overrides).
std::shared_ptr<AssetReader> makeHelperAssetReader(ImportLimits limits = {});

}  // namespace spin
