// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/math/sampling.h"

namespace spin {
namespace {

struct Dimension {
  int degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 3> first;
};
/// Dimensions 2 to 4 of Joe and Kuo's table; dimension 1 is the radical inverse.
constexpr std::array<Dimension, 3> kDimensions{{{1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}}};

using Directions = std::array<std::uint32_t, 32>;

Directions directionsOf(const Dimension& d) {
  Directions v{};
  for (int k = 0; k < 32; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (k < d.degree) {
      v[at] = d.first[at] << (31 - k);
      continue;
    }
    v[at] =
        v[static_cast<std::size_t>(k - d.degree)] ^ (v[static_cast<std::size_t>(k - d.degree)] >> d.degree);
    for (int i = 1; i < d.degree; ++i)
      if (d.coefficients >> (d.degree - 1 - i) & 1u) v[at] ^= v[static_cast<std::size_t>(k - i)];
  }
  return v;
}

}  // namespace

std::vector<std::array<std::uint32_t, 4>> sobolPoints(std::size_t count) {
  std::array<Directions, 4> directions;
  for (std::size_t k = 0; k < 32; ++k) directions[0][k] = 1u << (31 - k);
  for (std::size_t d = 0; d < 3; ++d) directions[d + 1] = directionsOf(kDimensions[d]);
  std::vector<std::array<std::uint32_t, 4>> points(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t d = 0; d < 4; ++d) {
      std::uint32_t word = 0;
      for (std::size_t bit = 0; bit < 32; ++bit)
        if (i >> bit & 1u) word ^= directions[d][bit];
      points[i][d] = word;
    }
  return points;
}

}  // namespace spin
