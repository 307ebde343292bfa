// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The pair loop on the processor; included once by each flow_loop_isa_*.cpp with SPIN_ISA set.
// Lanes are consecutive particles of a row. For such a group the candidates of the 9 neighbouring rows are
// first cut down to those within reach of the group's bounding box (a pack of candidates at a time), then
// each one left is broadcast to all lanes. Kernels vanish beyond their support, so no lane needs a mask, and
// every particle sums its neighbours in sorted order whatever the width of the pack.
#include "core/math/simd_pack.h"
#include "core/sph/flow_loop.h"
#include "core/sph/flow_passes.h"
#include "core/sph/implicit_passes.h"
#include "core/sph/row_search.h"
#include "core/sph/viscous_passes.h"

namespace spin::SPIN_ISA {
namespace {

constexpr std::uint32_t kBatch = 512;
constexpr std::uint32_t kWidth = static_cast<std::uint32_t>(kLanes);
constexpr float kToSupport = 1.0f / static_cast<float>(kCellUnits);

using Vector = PairVector<Pack>;

/// Up to kLanes consecutive particles.
struct PackLanes {
  using Real = Pack;
  std::uint32_t first = 0, count = 0;

  // Arrays are padded, so a whole pack may be read; what the last lanes hold is never written.
  SPIN_HD_INLINE Pack load(const float* array) const { return Pack::load(array + first); }
  template <class Record>
  SPIN_HD_INLINE Pack load(const Record* array, float Record::*member) const {
    float lanes[kLanes];
    for (std::uint32_t l = 0; l < kWidth; ++l) lanes[l] = array[first + (l < count ? l : 0)].*member;
    return Pack::load(lanes);
  }
  SPIN_HD_INLINE void store(Pack value, float* array) const {
    float lanes[kLanes];
    value.store(lanes);
    for (std::uint32_t l = 0; l < count; ++l) array[first + l] = lanes[l];
  }
  SPIN_HD_INLINE void unpack(Pack value, float* lanes) const { value.store(lanes); }
  SPIN_HD_INLINE Pack pack(const float* lanes) const { return Pack::load(lanes); }
};

/// Candidates within reach of a group, in the group's frame and in support radii.
struct Candidates {
  alignas(64) float x[kBatch + kPairPadding];
  alignas(64) float y[kBatch + kPairPadding];
  alignas(64) float z[kBatch + kPairPadding];
  alignas(64) std::int32_t index[kBatch + kPairPadding];
  std::uint32_t count = 0;
};

/// The lanes and the box round them.
struct Group {
  PackLanes lanes;
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
SPIN_HD_INLINE IntPack loadLanes(const std::int32_t* values, const PackLanes& own) {
  if (own.count == kWidth) return IntPack::load(values + own.first);
  std::int32_t lanes[kLanes];
  for (std::uint32_t l = 0; l < kWidth; ++l) lanes[l] = values[own.first + (l < own.count ? l : 0)];
  return IntPack::load(lanes);
}

SPIN_HD_INLINE Group makeGroup(const FlowView& v, std::uint32_t first, std::uint32_t count) {
  Group g;
  g.lanes = {first, count};
  const IntPack x = loadLanes(v.x, g.lanes), y = loadLanes(v.y, g.lanes), z = loadLanes(v.z, g.lanes);
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
SPIN_HD_INLINE void appendNear(const FlowView& v, const Group& g, const RowRange& range, std::uint32_t at,
                               Candidates& list) {
  const Pack x = local(IntPack::load(v.x + at), g.x0 - range.shiftX);
  const Pack y = local(IntPack::load(v.y + at), g.y0 - range.shiftY);
  const Pack z = local(IntPack::load(v.z + at), g.z0 - range.shiftZ);
  const Pack ox = outside(x, g.sizeX), oy = outside(y, g.sizeY), oz = outside(z, g.sizeZ);
  std::uint32_t bits = lessBits(mulAdd(oz, oz, mulAdd(oy, oy, ox * ox)), Pack(1.0f));
  const std::uint32_t left = range.end - at;
  if (left < kWidth) bits &= (1u << left) - 1u;
  if (bits == 0) return;
  const Compressor keep(bits);
  keep.store(x, list.x + list.count);
  keep.store(y, list.y + list.count);
  keep.store(z, list.z + list.count);
  keep.store(IntPack::iota() + IntPack(static_cast<std::int32_t>(at)), list.index + list.count);
  list.count += keep.count();
}

template <class Pass>
SPIN_HD_INLINE void addAll(const FlowView& v, const Group& g, Candidates& list, Pass& pass) {
  Pass sums = pass;  // a local one stays in registers
  for (std::uint32_t c = 0; c < list.count; ++c) {
    const Vector offset{Pack::broadcast(list.x + c) - g.position.x,
                        Pack::broadcast(list.y + c) - g.position.y,
                        Pack::broadcast(list.z + c) - g.position.z};
    sums.add(v, offset, static_cast<std::uint32_t>(list.index[c]));
  }
  pass = sums;
  list.count = 0;
}

/// A group ends with the pack, with its row, or two supports along x: a box as long as that holds few pairs.
SPIN_HD_INLINE std::uint32_t groupEnd(const FlowView& v, std::uint32_t first, std::uint32_t rowEnd) {
  std::uint32_t end = first + kWidth;
  if (end > rowEnd) end = rowEnd;
  while (v.x[end - 1] - v.x[first] > 2 * kCellUnits) --end;
  return end;
}

template <class Pass>
SPIN_HD_INLINE void runGroup(const FlowView& v, std::uint32_t first, std::uint32_t end, Candidates& list) {
  const Group g = makeGroup(v, first, end - first);
  Pass pass(v, g.lanes);
  forRowRanges(v, v.y[first] >> kCellBits, v.z[first] >> kCellBits, g.x0, g.x1, [&](const RowRange& range) {
    for (std::uint32_t at = range.begin; at < range.end; at += kWidth) {
      appendNear(v, g, range, at, list);
      if (list.count + kWidth > kBatch) addAll(v, g, list, pass);
    }
  });
  addAll(v, g, list, pass);
  pass.write(v, g.lanes);
}

template <class Pass>
void run(const FlowView& v, std::uint32_t begin, std::uint32_t end) {
  Candidates list;
  for (std::uint32_t first = begin; first < end;) {
    const FlowRow& row = v.rows[v.grid.rowOf(v.y[first], v.z[first])];
    const std::uint32_t afterRow =
        v.binStart[row.start + static_cast<std::uint32_t>(row.lastBin - row.firstBin) + 1];
    const std::uint32_t last = groupEnd(v, first, afterRow < end ? afterRow : end);
    runGroup<Pass>(v, first, last, list);
    first = last;
  }
}

}  // namespace

FlowLoops flowLoops() {
  return {run<DensityPass<PackLanes>>,
          run<ShearPass<PackLanes>>,
          {{run<ForcePass<PackLanes, false, false>>, run<ForcePass<PackLanes, false, true>>},
           {run<ForcePass<PackLanes, true, false>>, run<ForcePass<PackLanes, true, true>>}},
          {run<ConstraintPass<PackLanes>>, run<DivergencePass<PackLanes>>, run<PressurePushPass<PackLanes>>,
           run<ViscousProductPass<PackLanes>>, run<StressPass<PackLanes>>}};
}

}  // namespace spin::SPIN_ISA
