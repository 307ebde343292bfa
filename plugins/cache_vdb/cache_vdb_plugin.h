// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "plugins/sdk/exporter.h"

namespace spin {

/// Makes exporters of the air as OpenVDB volumes.
class CacheVdbPlugin final : public QObject, public ExporterFactory {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID SPIN_EXPORTER_FACTORY_IID FILE "cache_vdb.json")
  Q_INTERFACES(spin::ExporterFactory)

 public:
  std::vector<std::string> ids() const override { return {"vdb"}; }
  std::string labelOf(const std::string& id) const override;
  std::unique_ptr<CacheExporter> create(const std::string& id) const override;
};

}  // namespace spin
