// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "core/base/units.h"
#include "core/flake/flake_atlas.h"
#include "core/flake/flake_grower.h"

namespace spin {
namespace {

GrownFlake flakeOf(FlakeSymmetry symmetry, double radius, std::uint64_t seed = 1) {
  FlakeSettings settings;
  settings.symmetry = symmetry;
  settings.radius = radius;
  settings.seed = seed;
  auto grown = growFlake(settings, kSmallestFlake, kLargestFlake, {});
  EXPECT_TRUE(grown.ok());
  return std::move(*grown);
}

FlakePicture pictureOf(const GrownFlake& flake, int size) {
  auto picture = drawFlake(flake.centres, size);
  EXPECT_TRUE(picture.ok());
  return std::move(*picture);
}

FlakeAtlas atlasOf(int flakes, int size) {
  std::vector<FlakePicture> pictures;
  std::vector<double> radii;
  for (int f = 0; f < flakes; ++f) {
    const GrownFlake flake = flakeOf(f % 2 ? FlakeSymmetry::Free : FlakeSymmetry::Six, 0.5e-3 + 0.3e-3 * f);
    pictures.push_back(pictureOf(flake, pictureSizeFor(size)));
    radii.push_back(flake.radius);
  }
  auto atlas = makeFlakeAtlas(pictures, radii, size, {});
  EXPECT_TRUE(atlas.ok());
  return std::move(*atlas);
}

/// Mass, centre and second moments of a layer of the finest level, in pixels from the middle.
struct Moments {
  double mass = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  void add(double m, double px, double py) {
    mass += m, x += m * px, y += m * py, xx += m * px * px, xy += m * px * py, yy += m * py * py;
  }
};
Moments momentsOf(const FlakeAtlas& atlas, int layer) {
  Moments m;
  for (int k = 0; k < atlas.size * atlas.size; ++k)
    m.add(atlas.layer(0, layer)[k] / 255.0, k % atlas.size + 0.5 - 0.5 * atlas.size,
          k / atlas.size + 0.5 - 0.5 * atlas.size);
  return m;
}

TEST(FlakePicture, CoversWhatItsDiscsCover) {
  // One disc fills the circle of the picture's radius.
  const auto one = drawFlake({{0.0, 0.0}}, 64);
  ASSERT_TRUE(one.ok());
  EXPECT_NEAR(one->total(), kPi * one->radius * one->radius, 0.01 * one->total());
  // Discs far apart cover the sum of their areas, 1.15 fat.
  const auto two = drawFlake({{-5.0, 0.0}, {5.0, 0.0}, {0.0, 3.0}}, 256);
  ASSERT_TRUE(two.ok());
  const double unit = two->radius / (5.0 + 0.575);
  EXPECT_NEAR(two->total(), 3.0 * kPi * std::pow(0.575 * unit, 2), 0.01 * two->total());
  EXPECT_GT(two->at(128, 128 + static_cast<int>(3.0 * unit)), 0.99f);
}

TEST(FlakePicture, RefusesBadSizesAndNothing) {
  for (const int size : {-1, 0, 7, kLargestPicture + 1}) EXPECT_FALSE(drawFlake({{0.0, 0.0}}, size).ok());
  EXPECT_FALSE(drawFlake({}, 64).ok());
}

TEST(FlakePicture, HalvingKeepsTheCover) {
  const FlakePicture picture = pictureOf(flakeOf(FlakeSymmetry::Six, 1e-3), 256);
  const FlakePicture half = halved(picture);
  EXPECT_EQ(half.size, 128);
  EXPECT_NEAR(4.0 * half.total() / picture.total(), 1.0, 1e-6);
}

TEST(FlakeRotation, IsARotationAndClosesToALoop) {
  double largest = 0.0;
  for (int k = 0; k < kFlakeFrames; ++k) {
    const FlakeRotation r = flakeRotation(k), next = flakeRotation(k + 1);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(dot(r[a], r[b]), a == b ? 1.0 : 0.0, 1e-14);
    EXPECT_NEAR(dot(cross(r[0], r[1]), r[2]), 1.0, 1e-14);
    EXPECT_GE(r[2].z, 0.5 - 1e-12);  // never steeper than 60 degrees
    const double trace = dot(r[0], next[0]) + dot(r[1], next[1]) + dot(r[2], next[2]);
    largest = std::max(largest, std::acos(std::clamp(0.5 * (trace - 1.0), -1.0, 1.0)));
    for (int other = 0; other < k; ++other) {
      double difference = 0.0;
      for (std::size_t a = 0; a < 3; ++a) difference += length(r[a] - flakeRotation(other)[a]);
      EXPECT_GT(difference, 0.1);
    }
  }
  EXPECT_LT(radiansToDegrees(largest), 30.0);
  const FlakeRotation first = flakeRotation(0), last = flakeRotation(kFlakeFrames);
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(length(first[a] - last[a]), 0.0, 1e-14);
}

/// Every frame is the flake turned in space and seen along the line of sight: its cover shrinks with the
/// tilt, and its centre and second moments are carried along by the turned plane.
TEST(FlakeAtlas, FramesAreRotationsOfEachOther) {
  const GrownFlake flake = flakeOf(FlakeSymmetry::Free, 1.5e-3);
  const FlakePicture picture = pictureOf(flake, 512);
  const auto atlas = makeFlakeAtlas({picture}, {flake.radius}, 128, {});
  ASSERT_TRUE(atlas.ok());
  Moments own;
  for (int k = 0; k < 512 * 512; ++k) {
    const double scale = (64.0 - 1.0) / picture.radius;
    own.add(static_cast<double>(picture.cover[static_cast<std::size_t>(k)]) * scale * scale,
            scale * (k % 512 + 0.5 - 256.0), scale * (k / 512 + 0.5 - 256.0));
  }
  for (int frame = 0; frame < kFlakeFrames; ++frame) {
    const FlakeRotation r = flakeRotation(frame);
    const Moments seen = momentsOf(*atlas, frame);
    const double a = r[0].x, b = r[0].y, c = r[1].x, d = r[1].y;
    EXPECT_NEAR(seen.mass / (own.mass * r[2].z), 1.0, 0.02) << frame;
    const double share = seen.mass / own.mass;
    EXPECT_NEAR(seen.x, share * (a * own.x + b * own.y), 0.1 * seen.mass);
    EXPECT_NEAR(seen.y, share * (c * own.x + d * own.y), 0.1 * seen.mass);
    const double spread = own.xx + own.yy;
    EXPECT_NEAR(seen.xx, share * (a * a * own.xx + 2 * a * b * own.xy + b * b * own.yy),
                0.02 * share * spread);
    EXPECT_NEAR(seen.yy, share * (c * c * own.xx + 2 * c * d * own.xy + d * d * own.yy),
                0.02 * share * spread);
    EXPECT_NEAR(seen.xy, share * (a * c * own.xx + (a * d + b * c) * own.xy + b * d * own.yy),
                0.02 * share * spread);
  }
}

TEST(FlakeAtlas, MipLevelsKeepTheCoverOfEveryFrame) {
  const FlakeAtlas atlas = atlasOf(3, 64);
  ASSERT_EQ(atlas.levels.size(), 7u);
  for (int layer = 0; layer < atlas.layers(); ++layer) {
    double finest = 0.0;
    for (std::size_t level = 0; level < atlas.levels.size(); ++level) {
      const int n = atlas.sizeOf(level);
      ASSERT_EQ(atlas.levels[level].size(),
                static_cast<std::size_t>(atlas.layers()) * static_cast<std::size_t>(n * n));
      double mean = 0.0;
      for (int k = 0; k < n * n; ++k) mean += atlas.layer(level, layer)[k] / static_cast<double>(n * n);
      if (level == 0) finest = mean;
      EXPECT_NEAR(mean, finest, 0.5 + 1e-4) << "8-bit steps, layer " << layer << " level " << level;
    }
    EXPECT_GT(finest, 4.0);
  }
}

TEST(FlakeAtlas, FramesStayClearOfTheirRims) {
  const FlakeAtlas atlas = atlasOf(2, 64);
  for (int layer = 0; layer < atlas.layers(); ++layer)
    for (int k = 0; k < 64; ++k)
      for (const int at : {k, 63 * 64 + k, 64 * k, 64 * k + 63}) EXPECT_LE(atlas.layer(0, layer)[at], 2);
}

TEST(FlakeAtlas, ComesBackFromItsBytes) {
  const FlakeAtlas atlas = atlasOf(2, 32);
  ByteWriter out;
  saveFlakeAtlas(atlas, out);
  ByteReader in(out.bytes().data(), out.bytes().size());
  const auto read = loadFlakeAtlas(in);
  ASSERT_TRUE(read.ok());
  EXPECT_TRUE(in.atEnd());
  EXPECT_EQ(read->size, atlas.size);
  EXPECT_EQ(read->radii, atlas.radii);
  EXPECT_EQ(read->levels, atlas.levels);
}

TEST(FlakeAtlas, DamagedBytesAreRefused) {
  ByteWriter out;
  saveFlakeAtlas(atlasOf(1, 8), out);
  const std::vector<char> good = out.bytes();
  const auto reads = [](const std::vector<char>& bytes) {
    ByteReader in(bytes.data(), bytes.size());
    return loadFlakeAtlas(in).ok();
  };
  ASSERT_TRUE(reads(good));
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_FALSE(reads({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
  // Every byte before the pixels matters: magic, version, size, numbers of radii and of pixels; a radius only
  // where it leaves its range.
  const auto with = [&](std::size_t at, const auto& value) {
    std::vector<char> bytes = good;
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return bytes;
  };
  for (std::size_t at : {0u, 4u, 8u}) EXPECT_FALSE(reads(with(at, std::uint32_t{0xffffffffu})));
  EXPECT_FALSE(reads(with(8, std::uint32_t{0})));
  EXPECT_FALSE(reads(with(8, std::uint32_t{16})));
  EXPECT_FALSE(reads(with(12, std::uint64_t{1} << 61)));
  for (const float radius : {0.0f, -1e-3f, 1.0f, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_FALSE(reads(with(20, radius)));
  EXPECT_FALSE(reads(with(24, std::uint64_t{17})));
}

TEST(FlakeAtlas, RefusesBadSizes) {
  const FlakePicture picture = pictureOf(flakeOf(FlakeSymmetry::Free, 0.3e-3), 64);
  for (const int size : {-64, 0, 4, 48, 1024})
    EXPECT_FALSE(makeFlakeAtlas({picture}, {1e-3}, size, {}).ok()) << size;
  EXPECT_FALSE(makeFlakeAtlas({}, {}, 64, {}).ok());
  EXPECT_FALSE(makeFlakeAtlas({picture}, {}, 64, {}).ok());
  EXPECT_FALSE(makeFlakeAtlas({picture}, {1.0}, 64, {}).ok());
  EXPECT_FALSE(makeFlakeAtlas({FlakePicture{}}, {1e-3}, 64, {}).ok());
  EXPECT_FALSE(makeFlakeAtlas(std::vector<FlakePicture>(kMostFlakes + 1, picture),
                              std::vector<double>(kMostFlakes + 1, 1e-3), 8, {})
                   .ok());
  FlakeAtlasSettings settings;
  settings.flakes = 0;
  EXPECT_FALSE(growFlakeAtlas(settings, {}, {}).ok());
  settings.flakes = 1;
  settings.largest = 0.1e-3;
  EXPECT_FALSE(growFlakeAtlas(settings, {}, {}).ok());
}

TEST(FlakeAtlas, GrownOnesSpreadOverTheirSizes) {
  FlakeAtlasSettings settings;
  settings.flakes = 5;
  settings.size = 16;
  settings.smallest = 0.1e-3, settings.largest = 0.8e-3;
  double last = -1.0;
  const auto atlas = growFlakeAtlas(settings, {}, [&](double progress) {
    EXPECT_GT(progress, last);
    last = progress;
  });
  ASSERT_TRUE(atlas.ok());
  EXPECT_EQ(last, 1.0);
  ASSERT_EQ(atlas->flakes(), 5);
  for (std::size_t f = 0; f < 5; ++f) {
    EXPECT_GE(atlas->radii[f], 0.1e-3f);
    EXPECT_LE(atlas->radii[f], 0.8e-3f);
    if (f == 0) continue;
    EXPECT_GT(atlas->radii[f], atlas->radii[f - 1]);
  }
  const auto again = growFlakeAtlas(settings, {}, {});
  EXPECT_EQ(again->levels, atlas->levels);
}

TEST(FlakeAtlas, IsCancelledWithinASecond) {
  FlakeAtlasSettings settings;
  settings.flakes = kMostFlakes;
  settings.size = kLargestAtlas;
  settings.smallest = settings.largest = kLargestFlake * 0.99;
  settings.smallest *= 0.9;
  const CancelToken cancel;
  std::chrono::steady_clock::time_point asked;
  std::thread stop([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    asked = std::chrono::steady_clock::now();
    cancel.cancel();
  });
  const auto atlas = growFlakeAtlas(settings, cancel, {});
  const auto stopped = std::chrono::steady_clock::now();
  stop.join();
  ASSERT_FALSE(atlas.ok());
  EXPECT_EQ(atlas.error().kind, ErrorKind::Cancelled);
  RecordProperty("milliseconds",
                 static_cast<int>(std::chrono::duration<double, std::milli>(stopped - asked).count()));
  EXPECT_LT(std::chrono::duration<double>(stopped - asked).count(), 1.0);
}

}  // namespace
}  // namespace spin
