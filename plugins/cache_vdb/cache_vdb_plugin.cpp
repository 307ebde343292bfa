// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cache_vdb/cache_vdb_plugin.h"

#include "plugins/cache_vdb/vdb_exporter.h"

namespace spin {

std::string CacheVdbPlugin::labelOf(const std::string& id) const {
  return id == "vdb" ? VdbExporter().label() : std::string();
}

std::unique_ptr<CacheExporter> CacheVdbPlugin::create(const std::string& id) const {
  return id == "vdb" ? std::make_unique<VdbExporter>() : nullptr;
}

}  // namespace spin
