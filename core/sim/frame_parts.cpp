// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "core/sim/frame.h"
#include "core/sim/shared_registry.h"

namespace spin {
namespace {

std::string describe(const std::string& what, std::size_t index, double value) {
  return fmt::format("{} {} is {}", what, index, value);
}

template <class Range>
std::size_t firstBad(const Range& values) {
  const auto bad = std::find_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); });
  return static_cast<std::size_t>(bad - values.begin());
}

/// What follows in shared data.
enum class SharedKind : std::uint8_t { Layout = 0, Exposure = 1 };

void putRaster(ByteWriter& out, const Raster<float>& raster) {
  out.put(raster.width);
  out.put(raster.height);
  out.put(raster.originX);
  out.put(raster.originY);
  out.put(raster.cellSize);
  out.putArray(raster.values);
}

bool getRaster(ByteReader& in, Raster<float>& raster) {
  raster.width = in.get<int>();
  raster.height = in.get<int>();
  raster.originX = in.get<double>();
  raster.originY = in.get<double>();
  raster.cellSize = in.get<double>();
  raster.values = in.getArray<float>();
  if (!in.ok() || raster.width < 0 || raster.height < 0) return false;
  return raster.values.size() ==
         static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
}

}  // namespace

void putShared(const CoverLayout& layout, ByteWriter& out) {
  out.put(SharedKind::Layout);
  out.put(static_cast<std::uint64_t>(layout.grids.size()));
  for (const CoverGrid& grid : layout.grids) {
    out.put(grid.id);
    out.put(grid.node);
    putRaster(out, grid.base);
    putRaster(out, grid.area);
  }
}

void putShared(const CoverExposure& exposure, ByteWriter& out) {
  out.put(SharedKind::Exposure);
  out.put(static_cast<std::uint64_t>(exposure.grids.size()));
  for (const std::vector<float>& grid : exposure.grids) out.putArray(grid);
}

namespace {

std::shared_ptr<const void> loadLayout(ByteReader& in) {
  auto layout = std::make_shared<CoverLayout>();
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t g = 0; g < count && in.ok(); ++g) {
    CoverGrid grid;
    grid.id = in.getText();
    grid.node = in.getText();
    if (!getRaster(in, grid.base) || !getRaster(in, grid.area) || !grid.base.hasShapeOf(grid.area))
      return nullptr;
    layout->grids.push_back(std::move(grid));
  }
  if (!in.ok() || !in.atEnd()) return nullptr;
  return internLayout(std::move(layout));
}

std::shared_ptr<const void> loadExposure(ByteReader& in) {
  auto exposure = std::make_shared<CoverExposure>();
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t g = 0; g < count && in.ok(); ++g) exposure->grids.push_back(in.getArray<float>());
  if (!in.ok() || !in.atEnd()) return nullptr;
  return internExposure(std::move(exposure));
}

bool fits(const CoverExposure& exposure, const CoverLayout& layout) {
  bool same = exposure.grids.size() == layout.grids.size();
  for (std::size_t g = 0; same && g < layout.grids.size(); ++g)
    same = exposure.grids[g].size() == layout.grids[g].base.size();
  return same;
}

}  // namespace

std::shared_ptr<const CoverLayout> internLayout(std::shared_ptr<const CoverLayout> layout) {
  return registryOf<CoverLayout>().intern(std::move(layout));
}

std::shared_ptr<const CoverExposure> internExposure(std::shared_ptr<const CoverExposure> exposure) {
  return registryOf<CoverExposure>().intern(std::move(exposure));
}

std::shared_ptr<const void> loadCoverShared(ByteReader& in) {
  switch (in.get<SharedKind>()) {
    case SharedKind::Layout:
      return loadLayout(in);
    case SharedKind::Exposure:
      return loadExposure(in);
  }
  return nullptr;
}

std::size_t ParticlePart::memoryBytes() const {
  std::size_t bytes =
      particles.ids.size() * sizeof(std::uint64_t) + particles.positions.size() * sizeof(Vec3f);
  for (const ParticleAttribute& attribute : particles.attributes)
    bytes += attribute.values.size() * sizeof(float);
  return bytes;
}

void ParticlePart::save(ByteWriter& out) const {
  out.put(particles.name);
  out.put(particles.wrapBox);
  out.put(particles.weight);
  out.putArray(particles.ids);
  out.putArray(particles.positions);
  out.put(static_cast<std::uint64_t>(particles.attributes.size()));
  for (const ParticleAttribute& attribute : particles.attributes) {
    out.put(attribute.name);
    out.put(attribute.unit);
    out.put(attribute.components);
    out.putArray(attribute.values);
  }
}

