// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/air_part.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

using Brick = std::array<std::int32_t, 3>;

bool before(const Brick& a, const Brick& b) {
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

bool fits(const AirPart& part) {
  const bool numbers = isFinite(part.origin) && std::isfinite(part.cell) && part.cell > 0.0 &&
                       part.dropDiameter > 0.0 && part.snowDiameter > 0.0 && std::isfinite(part.temperature);
  const bool ordered =
      std::adjacent_find(part.bricks.begin(), part.bricks.end(),
                         [](const Brick& a, const Brick& b) { return !before(a, b); }) == part.bricks.end();
  return numbers && ordered &&
         std::all_of(part.fields.begin(), part.fields.end(), [&](const AirField& field) {
           return (field.components == 1 || field.components == 3) && std::isfinite(field.scale) &&
                  field.halves.size() == part.cells() * static_cast<std::size_t>(field.components);
         });
}

}  // namespace

std::size_t AirPart::memoryBytes() const {
  std::size_t bytes = sizeof *this + bricks.size() * sizeof(Brick);
  for (const AirField& field : fields) bytes += sizeof field + field.halves.size() * sizeof(std::uint16_t);
  return bytes;
}

void AirPart::save(ByteWriter& out) const {
  out.put(origin);
  for (const double v : {cell, dropDiameter, snowDiameter, temperature}) out.put(v);
  out.putArray(bricks);
  out.put(static_cast<std::uint32_t>(fields.size()));
  for (const AirField& field : fields) {
    out.put(field.name);
    out.put(field.unit);
    out.put(static_cast<std::int32_t>(field.components));
    out.put(field.scale);
    out.putArray(field.halves);
  }
}

std::shared_ptr<FramePart> AirPart::load(ByteReader& in) {
  auto part = std::make_shared<AirPart>();
  part->origin = in.get<Vec3d>();
  for (double* v : {&part->cell, &part->dropDiameter, &part->snowDiameter, &part->temperature})
    *v = in.get<double>();
  part->bricks = in.getArray<Brick>();
  const auto count = in.get<std::uint32_t>();
  for (std::uint32_t k = 0; k < count && in.ok(); ++k) {
    AirField field;
    field.name = in.getText();
    field.unit = in.getText();
    field.components = in.get<std::int32_t>();
    field.scale = in.get<float>();
    field.halves = in.getArray<std::uint16_t>();
    part->fields.push_back(std::move(field));
  }
  return in.ok() && fits(*part) ? part : nullptr;
}

std::string AirPart::firstNonFinite() const {
  constexpr std::uint16_t kNotFinite = 0x7c00;
  for (const AirField& field : fields)
    for (std::size_t k = 0; k < field.halves.size(); ++k)
      if ((field.halves[k] & kNotFinite) == kNotFinite)
        return field.name + " of the air, number " + std::to_string(k);
  return {};
}

}  // namespace spin
