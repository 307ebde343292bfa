// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/property/text_mark.h"
#include "plugins/sdk/file_name.h"
#include "plugins/sdk/import_limits.h"
#include "plugins/terrain_gdal/ascii_check.h"
#include "plugins/terrain_gdal/height_rows.h"
#include "plugins/terrain_gdal/terrain_gdal_plugin.h"

namespace spin {
namespace {

constexpr const char* kWhat = "The raster could not be read";

Status checkOptions(const ImportOptions& options, const std::string& path) {
  if (!std::isfinite(options.heightScale) || options.heightScale <= 0.0)
    return Error{ErrorKind::Usage, kWhat, path, fmt::format("a height scale of {}", options.heightScale),
                 "Give a positive number of metres per unit"};
  return {};
}

/// A PNG for heights needs 16 bits: 256 steps make terraces.
Status checkNumberType(const RasterSource& source, const std::string& path) {
  if (lowerCaseExtension(path) == "png" && source.band->GetRasterDataType() != GDT_UInt16)
    return badInput(kWhat, path, "it has 8 bits per cell", "Export the heights as a 16-bit grey PNG");
  return {};
}

std::string printable(std::string text) {
  std::string clean;
  for (const char c : text)
    if (static_cast<unsigned char>(c) >= 32 && clean.size() < 300) clean += c;
  return clean;
}

std::string creditOf(const RasterSource& source, const std::string& path) {
  if (const char* tag = source.dataset->GetMetadataItem("TIFFTAG_COPYRIGHT"); tag && *tag)
    return printable(tag);
  std::ifstream beside(std::filesystem::path(path).parent_path() / "CREDITS.txt");
  std::string line;
  // A bounded read, whatever bears that name.
  char buffer[512] = {};
  if (beside.read(buffer, sizeof buffer - 1) || beside.gcount() > 0) line = buffer;
  return printable(line.substr(0, line.find_first_of("\r\n")));
}

Result<Raster<float>> readHeights(HeightRows& rows, const RasterSource& source, const RasterPlacement& place,
                                  double lowest, const GdalMessages& messages, const std::string& path) {
  Raster<float> heights(source.width, source.height, 0.0, 0.0, place.cell);
  std::vector<double> row;
  for (int j = 0; j < source.height; ++j) {
    if (Status status = rows.read(j, row, messages, path); !status) return status.error();
    float* to = &heights.at(0, place.rowsFromSouth ? j : source.height - 1 - j);
    for (std::size_t i = 0; i < row.size(); ++i) to[i] = static_cast<float>(row[i] - lowest);
  }
  return heights;
}

std::vector<SummaryLine> summaryLines(const RasterSource& source, const RasterPlacement& place,
                                      const RasterCrs& crs, const HeightStatistics& found) {
  const double cells = static_cast<double>(source.width) * source.height;
  const GDALDriver* driver = source.dataset->GetDriver();
  std::vector<SummaryLine> lines{
      {SPIN_TR("Format"), const_cast<GDALDriver*>(driver)->GetDescription()},
      {SPIN_TR("Size"), fmt::format("{} x {} cells", source.width, source.height)},
      {SPIN_TR("Cell size"), fmt::format("{:.10g} m", place.cell)},
      {SPIN_TR("West, south"), fmt::format("{:.3f}, {:.3f} m", place.west, place.south)},
      {SPIN_TR("East, north"), fmt::format("{:.3f}, {:.3f} m", place.west + place.cell * source.width,
                                           place.south + place.cell * source.height)},
      {SPIN_TR("Heights"), fmt::format("{:.3f} to {:.3f} m", found.lowest, found.highest)},
      {SPIN_TR("No data"),
       fmt::format("{:.3f} % of the cells", 100.0 * static_cast<double>(found.holes) / cells)}};
  std::string system = crs.name.empty() ? "unknown" : crs.name;
  if (crs.epsg > 0) system = fmt::format("EPSG:{} ({})", crs.epsg, system);
  lines.push_back({SPIN_TR("Coordinate system"), system});
  return lines;
}

std::vector<std::string> findings(const HeightRows& rows, const RasterSource& source,
                                  const RasterPlacement& place, const RasterCrs& crs,
                                  const HeightStatistics& found) {
  std::vector<std::string> warnings;
  if (!place.georeferenced)
    warnings.push_back(
        fmt::format("The file does not say how large its cells are: {:g} m assumed", place.cell));
  if (crs.epsg == 0)
    warnings.push_back(crs.wkt.empty()
                           ? "The file names no coordinate system: metres assumed; give its EPSG number"
                           : "The coordinate system has no EPSG number");
  if (found.infinite > 0)
    warnings.push_back(fmt::format("{} cells are infinite: taken as holes", found.infinite));
  // 16-bit pictures cannot name a NoData value; by custom it is the first or the last number.
  if (!rows.knowsNoData() && source.band->GetRasterDataType() == GDT_UInt16) {
    const auto suspect = [&](int raw, double height, std::size_t cells) {
      if (height == rows.toMetres(raw) && cells > 1)
        warnings.push_back(fmt::format(
            "{} cells hold {}: if that marks missing data, name it as the NoData value", cells, raw));
    };
    suspect(0, found.lowest, found.atLowest);
    suspect(65535, found.highest, found.atHighest);
  }
  if (found.lowest < -1000.0)
    warnings.push_back(
        fmt::format("{} cells lie at {:g} m: if that number marks missing data, name it as the NoData value",
                    found.atLowest, found.lowest));
  return warnings;
}

}  // namespace

Result<TerrainImport> TerrainGdalPlugin::read(const std::string& path, const ImportOptions& options) {
  prepareGdal();
  const GdalMessages messages;
  if (Status status = checkOptions(options, path); !status) return status.error();
  const Result<RasterSource> source = openRaster(path, messages);
  if (!source) return source.error();
  if (Status status = checkNumberType(*source, path); !status) return status.error();
  const Result<RasterCrs> crs = crsOf(*source, options, path);
  if (!crs) return crs.error();
  const Result<RasterPlacement> place = placementOf(*source, options, path);
  if (!place) return place.error();
  if (Status status = checkRasterMemory(*source, path); !status) return status.error();
  if (lowerCaseExtension(path) == "asc")
    if (Status status = checkAsciiGrid(path); !status) return status.error();
  // What opening complained of without failing is a warning; from here on any failure counts.
  const GdalMessages reading;
  HeightRows rows(*source, options);
  const Result<HeightStatistics> found = rows.scan(reading, path);
  if (!found) return found.error();
  Result<Raster<float>> heights = readHeights(rows, *source, *place, found->lowest, reading, path);
  if (!heights) return heights.error();

  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = std::move(*heights);
  terrain->geo.origin = {place->west + 0.5 * place->cell, place->south + 0.5 * place->cell, found->lowest};
  terrain->geo.epsg = crs->epsg;
  terrain->geo.wkt = crs->wkt;
  terrain->credit = creditOf(*source, path);
  TerrainImport import{terrain, {summaryLines(*source, *place, *crs, *found), messages.warnings()}};
  for (const std::vector<std::string>& more :
       {reading.warnings(), findings(rows, *source, *place, *crs, *found)})
    import.summary.warnings.insert(import.summary.warnings.end(), more.begin(), more.end());
  if (!terrain->credit.empty()) import.summary.lines.push_back({SPIN_TR("Credit"), terrain->credit});
  return import;
}

}  // namespace spin
