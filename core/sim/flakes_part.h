// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/flutter.h"
#include "core/physics/gust.h"
#include "core/sim/frame.h"
#include "core/sim/wind_table.h"

namespace spin {

/// How all flakes of one size have moved in the mean wind, and what they are.
struct FlakeClass {
  double diameter = 0.0;        ///< m
  double mass = 0.0;            ///< kg
  double fallSpeed = 0.0;       ///< terminal, m/s
  Vec3d way{};                  ///< since film time 0, m
  Vec3d velocity{};             ///< m/s
  double swingAmplitude = 0.0;  ///< of the flutter, m
  double swingRate = 0.0;       ///< rad/s
  double swingAngle = 0.0;      ///< its integral over film time, rad
};
inline constexpr int kFlakeClasses = 256;

/// All flakes of a frame as functions of a few numbers: where flake k is follows from its number, the way of
/// its size and the gusts (core/snow/flake_field.h), so a million flakes need no memory in a frame.
struct FallingFlakes {
  std::uint64_t seed = 0;
  std::vector<FlakeClass> classes;  ///< kFlakeClasses, small to large, see flakeClassOf()
  FlutterLaw flutter = FlutterLaw::Steady;
  double gustLength = 25.0;  ///< m
  GustState gust;
  Vec3d wind{};                               ///< mean wind, m/s
  std::shared_ptr<const WindTable> landWind;  ///< what land and models change of it; null: nothing
  double numberDensity = 0.0;                 ///< real flakes per m3; 0 = nothing falls
  double extinction = 0.0;                    ///< of the real flakes, 1/m
  double cover = 0.0;  ///< share of the circle round it that a flake hides, so that all hide that
};

/// Place of a flake among the classes, 0 .. kFlakeClasses - 1, by x = -log(1 - u), u the share of smaller
/// ones; the melted diameter is x / slope of the spectrum. Inverse: x of a place.
double flakeClassOf(double x);
double flakeClassValue(double place);

/// The flakes of a frame.
struct FlakesPart final : FramePart {
  static constexpr const char* kKind = "flakes";
  FallingFlakes flakes;

  const char* kind() const override { return kKind; }
  std::size_t memoryBytes() const override;
  void save(ByteWriter& out) const override;
  std::string firstNonFinite() const override;
  std::vector<Hash128> sharedKeys() const override;
  void saveShared(const Hash128& key, ByteWriter& out) const override;
  /// Finds the wind over land by its key among those in use; null if it is not there.
  static std::shared_ptr<FramePart> load(ByteReader& in);
};

}  // namespace spin
