// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/signed_distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "core/base/parallel.h"
#include "core/fields/mesh_distance.h"

namespace spin {
namespace {

constexpr const char* kWhat = "The signed distance of a mesh could not be made";
constexpr std::size_t kNodesPerBlock = kFieldNodes * kFieldNodes * kFieldNodes;
constexpr std::uint32_t kNear = 0;  ///< while building: the surface is within reach
constexpr double kMostBlocks = 2.0e8;

}  // namespace

class SignedDistanceBuilder {
 public:
  SignedDistanceBuilder(MeshShells mesh, const SignedDistanceOptions& options)
      : m_mesh(std::move(mesh)), m_options(options), m_backend(options.threads) {}

  Result<std::shared_ptr<const SignedDistance>> build() {
    auto field = std::make_shared<SignedDistance>();
    m_field = field.get();
    if (Status ok = layOut(); !ok) return ok.error();
    if (Status ok = markBlocks(); !ok) return ok.error();
    const std::size_t near = number();
    if (static_cast<double>(near) * kNodesPerBlock * sizeof(float) > m_options.mostBytes)
      return tooLarge(static_cast<double>(near) * kNodesPerBlock * sizeof(float));
    fill(near);
    if (m_options.cancel.cancelled()) return cancelled();
    return std::shared_ptr<const SignedDistance>(field);
  }

 private:
  static Error cancelled() { return {ErrorKind::Cancelled, kWhat, {}, "it was cancelled", {}}; }
  Error tooLarge(double bytes) const {
    return {ErrorKind::OutOfResources,
            kWhat,
            {},
            fmt::format("it needs {:.0f} MB, {:.0f} MB are allowed", bytes / 1e6, m_options.mostBytes / 1e6),
            "Use larger particles, or a smaller or simpler model"};
  }
  double blockSize() const { return m_options.cell * kFieldBlock; }
  /// Thickening moves the surface outwards by up to half of it.
  double margin() const { return m_options.reach + 0.5 * m_options.leastThickness; }

  Status layOut() {
    Box3d box;
    for (std::size_t s = 0; s < m_mesh.shells.size(); ++s) {
      if (m_options.cancel.cancelled()) return cancelled();
      m_shells.emplace_back(m_mesh, s);
      box.extend(m_shells.back().box());
    }
    const double far = margin() + m_options.cell;
    m_low = box.min - Vec3d{far, far, far};
    const Vec3d size = box.size() + Vec3d{2 * far, 2 * far, 2 * far};
    double blocks = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double count = std::floor(size[axis] / blockSize()) + 1.0;
      blocks *= count;
      if (!(blocks <= kMostBlocks)) return tooLarge(blocks * sizeof(std::uint32_t));
      m_field->m_count[axis] = static_cast<std::int32_t>(count);
    }
    if (blocks * sizeof(std::uint32_t) > m_options.mostBytes) return tooLarge(blocks * sizeof(std::uint32_t));
    m_field->m_origin = m_mesh.origin + m_low;
    m_field->m_cell = m_options.cell;
    m_field->m_reach = m_options.reach;
    m_field->m_blocks.assign(static_cast<std::size_t>(blocks), kFieldOutside);
    return {};
  }

