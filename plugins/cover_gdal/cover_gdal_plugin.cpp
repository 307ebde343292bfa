// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cover_gdal/cover_gdal_plugin.h"

#include "plugins/cover_gdal/cover_exporter.h"

namespace spin {

std::string CoverGdalPlugin::labelOf(const std::string& id) const {
  return id == "cover_tif" ? CoverExporter().label() : std::string();
}

std::unique_ptr<CacheExporter> CoverGdalPlugin::create(const std::string& id) const {
  return id == "cover_tif" ? std::make_unique<CoverExporter>() : nullptr;
}

}  // namespace spin
