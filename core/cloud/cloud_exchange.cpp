// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_exchange.h"

#include <algorithm>
#include <cmath>

#include "core/cloud/spray.h"
#include "core/physics/humid_air.h"
#include "core/physics/spray_birth.h"
#include "core/sph/flow_setup.h"

namespace spin {
namespace {

/// Share of the bulk's neighbours from which a place is in the flow.
constexpr double kDenseShare = 0.35;
/// A parcel of less mass than this share of a particle is taken in by one that is there.
constexpr double kWholeShare = 0.5;
/// A parcel that has frayed to this share of a particle is mist altogether.
constexpr double kLeastShare = 0.005;
/// Stanton number of a rough surface of water in air: heat given over that of the air that passes (between
/// 1e-3 of a calm sea and 1e-2 of fully rough walls).
constexpr double kStanton = 5e-3;
/// A particle at the surface stands in the air with half of a ball of one spacing.
constexpr double kExposedHalf = 0.5;
/// kg/m3 of what settles: soft rime (100 to 300, Macklin 1962), and dust of powder, as fresh snow that the
/// wind has broken.
constexpr double kRimeDensity = 200.0, kDustDensity = 150.0;

Vec3d asFloats(Vec3d v) {
  return v.to<float>().to<double>();
}

}  // namespace

CloudExchange::CloudExchange(const CloudPart& part, CloudState& state) : m_part(part), m_state(state) {}

Result<AirStep> CloudExchange::run() {
  if (m_part.flow) {
    look();
    m_cells.emplace(m_samples, m_part.config.support());
    if (m_part.settings.spray) {
      leaveFlow();
      throwUp();
    }
    giveMist();
  }
  if (Status dragged = drag(); !dragged) return dragged.error();
  fray();
  if (Status warmed = warm(); !warmed) return warmed.error();
  fly();
  if (Status handed = handOver(); !handed) return handed.error();
  const Result<AirStep> done = m_part.air.step(m_part.seconds());
  if (done) takeDeposits();
  ++m_state.part;
  return done;
}

void CloudExchange::takeBack(const std::vector<FlowParticle>& refused) {
  CloudAccount& account = m_state.account;
  for (const FlowParticle& p : refused) {
    const double mass = kilograms(unitsGiven(1.0) - unitsGiven(p.given), p.material);
    account.toFlow -= mass;
    account.impulseFromFlow += p.velocity * mass;
    account.impulseToSpray += p.velocity * mass;
    lie(p.position, mass, isSnow(materialOf(p.material)), materialOf(p.material).restDensity);
  }
  if (!m_part.cover) return;
  for (const SnowGrain& grain : m_part.cover->refused) {
    account.settled -= grain.kilograms;
    account.onThings += grain.kilograms;
  }
  m_part.cover->refused.clear();
}

double CloudExchange::dragRate(const Touched& t) const {
  const FlowParticle& p = sampleOf(t).particle;
  const double speed = length(t.velocity - t.wind), density = materialOf(p.material).restDensity;
  const CarrierAir& air = m_part.surrounding.carrier;
  if (t.free) return sphereDragRate(lumpOf(p.material), density, speed, air);
  return kExposedHalf * sphereDragRate(m_part.config.spacing, density, speed, air);
}

/// Air with surface particles and spray: what one loses the other gains.
Status CloudExchange::drag() {
  std::vector<AirDrag> all;
  std::vector<std::size_t> touched;
  for (std::size_t k = 0; k < m_touched.size(); ++k) {
    const Touched& t = m_touched[k];
    if (t.taken || t.kind == FlowClass::Main) continue;
    all.push_back({sampleOf(t).particle.position, t.velocity, leftOf(t), dragRate(t)});
    touched.push_back(k);
  }
  std::vector<Vec3d> places;
  for (const SprayParcel& p : m_state.parcels) places.push_back(p.position);
  const std::vector<Vec3d> winds = m_part.air.velocities(places);
  const double seconds = m_part.seconds();
  for (std::size_t k = 0; k < m_state.parcels.size(); ++k) {
    SprayParcel& p = m_state.parcels[k];
    const double density = materialOf(p.material).restDensity;
    const double lift = 1.0 - m_part.surrounding.carrier.density / density;
    const double speed = length(p.velocity - winds[k]);
    tear(p, speed);
    const double rate = sphereDragRate(p.diameter, density, speed, m_part.surrounding.carrier);
    p.velocity += m_part.config.gravity * (lift * seconds);
    all.push_back({p.position, p.velocity, massOf(p), rate});
  }
  if (all.empty()) return {};
  const std::vector<AirDrag> before = all;
  if (Status dragged = m_part.air.drag(all, seconds); !dragged) return dragged;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Vec3d toAir = (before[k].velocity - all[k].velocity) * all[k].mass;
    m_state.account.impulseToAir += toAir;
    if (k < touched.size()) {
      m_touched[touched[k]].velocity = asFloats(all[k].velocity);
      m_state.account.impulseFromFlow += toAir;
    } else {
      m_state.parcels[k - touched.size()].velocity = all[k].velocity;
      m_state.account.impulseToSpray += -toAir;
    }
  }
  return {};
}

