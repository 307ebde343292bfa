// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/host/plugin_host.h"

#include <QObject>
#include <algorithm>
#include <mutex>
#include <type_traits>

#include "plugins/host/plugin_catalogue.h"
#include "plugins/sdk/importer.h"

namespace spin {

struct PluginHost::State {
  PluginCatalogue catalogue;
  std::vector<std::string> warnings;
  std::vector<ImageWriter*> writers;
  std::vector<ExporterFactory*> factories;
  std::vector<LayerFilter*> filters;
  std::once_flag loaded;

  /// Writers, exporters and filters bring large libraries, so their code is loaded when first asked for.
  void load() {
    std::call_once(loaded, [this] {
      warnings = catalogue.warnings;
      for (const PluginEntry& entry : catalogue.entries) loadEntry(entry);
    });
  }

  void loadEntry(const PluginEntry& entry) {
    if (entry.interfaceId == SPIN_TERRAIN_IMPORTER_IID || entry.interfaceId == SPIN_MODEL_IMPORTER_IID)
      return;
    const std::string& kind = entry.interfaceId;
    if (kind != SPIN_IMAGE_WRITER_IID && kind != SPIN_EXPORTER_FACTORY_IID && kind != SPIN_LAYER_FILTER_IID) {
      warnings.push_back("The plugin " + entry.path +
                         " is left out: this program does not know its interface " + kind);
      return;
    }
    const Result<QObject*> object = loadPlugin(entry);
    if (!object) {
      warnings.push_back(object.error().text());
      return;
    }
    const auto keep = [&](const char* interfaceId, auto& list) {
      using Interface = std::remove_pointer_t<typename std::decay_t<decltype(list)>::value_type>;
      auto* found = kind == interfaceId ? qobject_cast<Interface*>(*object) : nullptr;
      if (found) list.push_back(found);
      return found != nullptr;
    };
    const bool kept = keep(SPIN_IMAGE_WRITER_IID, writers) || keep(SPIN_EXPORTER_FACTORY_IID, factories) ||
                      keep(SPIN_LAYER_FILTER_IID, filters);
    if (!kept)
      warnings.push_back("The plugin " + entry.path + " is left out: it lacks the interface it names");
  }

  const ExporterFactory* factoryOf(const std::string& id) {
    load();
    for (const ExporterFactory* factory : factories)
      for (const std::string& known : factory->ids())
        if (known == id) return factory;
    return nullptr;
  }

  std::vector<std::string> extensionsOf(const char* interfaceId) const {
    std::vector<std::string> all;
    for (const PluginEntry& entry : catalogue.entries)
      if (entry.interfaceId == interfaceId)
        all.insert(all.end(), entry.extensions.begin(), entry.extensions.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }
};

PluginHost::PluginHost() : m_state(std::make_unique<State>()) {
  m_state->catalogue = readPluginCatalogue(pluginFolders());
}
PluginHost::~PluginHost() = default;

std::vector<ImageFormat> PluginHost::imageFormats() const {
  m_state->load();
  std::vector<ImageFormat> all;
  for (const ImageWriter* writer : m_state->writers)
    for (const ImageFormat& format : writer->formats()) all.push_back(format);
  return all;
}

ImageWriter* PluginHost::imageWriter(const std::string& formatId) const {
  m_state->load();
  for (ImageWriter* writer : m_state->writers)
    for (const ImageFormat& format : writer->formats())
      if (format.id == formatId) return writer;
  return nullptr;
}

std::vector<std::string> PluginHost::exporterIds() const {
  m_state->load();
  std::vector<std::string> all;
  for (const ExporterFactory* factory : m_state->factories)
    for (const std::string& id : factory->ids()) all.push_back(id);
  std::sort(all.begin(), all.end());
  return all;
}

std::string PluginHost::exporterLabel(const std::string& id) const {
  const ExporterFactory* factory = m_state->factoryOf(id);
  return factory ? factory->labelOf(id) : std::string();
}

std::unique_ptr<CacheExporter> PluginHost::makeExporter(const std::string& id) const {
  const ExporterFactory* factory = m_state->factoryOf(id);
  return factory ? factory->create(id) : nullptr;
}

std::vector<LayerFilterInfo> PluginHost::layerFilters() const {
  m_state->load();
  std::vector<LayerFilterInfo> all;
  for (const LayerFilter* filter : m_state->filters)
    for (const LayerFilterInfo& info : filter->filters()) all.push_back(info);
  return all;
}

const LayerFilter* PluginHost::layerFilter(const std::string& filterId) const {
  m_state->load();
  for (const LayerFilter* filter : m_state->filters)
    for (const LayerFilterInfo& info : filter->filters())
      if (info.id == filterId) return filter;
  return nullptr;
}

std::vector<std::string> PluginHost::terrainExtensions() const {
  return m_state->extensionsOf(SPIN_TERRAIN_IMPORTER_IID);
}

std::vector<std::string> PluginHost::modelExtensions() const {
  return m_state->extensionsOf(SPIN_MODEL_IMPORTER_IID);
}

const std::vector<std::string>& PluginHost::warnings() const {
  m_state->load();
  return m_state->warnings;
}

}  // namespace spin
