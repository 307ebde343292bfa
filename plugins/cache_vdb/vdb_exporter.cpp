// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cache_vdb/vdb_exporter.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>

#include "plugins/cache_vdb/vdb_grids.h"
#include "plugins/sdk/output_file.h"
#include "plugins/sdk/particle_parts.h"

namespace spin {
namespace {

/// openvdb::io::File opens its stream itself and never asks whether the last bytes arrived.
class CheckedArchive final : public openvdb::io::Archive {
 public:
  void writeTo(std::ostream& out, const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& about) const {
    write(out, grids, true, about);
  }
};

openvdb::MetaMap describe(const Frame& frame, const AirPart& part, const SceneSnapshot* scene) {
  openvdb::MetaMap about;
  const auto text = [&](const char* key, const std::string& value) {
    about.insertMeta(key, openvdb::StringMetadata(value));
  };
  const auto number = [&](const char* key, double value) {
    about.insertMeta(key, openvdb::DoubleMetadata(value));
  };
  text("creator", "Spindrift " SPIN_VERSION);
  text("up_axis", "z");
  text("length_unit", "m");
  about.insertMeta("frame", openvdb::Int32Metadata(frame.info.time.frame));
  number("time_film_s", frame.info.time.film);
  number("time_weather_s", frame.info.time.weather);
  number("ambient_temperature_K", part.temperature);
  number("mist_diameter_m", part.dropDiameter);
  number("snow_diameter_m", part.snowDiameter);
  if (scene && scene->terrain) {
    const GeoReference& geo = scene->terrain->geo;
    about.insertMeta("local_origin", openvdb::Vec3DMetadata({geo.origin.x, geo.origin.y, geo.origin.z}));
    about.insertMeta("epsg", openvdb::Int32Metadata(geo.epsg));
  }
  return about;
}

/// What the library throws becomes an error; the size of the file otherwise.
Result<std::size_t> writeArchive(const std::string& temporary, const std::string& path,
                                 const openvdb::GridCPtrVec& grids, const openvdb::MetaMap& about) {
  errno = 0;
  try {
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    if (!out) return cannotWrite(path, std::strerror(errno));
    out.exceptions(std::ios::badbit | std::ios::failbit);
    CheckedArchive().writeTo(out, grids, about);
    const auto size = static_cast<std::size_t>(out.tellp());
    out.close();
    return size;
  } catch (const std::ios_base::failure& problem) {
    return cannotWrite(path, errno != 0 ? std::strerror(errno) : problem.what());
  } catch (const std::exception& problem) {
    return cannotWrite(path, problem.what());
  }
}

}  // namespace

bool VdbExporter::applies(const Frame& frame) const {
  return std::any_of(frame.parts.begin(), frame.parts.end(), [](const auto& entry) {
    return dynamic_cast<const AirPart*>(entry.second.get()) != nullptr;
  });
}

Status VdbExporter::begin(const ExportContext& context) {
  // Without its registry the library cannot even write.
  openvdb::initialize();
  m_context = context;
  m_files.clear();
  m_attributes.clear();
  return {};
}

Status VdbExporter::writeFrame(const Frame& frame) {
  for (const auto& [name, part] : frame.parts)
    if (const auto* air = dynamic_cast<const AirPart*>(part.get()))
      if (Status status = writePart(frame, name, *air); !status) return status;
  return {};
}

Status VdbExporter::writePart(const Frame& frame, const std::string& partName, const AirPart& part) {
  const std::string base = partName == "air" ? m_context.baseName : m_context.baseName + "_" + partName;
  const std::string name = frameFileName(base, frame.info.time.frame, "vdb");
  if (!fitsVdb(part))
    return Error{ErrorKind::Failed, "The air could not be written", name,
                 "cells lie farther from the origin than OpenVDB counts",
                 "Choose larger cells or a scene nearer to its origin"};
  OutputFile file(m_context.directory + "/" + name);
  try {
    const std::vector<VdbGrid> made = vdbGrids(part);
    openvdb::GridCPtrVec grids;
    for (const VdbGrid& grid : made) grids.push_back(grid.grid);
    const Result<std::size_t> size = writeArchive(file.temporaryPath(), m_context.directory + "/" + name,
                                                  grids, describe(frame, part, m_context.scene.get()));
    if (!size) return size.error();
    if (Status status = file.commit(*size); !status) return status;
    for (const VdbGrid& grid : made) {
      const auto same = [&](const ExportedAttribute& e) { return e.name == grid.attribute.name; };
      if (std::none_of(m_attributes.begin(), m_attributes.end(), same))
        m_attributes.push_back(grid.attribute);
    }
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResources, "The air could not be written", name, "memory ran out",
                 "Close other programs or choose larger cells"};
  } catch (const std::exception& problem) {
    return cannotWrite(m_context.directory + "/" + name, problem.what());
  }
  m_files.push_back(name);
  return {};
}

}  // namespace spin
