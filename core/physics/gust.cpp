// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/physics/gust.h"

#include "core/base/random.h"

namespace spin {
namespace {

constexpr std::uint32_t kGustStream = 0x67757374u;

/// Three unit vectors across each other, turned at random: a uniform quaternion (Shoemake 1992).
std::array<Vec3d, 3> turnedAxes(const CounterRandom& random, std::uint64_t octave) {
  const UInt4 a = random.words(octave, 0), b = random.words(octave, 1);
  const double u = toUnitDouble(a.x, a.y), t1 = 2.0 * kPi * toUnitDouble(a.z, a.w),
               t2 = 2.0 * kPi * toUnitDouble(b.x, b.y);
  const double r1 = std::sqrt(1.0 - u), r2 = std::sqrt(u);
  const double x = r1 * std::sin(t1), y = r1 * std::cos(t1), z = r2 * std::sin(t2), w = r2 * std::cos(t2);
  return {Vec3d{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
          Vec3d{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
          Vec3d{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
}

}  // namespace

GustModes makeGustModes(std::uint64_t seed, double length) {
  const CounterRandom random{seed, kGustStream};
  std::array<double, kGustOctaves> share{};
  double whole = 0.0;
  for (int o = 0; o < kGustOctaves; ++o) {
    share[static_cast<std::size_t>(o)] = std::pow(kGustRatio, -2.0 / 3.0 * o);
    whole += share[static_cast<std::size_t>(o)];
  }
  GustModes modes;
  double before = 0.0;
  for (std::size_t o = 0; o < kGustOctaves; ++o) {
    const std::array<Vec3d, 3> axes = turnedAxes(random, o);
    const double k = std::pow(kGustRatio, static_cast<double>(o)) / length, energy = share[o] / whole;
    for (std::size_t i = 0; i < 3; ++i) {
      GustMode& mode = modes[3 * o + i];
      mode.wave = axes[i] * (axes[i].z > 0.0 ? -k : k);
      mode.push = axes[(i + 1) % 3] * std::sqrt(2.0 * energy);
      mode.phase = random.uniformDouble(o, static_cast<std::uint32_t>(2 + i));
      mode.swept = before + (i > 0 ? energy : 0.0);
    }
    before += energy;
  }
  return modes;
}

}  // namespace spin
