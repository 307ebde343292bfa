// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/air_light.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

/// Two-stream transmission of diffuse light through what absorbs nothing (A. Schuster 1905; Eddington's
/// factor).
constexpr float kTwoStream = 0.75f;
/// Fitted once to the reflectance of level layers between the optical depths 0.3 and 1000, which it then
/// gives within 0.1 under a high sun (tests/render/air_volume_test.cpp).
constexpr float kSeveral = 0.5f;
/// Length of the mean way out, weighted by openness, at a thick level surface: (1 + 4/sqrt 3) / 5.
constexpr float kLevelSurface = 0.66f;
constexpr float kSlant = 0.57735027f;
constexpr std::size_t kDirections = 14;

std::array<Vec3f, kDirections> directions() {
  std::array<Vec3f, kDirections> d{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t s = 0; s < 2; ++s) {
      const float one = s == 0 ? 1.0f : -1.0f;
      d[2 * k + s] = {k == 0 ? one : 0.0f, k == 1 ? one : 0.0f, k == 2 ? one : 0.0f};
    }
  for (std::size_t k = 0; k < 8; ++k)
    d[6 + k] = {k & 1 ? kSlant : -kSlant, k & 2 ? kSlant : -kSlant, k & 4 ? kSlant : -kSlant};
  return d;
}

struct Box {
  std::array<std::int64_t, 3> low{}, high{};  // cells, the high ones beyond
};

bool anyAbove(const float* cells) {
  return std::any_of(cells, cells + kBrickCells, [](float v) { return v > 0.0f; });
}

bool boxOf(const AirPart& air, const std::vector<float>& extinction, Box& box) {
  constexpr std::array<std::int64_t, 3> kBrick{kBrickX, kBrickY, kBrickZ};
  bool any = false;
  for (std::size_t k = 0; k < air.bricks.size(); ++k) {
    if (!anyAbove(extinction.data() + k * kBrickCells)) continue;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t low = air.bricks[k][a] * kBrick[a], high = low + kBrick[a];
      box.low[a] = any ? std::min(box.low[a], low) : low;
      box.high[a] = any ? std::max(box.high[a], high) : high;
    }
    any = true;
  }
  return any;
}

/// Optical depths from voxel centres to the outside, one direction at a time.
class Sweeper {
 public:
  Sweeper(const std::array<int, 3>& size, double voxel, const std::vector<float>& extinction,
          CpuBackend& backend)
      : m_size(size), m_voxel(static_cast<float>(voxel)), m_extinction(extinction), m_backend(backend) {
    m_stride = {1, size[0], static_cast<std::ptrdiff_t>(size[0]) * size[1]};
  }

  /// `depth` takes a number per voxel. Plane by plane from the side that the direction points to: in the
  /// plane before, the ray comes through between four centres.
  void sweep(Vec3f direction, std::vector<float>& depth) const {
    const float ax = std::abs(direction.x), ay = std::abs(direction.y), az = std::abs(direction.z);
    const std::size_t a = az >= ax && az >= ay ? 2 : ay >= ax ? 1 : 0, u = (a + 1) % 3, v = (a + 2) % 3;
    const float along = direction[static_cast<int>(a)];
    const float du = direction[static_cast<int>(u)] / std::abs(along),
                dv = direction[static_cast<int>(v)] / std::abs(along);
    const int planes = m_size[a], way = along > 0.0f ? 1 : -1;
    const Step step{u, v, du, dv, 0.5f * m_voxel * std::sqrt(1.0f + du * du + dv * dv), way * m_stride[a]};
    for (int k = 0; k < planes; ++k) {
      const int plane = way > 0 ? planes - 1 - k : k;
      const std::ptrdiff_t base = plane * m_stride[a];
      const auto rows = static_cast<std::size_t>(m_size[v]);
      m_backend.forChunks("light air", rows, std::max<std::size_t>(16, rows / 4),
                          [&](std::size_t begin, std::size_t end, std::size_t) {
                            for (std::size_t row = begin; row < end; ++row)
                              sweepRow(step, base, static_cast<int>(row), k == 0, depth);
                          });
    }
  }