std::shared_ptr<FramePart> ParticlePart::load(ByteReader& in) {
  auto part = std::make_shared<ParticlePart>();
  ParticleSet& set = part->particles;
  set.name = in.getText();
  set.wrapBox = in.get<double>();
  set.weight = in.get<double>();
  set.ids = in.getArray<std::uint64_t>();
  set.positions = in.getArray<Vec3f>();
  if (!set.ids.empty() && set.ids.size() != set.size()) return nullptr;
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t a = 0; a < count && in.ok(); ++a) {
    ParticleAttribute attribute;
    attribute.name = in.getText();
    attribute.unit = in.getText();
    attribute.components = in.get<int>();
    attribute.values = in.getArray<float>();
    if (attribute.components < 1 || attribute.components > 4) return nullptr;
    if (attribute.values.size() != set.size() * static_cast<std::size_t>(attribute.components))
      return nullptr;
    set.attributes.push_back(std::move(attribute));
  }
  return in.ok() ? part : nullptr;
}

std::string ParticlePart::firstNonFinite() const {
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (!isFinite(particles.positions[i]))
      return fmt::format("position of particle {} is ({}, {}, {})", i, particles.positions[i].x,
                         particles.positions[i].y, particles.positions[i].z);
  for (const ParticleAttribute& attribute : particles.attributes) {
    const std::size_t bad = firstBad(attribute.values);
    if (bad < attribute.values.size())
      return describe(attribute.name + " of particle", bad / static_cast<std::size_t>(attribute.components),
                      static_cast<double>(attribute.values[bad]));
  }
  return {};
}

std::size_t CoverPart::memoryBytes() const {
  std::size_t bytes = 0;
  for (const Values& grid : values)
    bytes +=
        (grid.swe.size() + grid.depth.size() + grid.liquid.size() + grid.temperature.size()) * sizeof(float);
  if (exposure)
    for (const std::vector<float>& grid : exposure->grids) bytes += grid.size() * sizeof(float);
  return bytes;
}

void CoverPart::save(ByteWriter& out) const {
  SPIN_CHECK(layout, "a cover part needs its layout");
  out.put(registryOf<CoverLayout>().keyOf(layout));
  out.put(exposure ? registryOf<CoverExposure>().keyOf(exposure) : Hash128{});
  out.put(static_cast<std::uint64_t>(values.size()));
  for (const Values& grid : values) {
    out.putArray(grid.swe);
    out.putArray(grid.depth);
    out.putArray(grid.liquid);
    out.putArray(grid.temperature);
  }
}

std::shared_ptr<FramePart> CoverPart::load(ByteReader& in) {
  auto part = std::make_shared<CoverPart>();
  part->layout = registryOf<CoverLayout>().find(in.get<Hash128>());
  const auto exposureKey = in.get<Hash128>();
  part->exposure = registryOf<CoverExposure>().find(exposureKey);
  if (!part->layout || (!part->exposure && !exposureKey.isNull())) return nullptr;
  if ((part->exposure && !fits(*part->exposure, *part->layout)) ||
      in.get<std::uint64_t>() != part->layout->grids.size())
    return nullptr;
  for (const CoverGrid& grid : part->layout->grids) {
    Values values{in.getArray<float>(), in.getArray<float>(), in.getArray<float>(), in.getArray<float>()};
    const std::size_t cells = grid.base.size();
    if (values.swe.size() != cells || values.depth.size() != cells) return nullptr;
    if (values.liquid.size() != values.temperature.size()) return nullptr;
    if (!values.liquid.empty() && values.liquid.size() != cells) return nullptr;
    part->values.push_back(std::move(values));
  }
  return in.ok() ? part : nullptr;
}

std::string CoverPart::firstNonFinite() const {
  for (std::size_t g = 0; g < values.size(); ++g) {
    const CoverGrid& grid = layout->grids[g];
    static const std::vector<float> kNone;
    const std::pair<const char*, const std::vector<float>*> fields[] = {
        {"swe", &values[g].swe},
        {"depth", &values[g].depth},
        {"liquid", &values[g].liquid},
        {"temperature", &values[g].temperature},
        {"exposure", exposure ? &exposure->grids[g] : &kNone}};
    for (const auto& [name, field] : fields)
      for (std::size_t cell = 0; cell < field->size(); ++cell)
        if (!std::isfinite((*field)[cell]) && !std::isnan(grid.base.values[cell]))
          return describe(fmt::format("{} of grid {}, cell", name, grid.id), cell,
                          static_cast<double>((*field)[cell]));
  }
  return {};
}

std::vector<Hash128> CoverPart::sharedKeys() const {
  SPIN_CHECK(layout, "a cover part needs its layout");
  std::vector<Hash128> keys{registryOf<CoverLayout>().keyOf(layout)};
  if (exposure) keys.push_back(registryOf<CoverExposure>().keyOf(exposure));
  return keys;
}

void CoverPart::saveShared(const Hash128& key, ByteWriter& out) const {
  if (key == registryOf<CoverLayout>().keyOf(layout))
    putShared(*layout, out);
  else
    putShared(*exposure, out);
}

}  // namespace spin