/// The air tears lumps of water to the drops that it leaves whole.
void CloudExchange::tear(SprayParcel& parcel, double speed) const {
  const FlowMaterialConfig& material = materialOf(parcel.material);
  const double whole = dropOf(parcel.material, speed);
  if (isSnow(material) || !(parcel.diameter > whole)) return;
  const double takes =
      breakUpTime(parcel.diameter, speed, material.restDensity, m_part.surrounding.carrier.density);
  parcel.diameter = whole + (parcel.diameter - whole) * std::exp(-m_part.seconds() / takes);
}

/// Water and its drops against the air that they are in, and what of them has gone into it.
Status CloudExchange::warm() {
  std::vector<WaterContact> contacts = std::move(m_mixing);
  const std::size_t mixing = contacts.size();
  std::vector<Touched*> touched;
  std::vector<SprayParcel*> parcels;
  if (m_part.settings.waterWarms) {
    contactsOfFlow(contacts, touched);
    contactsOfSpray(contacts, parcels);
  }
  if (contacts.empty()) return {};
  const Result<ContactEffect> effect = exchangeHeat(contacts, m_part.air, m_part.settings.waterTemperature,
                                                    m_part.surrounding, m_part.seconds());
  if (!effect) return effect.error();
  m_sources.insert(m_sources.end(), effect->sources.begin(), effect->sources.end());
  for (std::size_t k = mixing; k < contacts.size(); ++k) {
    const double vapour = effect->vapour[k];
    const auto units = static_cast<std::int64_t>(std::llround(vapour / contacts[k].quantum));
    const Vec3d impulse = contacts[k].velocity * vapour;
    m_state.account.toAir += vapour;
    m_state.account.impulseToAir += impulse;
    if (k - mixing < touched.size()) {
      touched[k - mixing]->given += units;
      m_state.account.fromFlow += vapour;
      m_state.account.impulseFromFlow += impulse;
    } else {
      parcels[k - mixing - touched.size()]->units -= units;
      m_state.account.impulseToSpray += -impulse;
    }
  }
  return {};
}

void CloudExchange::contactsOfFlow(std::vector<WaterContact>& contacts, std::vector<Touched*>& touched) {
  const double area = m_part.config.spacing * m_part.config.spacing;
  const double perArea = m_part.surrounding.carrier.density * kDryAirHeat * kStanton;
  for (Touched& t : m_touched) {
    const FlowParticle& p = sampleOf(t).particle;
    if (t.taken || t.kind == FlowClass::Main || isSnow(materialOf(p.material))) continue;
    WaterContact c;
    c.position = p.position, c.velocity = t.velocity;
    c.conductance = perArea * length(t.velocity - t.wind) * area;
    c.quantum = kilograms(1, p.material);
    c.room = std::max(kilograms(t.given + unitsGiven(0.5), p.material), 0.0);
    c.most = std::max(kilograms(unitsGiven(m_part.settings.mostGiven) - t.given, p.material), 0.0);
    contacts.push_back(c);
    touched.push_back(&t);
  }
}

