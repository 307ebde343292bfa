// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/math/noise.h"

#include <cmath>

#include "core/base/random.h"

namespace spin {
namespace {

constexpr double kFalling = 0.6;  // amplitude of an octave against the one before

/// Dot product of the offset with one of the twelve edge directions of a cube.
double latticeTerm(std::int64_t i, std::int64_t j, std::int64_t k, Vec3d d, std::uint64_t seed) {
  const UInt4 word = philox4x32({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                                 static_cast<std::uint32_t>(k), 0x6e6f6973u},
                                seed);
  const double a = word.x & 1u ? 1.0 : -1.0, b = word.x & 2u ? 1.0 : -1.0;
  switch (word.y % 3u) {
    case 0:
      return a * d.x + b * d.y;
    case 1:
      return a * d.y + b * d.z;
    default:
      return a * d.z + b * d.x;
  }
}

double fade(double t) {
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}
double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

}  // namespace

double gradientNoise(Vec3d p, std::uint64_t seed) {
  const Vec3d floorP{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3d f = p - floorP;
  const auto i = static_cast<std::int64_t>(floorP.x), j = static_cast<std::int64_t>(floorP.y),
             k = static_cast<std::int64_t>(floorP.z);
  double level[2];
  for (int dk = 0; dk < 2; ++dk) {
    double row[2];
    for (int dj = 0; dj < 2; ++dj) {
      const auto term = [&](int di) {
        return latticeTerm(i + di, j + dj, k + dk, f - Vec3d{double(di), double(dj), double(dk)}, seed);
      };
      row[dj] = mix(term(0), term(1), fade(f.x));
    }
    level[dk] = mix(row[0], row[1], fade(f.y));
  }
  return mix(level[0], level[1], fade(f.z));
}

double octaveNoise(Vec3d position, double wavelength, double shortest, std::uint64_t seed) {
  double sum = 0.0, amplitude = 1.0;
  for (std::uint64_t octave = 0; octave < 8 && (octave == 0 || wavelength >= shortest); ++octave) {
    sum += amplitude * gradientNoise(position / wavelength, seed + octave);
    amplitude *= kFalling;
    wavelength *= 0.5;
  }
  // By the sum of two amplitudes, whatever octaves are left out: grids of different cells then differ in fine
  // detail only.
  return sum / (1.0 + kFalling);
}

}  // namespace spin
