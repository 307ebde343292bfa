// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cache_ply/cache_ply_plugin.h"

#include "plugins/cache_ply/ply_exporter.h"

namespace spin {

std::string CachePlyPlugin::labelOf(const std::string& id) const {
  return id == "ply" ? PlyExporter().label() : std::string();
}

std::unique_ptr<CacheExporter> CachePlyPlugin::create(const std::string& id) const {
  return id == "ply" ? std::make_unique<PlyExporter>() : nullptr;
}

}  // namespace spin
