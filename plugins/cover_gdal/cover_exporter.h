// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/text_mark.h"
#include "plugins/sdk/exporter.h"

namespace spin {

/// The terrain's snow cover as GeoTIFF on the elevation model's cells: band 1 depth in m, band 2 snow water
/// equivalent in kg/m2, band 3 liquid water within the snow in kg/m2, band 4 temperature of the surface (snow
/// or bare) in K; the last two hold NoData where the frame lacks them (nothing melts). Where fine grids stand
/// in for coarse cells, a cell holds their area-weighted mean, so that the raster's mass is the terrain's.
/// Cells without ground hold NoData.
class CoverExporter final : public CacheExporter {
 public:
  std::string id() const override { return "cover_tif"; }
  std::string label() const override { return SPIN_TR("Snow cover of the terrain, GeoTIFF"); }
  bool applies(const Frame& frame) const override;
  Status begin(const ExportContext& context) override;
  Status writeFrame(const Frame& frame) override;
  Status finish() override { return {}; }
  std::vector<std::string> files() const override { return m_files; }
  std::vector<ExportedAttribute> attributes() const override {
    return {{"snow_depth", "m", 1},
            {"snow_water_equivalent", "kg/m2", 1},
            {"snow_liquid_water", "kg/m2", 1},
            {"surface_temperature", "K", 1}};
  }

 private:
  ExportContext m_context;
  std::vector<std::string> m_files;
};

}  // namespace spin
