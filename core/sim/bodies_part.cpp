// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/bodies_part.h"

#include <cmath>

namespace spin {

std::size_t BodiesPart::memoryBytes() const {
  return sizeof *this + bodies.size() * sizeof(Placement);
}

void BodiesPart::save(ByteWriter& out) const {
  out.put(static_cast<std::uint64_t>(bodies.size()));
  for (const Placement& body : bodies) {
    out.put(body.model);
    out.put(body.placement.linear);
    out.put(body.placement.translation);
    out.put(body.velocity);
  }
}

std::shared_ptr<FramePart> BodiesPart::load(ByteReader& in) {
  auto part = std::make_shared<BodiesPart>();
  const auto count = in.get<std::uint64_t>();
  for (std::uint64_t k = 0; k < count && in.ok(); ++k) {
    Placement body;
    body.model = in.getText();
    body.placement.linear = in.get<std::array<double, 9>>();
    body.placement.translation = in.get<Vec3d>();
    body.velocity = in.get<Vec3d>();
    part->bodies.push_back(std::move(body));
  }
  if (!in.ok()) return nullptr;
  return part;
}

std::string BodiesPart::firstNonFinite() const {
  for (const Placement& body : bodies) {
    double sum = 0.0;
    for (const double v : body.placement.linear) sum += v;
    if (!std::isfinite(sum) || !isFinite(body.placement.translation) || !isFinite(body.velocity))
      return "placement of " + body.model;
  }
  return {};
}

}  // namespace spin
