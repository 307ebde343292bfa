// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cache_ply/ply_exporter.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "plugins/sdk/output_file.h"
#include "plugins/sdk/particle_parts.h"

namespace spin {
namespace {

constexpr const char* kAxes[] = {"_x", "_y", "_z"};

std::string componentName(const ParticleAttribute& attribute, int component) {
  const std::string name = "scalar_" + attribute.name;
  if (attribute.components == 1) return name;
  return component < 3 ? name + kAxes[component] : fmt::format("{}_{}", name, component);
}

/// PLY knows no 64-bit integers: the upper half gets a property of its own where it is needed.
bool needsHighIds(const ParticleSet& particles) {
  return std::any_of(particles.ids.begin(), particles.ids.end(),
                     [](std::uint64_t id) { return id >> 32 != 0; });
}

std::string header(const Frame& frame, const ParticleSet& particles, const SceneSnapshot* scene,
                   bool highIds) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  auto out = std::back_inserter(text);
  fmt::format_to(out, "comment {}, local metres, z up\n", particles.name);
  fmt::format_to(out, "comment time_film_s {:.9g} time_weather_s {:.9g}\n", frame.info.time.film,
                 frame.info.time.weather);
  fmt::format_to(out, "comment weight {:.9g}\n", particles.weight);
  if (scene && scene->terrain) {
    const GeoReference& geo = scene->terrain->geo;
    fmt::format_to(out, "comment local_origin {:.6f} {:.6f} {:.6f} epsg {}\n", geo.origin.x, geo.origin.y,
                   geo.origin.z, geo.epsg);
  }
  for (const ParticleAttribute& a : particles.attributes)
    if (!a.unit.empty()) fmt::format_to(out, "comment unit {} {}\n", a.name, a.unit);
  fmt::format_to(
      out, "element vertex {}\nproperty float x\nproperty float y\nproperty float z\nproperty uint id\n",
      particles.size());
  if (highIds) text += "property uint id_high\n";
  for (const ParticleAttribute& a : particles.attributes)
    for (int c = 0; c < a.components; ++c) fmt::format_to(out, "property float {}\n", componentName(a, c));
  text += "end_header\n";
  return text;
}

void putBytes(std::vector<char>& out, const void* data, std::size_t size) {
  const std::size_t at = out.size();
  out.resize(at + size);
  std::memcpy(out.data() + at, data, size);
}

}  // namespace

bool PlyExporter::applies(const Frame& frame) const {
  return hasParticles(frame);
}

Status PlyExporter::begin(const ExportContext& context) {
  m_context = context;
  m_files.clear();
  m_attributes = {{"position", "m", 3}, {"id", "", 1}};
  return {};
}

Status PlyExporter::writeFrame(const Frame& frame) {
  for (const auto& [name, part] : frame.parts)
    if (const auto* particles = dynamic_cast<const ParticlePart*>(part.get()))
      if (Status status = writeSet(frame, name, particles->particles); !status) return status;
  return {};
}

Status PlyExporter::writeSet(const Frame& frame, const std::string& partName, const ParticleSet& particles) {
  const std::string name = frameFileName(particleBaseName(m_context, partName), frame.info.time.frame, "ply");
  if (Status status = checkParticles(particles, name); !status) return status;
  const bool highIds = needsHighIds(particles);
  const std::string head = header(frame, particles, m_context.scene.get(), highIds);
  std::vector<char> bytes(head.begin(), head.end());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    putBytes(bytes, &particles.positions[i], sizeof(Vec3f));
    const std::uint64_t id = particles.ids.empty() ? i : particles.ids[i];
    const std::uint32_t halves[] = {static_cast<std::uint32_t>(id), static_cast<std::uint32_t>(id >> 32)};
    putBytes(bytes, halves, highIds ? 8 : 4);
    for (const ParticleAttribute& a : particles.attributes) {
      const auto n = static_cast<std::size_t>(a.components);
      putBytes(bytes, &a.values[i * n], n * sizeof(float));
    }
  }
  OutputFile file(m_context.directory + "/" + name);
  if (Status status = file.write(bytes); !status) return status;
  if (Status status = file.commit(bytes.size()); !status) return status;
  m_files.push_back(name);
  for (const ParticleAttribute& a : particles.attributes) {
    const auto same = [&](const ExportedAttribute& e) { return e.name == a.name; };
    if (std::none_of(m_attributes.begin(), m_attributes.end(), same))
      m_attributes.push_back({a.name, a.unit, a.components});
  }
  return {};
}

}  // namespace spin
