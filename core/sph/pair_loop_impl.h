// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The pair loop on the processor; included once by each pair_loop_isa_*.cpp with SPIN_ISA set.
// Lanes are consecutive particles of a row. For such a group the candidates of the 9 neighbouring rows are
// first cut down to those within reach of the group's bounding box (eight or sixteen candidates at a time),
// then each one left is broadcast to all lanes. Kernels vanish beyond their support, so no lane needs a mask,
// and every particle sums its neighbours in sorted order whatever the width of the pack.
#include "core/math/simd_pack.h"
#include "core/sph/pair_law.h"
#include "core/sph/pair_loop.h"
#include "core/sph/row_ranges.h"

namespace spin::SPIN_ISA {
namespace {

constexpr std::uint32_t kBatch = 512;
constexpr float kToSupport = 1.0f / static_cast<float>(kCellUnits);

using Vector = PairVector<Pack>;

/// Candidates within reach of a group, in the group's frame and in support radii.
struct Candidates {
  alignas(64) float x[kBatch + kPairPadding];
  alignas(64) float y[kBatch + kPairPadding];
  alignas(64) float z[kBatch + kPairPadding];
  alignas(64) std::int32_t index[kBatch + kPairPadding];
  std::uint32_t count = 0;
};

/// Up to kLanes particles of one row and the box round them.
struct Group {
  std::uint32_t first, count;
  std::int32_t x0, y0, z0;  // lowest corner, units
  std::int32_t x1;          // highest x, units
  Vector position;          // from the corner, support radii
  Pack sizeX, sizeY, sizeZ;
};

SPIN_HD_INLINE Pack local(IntPack position, std::int32_t origin) {
  return toFloat(position - IntPack(origin)) * Pack(kToSupport);
}

/// Loads particle `first` and its followers; lanes past the end of the group repeat its first particle, so
/// that they do not widen the box.
SPIN_HD_INLINE IntPack loadLanes(const std::int32_t* values, std::uint32_t first, std::uint32_t count) {
  if (count == static_cast<std::uint32_t>(kLanes)) return IntPack::load(values + first);
  std::int32_t lanes[kLanes];
  for (std::uint32_t l = 0; l < static_cast<std::uint32_t>(kLanes); ++l)
    lanes[l] = values[first + (l < count ? l : 0)];
  return IntPack::load(lanes);
}

SPIN_HD_INLINE Group makeGroup(const SliceView& v, std::uint32_t first, std::uint32_t count) {
  const IntPack x = loadLanes(v.x, first, count);
  const IntPack y = loadLanes(v.y, first, count);
  const IntPack z = loadLanes(v.z, first, count);
  Group g;
  g.first = first;
  g.count = count;
  g.x0 = lowest(x);
  g.y0 = lowest(y);
  g.z0 = lowest(z);
  g.x1 = highest(x);
  g.position = {local(x, g.x0), local(y, g.y0), local(z, g.z0)};
  g.sizeX = Pack(static_cast<float>(g.x1 - g.x0) * kToSupport);
  g.sizeY = Pack(static_cast<float>(highest(y) - g.y0) * kToSupport);
  g.sizeZ = Pack(static_cast<float>(highest(z) - g.z0) * kToSupport);
  return g;
}

/// Distance from the interval [0, size].
SPIN_HD_INLINE Pack outside(Pack p, Pack size) {
  return maximum(maximum(-p, p - size), Pack(0.0f));
}

/// Appends the next kLanes candidates that lie within reach of the box.
SPIN_HD_INLINE void appendNear(const SliceView& v, const Group& g, const RowRange& range, std::uint32_t at,
                               Candidates& list) {
  const Pack x = local(IntPack::load(v.x + at), g.x0 - range.shiftX);
  const Pack y = local(IntPack::load(v.y + at), g.y0 - range.shiftY);
  const Pack z = local(IntPack::load(v.z + at), g.z0);
  const Pack ox = outside(x, g.sizeX), oy = outside(y, g.sizeY), oz = outside(z, g.sizeZ);
  std::uint32_t bits = lessBits(mulAdd(oz, oz, mulAdd(oy, oy, ox * ox)), Pack(1.0f));
  const std::uint32_t left = range.end - at;
  if (left < static_cast<std::uint32_t>(kLanes)) bits &= (1u << left) - 1u;
  if (bits == 0) return;
  const Compressor keep(bits);
  keep.store(x, list.x + list.count);
  keep.store(y, list.y + list.count);
  keep.store(z, list.z + list.count);
  keep.store(IntPack::iota() + IntPack(static_cast<std::int32_t>(at)), list.index + list.count);
  list.count += keep.count();
}

SPIN_HD_INLINE Vector offsetTo(const Candidates& list, std::uint32_t c, const Vector& from) {
  return {Pack::broadcast(list.x + c) - from.x, Pack::broadcast(list.y + c) - from.y,
          Pack::broadcast(list.z + c) - from.z};
}

struct DensitySum {
  Pack sum = Pack(0.0f);

