// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/hash.h"
#include "core/flake/flake_picture.h"
#include "core/flake/flake_settings.h"
#include "core/sim/serialize.h"

namespace spin {

/// Frames of a flake that turns about several axes; they close to a loop.
inline constexpr int kFlakeFrames = 18;

/// Rows of an orthonormal matrix.
using FlakeRotation = std::array<Vec3d, 3>;
/// Orientation in frame k: the flake nods once about an axis of its own between 10 and 60 degrees, so that it
/// is never seen edge-on, while all turns once about the line of sight.
FlakeRotation flakeRotation(int frame);

/// Pictures of several flakes for sprites: layer = flake * kFlakeFrames + frame, each a square of `size`
/// pixels in 8 bits, with all mip levels down to one pixel. Plain arrays; a picture is read as in
/// FlakePicture.
struct FlakeAtlas {
  int size = 0;
  std::vector<float> radii;                       ///< by flake, m
  std::vector<std::vector<std::uint8_t>> levels;  ///< by mip level: all layers, one after the other

  int flakes() const { return static_cast<int>(radii.size()); }
  int layers() const { return flakes() * kFlakeFrames; }
  int sizeOf(std::size_t level) const { return size >> level; }
  const std::uint8_t* layer(std::size_t level, int layer) const {
    const auto n = static_cast<std::size_t>(sizeOf(level));
    return levels[level].data() + static_cast<std::size_t>(layer) * n * n;
  }
};

inline constexpr int kSmallestAtlas = 8, kLargestAtlas = 512, kMostFlakes = 64;

/// Fails where the frames' size is not a power of two from kSmallestAtlas to kLargestAtlas.
Status checkAtlasSize(int size);

/// Pixels of the picture that an atlas of this frame size is best made from.
inline int pictureSizeFor(int atlasSize) {
  return std::min(4 * atlasSize, kLargestPicture);
}

/// Turns pictures into an atlas. radii in m, one a picture. Fails on a size that is not a power of two from
/// kSmallestAtlas to kLargestAtlas, on none or more than kMostFlakes pictures, and on radii outside the
/// range of new snow.
Result<FlakeAtlas> makeFlakeAtlas(const std::vector<FlakePicture>& pictures, const std::vector<double>& radii,
                                  int size, const CancelToken& cancel);

/// What an atlas is grown from: flakes of one kind, their radii spread evenly over the logarithms.
struct FlakeAtlasSettings {
  FlakeSettings flake;                         ///< its radius and seed do not count
  std::optional<CrystalSettings> crystal;      ///< grown instead, where set; its seed does not count
  double smallest = 0.3e-3, largest = 2.5e-3;  ///< m
  int flakes = 8;
  int size = 64;
  std::uint64_t seed = 1;
};

/// Grows one flake whose radius lies in [smallest, largest] m: one outside is grown again with another seed.
/// Returns the centres in particle diameters and the radius reached.
struct GrownFlake {
  std::vector<Vec2d> centres;
  double radius = 0.0;  ///< m
};
Result<GrownFlake> growFlake(FlakeSettings settings, double smallest, double largest,
                             const CancelToken& cancel);

/// Grows, draws and turns all flakes, several at once on up to that many threads (0 = all there are); the
/// result does not depend on it. progress is told 0..1, from any thread but never two at once, and may be
/// empty.
Result<FlakeAtlas> growFlakeAtlas(const FlakeAtlasSettings& settings, const CancelToken& cancel,
                                  const std::function<void(double)>& progress, int threads = 0);

/// Key of what these settings grow: of all that counts and of the way of growing.
Hash128 flakeAtlasKey(const FlakeAtlasSettings& settings);

/// Writes what a scene keeps of an atlas: sizes, radii and the finest level.
void saveFlakeAtlas(const FlakeAtlas& atlas, ByteWriter& out);
/// Reads it back; every number is checked, whatever the bytes are.
Result<FlakeAtlas> loadFlakeAtlas(ByteReader& in);

}  // namespace spin