void CloudExchange::contactsOfSpray(std::vector<WaterContact>& contacts, std::vector<SprayParcel*>& parcels) {
  const CarrierAir& air = m_part.surrounding.carrier;
  for (SprayParcel& p : m_state.parcels) {
    const FlowMaterialConfig& material = materialOf(p.material);
    if (isSnow(material)) continue;
    const double falls = sphereTerminalSpeed(p.diameter, material.restDensity, air);
    WaterContact c;
    c.position = p.position, c.velocity = p.velocity;
    c.conductance = massOf(p) * dropHeatRate(p.diameter, material.restDensity, falls, air,
                                             m_part.surrounding.conductivity);
    c.quantum = kilograms(1, p.material);
    c.room = massOf(p), c.most = 0.5 * massOf(p);
    contacts.push_back(c);
    parcels.push_back(&p);
  }
}

/// Drops fray into mist, clumps into powder: by their surface, so that large ones take longer.
void CloudExchange::fray() {
  const AirNode& s = m_part.settings;
  const std::int64_t least = unitsGiven(kLeastShare);
  for (SprayParcel& p : m_state.parcels) {
    const bool snow = isSnow(materialOf(p.material));
    const double life = (snow ? s.clumpLife : s.sprayLife) * p.diameter / dropOf(p.material, 0.0);
    const double share = shareOfRate(1.0 / life, m_part.seconds());
    auto units = static_cast<std::int64_t>(std::llround(share * static_cast<double>(p.units)));
    if (p.units - units < least) units = p.units;
    if (units <= 0) continue;
    const Vec3d impulse = p.velocity * kilograms(units, p.material);
    m_state.account.impulseToSpray += -impulse;
    addSource(p.position, units, p.material, impulse);
    p.units -= units;
  }
  std::erase_if(m_state.parcels, [](const SprayParcel& p) { return p.units <= 0; });
}

void CloudExchange::fly() {
  const double reach = m_part.config.supportSpacings;
  const int dense = static_cast<int>(kDenseShare * (4.0 / 3.0 * kPi * reach * reach * reach)) + 1;
  const SprayWorld world{m_part.solids, m_part.flow ? &*m_cells : nullptr, m_part.box, m_part.config.spacing,
                         dense};
  std::vector<SprayParcel> flying;
  flying.reserve(m_state.parcels.size());
  for (SprayParcel& p : m_state.parcels) {
    Vec3d end;
    switch (flyOn(p, m_part.seconds(), m_part.to, world, end)) {
      case SprayEnd::Flies:
        flying.push_back(p);
        break;
      case SprayEnd::Left:
        m_state.account.sprayLeft += massOf(p);
        break;
      case SprayEnd::Landed:
        land(p, end);
        break;
      case SprayEnd::Rejoins:
        if (!absorb(p)) flowOn(p, p.velocity, 1);
        break;
    }
  }
  m_state.parcels = std::move(flying);
}

/// What is much of a particle flows on, the rest lies where it fell.
void CloudExchange::land(const SprayParcel& parcel, Vec3d hit) {
  const Vec3d normal = m_part.solids.normal(hit);
  const double into = std::min(dot(parcel.velocity, normal), 0.0);
  flowOn(parcel, parcel.velocity - normal * into, unitsGiven(kWholeShare));
}

/// The air's box is wider than that of the flow: what comes down beside the flow lies there.
void CloudExchange::flowOn(const SprayParcel& parcel, Vec3d velocity, std::int64_t least) {
  const Vec3d p = parcel.position, &low = m_part.config.domainMin, &high = m_part.config.domainMax;
  const bool inside =
      p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y && p.z < high.z;
  if (m_part.flow && inside && parcel.units >= least) {
    rejoin(parcel, velocity);
    return;
  }
  const FlowMaterialConfig& material = materialOf(parcel.material);
  lie(p, massOf(parcel), isSnow(material), material.restDensity);
}