  SPIN_HD_INLINE DensitySum(const SliceView&, const Group&) {}
  SPIN_HD_INLINE void add(const SliceView&, const Group& g, const Candidates& list) {
    Pack total = sum;  // a local one stays in a register
    for (std::uint32_t c = 0; c < list.count; ++c) total = total + densityTerm(offsetTo(list, c, g.position));
    sum = total;
  }
  SPIN_HD_INLINE void write(const SliceView& v, const Group& g) const {
    float lanes[kLanes];
    sum.store(lanes);
    for (std::uint32_t l = 0; l < g.count; ++l) v.excess[g.first + l] = lanes[l];
  }
};

struct ForceSum {
  Vector sum{Pack(0.0f), Pack(0.0f), Pack(0.0f)};
  Vector velocity;
  Pack pressure, drag;

  SPIN_HD_INLINE ForceSum(const SliceView& v, const Group& g) {
    float lane[5][kLanes] = {};
    for (std::uint32_t l = 0; l < g.count; ++l) {
      const PairRecord& r = v.record[g.first + l];
      lane[0][l] = r.vx;
      lane[1][l] = r.vy;
      lane[2][l] = r.vz;
      lane[3][l] = r.pressureTerm;
      lane[4][l] = v.constants.viscosityFactor * r.inverseDensity;
    }
    velocity = {Pack::load(lane[0]), Pack::load(lane[1]), Pack::load(lane[2])};
    pressure = Pack::load(lane[3]);
    drag = Pack::load(lane[4]);
  }
  SPIN_HD_INLINE void add(const SliceView& v, const Group& g, const Candidates& list) {
    Vector total = sum;
    for (std::uint32_t c = 0; c < list.count; ++c) {
      const PairRecord& r = v.record[list.index[c]];
      const Vector relative{velocity.x - Pack::broadcast(&r.vx), velocity.y - Pack::broadcast(&r.vy),
                            velocity.z - Pack::broadcast(&r.vz)};
      addPairForce(offsetTo(list, c, g.position), pressure + Pack::broadcast(&r.pressureTerm),
                   drag * Pack::broadcast(&r.inverseDensity), relative, total);
    }
    sum = total;
  }
  SPIN_HD_INLINE void write(const SliceView& v, const Group& g) const {
    float x[kLanes], y[kLanes], z[kLanes];
    sum.x.store(x);
    sum.y.store(y);
    sum.z.store(z);
    for (std::uint32_t l = 0; l < g.count; ++l) {
      v.ax[g.first + l] = x[l];
      v.ay[g.first + l] = y[l];
      v.az[g.first + l] = z[l];
    }
  }
};

/// A group ends with the pack, with the row, or two supports along x: a box as long as that holds few pairs.
SPIN_HD_INLINE std::uint32_t groupEnd(const SliceView& v, std::uint32_t first, std::uint32_t rowEnd) {
  std::uint32_t end = first + static_cast<std::uint32_t>(kLanes);
  if (end > rowEnd) end = rowEnd;
  while (v.x[end - 1] - v.x[first] > 2 * kCellUnits) --end;
  return end;
}

template <class Sum>
SPIN_HD_INLINE void runRow(const SliceView& v, std::uint32_t row) {
  const std::size_t bins = static_cast<std::size_t>(v.grid.binsX());
  const std::uint32_t rowEnd = v.binStart[(row + 1) * bins];
  const std::int32_t cellY = static_cast<std::int32_t>(row) % v.grid.cellsY;
  const std::int32_t cellZ = static_cast<std::int32_t>(row) / v.grid.cellsY;
  Candidates list;
  for (std::uint32_t first = v.binStart[row * bins]; first < rowEnd;) {
    const std::uint32_t end = groupEnd(v, first, rowEnd);
    const Group g = makeGroup(v, first, end - first);
    Sum sum(v, g);
    list.count = 0;
    forRowRanges(v, cellY, cellZ, g.x0, g.x1, [&](const RowRange& range) {
      for (std::uint32_t at = range.begin; at < range.end; at += static_cast<std::uint32_t>(kLanes)) {
        appendNear(v, g, range, at, list);
        if (list.count + static_cast<std::uint32_t>(kLanes) <= kBatch) continue;
        sum.add(v, g, list);
        list.count = 0;
      }
    });
    sum.add(v, g, list);
    sum.write(v, g);
    first = end;
  }
}

void density(const SliceView& v, std::uint32_t rowBegin, std::uint32_t rowEnd) {
  for (std::uint32_t row = rowBegin; row < rowEnd; ++row) runRow<DensitySum>(v, row);
}

void force(const SliceView& v, std::uint32_t rowBegin, std::uint32_t rowEnd) {
  for (std::uint32_t row = rowBegin; row < rowEnd; ++row) runRow<ForceSum>(v, row);
}

}  // namespace

PairLoops pairLoops() {
  return {density, force};
}

}  // namespace spin::SPIN_ISA
