// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "plugins/terrain_gdal/raster_source.h"

namespace spin {

/// What a look at all cells found, before memory is taken for them.
struct HeightStatistics {
  double lowest = 0.0;   ///< m
  double highest = 0.0;  ///< m
  std::size_t holes = 0;
  std::size_t infinite = 0;   ///< of the holes: cells holding an infinite number
  std::size_t atLowest = 0;   ///< cells at the lowest height
  std::size_t atHighest = 0;  ///< cells at the highest height
};

/// The cells of a raster row by row as metres in double, NaN where there are none: NoData value, mask or
/// alpha, NaN, infinities, and the NoData value given with the import; scale, offset and feet are applied.
class HeightRows {
 public:
  HeightRows(const RasterSource& source, const ImportOptions& options);

  /// Row as in the file, from the top.
  Status read(int fileRow, std::vector<double>& metres, const GdalMessages& messages,
              const std::string& path);
  /// Reads all rows; refuses absurd heights and rasters without any.
  Result<HeightStatistics> scan(const GdalMessages& messages, const std::string& path);
  double toMetres(double raw) const { return raw * m_scale + m_offset; }
  bool knowsNoData() const { return m_hasNoData || m_hasGiven || m_mask; }

 private:
  bool isHole(double raw, std::size_t column) const;

  const RasterSource& m_source;
  GDALRasterBand* m_mask = nullptr;
  std::vector<std::uint8_t> m_maskRow;
  bool m_single = false;  ///< cells are float32: the NoData value is compared as such
  bool m_hasNoData = false;
  double m_noData = 0.0;
  bool m_hasGiven = false;
  double m_given = 0.0;
  double m_scale = 1.0;
  double m_offset = 0.0;
  std::size_t m_infinite = 0;
};

}  // namespace spin