 private:
  struct Step {
    std::size_t u, v;
    float du, dv;       // voxels beside, per plane
    float half;         // m, of the way between planes
    std::ptrdiff_t up;  // to the plane that was swept before
  };

  void sweepRow(const Step& s, std::ptrdiff_t base, int j, bool first, std::vector<float>& depth) const {
    const int nu = m_size[s.u], nv = m_size[s.v];
    const std::ptrdiff_t su = m_stride[s.u], sv = m_stride[s.v];
    const float fv = static_cast<float>(j) + s.dv;
    const int j0 = static_cast<int>(std::floor(fv));
    const float wv = fv - static_cast<float>(j0);
    for (int i = 0; i < nu; ++i) {
      const std::ptrdiff_t at = base + i * su + j * sv;
      float before = 0.0f;  // depth at the ray's place in the plane before, and half of the way from there
      if (!first) {
        const float fu = static_cast<float>(i) + s.du;
        const int i0 = static_cast<int>(std::floor(fu));
        const float wu = fu - static_cast<float>(i0);
        const auto look = [&](int x, int y, float weight) {
          if (weight <= 0.0f || x < 0 || y < 0 || x >= nu || y >= nv) return;
          const auto k = static_cast<std::size_t>(base + s.up + x * su + y * sv);
          before += weight * (depth[k] + s.half * m_extinction[k]);
        };
        look(i0, j0, (1.0f - wu) * (1.0f - wv));
        look(i0 + 1, j0, wu * (1.0f - wv));
        look(i0, j0 + 1, (1.0f - wu) * wv);
        look(i0 + 1, j0 + 1, wu * wv);
      }
      depth[static_cast<std::size_t>(at)] = before + s.half * m_extinction[static_cast<std::size_t>(at)];
    }
  }

  std::array<int, 3> m_size;
  float m_voxel;
  const std::vector<float>& m_extinction;
  CpuBackend& m_backend;
  std::array<std::ptrdiff_t, 3> m_stride{};
};

/// Sums over directions, per voxel.
struct Openness {
  std::vector<float> all, fromSky, x, y, z;

  explicit Openness(std::size_t voxels) {
    for (auto* list : {&all, &fromSky, &x, &y, &z}) list->assign(voxels, 0.0f);
  }
  void add(Vec3f d, const std::vector<float>& depth) {
    const float sky = d.z > 0.0f ? 1.0f : d.z < 0.0f ? 0.0f : 0.5f;
    for (std::size_t k = 0; k < depth.size(); ++k) {
      const float open = 1.0f / (1.0f + kTwoStream * depth[k]);
      all[k] += open;
      fromSky[k] += sky * open;
      x[k] += d.x * open;
      y[k] += d.y * open;
      z[k] += d.z * open;
    }
  }
};

/// (1 - mean cosine) times the extinction, as the mean over each voxel.
std::vector<float> reducedExtinction(const AirPart& air, const AirOptics& optics, const Box& box, int merged,
                                     const std::array<int, 3>& size) {
  std::vector<float> values(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                            static_cast<std::size_t>(size[2]));
  const auto share = static_cast<float>((1.0 - optics.phase.meanCosine()) / std::pow(merged, 3));
  for (std::size_t b = 0; b < air.bricks.size(); ++b) {
    const float* cell = optics.extinction.data() + b * kBrickCells;
    if (!anyAbove(cell)) continue;
    const std::int64_t x0 = air.bricks[b][0] * std::int64_t{kBrickX} - box.low[0],
                       y0 = air.bricks[b][1] * std::int64_t{kBrickY} - box.low[1],
                       z0 = air.bricks[b][2] * std::int64_t{kBrickZ} - box.low[2];
    for (std::int64_t z = z0; z < z0 + kBrickZ; ++z)
      for (std::int64_t y = y0; y < y0 + kBrickY; ++y) {
        float* row = values.data() + ((z / merged) * size[1] + y / merged) * size[0];
        for (std::int64_t x = x0; x < x0 + kBrickX; ++x) row[x / merged] += share * *cell++;
      }
  }
  return values;
}