void CloudExchange::rejoin(const SprayParcel& parcel, Vec3d velocity) {
  FlowParticle back;
  back.position = parcel.position;
  back.velocity = asFloats(velocity);
  back.material = static_cast<std::uint8_t>(parcel.material);
  back.given = static_cast<double>(unitsGiven(1.0) - parcel.units) * kGivenUnit;
  m_part.rejoining->push_back(back);
  const Vec3d impulse = back.velocity * massOf(parcel);
  m_state.account.toFlow += massOf(parcel);
  m_state.account.impulseFromFlow += -impulse;
  m_state.account.impulseToSpray += -impulse;
}

/// The nearest particle takes a small parcel in, where it has room.
bool CloudExchange::absorb(const SprayParcel& parcel) {
  if (parcel.units >= unitsGiven(kWholeShare)) return false;
  std::size_t nearest = SIZE_MAX;
  double best = m_cells->support();
  m_cells->near(parcel.position, [&](std::size_t j, Vec3d, double distance) {
    const bool taken = m_touchedOf[j] != SIZE_MAX && m_touched[m_touchedOf[j]].taken;
    if (taken || m_samples[j].particle.material != parcel.material || !(distance < best)) return;
    best = distance;
    nearest = j;
  });
  if (nearest == SIZE_MAX) return false;
  if (m_touchedOf[nearest] == SIZE_MAX) {
    const FlowParticle& p = m_samples[nearest].particle;
    m_touchedOf[nearest] = m_touched.size();
    Touched taker;
    taker.sample = nearest, taker.velocity = p.velocity, taker.given = unitsGiven(p.given);
    m_touched.push_back(taker);
  }
  Touched& t = m_touched[m_touchedOf[nearest]];
  if (t.given - parcel.units < unitsGiven(-0.9)) return false;
  const double before = leftOf(t), gain = massOf(parcel);
  const Vec3d mixed = asFloats((t.velocity * before + parcel.velocity * gain) / (before + gain));
  const Vec3d impulse = mixed * (before + gain) - t.velocity * before;
  t.velocity = mixed;
  t.given -= parcel.units;
  m_state.account.toFlow += gain;
  m_state.account.impulseFromFlow += -impulse;
  m_state.account.impulseToSpray += -impulse;
  return true;
}

Status CloudExchange::handOver() {
  std::vector<FlowExchange> changes;
  for (const Touched& t : m_touched) {
    const FlowParticle& p = sampleOf(t).particle;
    if (!t.taken && t.given == unitsGiven(p.given) && t.velocity == p.velocity) continue;
    changes.push_back({p.id, t.velocity, static_cast<double>(t.given) * kGivenUnit, t.taken});
  }
  if (m_part.flow)
    if (Status changed = m_part.flow->exchange(changes); !changed) return changed;
  return m_part.air.add(m_sources);
}

void CloudExchange::takeDeposits() {
  for (const AirDeposit& d : m_part.air.takeDeposits()) {
    if (d.snow > 0.0) lie(d.position, d.snow, true, kDustDensity);
    if (d.mist > 0.0) lie(d.position, d.mist, false, kRimeDensity);
  }
}

/// Water freezes where the air is below zero.
void CloudExchange::lie(Vec3d position, double kilograms, bool snow, double density) {
  CloudAccount& account = m_state.account;
  if (!snow && m_part.surrounding.temperature >= kZeroCelsius) {
    account.ranOff += kilograms;
  } else if (m_part.cover && m_part.solids.groundDistance(position) < 1.5 * m_part.cell) {
    account.settled += kilograms;
    m_part.cover->falling.push_back({position, kilograms, snow ? density : kRimeDensity});
  } else {
    account.onThings += kilograms;
  }
}

}  // namespace spin
