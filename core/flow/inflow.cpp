// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/inflow.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/flow/flow_scene.h"

namespace spin {
namespace {

/// Rows above the line, as many as the sheet is thick; each particle stands for spacing^3, so a sheet thinner
/// than its rows stretches the lattices along the flow instead.
void fillLine(const SceneSnapshot& scene, const WaterSourceNode& source, double spacing, InflowLattice& out) {
  const Vec3d from = sourcePoint(scene, source, source.position), to = sourcePoint(scene, source, source.end);
  const double size = length(to - from), speed = length(source.velocity);
  if (!(size > 0.0)) return void(out.problem = "the line's ends stand on the same spot");
  if (!(speed > 0.0)) return void(out.problem = "the velocity is 0: nothing can enter");
  const Vec3d along = (to - from) * (1.0 / size);
  Vec3d up = normalized(cross(along, source.velocity));
  if (!(length(up) > 0.5)) return void(out.problem = "the velocity points along the line");
  if (up.z < 0.0) up = -up;
  out.velocity = source.velocity;
  out.thickness = source.flowPerMetre / speed;
  if (!(source.flowPerMetre > 0.0)) return;
  const int rows = std::max(1, static_cast<int>(std::ceil(out.thickness / spacing - 1e-6)));
  const int columns = std::max(1, static_cast<int>(std::lround(size / spacing)));
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      out.positions.push_back(from + along * ((c + 0.5) * size / columns) + up * ((r + 0.5) * spacing));
  out.interval = rows * columns * spacing * spacing * spacing / (source.flowPerMetre * size);
}

void fillDisc(const SceneSnapshot& scene, const WaterSourceNode& source, double spacing, InflowLattice& out) {
  const Vec3d direction = normalized(source.velocity);
  if (!(length(direction) > 0.5)) return void(out.problem = "the velocity gives no direction");
  const double speed = source.flow / (kPi * source.radius * source.radius);
  out.velocity = direction * speed;
  out.thickness = 2.0 * source.radius;
  if (!(speed > 0.0)) return;
  const Vec3d centre = sourcePoint(scene, source, source.position);
  const Vec3d level{-direction.y, direction.x, 0.0};
  const Vec3d u = length(level) > 1e-9 ? normalized(level) : Vec3d{1, 0, 0}, v = cross(direction, u);
  const int reach = static_cast<int>(source.radius / spacing) + 1;
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i)
      if (std::hypot(i, j) * spacing <= source.radius)
        out.positions.push_back(centre + u * (i * spacing) + v * (j * spacing));
  out.interval = static_cast<double>(out.positions.size()) * spacing * spacing * spacing / source.flow;
  // A disc's lattice may hold fewer particles than its area asks for; they come a spacing apart all the same.
  if (speed * out.interval < 0.7 * spacing)
    out.problem = "the disc is too small for this spacing: its particles would overlap";
}

/// Each column along the flow is as far ahead of the others as a sequence without a period says: lattices
/// that enter as one would fall as rows that can be seen all the way down.
void stagger(InflowLattice& lattice) {
  constexpr double kGolden = 0.6180339887498949;
  for (std::size_t k = 0; k < lattice.positions.size(); ++k) {
    const double turns = static_cast<double>(k) * kGolden;
    lattice.positions[k] += lattice.velocity * (lattice.interval * (turns - std::floor(turns)));
  }
}

}  // namespace

InflowLattice inflowLattice(const SceneSnapshot& scene, const WaterSourceNode& source, double spacing) {
  InflowLattice out;
  if (source.shape == WaterSourceShape::Line)
    fillLine(scene, source, spacing, out);
  else
    fillDisc(scene, source, spacing, out);
  stagger(out);
  return out;
}

}  // namespace spin
