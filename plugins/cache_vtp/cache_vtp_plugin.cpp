// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cache_vtp/cache_vtp_plugin.h"

#include "plugins/cache_vtp/vtp_exporter.h"

namespace spin {

std::string CacheVtpPlugin::labelOf(const std::string& id) const {
  return id == "vtp" ? VtpExporter().label() : std::string();
}

std::unique_ptr<CacheExporter> CacheVtpPlugin::create(const std::string& id) const {
  return id == "vtp" ? std::make_unique<VtpExporter>() : nullptr;
}

}  // namespace spin
