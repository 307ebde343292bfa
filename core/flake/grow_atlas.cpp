// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/base/parallel.h"
#include "core/flake/flake_atlas.h"
#include "core/flake/flake_grower.h"

namespace spin {
namespace {

constexpr int kAttempts = 16;
constexpr std::size_t kSlice = 256;  // particles between two looks at cancel
constexpr int kCrystalSlice = 200;   // steps
/// Raised when the same settings grow or draw other flakes than before.
constexpr int kGrowthVersion = 1;

/// One flake of an atlas on its way.
struct Piece {
  Result<FlakePicture> picture{FlakePicture{}};
  double radius = 0.0;
};

double radiusOf(const FlakeAtlasSettings& settings, int flake) {
  const double share = (flake + 0.5) / settings.flakes;
  return settings.smallest * std::pow(settings.largest / settings.smallest, share);
}

Piece growCrystalPiece(const FlakeAtlasSettings& settings, int flake, const CancelToken& cancel) {
  CrystalSettings crystal = *settings.crystal;
  crystal.seed = settings.seed * 0x100000001b3ull + static_cast<std::uint64_t>(flake);
  Piece piece{FlakePicture{}, radiusOf(settings, flake)};
  if (Status status = checkCrystalSettings(crystal); !status) return {status.error(), 0.0};
  CrystalGrower grower(crystal);
  while (!grower.done())
    if (Status status = grower.grow(kCrystalSlice, cancel); !status) return {status.error(), 0.0};
  piece.picture = drawCrystal(grower, pictureSizeFor(settings.size));
  return piece;
}

Piece growPiece(const FlakeAtlasSettings& settings, int flake, const CancelToken& cancel) {
  if (settings.crystal) return growCrystalPiece(settings, flake, cancel);
  FlakeSettings one = settings.flake;
  one.seed = settings.seed * 0x100000001b3ull + static_cast<std::uint64_t>(flake);
  one.radius = radiusOf(settings, flake);
  auto grown = growFlake(one, settings.smallest, settings.largest, cancel);
  if (!grown) return {grown.error(), 0.0};
  return {drawFlake(grown->centres, pictureSizeFor(settings.size)), grown->radius};
}

Status checkRange(const FlakeAtlasSettings& settings) {
  const auto within = [](double r) {
    return r >= kSmallestFlake * (1.0 - 1e-6) && r <= kLargestFlake * (1.0 + 1e-6);
  };
  if (settings.flakes < 1 || settings.flakes > kMostFlakes)
    return badInput("The flake atlas cannot be made", "flakes",
                    fmt::format("{} are not between 1 and {}", settings.flakes, kMostFlakes));
  if (within(settings.smallest) && within(settings.largest) && settings.smallest <= settings.largest)
    return {};
  return badInput("The flake atlas cannot be made", "radius",
                  fmt::format("{:g} to {:g} m is no range of new snow", settings.smallest, settings.largest),
                  fmt::format("Choose radii from {:g} to {:g} mm, the smallest first", kSmallestFlake * 1e3,
                              kLargestFlake * 1e3));
}

}  // namespace

Result<GrownFlake> growFlake(FlakeSettings settings, double smallest, double largest,
                             const CancelToken& cancel) {
  const std::uint64_t seed = settings.seed;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    settings.seed = seed + 0x9e3779b97f4a7c15ull * static_cast<std::uint64_t>(attempt);
    if (Status status = checkFlakeSettings(settings); !status) return status.error();
    FlakeGrower grower(settings);
    while (!grower.done())
      if (Status status = grower.grow(kSlice, cancel); !status) return status.error();
    if (grower.radius() >= smallest && grower.radius() <= largest)
      return GrownFlake{grower.centres(), grower.radius()};
  }
  return badInput(
      "The flake cannot be grown", "radius",
      fmt::format("none of {} flakes came to between {:g} and {:g} m", kAttempts, smallest, largest),
      "Allow more particles or a wider range");
}

Result<FlakeAtlas> growFlakeAtlas(const FlakeAtlasSettings& settings, const CancelToken& cancel,
                                  const std::function<void(double)>& progress, int threads) {
  if (Status status = checkRange(settings); !status) return status.error();
  if (Status status = checkAtlasSize(settings.size); !status) return status.error();
  std::vector<Piece> pieces(static_cast<std::size_t>(settings.flakes));
  std::mutex mutex;
  int done = 0;
  CpuBackend backend(threads);
  backend.forEach(
      "grow flakes", pieces.size(),
      [&](std::size_t f) {
        pieces[f] = growPiece(settings, static_cast<int>(f), cancel);
        const std::lock_guard lock(mutex);
        if (progress) progress(static_cast<double>(++done) / settings.flakes);
      },
      1);
  std::vector<FlakePicture> pictures;
  std::vector<double> radii;
  for (Piece& piece : pieces) {
    if (!piece.picture) return piece.picture.error();
    pictures.push_back(std::move(*piece.picture));
    radii.push_back(piece.radius);
  }
  return makeFlakeAtlas(pictures, radii, settings.size, cancel);
}

Hash128 flakeAtlasKey(const FlakeAtlasSettings& settings) {
  Hasher hasher;
  hasher.add("flakes").add(kGrowthVersion).add(settings.smallest).add(settings.largest);
  hasher.add(settings.flakes).add(settings.size).add(settings.seed).add(settings.crystal.has_value());
  if (settings.crystal) {
    const CrystalSettings& c = *settings.crystal;
    const CrystalLaw& l = c.law;
    for (const double v :
         {l.vapour, l.tipMass, l.hollowMass, l.scarce, l.freezing, l.melting, l.sublimation, c.weather})
      hasher.add(v);
    hasher.add(c.cells).add(c.mostSteps);
  } else {
    const FlakeSettings& f = settings.flake;
    hasher.add(f.symmetry).add(f.particleDiameter).add(f.particles).add(f.alignment).add(f.landings);
  }
  return hasher.digest();
}

}  // namespace spin
