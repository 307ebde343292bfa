// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/mass_properties.h"

#include <algorithm>

namespace spin {
namespace {

/// Integrals of 1, x and x x^T over a volume.
struct Moments {
  double volume = 0.0;
  Vec3d first{};
  SymmetricMatrix second;

  /// The tetrahedron of the origin and a triangle; its volume has the sign of the winding.
  void add(Vec3d a, Vec3d b, Vec3d c) {
    const double v = dot(a, cross(b, c)) / 6.0;
    volume += v;
    first += (a + b + c) * (v / 4.0);
    const Vec3d s = a + b + c;
    const auto product = [&](int i, int j) {
      return v / 20.0 * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
    };
    second.xx += product(0, 0), second.yy += product(1, 1), second.zz += product(2, 2);
    second.xy += product(0, 1), second.xz += product(0, 2), second.yz += product(1, 2);
  }
};

MassProperties fromMoments(const Moments& m) {
  MassProperties p;
  p.volume = m.volume;
  const Vec3d c = m.first / m.volume;
  p.centre = c;
  const double xx = m.second.xx - m.volume * c.x * c.x, yy = m.second.yy - m.volume * c.y * c.y,
               zz = m.second.zz - m.volume * c.z * c.z;
  p.inertia = {yy + zz,
               xx + zz,
               xx + yy,
               m.volume * c.x * c.y - m.second.xy,
               m.volume * c.x * c.z - m.second.xz,
               m.volume * c.y * c.z - m.second.yz};
  return p;
}

MassProperties ofBox(const MeshShells& mesh) {
  Box3d box;
  for (const MeshShell& shell : mesh.shells)
    for (const auto& t : shell.triangles)
      for (const std::uint32_t k : t) box.extend(mesh.positions[k].to<double>());
  Vec3d e = box.size();
  const double least = std::max({e.x, e.y, e.z}) / 20.0;
  e = {std::max(e.x, least), std::max(e.y, least), std::max(e.z, least)};
  MassProperties p;
  p.source = MassSource::Box;
  p.volume = e.x * e.y * e.z;
  p.centre = box.centre();
  const double k = p.volume / 12.0;
  p.inertia = {
      k * (e.y * e.y + e.z * e.z), k * (e.x * e.x + e.z * e.z), k * (e.x * e.x + e.y * e.y), 0, 0, 0};
  return p;
}

}  // namespace

MassProperties massProperties(const MeshShells& mesh) {
  MassProperties p;
  if (mesh.closed()) {
    Moments moments;
    for (const MeshShell& shell : mesh.shells)
      for (const auto& t : shell.triangles)
        moments.add(mesh.positions[t[0]].to<double>(), mesh.positions[t[1]].to<double>(),
                    mesh.positions[t[2]].to<double>());
    if (moments.volume > 0.0) p = fromMoments(moments);
  }
  if (!(p.volume > 0.0)) p = ofBox(mesh);
  p.centre += mesh.origin;
  return p;
}

}  // namespace spin
