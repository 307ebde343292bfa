// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/cloud/cloud_exchange.h"
#include "core/physics/humid_air.h"
#include "core/physics/spray_birth.h"
#include "core/sph/flow_setup.h"

/// What the flow gives to the air and to spray.
namespace spin {
namespace {

/// A parcel that is thrown up has this share of a particle.
constexpr double kThrownShare = 0.125;
/// Sideways speed of what is thrown up, share of the flow's.
constexpr double kThrownSpread = 0.15;
/// What is nearer to something solid slides on it, spacings.
constexpr double kOffGround = 1.5;
constexpr std::uint32_t kThrownStream = 0x5350;

Vec3d asFloats(Vec3d v) {
  return v.to<float>().to<double>();
}

}  // namespace

bool isSnow(const FlowMaterialConfig& material) {
  return material.rheology.frictionTangent > 0.0f;
}

double CloudExchange::leftOf(const Touched& t) const {
  return kilograms(unitsGiven(1.0) - t.given, sampleOf(t).particle.material);
}

double CloudExchange::dropOf(std::size_t material, double speed) const {
  const AirNode& s = m_part.settings;
  if (isSnow(materialOf(material))) return s.clumpDiameter;
  const double least = 4.0 * s.mistDiameter;
  return std::clamp(largestDrop(speed, m_part.surrounding.carrier.density), least,
                    std::max(s.dropDiameter, least));
}

double CloudExchange::lumpOf(std::size_t material) const {
  const AirNode& s = m_part.settings;
  if (isSnow(materialOf(material))) return s.clumpDiameter;
  return std::max(std::min(s.lumpDiameter, m_part.config.spacing), dropOf(material, 0.0));
}

bool CloudExchange::mayMake(std::size_t parcels) {
  if (m_state.parcels.size() + parcels <= static_cast<std::size_t>(m_part.settings.mostDrops)) return true;
  m_state.account.refused += parcels;
  return false;
}

void CloudExchange::makeParcel(Vec3d position, Vec3d velocity, std::int64_t units, std::size_t material,
                               double diameter) {
  SprayParcel parcel;
  parcel.position = position, parcel.velocity = velocity;
  parcel.diameter = diameter;
  parcel.born = m_part.from;
  parcel.id = m_state.nextParcel++;
  parcel.material = static_cast<std::uint32_t>(material);
  parcel.units = units;
  m_state.parcels.push_back(parcel);
  m_state.account.fromFlow += kilograms(units, material);
  m_state.account.impulseToSpray += velocity * kilograms(units, material);
}

void CloudExchange::addSource(Vec3d position, std::int64_t units, std::size_t material, Vec3d impulse) {
  const bool snow = isSnow(materialOf(material));
  const double mass = kilograms(units, material);
  AirSource source;
  source.position = position, source.impulse = impulse;
  source.amounts[static_cast<std::size_t>(snow ? AirScalar::Snow : AirScalar::Mist)] = mass;
  m_sources.push_back(source);
  // Snow has the temperature of the air that it lies in.
  if (!snow) {
    WaterContact water;
    water.position = position, water.mixes = mass * kWaterHeat;
    m_mixing.push_back(water);
  }
  m_state.account.toAir += mass;
  m_state.account.impulseToAir += impulse;
}

/// m/s; 0 where the particle came in meanwhile.
double CloudExchange::changeOf(const FlowSample& sample) const {
  if (!m_part.before) return 0.0;
  const std::optional<Vec3d> then = m_part.before->of(sample.particle.id);
  if (!then) return 0.0;
  return length(sample.particle.velocity - *then - m_part.config.gravity * m_part.seconds());
}

/// Particles at the surface, alone, or hit by something.
void CloudExchange::look() {
  m_samples = m_part.flow->samples();
  m_touchedOf.assign(m_samples.size(), SIZE_MAX);
  std::vector<Vec3d> places;
  for (std::size_t i = 0; i < m_samples.size(); ++i) {
    const FlowSample& s = m_samples[i];
    Touched t;
    t.kind = flowClassOf(m_part.config, s);
    t.stopped = changeOf(s);
    if (t.kind == FlowClass::Main && !isImpact(t.stopped)) continue;
    t.sample = i;
    t.free = t.kind == FlowClass::Isolated &&
             m_part.solids.distance(s.particle.position) > kOffGround * m_part.config.spacing;
    t.velocity = s.particle.velocity;
    t.given = unitsGiven(s.particle.given);
    m_touchedOf[i] = m_touched.size();
    m_touched.push_back(t);
    places.push_back(s.particle.position);
  }
  const std::vector<Vec3d> winds = m_part.air.velocities(places);
  for (std::size_t k = 0; k < m_touched.size(); ++k) m_touched[k].wind = winds[k];
}

void CloudExchange::giveMist() {
  for (Touched& t : m_touched)
    if (!t.taken) giveMist(t);
}

/// Shares are of what the particle has left, as exponentials of rates, so that two half parts give what a
/// whole one does.
void CloudExchange::giveMist(Touched& t) {
  const AirNode& s = m_part.settings;
  const FlowSample& sample = sampleOf(t);
  const std::size_t material = sample.particle.material;
  const bool snow = isSnow(materialOf(material));
  const double seconds = m_part.seconds();
  const double least = snow ? s.powderSpeed : s.mistSpeed, speed = length(t.velocity - t.wind);
  // Particles in slow water push each other about as hard as some that hit a rock: speed tells them apart.
  const double fast = clampedPotential(speed, least, 3.0 * least);
  const double byImpact =
      isImpact(t.stopped) ? (snow ? s.impactSnow : s.impactWater) * t.stopped / seconds * fast : 0.0;
  const double bySurface = t.kind == FlowClass::Main ? 0.0 : (snow ? s.powderRate : s.mistRate) * fast;
  const double rate = byImpact + bySurface;
  if (!(rate > 0.0)) return;
  const std::int64_t left = unitsGiven(1.0) - t.given;
  const std::int64_t allowed = std::max<std::int64_t>(unitsGiven(s.mostGiven) - t.given, 0);
  const auto wanted =
      static_cast<std::int64_t>(std::llround(shareOfRate(rate, seconds) * static_cast<double>(left)));
  const std::int64_t units = std::min(wanted, allowed);
  if (units <= 0) return;
  // The particle loses the momentum of what it gave. To slow what is left of it as well, as is published for
  // particles whose masses stay, would hand it over twice.
  const double gift = kilograms(units, material);
  const Vec3d impulse = t.velocity * gift;
  t.given += units;
  m_state.account.fromFlow += gift;
  m_state.account.impulseFromFlow += impulse;
  addSource(sample.particle.position, units, material, impulse);
}

/// What is alone and free of the ground flies on as spray.
void CloudExchange::leaveFlow() {
  for (Touched& t : m_touched) {
    const FlowSample& s = sampleOf(t);
    if (!t.free || t.given >= unitsGiven(1.0)) continue;
    if (!mayMake(1)) continue;
    t.taken = true;
    const Vec3d momentum = t.velocity * leftOf(t);
    m_state.account.impulseFromFlow += momentum;
    makeParcel(s.particle.position, t.velocity, unitsGiven(1.0) - t.given, s.particle.material,
               lumpOf(s.particle.material));
  }
}

/// 1/s, share of a particle.
double CloudExchange::birthRate(const Touched& t, const std::vector<Vec3d>& normals) const {
  const AirNode& s = m_part.settings;
  const FlowParticle& own = sampleOf(t).particle;
  const double energy = clampedPotential(0.5 * dot(t.velocity, t.velocity), s.energyLow, s.energyHigh);
  if (!(energy > 0.0)) return 0.0;
  const Vec3d normal = normals[t.sample];
  double trapped = 0.0, bend = 0.0, weights = 0.0, bends = 0.0;
  m_cells->near(own.position, [&](std::size_t j, Vec3d offset, double distance) {
    if (j == t.sample) return;
    const double w = birthWeight(distance, m_cells->support());
    trapped += w * trappedAir(own.velocity - m_samples[j].particle.velocity, -offset);
    weights += w;
    if (m_touchedOf[j] == SIZE_MAX) return;
    bend += w * crestBend(normal, normals[j], offset);
    bends += w;
  });
  if (!(weights > 0.0)) return 0.0;
  const double air = clampedPotential(trapped / weights, s.trappedLow, s.trappedHigh);
  const double crest = bends > 0.0 && goesForward(t.velocity, normal)
                           ? clampedPotential(bend / bends, s.crestLow, s.crestHigh)
                           : 0.0;
  return s.sprayRate * energy * std::min(air + crest, 1.0);
}

void CloudExchange::throwUp() {
  // Normals away from the neighbours.
  std::vector<Vec3d> normals(m_samples.size());
  for (const Touched& t : m_touched) {
    Vec3d sum{};
    m_cells->near(sampleOf(t).particle.position, [&](std::size_t, Vec3d offset, double distance) {
      sum += -offset * birthWeight(distance, m_cells->support());
    });
    normals[t.sample] = normalized(sum);
  }
  for (Touched& t : m_touched) {
    const FlowParticle& p = sampleOf(t).particle;
    if (t.taken || t.kind != FlowClass::Surface || isSnow(materialOf(p.material))) continue;
    const double rate = birthRate(t, normals);
    if (rate > 0.0) throwUp(t, rate);
  }
}

void CloudExchange::throwUp(Touched& t, double rate) {
  const FlowParticle& p = sampleOf(t).particle;
  const std::int64_t quantum = unitsGiven(kThrownShare);
  const CounterRandom random{static_cast<std::uint64_t>(m_part.seed), kThrownStream};
  const auto draw = [&](std::uint32_t k) { return random.uniformDouble(p.id, 64 * m_state.part + k); };
  const double left = 1.0 - static_cast<double>(t.given) * kGivenUnit;
  const double wanted = shareOfRate(rate, m_part.seconds()) * left / kThrownShare;
  const auto most =
      std::max<std::int64_t>(unitsGiven(m_part.settings.mostGiven) - t.given, std::int64_t{0}) / quantum;
  const auto count = std::clamp<std::int64_t>(static_cast<std::int64_t>(wanted + draw(0)), 0,
                                              std::min<std::int64_t>(most, 8));
  const Vec3d forward = normalized(t.velocity);
  const Vec3d side = normalized(cross(forward, std::abs(forward.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0}));
  const Vec3d other = cross(forward, side);
  for (std::int64_t k = 0; k < count; ++k) {
    if (!mayMake(1)) return;
    const auto at = static_cast<std::uint32_t>(4 * k + 1);
    // In a cylinder along the velocity, as theirs.
    const double radius = std::sqrt(draw(at)), angle = 2.0 * kPi * draw(at + 1);
    const Vec3d out = (side * std::cos(angle) + other * std::sin(angle)) * radius;
    const Vec3d position =
        p.position + out * (0.5 * m_part.config.spacing) +
        t.velocity * (draw(at + 2) *
                      std::min(m_part.seconds(), m_part.config.spacing / std::max(length(t.velocity), 1e-9)));
    const Vec3d thrown = t.velocity + out * (kThrownSpread * length(t.velocity));
    const double before = leftOf(t), gift = kilograms(quantum, p.material);
    const Vec3d after = asFloats((t.velocity * before - thrown * gift) / (before - gift));
    // The parcel gets just what the particle has lost.
    const Vec3d impulse = t.velocity * before - after * (before - gift);
    t.velocity = after;
    t.given += quantum;
    m_state.account.impulseFromFlow += impulse;
    makeParcel(position, impulse / gift, quantum, p.material, dropOf(p.material, length(thrown - t.wind)));
  }
}

}  // namespace spin
