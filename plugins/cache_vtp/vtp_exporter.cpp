// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cache_vtp/vtp_exporter.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "plugins/sdk/output_file.h"
#include "plugins/sdk/particle_parts.h"

namespace spin {
namespace {

/// Names come from our own processes, but a stray sign must not break the XML.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// The XML with the arrays' places in it, and the arrays behind it: each a 64-bit size and the raw bytes.
class PolyDataWriter {
 public:
  PolyDataWriter(const FrameTime& time, std::size_t points) {
    m_xml =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n";
    const double film[] = {time.film};
    array("TimeValue", "Float64", 0, film, 1, "NumberOfTuples=\"1\"");
    m_xml += fmt::format(
        "</FieldData>\n<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
        points);
  }

  void open(const char* element) { m_xml += fmt::format("<{}>\n", element); }
  void close(const char* element) { m_xml += fmt::format("</{}>\n", element); }

  template <class T>
  void array(const std::string& name, const char* type, int components, const T* values, std::size_t count,
             const std::string& more = {}) {
    m_xml += fmt::format("<DataArray type=\"{}\" Name=\"{}\"", type, escaped(name));
    if (components > 0) m_xml += fmt::format(" NumberOfComponents=\"{}\"", components);
    if (!more.empty()) m_xml += " " + more;
    m_xml += fmt::format(" format=\"appended\" offset=\"{}\"/>\n", m_data.size());
    const std::uint64_t bytes = count * sizeof(T);
    const std::size_t at = m_data.size();
    m_data.resize(at + sizeof bytes + bytes);
    std::memcpy(m_data.data() + at, &bytes, sizeof bytes);
    if (bytes > 0) std::memcpy(m_data.data() + at + sizeof bytes, values, bytes);
  }

  std::vector<char> finish() {
    m_xml += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
    std::vector<char> all(m_xml.begin(), m_xml.end());
    all.insert(all.end(), m_data.begin(), m_data.end());
    const std::string end = "\n</AppendedData>\n</VTKFile>\n";
    all.insert(all.end(), end.begin(), end.end());
    return all;
  }

 private:
  std::string m_xml;
  std::vector<char> m_data;
};

std::vector<char> polyData(const Frame& frame, const ParticleSet& particles) {
  const std::size_t n = particles.size();
  PolyDataWriter out(frame.info.time, n);
  out.open("PointData");
  std::vector<std::int64_t> ids(n);
  for (std::size_t i = 0; i < n; ++i)
    ids[i] = static_cast<std::int64_t>(particles.ids.empty() ? i : particles.ids[i]);
  out.array("id", "Int64", 1, ids.data(), n);
  for (const ParticleAttribute& a : particles.attributes)
    out.array(a.name, "Float32", a.components, a.values.data(), a.values.size());
  out.close("PointData");
  out.open("Points");
  static_assert(sizeof(Vec3f) == 12);
  const float* first = n > 0 ? &particles.positions[0].x : nullptr;
  out.array("Points", "Float32", 3, first, 3 * n);
  out.close("Points");
  std::vector<std::int64_t> connectivity(n), offsets(n);
  for (std::size_t i = 0; i < n; ++i) {
    connectivity[i] = static_cast<std::int64_t>(i);
    offsets[i] = static_cast<std::int64_t>(i) + 1;
  }
  out.open("Verts");
  out.array("connectivity", "Int64", 0, connectivity.data(), n);
  out.array("offsets", "Int64", 0, offsets.data(), n);
  out.close("Verts");
  return out.finish();
}

}  // namespace

bool VtpExporter::applies(const Frame& frame) const {
  return hasParticles(frame);
}

Status VtpExporter::begin(const ExportContext& context) {
  m_context = context;
  m_series.clear();
  m_files.clear();
  m_attributes = {{"position", "m", 3}, {"id", "", 1}};
  return {};
}

Status VtpExporter::writeFrame(const Frame& frame) {
  for (const auto& [name, part] : frame.parts)
    if (const auto* particles = dynamic_cast<const ParticlePart*>(part.get()))
      if (Status status = writeSet(frame, name, particles->particles); !status) return status;
  return {};
}

Status VtpExporter::writeSet(const Frame& frame, const std::string& partName, const ParticleSet& particles) {
  const std::string base = particleBaseName(m_context, partName);
  const std::string name = frameFileName(base, frame.info.time.frame, "vtp");
  if (Status status = checkParticles(particles, name); !status) return status;
  const std::vector<char> bytes = polyData(frame, particles);
  OutputFile file(m_context.directory + "/" + name);
  if (Status status = file.write(bytes); !status) return status;
  if (Status status = file.commit(bytes.size()); !status) return status;
  m_files.push_back(name);
  m_series[base].push_back({frame.info.time.film, name});
  for (const ParticleAttribute& a : particles.attributes) {
    const auto same = [&](const ExportedAttribute& e) { return e.name == a.name; };
    if (std::none_of(m_attributes.begin(), m_attributes.end(), same))
      m_attributes.push_back({a.name, a.unit, a.components});
  }
  return {};
}

Status VtpExporter::finish() {
  for (const auto& [base, entries] : m_series) {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n";
    for (const Entry& entry : entries)
      text += fmt::format("<DataSet timestep=\"{:.9g}\" group=\"\" part=\"0\" file=\"{}\"/>\n", entry.time,
                          escaped(entry.file));
    text += "</Collection>\n</VTKFile>\n";
    OutputFile file(m_context.directory + "/" + base + ".pvd");
    if (Status status = file.write({text.begin(), text.end()}); !status) return status;
    if (Status status = file.commit(text.size()); !status) return status;
    m_files.push_back(base + ".pvd");
  }
  m_series.clear();
  return {};
}

}  // namespace spin
