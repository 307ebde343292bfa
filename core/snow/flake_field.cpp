// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/flake_field.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/physics/drag.h"

namespace spin {
namespace {

constexpr std::uint32_t kPlaceStream = 0x66616c6cu, kFlutterStream = 0x666c616bu;
constexpr std::size_t kChunkBlocks = 128;

/// x of the flake size whose mass is the mean of a share a .. b of all flakes, x = -log(1 - u): by it a few
/// sizes carry the whole precipitation.
double massOfShare(double a, double b) {
  const auto rest = [](double u) {
    const double x = -std::log1p(-u);
    return u >= 1.0 ? 0.0 : (1.0 - u) * (((x + 3.0) * x + 6.0) * x + 6.0);
  };
  return std::cbrt((rest(a) - rest(b)) / (b - a));
}

double turnsLeft(double turns) {
  return turns - std::floor(turns);
}

/// Waves about the eye.
int wavesAt(const FallingFlakes& flakes, const GustModes& modes, Vec3d eye, FlakeWave* waves) {
  if (!(flakes.gust.strength > 0.0)) return 0;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    const GustMode& mode = modes[m];
    for (int axis = 0; axis < 3; ++axis) {
      waves[m].wave[axis] = static_cast<float>(mode.wave[axis]);
      waves[m].push[axis] = static_cast<float>(flakes.gust.strength * mode.push[axis]);
    }
    waves[m].phase = static_cast<float>(turnsLeft(gustTurns(mode, flakes.gust, eye)));
    waves[m].turning = static_cast<float>(length(mode.wave) * kEddyTurnover * flakes.gust.strength -
                                          dot(mode.wave, flakes.wind));
  }
  return kGustModes;
}

/// The same waves backwards: from the eye to where a flake there would be without gusts.
Vec3d blownBack(const FlakeRow& row, const FlakeWave* waves, int count) {
  Vec3d p{};
  for (int m = count - 1; m >= 0; --m) {
    const FlakeWave& w = waves[m];
    const auto at = [](const float* v) { return Vec3f{v[0], v[1], v[2]}.to<double>(); };
    const double turns = dot(at(w.wave), p) + static_cast<double>(w.phase);
    p = p - at(w.push) * (static_cast<double>(row.reach[m]) * turnSine(turns));
  }
  return p;
}

FlakeRow rowOf(const FlakeClass& c, const FallingFlakes& flakes, const GustModes& modes,
               const FlakeWave* waves, int count) {
  FlakeRow row{};
  for (int axis = 0; axis < 3; ++axis) row.velocity[axis] = static_cast<float>(c.velocity[axis]);
  row.diameter = static_cast<float>(c.diameter);
  row.swing = static_cast<float>(c.swingAmplitude);
  row.turns = static_cast<float>(c.swingAngle / (2.0 * kPi));
  row.turnRate = static_cast<float>(c.swingRate / (2.0 * kPi));
  for (int m = 0; m < count; ++m)
    row.reach[m] = static_cast<float>(gustReach(modes[static_cast<std::size_t>(m)], flakes.gust.strength,
                                                c.fallSpeed, relaxationTime(c.fallSpeed, kStandardGravity)));
  const Vec3d back = blownBack(row, waves, count);
  for (int axis = 0; axis < 3; ++axis) row.back[axis] = static_cast<float>(back[axis]);
  return row;
}

/// By class: where, in boxes and without any motion, a flake is that shows at the eye.
std::vector<std::array<double, 3>> centresOf(const FallingFlakes& flakes, const std::vector<FlakeRow>& rows,
                                             Vec3d eye, double box) {
  std::vector<std::array<double, 3>> centres;
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const Vec3d back = Vec3f{rows[c].back[0], rows[c].back[1], rows[c].back[2]}.to<double>();
    const Vec3d p = (eye + back - flakes.classes[c].way) / box;
    centres.push_back({p.x, p.y, p.z});
  }
  return centres;
}

