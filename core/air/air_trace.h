// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/air_lanes.h"
#include "core/physics/bounded_math.h"

/// Where the air at a face comes from, and values of a field there. Places are in cells from the lattice's
/// corner; velocities lie at the lower faces of cells.
namespace spin {

struct AirDims {
  std::int32_t x = 0, y = 0, z = 0;
};

template <class Real>
struct LatticePlace {
  Real x, y, z;
};

/// The eight corners round a place of a field whose samples lie at whole numbers.
template <class At>
struct Corners {
  using Real = typename At::Real;
  using Int = typename At::Int;
  Int first;
  Real fx, fy, fz;

  SPIN_HD_INLINE Corners(const LatticePlace<Real>& p, const AirDims& dims, const AirStrides& strides) {
    const Real x = held(p.x, dims.x), y = held(p.y, dims.y), z = held(p.z, dims.z);
    const Int ix = toInt(x), iy = toInt(y), iz = toInt(z);
    fx = x - toFloat(ix);
    fy = y - toFloat(iy);
    fz = z - toFloat(iz);
    first = ix + iy * Int(strides.y) + iz * Int(strides.z);
  }

  SPIN_HD_INLINE Real linear(const float* field, const AirStrides& s) const {
    const Real low = plane(field, s.y), high = plane(field + s.z, s.y);
    return mulAdd(fz, high - low, low);
  }
  /// Also the least and the largest of the corners.
  SPIN_HD_INLINE Real linear(const float* field, const AirStrides& s, Real& least, Real& most) const {
    Real v[8];
    for (int c = 0; c < 8; ++c) v[c] = gather(field + (c & 1) + (c & 2 ? s.y : 0) + (c & 4 ? s.z : 0), first);
    least = most = v[0];
    for (int c = 1; c < 8; ++c) {
      least = minimum(least, v[c]);
      most = maximum(most, v[c]);
    }
    const Real a = mulAdd(fx, v[1] - v[0], v[0]), b = mulAdd(fx, v[3] - v[2], v[2]);
    const Real c = mulAdd(fx, v[5] - v[4], v[4]), d = mulAdd(fx, v[7] - v[6], v[6]);
    const Real low = mulAdd(fy, b - a, a), high = mulAdd(fy, d - c, c);
    return mulAdd(fz, high - low, low);
  }

