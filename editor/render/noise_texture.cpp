// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/noise_texture.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/math/vec.h"

namespace spin {
namespace {

constexpr CounterRandom kRandom{20260101, 7};

std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// Gradient noise with `period` cells over the tile.
float gradientNoise(float u, float v, int period, std::uint32_t layer) {
  const float x = u * static_cast<float>(period), y = v * static_cast<float>(period);
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const auto corner = [&](int a, int b) {
    const auto index = static_cast<std::uint64_t>(((j + b) % period) * period + (i + a) % period);
    const float angle = 6.2831853f * kRandom.uniform(index, layer);
    return std::cos(angle) * (fx - static_cast<float>(a)) + std::sin(angle) * (fy - static_cast<float>(b));
  };
  const auto fade = [](float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); };
  const float a = std::lerp(corner(0, 0), corner(1, 0), fade(fx));
  const float b = std::lerp(corner(0, 1), corner(1, 1), fade(fx));
  return std::lerp(a, b, fade(fy));
}

float layered(int i, int j) {
  const float u = (static_cast<float>(i) + 0.5f) / kNoiseSize,
              v = (static_cast<float>(j) + 0.5f) / kNoiseSize;
  float sum = 0.0f, weight = 1.0f;
  std::uint32_t layer = 0;
  for (int period = 8; period <= 64; period *= 2, weight *= 0.55f)
    sum += weight * gradientNoise(u, v, period, layer++);
  return 0.5f + 0.5f * sum;
}

}  // namespace

std::vector<std::uint8_t> makeNoiseTile() {
  std::vector<float> height(kNoiseSize * kNoiseSize);
  for (int j = 0; j < kNoiseSize; ++j)
    for (int i = 0; i < kNoiseSize; ++i) height[static_cast<std::size_t>(j * kNoiseSize + i)] = layered(i, j);
  const auto at = [&](int i, int j) {
    return height[static_cast<std::size_t>(((j + kNoiseSize) % kNoiseSize) * kNoiseSize +
                                           (i + kNoiseSize) % kNoiseSize)];
  };
  std::vector<std::uint8_t> tile;
  tile.reserve(height.size() * 4);
  for (int j = 0; j < kNoiseSize; ++j)
    for (int i = 0; i < kNoiseSize; ++i) {
      tile.push_back(toByte(at(i, j)));
      tile.push_back(toByte(0.5f + 4.0f * (at(i + 1, j) - at(i - 1, j))));
      tile.push_back(toByte(0.5f + 4.0f * (at(i, j + 1) - at(i, j - 1))));
      tile.push_back(toByte(kRandom.uniform(static_cast<std::uint64_t>(j * kNoiseSize + i), 50)));
    }
  return tile;
}

}  // namespace spin