/// A flake may reach a little way in from outside, and be blown in.
double marginOf(const FlakeGroup& group, const FlakeView& view, Vec3d place) {
  constexpr double kReach = 0.1;  // m
  return view.wind ? kReach + view.wind->spread(place, 0.5 * group.box) : kReach;
}

/// place: where the eye looks from without the wind round land.
void setGroup(const FlakeGroup& group, const FlakeView& from, Vec3d place, FlakeLookView& view) {
  const auto at = [](double v) { return static_cast<float>(v); };
  view.box = at(group.box);
  if (view.frustum) view.margin = at(marginOf(group, from, place));
  // In light snow a group has more flakes than there are: only as many are shown, each of its own size.
  const double real = from.leastFade < 0.0 ? 1.0 : std::min(group.weight, 1.0);
  view.weight = at(group.weight / real);
  // Ranks lie in 0..1, both included.
  const double share = from.share * real;
  view.share = share < 1.0 ? at(share) : 2.0f;
  // Without a border in front all distances lie beyond it.
  view.nearFrom = group.nearest > 0.0 ? at(group.nearest * (1.0 - kGroupBlend)) : -2.0f;
  view.nearTo = group.nearest > 0.0 ? at(group.nearest * (1.0 + kGroupBlend)) : -1.0f;
  view.farFrom = at(group.farthest * (1.0 - kGroupBlend));
  view.farTo = at(group.farthest * (1.0 + kGroupBlend));
}

void setView(const FlakeView& from, FlakeLookView& view) {
  for (int axis = 0; axis < 3; ++axis) {
    view.forward[axis] = static_cast<float>(from.forward[axis]);
    view.right[axis] = static_cast<float>(from.right[axis]);
    view.up[axis] = static_cast<float>(from.up[axis]);
  }
  view.frustum = from.tangentX > 0.0 && from.tangentY > 0.0;
  view.tangentX = static_cast<float>(from.tangentX);
  view.tangentY = static_cast<float>(from.tangentY);
  view.leastFade = static_cast<float>(from.leastFade);
}

/// Takes flakes that were seen from a place without the wind round land to where they are with it, as seen
/// from the eye.
void blowRoundLand(const FlakeView& view, Vec3d place, CpuBackend& backend, FlakeRecords& seen) {
  const Vec3d apart = place - view.eye;
  float* const at[] = {seen.values[0], seen.values[1], seen.values[2]};
  float* const velocity[] = {seen.values[3], seen.values[4], seen.values[5]};
  backend.forEach("flakes round land", seen.count, [&](std::size_t k) {
    const Vec3d p = place + Vec3f{at[0][k], at[1][k], at[2][k]}.to<double>();
    const Vec3d v = Vec3f{velocity[0][k], velocity[1][k], velocity[2][k]}.to<double>();
    const Vec3d moved = view.wind->shiftAt(p) + apart, faster = view.wind->velocityAt(p, v);
    for (int axis = 0; axis < 3; ++axis) {
      at[axis][k] += static_cast<float>(moved[axis]);
      velocity[axis][k] += static_cast<float>(faster[axis]);
    }
  });
}

}  // namespace

struct FlakeField::Seeds {
  Columns<std::int32_t, 3> place;
  Columns<float, kFlakeSeeds> seeds;
  std::vector<float> blockClass;
  struct Chunk {
    std::size_t group, begin, end;  ///< blocks
    std::size_t firstFlake() const { return begin * kFlakeBlock; }
  };
  std::vector<Chunk> chunks;

  void addGroup(std::size_t group, std::uint32_t blocks) {
    const std::size_t first = blockClass.size();
    for (std::uint32_t b = 0; b < blocks; ++b) {
      const double x = massOfShare(static_cast<double>(b) / blocks, (b + 1.0) / blocks);
      // The last class has no successor to blend with.
      blockClass.push_back(static_cast<float>(std::min(flakeClassOf(x), kFlakeClasses - 1.0 - 1e-3)));
    }
    for (std::size_t b = 0; b < blocks; b += kChunkBlocks)
      chunks.push_back({group, first + b, first + std::min<std::size_t>(b + kChunkBlocks, blocks)});
  }

