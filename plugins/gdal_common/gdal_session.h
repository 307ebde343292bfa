// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/fields/raster.h"

namespace spin {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using DatasetPointer = std::unique_ptr<GDALDataset, CloseDataset>;

/// Registers the drivers once and sets what the whole process shares.
inline void prepareGdal() {
  static std::once_flag once;
  std::call_once(once, [] {
    GDALAllRegister();
    // 64 MiB: rasters are read row by row, a larger block cache only takes memory.
    GDALSetCacheMax64(std::int64_t{64} << 20);
    CPLSetConfigOption("GDAL_PAM_ENABLED", "YES");
  });
}

/// Collects what GDAL says while it lives, instead of printing it. For one thread.
class GdalMessages {
 public:
  GdalMessages() { CPLPushErrorHandlerEx(&GdalMessages::receive, this); }
  ~GdalMessages() { CPLPopErrorHandler(); }
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  /// Different warnings, at most ten.
  const std::vector<std::string>& warnings() const { return m_warnings; }
  bool failed() const { return !m_error.empty(); }
  /// The first failure, which is nearest to the cause; `otherwise` if GDAL gave no reason.
  std::string reason(const std::string& otherwise) const { return m_error.empty() ? otherwise : m_error; }

 private:
  static void CPL_STDCALL receive(CPLErr level, CPLErrorNum, const char* text) {
    auto* self = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
    if (level == CE_Warning && self->m_warnings.size() < 10 &&
        !std::count(self->m_warnings.begin(), self->m_warnings.end(), text))
      self->m_warnings.emplace_back(text);
    if (level >= CE_Failure && self->m_error.empty()) self->m_error = text;
  }
  std::vector<std::string> m_warnings;
  std::string m_error;
};

/// The coordinate system of a georeference: by its number, else by its text; nothing if neither is known.
inline std::unique_ptr<OGRSpatialReference> spatialReferenceOf(const GeoReference& geo) {
  auto srs = std::make_unique<OGRSpatialReference>();
  srs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (geo.epsg > 0 && srs->importFromEPSG(geo.epsg) == OGRERR_NONE) return srs;
  if (!geo.wkt.empty() && srs->importFromWkt(geo.wkt.c_str()) == OGRERR_NONE) return srs;
  return nullptr;
}

/// GDAL's six numbers for a raster whose rows run from the north: outer corner of the north-west cell.
inline void geoTransformOf(double originX, double originY, double cell, int height, const GeoReference& geo,
                           double (&out)[6]) {
  out[0] = geo.origin.x + originX - 0.5 * cell;
  out[1] = cell;
  out[2] = 0.0;
  out[3] = geo.origin.y + originY + (height - 0.5) * cell;
  out[4] = 0.0;
  out[5] = -cell;
}

}  // namespace spin
