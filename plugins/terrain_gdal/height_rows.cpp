// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/terrain_gdal/height_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "plugins/sdk/import_limits.h"

namespace spin {
namespace {

/// Metres per unit of the band's vertical unit; 0 if the file names none.
double metresPerUnit(const char* unit) {
  const std::string name = unit ? unit : "";
  if (name.empty()) return 0.0;
  if (EQUAL(unit, "ft") || EQUAL(unit, "foot") || EQUAL(unit, "feet")) return 0.3048;
  if (EQUAL(unit, "us-ft") || EQUAL(unit, "sft") || EQUAL(unit, "US survey foot")) return 1200.0 / 3937.0;
  return 1.0;
}

}  // namespace

HeightRows::HeightRows(const RasterSource& source, const ImportOptions& options) : m_source(source) {
  GDALRasterBand& band = *source.band;
  int has = 0;
  m_noData = band.GetNoDataValue(&has);
  m_hasNoData = has != 0;
  m_single = band.GetRasterDataType() == GDT_Float32;
  m_hasGiven = !std::isnan(options.noDataValue);
  m_given = options.noDataValue;
  if ((band.GetMaskFlags() & (GMF_PER_DATASET | GMF_ALPHA)) != 0) {
    m_mask = band.GetMaskBand();
    m_maskRow.resize(static_cast<std::size_t>(source.width));
  }
  const double unit = metresPerUnit(band.GetUnitType());
  const double scale = band.GetScale(&has);
  m_scale = (has ? scale : 1.0) * (unit > 0.0 ? unit : options.heightScale);
  const double offset = band.GetOffset(&has);
  m_offset = (has ? offset : 0.0) * (unit > 0.0 ? unit : options.heightScale);
}

bool HeightRows::isHole(double raw, std::size_t column) const {
  if (!std::isfinite(raw)) return true;
  if (m_mask && m_maskRow[column] == 0) return true;
  const auto same = [this](double a, double b) {
    return a == b || (m_single && static_cast<float>(a) == static_cast<float>(b));
  };
  return (m_hasNoData && same(raw, m_noData)) || (m_hasGiven && same(raw, m_given));
}

Status HeightRows::read(int fileRow, std::vector<double>& metres, const GdalMessages& messages,
                        const std::string& path) {
  const int width = m_source.width;
  metres.resize(static_cast<std::size_t>(width));
  CPLErr result = m_source.band->RasterIO(GF_Read, 0, fileRow, width, 1, metres.data(), width, 1, GDT_Float64,
                                          0, 0, nullptr);
  if (result == CE_None && m_mask)
    result =
        m_mask->RasterIO(GF_Read, 0, fileRow, width, 1, m_maskRow.data(), width, 1, GDT_Byte, 0, 0, nullptr);
  if (result != CE_None || messages.failed())
    return badInput("The raster could not be read", path,
                    fmt::format("row {} of {}: {}", fileRow + 1, m_source.height,
                                messages.reason("its cells could not be read")),
                    "The file may be cut off or damaged: copy or export it again");
  for (std::size_t i = 0; i < metres.size(); ++i) {
    if (std::isinf(metres[i])) ++m_infinite;
    metres[i] = isHole(metres[i], i) ? std::numeric_limits<double>::quiet_NaN() : toMetres(metres[i]);
  }
  return {};
}

Result<HeightStatistics> HeightRows::scan(const GdalMessages& messages, const std::string& path) {
  HeightStatistics found;
  found.lowest = std::numeric_limits<double>::infinity();
  found.highest = -found.lowest;
  m_infinite = 0;
  std::vector<double> row;
  for (int j = 0; j < m_source.height; ++j) {
    if (Status status = read(j, row, messages, path); !status) return status.error();
    for (const double z : row) {
      if (std::isnan(z)) {
        ++found.holes;
        continue;
      }
      if (std::abs(z) > kMaxHeight)
        return badInput("The raster could not be read", path,
                        fmt::format("row {} holds a height of {:g} m", j + 1, z),
                        "If this number marks missing data, name it as the NoData value");
      found.atLowest = z < found.lowest ? 1 : found.atLowest + (z == found.lowest);
      found.atHighest = z > found.highest ? 1 : found.atHighest + (z == found.highest);
      found.lowest = std::fmin(found.lowest, z);
      found.highest = std::fmax(found.highest, z);
    }
  }
  found.infinite = m_infinite;
  if (found.lowest > found.highest)
    return badInput("The raster could not be read", path, "no cell holds a height", "Choose another file");
  return found;
}

}  // namespace spin