  void draw(std::uint64_t seed, std::size_t k) {
    const CounterRandom places{seed, kPlaceStream}, flutters{seed, kFlutterStream};
    const UInt4 a = places.words(k, 0);
    place[0][k] = static_cast<std::int32_t>(a.x);
    place[1][k] = static_cast<std::int32_t>(a.y);
    place[2][k] = static_cast<std::int32_t>(a.z);
    const Flutter f = drawFlutter(flutters, k);
    const double main = f.swing * f.mainShare;
    const double values[kFlakeSeeds] = {f.phases.x / (2.0 * kPi),
                                        f.phases.y / (2.0 * kPi),
                                        f.rates.x,
                                        f.rates.y,
                                        main * f.heading.x,
                                        main * f.heading.y,
                                        std::sqrt(1.0 - f.mainShare * f.mainShare) / f.mainShare,
                                        static_cast<double>(toUnitFloat(a.w))};
    for (std::size_t v = 0; v < kFlakeSeeds; ++v) seeds[v][k] = static_cast<float>(values[v]);
  }
};

FlakeField::FlakeField(std::uint64_t seed, const std::vector<FlakeGroup>& groups)
    : m_seed(seed), m_size(flakeCountOf(groups)), m_seeds(std::make_unique<Seeds>()) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    m_blocks.push_back(groups[g].blocks);
    m_seeds->addGroup(g, groups[g].blocks);
  }
  m_seeds->place.reserve(m_size);
  m_seeds->seeds.reserve(m_size);
  CpuBackend backend;
  backend.forEach("flake seeds", m_size, [this](std::size_t k) { m_seeds->draw(m_seed, k); });
}
FlakeField::~FlakeField() = default;

bool FlakeField::fits(std::uint64_t seed, const std::vector<FlakeGroup>& groups) const {
  return seed == m_seed &&
         std::equal(groups.begin(), groups.end(), m_blocks.begin(), m_blocks.end(),
                    [](const FlakeGroup& g, std::uint32_t blocks) { return g.blocks == blocks; });
}

double FlakeField::classOf(std::size_t flake) const {
  return static_cast<double>(m_seeds->blockClass.at(flake / kFlakeBlock));
}

void FlakeField::look(const FallingFlakes& flakes, const std::vector<FlakeGroup>& groups,
                      const FlakeView& view, CpuBackend& backend, FlakeRecords& seen, Isa isa) const {
  SPIN_CHECK(fits(flakes.seed, groups), "the flakes are of another field");
  SPIN_CHECK(flakes.classes.size() == static_cast<std::size_t>(kFlakeClasses), "flakes without classes");
  const GustModes modes = makeGustModes(flakes.seed, flakes.gustLength);
  const Vec3d eye = view.wind ? view.wind->before(view.eye) : view.eye;
  FlakeLookView base{};
  base.waveCount = wavesAt(flakes, modes, eye, base.waves);
  base.decaying = flakes.flutter == FlutterLaw::Decaying;
  setView(view, base);
  std::vector<FlakeRow> rows;
  for (const FlakeClass& c : flakes.classes)
    rows.push_back(rowOf(c, flakes, modes, base.waves, base.waveCount));
  std::vector<std::vector<std::array<double, 3>>> centres;
  std::vector<FlakeLookView> views;
  for (const FlakeGroup& group : groups) {
    centres.push_back(centresOf(flakes, rows, eye, group.box));
    FlakeLookView& in = views.emplace_back(base);
    setGroup(group, view, eye, in);
    for (std::size_t a = 0; a < 3; ++a) in.place[a] = m_seeds->place[a];
    for (std::size_t v = 0; v < kFlakeSeeds; ++v) in.seeds[v] = m_seeds->seeds[v];
    in.blockClass = m_seeds->blockClass.data();
    in.rows = rows.data();
  }
  for (std::size_t g = 0; g < views.size(); ++g) views[g].centre = centres[g].data();
  const FlakeLook loop = flakeLookFor(isa);
  seen.values.reserve(m_size);
  std::vector<std::size_t> counts(m_seeds->chunks.size());
  backend.forEach(
      "flakes", counts.size(),
      [&](std::size_t c) {
        const Seeds::Chunk& chunk = m_seeds->chunks[c];
        FlakeLookView in = views[chunk.group];
        // A chunk writes to the places of its own flakes: packs are stored whole, but never ahead of it.
        for (std::size_t k = 0; k < kFlakeRecord; ++k) in.out[k] = seen.values[k] + chunk.firstFlake();
        counts[c] = loop(in, chunk.begin, chunk.end);
      },
      1);
  close(counts, backend, seen);
  if (view.wind) blowRoundLand(view, eye, backend, seen);
}

