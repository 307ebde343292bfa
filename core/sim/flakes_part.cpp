// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/flakes_part.h"

#include <algorithm>
#include <cmath>

#include "core/sim/shared_registry.h"

namespace spin {
namespace {

constexpr double kLargestValue = 20.0;  // of -log(1 - u): one flake in 5e8 is larger

}  // namespace

// Fall speeds go with about the cube root of x, so they are nearly linear between classes.
double flakeClassOf(double x) {
  return (kFlakeClasses - 1) * std::cbrt(std::clamp(x / kLargestValue, 0.0, 1.0));
}
double flakeClassValue(double place) {
  const double share = place / (kFlakeClasses - 1);
  return kLargestValue * share * share * share;
}

std::size_t FlakesPart::memoryBytes() const {
  return sizeof *this + flakes.classes.size() * sizeof(FlakeClass);
}

void FlakesPart::save(ByteWriter& out) const {
  out.put(flakes.seed);
  out.putArray(flakes.classes);
  out.put(static_cast<std::uint8_t>(flakes.flutter));
  out.put(flakes.gustLength);
  out.put(flakes.gust);
  out.put(flakes.wind);
  for (const double v : {flakes.numberDensity, flakes.extinction, flakes.cover}) out.put(v);
  out.put(static_cast<std::uint8_t>(flakes.landWind ? 1 : 0));
  if (flakes.landWind) out.put(registryOf<WindTable>().keyOf(flakes.landWind));
}

std::vector<Hash128> FlakesPart::sharedKeys() const {
  if (!flakes.landWind) return {};
  return {registryOf<WindTable>().keyOf(flakes.landWind)};
}

void FlakesPart::saveShared(const Hash128&, ByteWriter& out) const {
  putShared(*flakes.landWind, out);
}

std::shared_ptr<FramePart> FlakesPart::load(ByteReader& in) {
  auto part = std::make_shared<FlakesPart>();
  FallingFlakes& f = part->flakes;
  f.seed = in.get<std::uint64_t>();
  f.classes = in.getArray<FlakeClass>();
  const auto law = in.get<std::uint8_t>();
  f.flutter = static_cast<FlutterLaw>(law);
  f.gustLength = in.get<double>();
  f.gust = in.get<GustState>();
  f.wind = in.get<Vec3d>();
  for (double* v : {&f.numberDensity, &f.extinction, &f.cover}) *v = in.get<double>();
  if (in.get<std::uint8_t>() != 0) {
    f.landWind = registryOf<WindTable>().find(in.get<Hash128>());
    if (!f.landWind) return nullptr;
  }
  const bool known = law <= static_cast<std::uint8_t>(FlutterLaw::Decaying);
  const bool whole = f.classes.size() == static_cast<std::size_t>(kFlakeClasses) && f.gustLength > 0.0;
  return in.ok() && known && whole ? part : nullptr;
}

std::string FlakesPart::firstNonFinite() const {
  for (std::size_t k = 0; k < flakes.classes.size(); ++k) {
    const FlakeClass& c = flakes.classes[k];
    const double rest = c.diameter + c.mass + c.fallSpeed + c.swingAmplitude + c.swingRate + c.swingAngle;
    if (!std::isfinite(rest) || !isFinite(c.way) || !isFinite(c.velocity))
      return "way of flake class " + std::to_string(k);
  }
  const GustState& g = flakes.gust;
  if (!std::isfinite(g.strength + g.eddyWay) || !isFinite(g.carried)) return "gusts of the flakes";
  if (!std::isfinite(flakes.numberDensity + flakes.extinction + flakes.cover)) return "number of the flakes";
  return {};
}

}  // namespace spin
