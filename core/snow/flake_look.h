// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/cpu_features.h"
#include "core/physics/gust.h"

namespace spin {

/// What is told of a flake that shows.
enum class FlakeValue : std::uint8_t {
  X,
  Y,
  Z,  ///< place from the eye, m
  VX,
  VY,
  VZ,         ///< velocity, m/s
  Diameter,   ///< m
  Weight,     ///< real flakes that it stands for
  Fade,       ///< 0..1
  Character,  ///< 0..1, of its own for life
  Turn,       ///< of its spin, -0.5..0.5
  Number,     ///< of the flake, whole
};
inline constexpr std::size_t kFlakeRecord = 12;

/// What flakes keep for life, one array of floats each: phases of the two swings, turns; factors on their
/// rates; share of the amplitude along x and y; of the swing across, in shares of that; character.
inline constexpr std::size_t kFlakeSeeds = 8;

/// A flake class as the loop reads it: all floats, so that a pair is blended in one go.
struct FlakeRow {
  float velocity[3];        ///< in the mean wind, m/s
  float back[3];            ///< from the eye to where a flake that is at the eye would be without gusts, m
  float diameter;           ///< m
  float swing;              ///< amplitude of the flutter, m
  float turns, turnRate;    ///< of the flutter, turns and turns per second
  float reach[kGustModes];  ///< gustReach(), s
};
inline constexpr int kFlakeRowFloats = sizeof(FlakeRow) / sizeof(float);

/// A wave of the gusts about the eye.
struct FlakeWave {
  float wave[3], push[3];  ///< turns per metre; m/s, strength included
  float phase, turning;    ///< at the eye, turns; turns per second
};

/// What the loop over a chunk of flakes of one group reads and writes.
struct FlakeLookView {
  const std::int32_t* place[3];     ///< by flake: places without any motion, fractions of the box times 2^32
  const float* seeds[kFlakeSeeds];  ///< by flake
  const float* blockClass;          ///< by block: place among the classes
  const FlakeRow* rows;             ///< by class
  const std::array<double, 3>* centre;  ///< by class: place without motion of a flake at `back`, in boxes
  FlakeWave waves[kGustModes];
  int waveCount = 0;  ///< 0 where there are no gusts
  bool decaying = false;
  float box = 0.0f, weight = 0.0f;
  float nearFrom = 0.0f, nearTo = 0.0f, farFrom = 0.0f, farTo = 0.0f;  ///< borders, m
  bool frustum = false;
  float forward[3], right[3], up[3], tangentX = 0.0f, tangentY = 0.0f;
  float margin = 0.1f;  ///< m, by which flakes outside the frustum still count
  float share = 1.0f, leastFade = 1e-3f;
  float* out[kFlakeRecord];  ///< of the chunk
};

/// Looks at the blocks begin .. end and returns the number of flakes that show.
using FlakeLook = std::size_t (*)(const FlakeLookView& view, std::size_t begin, std::size_t end);
FlakeLook flakeLookFor(Isa isa);

}  // namespace spin
