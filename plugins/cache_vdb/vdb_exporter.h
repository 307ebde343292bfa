// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/text_mark.h"
#include "core/sim/air_part.h"
#include "plugins/sdk/exporter.h"

namespace spin {

/// What hangs in the air as OpenVDB volumes (see vdb_grids.h), one file per frame. The file's metadata:
/// creator, frame, time_film_s, time_weather_s, up_axis "z", length_unit "m", ambient_temperature_K (the grid
/// `temperature` is K over it), mist_diameter_m and snow_diameter_m of what scatters light; where the scene
/// has a terrain local_origin and epsg. A frame whose air holds nothing gives a file with empty grids.
class VdbExporter final : public CacheExporter {
 public:
  std::string id() const override { return "vdb"; }
  std::string label() const override { return SPIN_TR("Mist and powder, OpenVDB"); }
  bool applies(const Frame& frame) const override;
  Status begin(const ExportContext& context) override;
  Status writeFrame(const Frame& frame) override;
  Status finish() override { return {}; }
  std::vector<std::string> files() const override { return m_files; }
  std::vector<ExportedAttribute> attributes() const override { return m_attributes; }

 private:
  Status writePart(const Frame& frame, const std::string& name, const AirPart& part);

  ExportContext m_context;
  std::vector<std::string> m_files;
  std::vector<ExportedAttribute> m_attributes;
};

}  // namespace spin
