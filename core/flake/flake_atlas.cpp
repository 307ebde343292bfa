// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flake/flake_atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace spin {
namespace {

constexpr std::uint32_t kMagic = 0x414c4653, kVersion = 1;  // "SFLA"
constexpr int kSamples = 4;                                 // of a frame's pixel, per axis

Error refuse(const char* where, const std::string& why) {
  return badInput("The flake atlas cannot be made", where, why);
}

bool isNewSnow(double radius) {
  return radius >= kSmallestFlake * (1.0 - 1e-6) && radius <= kLargestFlake * (1.0 + 1e-6);  // NaN fails
}

/// Cover at a point of a picture, linear between pixel centres, 0 outside.
double coverAt(const FlakePicture& picture, double x, double y) {
  const double fx = std::floor(x - 0.5), fy = std::floor(y - 0.5);
  const double u = x - 0.5 - fx, v = y - 0.5 - fy;
  const int i = static_cast<int>(fx), j = static_cast<int>(fy);
  const auto pixel = [&](int a, int b) {
    const bool inside = a >= 0 && b >= 0 && a < picture.size && b < picture.size;
    return inside ? static_cast<double>(picture.at(a, b)) : 0.0;
  };
  return (1.0 - v) * ((1.0 - u) * pixel(i, j) + u * pixel(i + 1, j)) +
         v * ((1.0 - u) * pixel(i, j + 1) + u * pixel(i + 1, j + 1));
}

std::uint8_t toByte(double cover) {
  return static_cast<std::uint8_t>(std::clamp(cover, 0.0, 1.0) * 255.0 + 0.5);
}

/// The flake's plane seen along z: the upper left 2 x 2 of the rotation, turned round.
void drawFrame(const FlakePicture& picture, int frame, int size, std::uint8_t* out) {
  const FlakeRotation r = flakeRotation(frame);
  const double det = r[0].x * r[1].y - r[0].y * r[1].x;
  // The flake's circle fills the frame but for a pixel all round, so that the mip levels do not touch it.
  const double scale = picture.radius / (0.5 * size - 1.0), middle = 0.5 * picture.size;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      double sum = 0.0;
      for (int s = 0; s < kSamples * kSamples; ++s) {
        const double px = (x + (s % kSamples + 0.5) / kSamples - 0.5 * size) * scale;
        const double py = (y + (s / kSamples + 0.5) / kSamples - 0.5 * size) * scale;
        sum += coverAt(picture, middle + (r[1].y * px - r[0].y * py) / det,
                       middle + (r[0].x * py - r[1].x * px) / det);
      }
      *out++ = toByte(sum / (kSamples * kSamples));
    }
}

/// The picture at about four pixels to one of the frame, as the samples want it.
FlakePicture fitting(FlakePicture picture, int size) {
  while (picture.size % 2 == 0 && picture.size > kSamples * size) picture = halved(picture);
  return picture;
}

/// Levels below the first. Sums are kept in floats from level to level, so that only the last rounding of
/// each level to 8 bits is lost.
void addMipLevels(FlakeAtlas& atlas) {
  std::vector<float> finer(atlas.levels[0].begin(), atlas.levels[0].end());
  for (int n = atlas.size / 2; n >= 1; n /= 2) {
    const auto width = static_cast<std::size_t>(n);
    std::vector<float> coarser(static_cast<std::size_t>(atlas.layers()) * width * width);
    std::size_t out = 0;
    for (std::size_t row = 0; row < static_cast<std::size_t>(atlas.layers()) * width; ++row)
      for (std::size_t x = 0; x < width; ++x) {
        const float* in = finer.data() + 4 * row * width + 2 * x;
        coarser[out++] = 0.25f * (in[0] + in[1] + in[2 * width] + in[2 * width + 1]);
      }
    auto& level = atlas.levels.emplace_back();
    level.reserve(coarser.size());
    for (const float c : coarser) level.push_back(static_cast<std::uint8_t>(c + 0.5f));
    finer = std::move(coarser);
  }
}

Error cancelled() {
  return Error{ErrorKind::Cancelled, "The flake atlas was not made", "flakes", "it was cancelled", ""};
}

