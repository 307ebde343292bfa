// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_state_io.h"

#include <algorithm>
#include <cmath>

#include "core/sph/flow_setup.h"

namespace spin {
namespace {

/// Without the bytes between members, which are anything.
struct PackedParticle {
  Vec3d position, velocity;
  double excess, given;
  std::uint32_t id, material;
};

void putParticles(const std::vector<FlowParticle>& particles, ByteWriter& out) {
  std::vector<PackedParticle> packed;
  for (const FlowParticle& p : particles)
    packed.push_back({p.position, p.velocity, p.excess, p.given, p.id, p.material});
  out.putArray(packed);
}

std::vector<FlowParticle> getParticles(ByteReader& in) {
  std::vector<FlowParticle> particles;
  for (const PackedParticle& p : in.getArray<PackedParticle>())
    particles.push_back({p.position, p.velocity, static_cast<std::uint8_t>(std::min(p.material, 255u)), p.id,
                         p.excess, p.given});
  return particles;
}

}  // namespace

void saveCloud(const FlowCoupling& coupling, const SnowFallout* cover, const AirState& air, ByteWriter& out) {
  putParticles(coupling.rejoining, out);
  putParticles(coupling.refused, out);
  out.putArray(cover ? cover->falling : std::vector<SnowGrain>());
  out.putArray(cover ? cover->refused : std::vector<SnowGrain>());
  out.putArray(air.bricks);
  out.putArray(air.values);
  for (const std::vector<float>& upper : air.upper) out.putArray(upper);
  out.put(static_cast<std::uint8_t>(air.forward));
  out.put(air.budget);
}

AirState loadCloud(ByteReader& in, FlowCoupling& coupling, SnowFallout* cover) {
  coupling.rejoining = getParticles(in);
  coupling.refused = getParticles(in);
  SnowFallout falling;
  falling.falling = in.getArray<SnowGrain>();
  falling.refused = in.getArray<SnowGrain>();
  if (cover) *cover = std::move(falling);
  AirState air;
  air.bricks = in.getArray<std::array<std::int32_t, 3>>();
  air.values = in.getArray<float>();
  for (std::vector<float>& upper : air.upper) upper = in.getArray<float>();
  air.forward = in.get<std::uint8_t>() != 0;
  air.budget = in.get<AirBudget>();
  return air;
}

bool fits(const CloudState& state, const FlowCoupling& coupling, std::size_t materials) {
  const auto particle = [&](const FlowParticle& p) {
    return isFinite(p.position) && isFinite(p.velocity) && p.material < materials && std::abs(p.given) <= 1.0;
  };
  return std::all_of(state.parcels.begin(), state.parcels.end(),
                     [&](const SprayParcel& p) {
                       return isFinite(p.position) && isFinite(p.velocity) && p.material < materials &&
                              p.diameter > 0.0 && std::isfinite(p.diameter) && std::isfinite(p.born) &&
                              p.units > 0 && p.units <= 2 * std::int64_t{unitsGiven(1.0)};
                     }) &&
         std::all_of(coupling.rejoining.begin(), coupling.rejoining.end(), particle) &&
         std::all_of(coupling.refused.begin(), coupling.refused.end(), particle);
}

}  // namespace spin