/// Moves what the chunks wrote together, in order.
void FlakeField::close(const std::vector<std::size_t>& counts, CpuBackend& backend,
                       FlakeRecords& seen) const {
  backend.forEach(
      "flakes seen", kFlakeRecord,
      [&](std::size_t k) {
        float* const values = seen.values[k];
        std::size_t to = 0;
        for (std::size_t c = 0; c < counts.size(); to += counts[c++]) {
          const float* from = values + m_seeds->chunks[c].firstFlake();
          if (from != values + to) std::copy(from, from + counts[c], values + to);
        }
      },
      1);
  seen.count = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

FlakeClass flakeAt(const FallingFlakes& flakes, double place) {
  const auto lower = std::min(static_cast<std::size_t>(std::max(place, 0.0)), flakes.classes.size() - 2);
  const FlakeClass &a = flakes.classes[lower], &b = flakes.classes[lower + 1];
  const double t = place - static_cast<double>(lower);
  const auto mix = [t](auto x, auto y) { return x + (y - x) * t; };
  return {mix(a.diameter, b.diameter),   mix(a.mass, b.mass),
          mix(a.fallSpeed, b.fallSpeed), mix(a.way, b.way),
          mix(a.velocity, b.velocity),   mix(a.swingAmplitude, b.swingAmplitude),
          mix(a.swingRate, b.swingRate), mix(a.swingAngle, b.swingAngle)};
}

ParticleSet flakesAround(const FallingFlakes& flakes, const SnowfallNode& snowfall, Vec3d eye,
                         CpuBackend& backend) {
  ParticleSet set;
  set.name = "flakes";
  set.attributes = {
      {"velocity", "m/s", 3, {}}, {"diameter", "m", 1, {}}, {"mass", "kg", 1, {}}, {"weight", "", 1, {}}};
  const std::vector<FlakeGroup> groups = flakeGroups(snowfall, flakes.numberDensity);
  if (groups.empty() || !(flakes.numberDensity > 0.0)) return set;
  const FlakeField field(flakes.seed, groups);
  FlakeRecords seen;
  const std::shared_ptr<const FallWind> wind = FallWind::of(flakes, backend);
  FlakeView view;
  view.eye = eye;
  view.wind = wind.get();
  field.look(flakes, groups, view, backend, seen);
  for (std::size_t k = 0; k < seen.count; ++k) {
    const auto value = [&](FlakeValue v) { return seen[v][k]; };
    const auto id = static_cast<std::size_t>(value(FlakeValue::Number));
    const Vec3d p{value(FlakeValue::X), value(FlakeValue::Y), value(FlakeValue::Z)};
    set.ids.push_back(id);
    set.positions.push_back((eye + p).to<float>());
    for (const FlakeValue v : {FlakeValue::VX, FlakeValue::VY, FlakeValue::VZ})
      set.attributes[0].values.push_back(value(v));
    set.attributes[1].values.push_back(value(FlakeValue::Diameter));
    set.attributes[2].values.push_back(static_cast<float>(flakeAt(flakes, field.classOf(id)).mass));
    set.attributes[3].values.push_back(value(FlakeValue::Weight));
  }
  return set;
}

}  // namespace spin
