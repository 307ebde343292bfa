// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/terrain_gdal/height_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "plugins/sdk/import_limits.h"

namespace spin {
namespace {

/// Metres per unit of the band's vertical unit; 0 if the file names none or one that is no length.
double metresPerUnit(const char* unit) {
  const std::string name = unit ? unit : "";
  struct Named {
    const char* name;
    double metres;
  };
  constexpr double kSurveyFoot = 1200.0 / 3937.0;
  static constexpr Named kUnits[] = {{"m", 1.0},
                                     {"metre", 1.0},
                                     {"meter", 1.0},
                                     {"metres", 1.0},
                                     {"meters", 1.0},
                                     {"dm", 0.1},
                                     {"decimetre", 0.1},
                                     {"decimeter", 0.1},
                                     {"cm", 0.01},
                                     {"centimetre", 0.01},
                                     {"centimeter", 0.01},
                                     {"mm", 0.001},
                                     {"millimetre", 0.001},
                                     {"millimeter", 0.001},
                                     {"km", 1000.0},
                                     {"kilometre", 1000.0},
                                     {"kilometer", 1000.0},
                                     {"ft", 0.3048},
                                     {"foot", 0.3048},
                                     {"feet", 0.3048},
                                     {"us-ft", kSurveyFoot},
                                     {"sft", kSurveyFoot},
                                     {"US survey foot", kSurveyFoot}};
  for (const Named& known : kUnits)
    if (EQUAL(name.c_str(), known.name)) return known.metres;
  return 0.0;
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