 private:
  SPIN_HD_INLINE static Real held(Real p, int cells) {
    return minimum(maximum(p, lit<Real>(0.0)), lit<Real>(static_cast<double>(cells) - 1.002));
  }
  SPIN_HD_INLINE Real plane(const float* field, int y) const {
    const Real a = gather(field, first), b = gather(field + 1, first);
    const Real c = gather(field + y, first), d = gather(field + y + 1, first);
    const Real low = mulAdd(fx, b - a, a), high = mulAdd(fx, d - c, c);
    return mulAdd(fy, high - low, low);
  }
};

/// Velocity field of a lattice.
struct VelocityView {
  AirStrides strides;
  AirDims dims;
  const float* u[3];
};

/// Corners of component k round a place.
template <class At>
SPIN_HD_INLINE Corners<At> cornersOf(const VelocityView& v, int k, const LatticePlace<typename At::Real>& p) {
  using Real = typename At::Real;
  const Real half = lit<Real>(0.5);
  LatticePlace<Real> q{p.x - half, p.y - half, p.z - half};
  if (k == 0) q.x = p.x;
  if (k == 1) q.y = p.y;
  if (k == 2) q.z = p.z;
  return Corners<At>(q, v.dims, v.strides);
}

/// Where the centre of the lower face along `axis` is.
template <int axis, class At>
SPIN_HD_INLINE LatticePlace<typename At::Real> faceOf(const At& at) {
  using Real = typename At::Real;
  return {at.lanesX() + lit<Real>(axis == 0 ? 0.0 : 0.5), lit<Real>(at.y + (axis == 1 ? 0.0 : 0.5)),
          lit<Real>(at.z + (axis == 2 ? 0.0 : 0.5))};
}

/// Component k at that face: its own, or the mean of the four round it.
template <int axis, class At>
SPIN_HD_INLINE typename At::Real atFace(const VelocityView& v, const At& at, int k) {
  if (k == axis) return at.load(v.u[k]);
  const int steps[3] = {1, v.strides.y, v.strides.z};
  const int along = steps[k], back = -steps[axis];
  return lit<typename At::Real>(0.25) *
         (at.load(v.u[k]) + at.load(v.u[k], along) + at.load(v.u[k], back) + at.load(v.u[k], along + back));
}

/// Which neighbours along a dimension a value less than half a cell (Up, Down) or a cell (Three) from a face
/// is between, for component k at a lower face along `axis`.
enum class AirReach { Three, Up, Down };
constexpr AirReach reachOf(int k, int axis, int dimension) {
  return k == axis           ? AirReach::Three
         : dimension == k    ? AirReach::Up
         : dimension == axis ? AirReach::Down
                             : AirReach::Three;
}

/// A value with the least and the largest of the corners that it is between.
template <class Real>
struct HeldValue {
  Real value, least, most;
};
template <class Real>
SPIN_HD_INLINE Real blend(Real share, Real a, Real b) {
  return mulAdd(share, b - a, a);
}
template <class Real>
SPIN_HD_INLINE HeldValue<Real> blend(Real share, const HeldValue<Real>& a, const HeldValue<Real>& b) {
  return {blend(share, a.value, b.value), minimum(a.least, b.least), maximum(a.most, b.most)};
}
template <class Real>
SPIN_HD_INLINE HeldValue<Real> selectLess(Real a, Real b, const HeldValue<Real>& x,
                                          const HeldValue<Real>& y) {
  return {selectLess(a, b, x.value, y.value), selectLess(a, b, x.least, y.least),
          selectLess(a, b, x.most, y.most)};
}

/// Linear along one dimension; at(-1), at(0) and at(1) are its neighbours.
template <AirReach reach, class Real, class Value>
SPIN_HD_INLINE auto along(Real d, const Value& at) {
  const Real zero = lit<Real>(0.0), half = lit<Real>(0.5);
  if constexpr (reach == AirReach::Three)
    return blend(maximum(d, -d), at(0), selectLess(d, zero, at(-1), at(1)));
  else
    return blend(half + d, at(reach == AirReach::Up ? 0 : -1), at(reach == AirReach::Up ? 1 : 0));
}

/// Component k of a field, displaced from the lower face along `axis` by less than the reach says: neighbours
/// are loaded as they lie, which is many times faster than to gather corners lane by lane.
template <int k, int axis, class At, class Load>
SPIN_HD_INLINE auto nearBy(const LatticePlace<typename At::Real>& d, const AirStrides& s, const Load& load) {
  return along<reachOf(k, axis, 2)>(d.z, [&](int z) SPIN_INLINE_LAMBDA {
    return along<reachOf(k, axis, 1)>(d.y, [&](int y) SPIN_INLINE_LAMBDA {
      return along<reachOf(k, axis, 0)>(
          d.x, [&](int x) SPIN_INLINE_LAMBDA { return load(x + y * s.y + z * s.z); });
    });
  });
}

/// Whether all lanes go less than that far; one cell alone is better off with its eight corners.
template <class At>
SPIN_HD_INLINE bool allWithin(const LatticePlace<typename At::Real>& d, double cells) {
  if constexpr (At::kWidth == 1) {
    (void)d, (void)cells;
    return false;
  } else {
    using Real = typename At::Real;
    const Real most = maximum(maximum(maximum(d.x, -d.x), maximum(d.y, -d.y)), maximum(d.z, -d.z));
    return lessBits(most, lit<Real>(cells)) == (1u << At::kWidth) - 1u;
  }
}

template <class Real>
SPIN_HD_INLINE LatticePlace<Real> moved(const LatticePlace<Real>& p, const LatticePlace<Real>& d) {
  return {p.x + d.x, p.y + d.y, p.z + d.z};
}

/// Component k displaced from a face.
template <int k, int axis, class At>
SPIN_HD_INLINE typename At::Real displaced(const VelocityView& v, const float* field, const At& at,
                                           const LatticePlace<typename At::Real>& d, bool isNear) {
  if (isNear)
    return nearBy<k, axis, At>(d, v.strides,
                               [&](int offset) SPIN_INLINE_LAMBDA { return at.load(field, offset); });
  return cornersOf<At>(v, k, moved(faceOf<axis>(at), d)).linear(field, v.strides);
}

/// The field's own component displaced from its face, with the corners' bounds.
template <int axis, class At>
SPIN_HD_INLINE HeldValue<typename At::Real> heldAt(const VelocityView& v, const float* field, const At& at,
                                                   const LatticePlace<typename At::Real>& d) {
  using Real = typename At::Real;
  if (allWithin<At>(d, 1.0))
    return nearBy<axis, axis, At>(d, v.strides, [&](int offset) SPIN_INLINE_LAMBDA {
      const Real own = at.load(field, offset);
      return HeldValue<Real>{own, own, own};
    });
  HeldValue<Real> held;
  held.value =
      cornersOf<At>(v, axis, moved(faceOf<axis>(at), d)).linear(field, v.strides, held.least, held.most);
  return held;
}

/// How far the air at a face has come (cells < 0) or goes: midpoint rule, `cells` = time over cell size.
template <int axis, class At>
SPIN_HD_INLINE LatticePlace<typename At::Real> traced(const VelocityView& v, const At& at, float cells) {
  using Real = typename At::Real;
  const Real half(0.5f * cells), whole(cells);
  const LatticePlace<Real> mid{half * atFace<axis>(v, at, 0), half * atFace<axis>(v, at, 1),
                               half * atFace<axis>(v, at, 2)};
  const bool isNear = allWithin<At>(mid, 0.5);
  return {whole * displaced<0, axis>(v, v.u[0], at, mid, isNear),
          whole * displaced<1, axis>(v, v.u[1], at, mid, isNear),
          whole * displaced<2, axis>(v, v.u[2], at, mid, isNear)};
}

}  // namespace spin