Status checkAtlas(int size, std::size_t flakes) {
  if (Status status = checkAtlasSize(size); !status) return status;
  if (flakes < 1 || flakes > static_cast<std::size_t>(kMostFlakes))
    return refuse("flakes", fmt::format("{} are not between 1 and {}", flakes, kMostFlakes));
  return {};
}

}  // namespace

Status checkAtlasSize(int size) {
  const bool powerOfTwo = size > 0 && (size & (size - 1)) == 0;
  if (powerOfTwo && size >= kSmallestAtlas && size <= kLargestAtlas) return {};
  return refuse(
      "size", fmt::format("{} is not a power of two between {} and {}", size, kSmallestAtlas, kLargestAtlas));
}

FlakeRotation flakeRotation(int frame) {
  const double turn = 2.0 * kPi * frame / kFlakeFrames;
  const double tilt = degreesToRadians(35.0 + 25.0 * std::sin(turn));
  const double c = std::cos(turn), s = std::sin(turn), ct = std::cos(tilt), st = std::sin(tilt);
  // Rz(turn) Rx(tilt).
  return {{{c, -s * ct, s * st}, {s, c * ct, -c * st}, {0.0, st, ct}}};
}

Result<FlakeAtlas> makeFlakeAtlas(const std::vector<FlakePicture>& pictures, const std::vector<double>& radii,
                                  int size, const CancelToken& cancel) {
  if (Status status = checkAtlas(size, pictures.size()); !status) return status.error();
  if (radii.size() != pictures.size()) return refuse("radii", "there is not one for each picture");
  FlakeAtlas atlas;
  atlas.size = size;
  const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  atlas.levels.emplace_back(pictures.size() * kFlakeFrames * pixels);
  std::uint8_t* out = atlas.levels[0].data();
  for (std::size_t f = 0; f < pictures.size(); ++f) {
    if (!isNewSnow(radii[f]))
      return refuse("radii", fmt::format("{:g} m is no radius of new snow", radii[f]));
    if (pictures[f].size < kSmallestPicture || pictures[f].cover.empty())
      return refuse("pictures", "one is empty");
    atlas.radii.push_back(static_cast<float>(radii[f]));
    const FlakePicture picture = fitting(pictures[f], size);
    for (int frame = 0; frame < kFlakeFrames; ++frame, out += pixels) {
      if (cancel.cancelled()) return cancelled();
      drawFrame(picture, frame, size, out);
    }
  }
  addMipLevels(atlas);
  return atlas;
}

void saveFlakeAtlas(const FlakeAtlas& atlas, ByteWriter& out) {
  out.put(kMagic);
  out.put(kVersion);
  out.put(static_cast<std::uint32_t>(atlas.size));
  out.putArray(atlas.radii);
  out.putArray(atlas.levels.at(0));
}

Result<FlakeAtlas> loadFlakeAtlas(ByteReader& in) {
  const auto damaged = [](const std::string& why) {
    return badInput("The flake atlas could not be read", "flakes", why, "Grow the flakes again");
  };
  if (in.get<std::uint32_t>() != kMagic) return damaged("these bytes are no atlas");
  const auto version = in.get<std::uint32_t>();
  if (version != kVersion) return damaged(fmt::format("version {} is not known", version));
  const auto size = in.get<std::uint32_t>();
  FlakeAtlas atlas;
  atlas.radii = in.getArray<float>();
  atlas.levels.push_back(in.getArray<std::uint8_t>());
  if (!in.ok()) return damaged("it ends too early");
  if (size > static_cast<std::uint32_t>(kLargestAtlas))
    return damaged(fmt::format("frames of {} pixels are too large", size));
  atlas.size = static_cast<int>(size);
  if (Status status = checkAtlas(atlas.size, atlas.radii.size()); !status) return damaged(status.error().why);
  if (atlas.levels[0].size() != static_cast<std::size_t>(atlas.layers()) * size * size)
    return damaged("its pixels do not fit its sizes");
  for (const float radius : atlas.radii)
    if (!isNewSnow(static_cast<double>(radius)))
      return damaged(fmt::format("{:g} m is no radius of new snow", radius));
  addMipLevels(atlas);
  return atlas;
}

}  // namespace spin