  std::size_t indexOf(std::int32_t x, std::int32_t y, std::int32_t z) const {
    const auto* n = m_field->m_count;
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(n[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(n[0]) +
           static_cast<std::size_t>(x);
  }
  Vec3d cornerOf(std::size_t block) const {
    const auto nx = static_cast<std::size_t>(m_field->m_count[0]),
               ny = static_cast<std::size_t>(m_field->m_count[1]);
    return m_low + Vec3d{static_cast<double>(block % nx), static_cast<double>(block / nx % ny),
                         static_cast<double>(block / nx / ny)} *
                       blockSize();
  }

  /// Blocks that a triangle is within the margin of.
  Status markBlocks() {
    const double reach = margin() + 0.5 * std::sqrt(3.0) * blockSize();
    for (const MeshShell& shell : m_mesh.shells)
      for (const auto& t : shell.triangles) {
        if (m_options.cancel.cancelled()) return cancelled();
        markTriangle(m_mesh.positions[t[0]].to<double>(), m_mesh.positions[t[1]].to<double>(),
                     m_mesh.positions[t[2]].to<double>(), reach);
      }
    return {};
  }
  void markTriangle(Vec3d a, Vec3d b, Vec3d c, double reach) {
    std::int32_t low[3], high[3];
    for (int axis = 0; axis < 3; ++axis) {
      const double from = std::min({a[axis], b[axis], c[axis]}) - margin() - m_low[axis],
                   to = std::max({a[axis], b[axis], c[axis]}) + margin() - m_low[axis];
      const std::int32_t last = m_field->m_count[axis] - 1;
      low[axis] = std::clamp(static_cast<std::int32_t>(std::floor(from / blockSize())), 0, last);
      high[axis] = std::clamp(static_cast<std::int32_t>(std::floor(to / blockSize())), 0, last);
    }
    for (std::int32_t z = low[2]; z <= high[2]; ++z)
      for (std::int32_t y = low[1]; y <= high[1]; ++y)
        for (std::int32_t x = low[0]; x <= high[0]; ++x) {
          const Vec3d middle = m_low + Vec3d{x + 0.5, y + 0.5, z + 0.5} * blockSize();
          const Vec3d away = middle - closestOnTriangle(middle, a, b, c).point;
          if (dot(away, away) <= reach * reach) m_field->m_blocks[indexOf(x, y, z)] = kNear;
        }
  }

  /// Numbers the blocks near the surface in order.
  std::size_t number() {
    std::uint32_t next = 0;
    for (std::uint32_t& block : m_field->m_blocks)
      if (block == kNear) {
        block = next++;
        m_near.push_back(static_cast<std::size_t>(&block - m_field->m_blocks.data()));
      }
    return next;
  }

  void fill(std::size_t near) {
    m_field->m_values.resize(near * kNodesPerBlock);
    m_backend.forEach(
        "blocks", near, [&](std::size_t b) { fillBlock(b); }, 4);
    m_backend.forEach("inside", m_field->m_blocks.size(), [&](std::size_t block) {
      if (m_field->m_blocks[block] != kFieldOutside || m_options.cancel.cancelled()) return;
      const double half = 0.5 * blockSize();
      if (inside(cornerOf(block) + Vec3d{half, half, half})) m_field->m_blocks[block] = kFieldInside;
    });
  }
  void fillBlock(std::size_t b) {
    if (m_options.cancel.cancelled()) return;
    const Vec3d corner = cornerOf(m_near[b]);
    std::vector<Last> last(m_shells.size());
    float* out = m_field->m_values.data() + b * kNodesPerBlock;
    for (int z = 0; z < kFieldNodes; ++z)
      for (int y = 0; y < kFieldNodes; ++y)
        for (int x = 0; x < kFieldNodes; ++x)
          *out++ =
              static_cast<float>(valueAt(corner + Vec3d{x * 1.0, y * 1.0, z * 1.0} * m_options.cell, last));
  }

  static bool holds(const Box3d& box, Vec3d p, double margin) {
    return p.x >= box.min.x - margin && p.y >= box.min.y - margin && p.z >= box.min.z - margin &&
           p.x <= box.max.x + margin && p.y <= box.max.y + margin && p.z <= box.max.z + margin;
  }

  /// Far from every surface.
  bool inside(Vec3d p) const {
    return std::any_of(m_shells.begin(), m_shells.end(), [&](const ShellDistance& shell) {
      return shell.closed() && holds(shell.box(), p, 0.0) && *shell.signedDistance(p, 1e30) < 0.0;
    });
  }

  /// A node asked before and a shell's distance from it: no neighbour is farther from that shell than the
  /// sum.
  struct Last {
    Vec3d place{};
    double distance = 1e30;
  };

  /// The least over the shells: the union of solids.
  double valueAt(Vec3d p, std::vector<Last>& last) const {
    const double far = margin() + std::sqrt(3.0) * blockSize();
    double value = far;
    for (std::size_t k = 0; k < m_shells.size(); ++k) {
      const ShellDistance& shell = m_shells[k];
      if (!holds(shell.box(), p, far)) continue;
      // Inside a closed shell the sign needs the surface however far it is.
      const bool within = shell.closed() && holds(shell.box(), p, 0.0);
      const double known = 1.001 * (last[k].distance + length(p - last[k].place));
      const auto s = shell.nearest(p, std::min(within ? 1e30 : far, known));
      if (!s) continue;
      last[k] = {p, s->distance};
      value = std::min(value, thickened(shell, p, *s));
    }
    return value;
  }

  double thickened(const ShellDistance& shell, Vec3d p, const MeshPlace& s) const {
    const double side = shell.closed() && dot(p - s.point, s.normal) < 0.0 ? -1.0 : 1.0;
    const double least = m_options.leastThickness;
    if (!(least > 0.0) || s.distance > margin()) return side * s.distance;
    const Vec3d away = p - s.point;
    const Vec3d inward = s.distance > 1e-6 * least ? away * (-side / s.distance) : normalized(-s.normal);
    return side * s.distance - 0.5 * (least - shell.thickness(s.point, inward, least));
  }

  MeshShells m_mesh;
  SignedDistanceOptions m_options;
  CpuBackend m_backend;
  SignedDistance* m_field = nullptr;
  std::vector<ShellDistance> m_shells;
  std::vector<std::size_t> m_near;
  Vec3d m_low{};
};

Result<std::shared_ptr<const SignedDistance>> SignedDistance::make(const TriangleMesh& mesh,
                                                                   const SignedDistanceOptions& options) {
  const auto positive = [](double v) { return v > 0.0 && std::isfinite(v); };
  if (!positive(options.cell) || !positive(options.reach) || !(options.leastThickness >= 0.0) ||
      !std::isfinite(options.leastThickness))
    return badInput(kWhat, "options", "cell and reach must be above 0");
  try {
    Result<MeshShells> shells = makeMeshShells(mesh);
    if (!shells) return shells.error();
    return SignedDistanceBuilder(std::move(*shells), options).build();
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResources, kWhat, {}, "there is not enough memory", "Use larger particles"};
  }
}

SignedDistanceView SignedDistance::view(Vec3d origin) const {
  SignedDistanceView v;
  v.blocks = m_blocks.data();
  v.values = m_values.data();
  v.blocksX = m_count[0], v.blocksY = m_count[1], v.blocksZ = m_count[2];
  const Vec3f o = (m_origin - origin).to<float>();
  v.originX = o.x, v.originY = o.y, v.originZ = o.z;
  v.cellsPerMetre = static_cast<float>(1.0 / m_cell);
  v.reach = static_cast<float>(m_reach);
  return v;
}

}  // namespace spin