struct Voxel {
  float all, fromSky;
  Vec3f out;  // sum of directions by openness
  float sun;  // share that comes through
};

/// Colour of what is scattered more than once, and of sky and ground.
Vec3f scattered(const Voxel& v, const AirSky& sky, Vec3f toSun) {
  const float mean = v.all / static_cast<float>(kDirections);
  // The less open, the more often light is scattered before it leaves.
  float several = kSeveral * v.sun * (1.0f - mean) / std::max(mean, 1e-4f);
  // A surface takes light by the cosine that the sun stands over it.
  const Vec3f out = v.out * (1.0f / (kLevelSurface * std::max(v.all, 1e-6f)));
  const float lean = length(out), sided = std::min(lean, 1.0f);
  const float cosine = lean > 1e-6f ? dot(out, toSun) / lean : 0.0f;
  several *= std::clamp(1.0f - sided + sided * cosine, 0.0f, 1.0f);
  const float above = v.fromSky / std::max(v.all, 1e-6f);
  return sky.sun.to<float>() * several + sky.sky.to<float>() * above +
         sky.bounce.to<float>() * (1.0f - above);
}

}  // namespace

AirLight lightAir(const AirPart& air, const AirOptics& optics, const AirSky& sky, std::size_t mostVoxels,
                  CpuBackend& backend) {
  AirLight light;
  Box box;
  if (optics.extinction.empty() || !boxOf(air, optics.extinction, box)) return light;
  int merged = 1;
  const auto voxels = [&](std::size_t a) { return (box.high[a] - box.low[a] + merged - 1) / merged; };
  const auto tooMany = [&] {
    return static_cast<double>(voxels(0)) * static_cast<double>(voxels(1)) * static_cast<double>(voxels(2)) >
           static_cast<double>(mostVoxels);
  };
  while (tooMany()) ++merged;
  for (std::size_t a = 0; a < 3; ++a) light.size[a] = static_cast<int>(voxels(a));
  light.voxel = air.cell * merged;
  const auto corner = [&](std::size_t a) { return static_cast<double>(box.low[a]) * air.cell; };
  light.origin = air.origin + Vec3d{corner(0), corner(1), corner(2)};
  const std::vector<float> reduced = reducedExtinction(air, optics, box, merged, light.size);
  std::vector<float> depth(reduced.size());
  const Sweeper sweeper(light.size, light.voxel, reduced, backend);
  Openness open(reduced.size());
  for (const Vec3f& d : directions()) {
    sweeper.sweep(d, depth);
    open.add(d, depth);
  }
  const bool shines = sky.toSun.z > 0.0;
  const Vec3f toSun = (shines ? sky.toSun : Vec3d{0, 0, 1}).to<float>();
  sweeper.sweep(toSun, depth);
  light.texels.resize(4 * reduced.size());
  light.through.resize(reduced.size());
  const auto nx = static_cast<std::size_t>(light.size[0]), ny = static_cast<std::size_t>(light.size[1]);
  backend.forChunks("colour air", reduced.size(), 4096, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t k = begin; k < end; ++k) {
      const Vec3d at{static_cast<double>(k % nx), static_cast<double>(k / nx % ny),
                     static_cast<double>(k / nx / ny)};
      const double share = !shines ? 0.0
                           : sky.sunShare
                               ? sky.sunShare(light.origin + (at + Vec3d{0.5, 0.5, 0.5}) * light.voxel)
                               : 1.0;
      const float through = 1.0f / (1.0f + kTwoStream * depth[k]);
      const float sun = static_cast<float>(share) * through;
      const Vec3f c =
          scattered({open.all[k], open.fromSky[k], {open.x[k], open.y[k], open.z[k]}, sun}, sky, toSun);
      std::uint16_t* texel = light.texels.data() + 4 * k;
      texel[0] = halfFromFloat(c.x);
      texel[1] = halfFromFloat(c.y);
      texel[2] = halfFromFloat(c.z);
      texel[3] = halfFromFloat(sun);
      light.through[k] = static_cast<std::uint8_t>(255.0f * through + 0.5f);
    }
  });
  return light;
}

}  // namespace spin
