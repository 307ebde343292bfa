// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QObject>

#include "plugins/sdk/exporter.h"

/// Defined nowhere: loading this plugin fails.
extern int spinSymbolThatNobodyDefines;

namespace spin {

class BrokenPlugin final : public QObject, public ExporterFactory {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID SPIN_EXPORTER_FACTORY_IID)
  Q_INTERFACES(spin::ExporterFactory)

 public:
  std::vector<std::string> ids() const override {
    return std::vector<std::string>(static_cast<std::size_t>(spinSymbolThatNobodyDefines));
  }
  std::string labelOf(const std::string&) const override { return {}; }
  std::unique_ptr<CacheExporter> create(const std::string&) const override { return nullptr; }
};

}  // namespace spin

#include "broken_plugin.moc"
