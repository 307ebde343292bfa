// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flake/flake_grower.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace spin {
namespace {

constexpr double kArmsOwn = 3.0;    // from the axis and its tip, where nothing but the arm grows along it
constexpr double kTipShare = 0.88;  // of the landings that the tip needs
constexpr double kLaunchGap = 1.5;  // launching circle beyond the outermost centre; 1 would touch it
constexpr double kHalfRootTwo = 0.70710678118654752, kHalfRootThree = 0.86602540378443865;
constexpr Vec2d kWallSix{kHalfRootThree, 0.5};                         // 30 degrees
constexpr Vec2d kWallEight{0.92387953251128676, 0.38268343236508977};  // 22.5 degrees

double dot2(Vec2d a, Vec2d b) {
  return a.x * b.x + a.y * b.y;
}
/// a turned by the angle of the unit vector b.
Vec2d turned(Vec2d a, Vec2d b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
double size(Vec2d a) {
  return std::sqrt(dot2(a, a));
}

/// Unit vectors of the arms; opposite and mirrored ones are equal to the bit but for signs.
std::array<Vec2d, 8> armsOf(int arms) {
  constexpr double h = kHalfRootThree, q = kHalfRootTwo;
  if (arms == 6) return {{{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}}};
  if (arms == 8) return {{{1, 0}, {q, q}, {0, 1}, {-q, q}, {-1, 0}, {-q, -q}, {0, -1}, {q, -q}}};
  return {{{1, 0}}};
}

}  // namespace

/// Random directions of one walker, by its number.
class FlakeGrower::Walk {
 public:
  Walk(std::uint64_t seed, std::uint64_t walker) : m_random{seed, 0x666c616bu}, m_walker(walker) {}

  /// Uniform on the unit circle: the square of a complex number that is uniform in the disc, normalised (von
  /// Neumann 1951, after rejection of the corners). No trigonometry, so the same bits everywhere.
  Vec2d direction() {
    for (;;) {
      const std::uint32_t word = next();
      const double a = (static_cast<double>(word >> 16) + 0.5) * 0x1p-15 - 1.0;
      const double b = (static_cast<double>(word & 0xffffu) + 0.5) * 0x1p-15 - 1.0;
      const double aa = a * a, bb = b * b, sum = aa + bb;
      if (sum > 1.0) continue;
      const double inverse = 1.0 / sum;
      return {(aa - bb) * inverse, 2.0 * a * b * inverse};
    }
  }

 private:
  std::uint32_t next() {
    if (m_left == 0) {
      const UInt4 w = m_random.words(m_walker, m_draw++);
      m_words = {w.x, w.y, w.z, w.w};
      m_left = 4;
    }
    return m_words[--m_left];
  }

  CounterRandom m_random;
  std::uint64_t m_walker;
  std::uint32_t m_draw = 0;
  std::size_t m_left = 0;
  std::array<std::uint32_t, 4> m_words{};
};

FlakeGrower::FlakeGrower(const FlakeSettings& settings)
    : m_settings(settings), m_arms(static_cast<int>(settings.symmetry)) {
  SPIN_CHECK(checkFlakeSettings(settings).ok(), "a flake of unchecked settings");
  m_turns = armsOf(m_arms);
  m_wall = m_arms == 8 ? kWallEight : kWallSix;
  plantSeed();
}

/// One particle; a ring of eight where eight arms would crowd round one.
void FlakeGrower::plantSeed() {
  if (m_arms != 8) add({});
  if (m_arms == 6) addImages({{1.0, 0.0}, true});
  if (m_arms == 8) addImages({{0.5 / kWallEight.y, 0.0}, true});
}

bool FlakeGrower::done() const {
  return radius() >= m_settings.radius || centres().size() >= static_cast<std::size_t>(m_settings.particles);
}

double FlakeGrower::progress() const {
  const double byNumber = static_cast<double>(centres().size()) / m_settings.particles;
  return std::min(std::max(byNumber, radius() / m_settings.radius), 1.0);
}

Status FlakeGrower::grow(std::size_t particles, const CancelToken& cancel) {
  const std::size_t wanted = centres().size() + particles;
  while (centres().size() < wanted && !done()) {
    if (cancel.cancelled())
      return Error{ErrorKind::Cancelled, "The flake stopped growing", "flake", "it was cancelled", ""};
    Walk walk(m_settings.seed, m_walkers++);
    Place place;
    if (settle(walkOnce(walk), place) && landedOften(place)) addImages(place);
  }
  return {};
}

FlakeGrower::Landing FlakeGrower::walkOnce(Walk& walk) const {
  const double launch = m_reach + kLaunchGap;
  Vec2d p = walk.direction() * launch;
  for (;;) {
    const Vec2d u = walk.direction();
    const double free = m_map.clearance(p) - 1.0;
    if (free >= 1.0) {
      p = p + u * free;
    } else {
      const ClusterMap::Contact contact = m_map.firstContact(p, u);
      p = p + u * contact.way;
      if (contact.disc >= 0) return {p, centres()[static_cast<std::size_t>(contact.disc)]};
    }
    const double rr = dot2(p, p);
    if (rr > launch * launch) p = returned(p, launch, walk.direction());
  }
}

/// First point on the circle of a Brownian walk from p outside it. The harmonic measure seen from a point is
/// the uniform one, carried along by the Moebius map that brings the centre to that point.
Vec2d FlakeGrower::returned(Vec2d p, double radius, Vec2d z) const {
  const double r = size(p), a = radius / r;
  const Vec2d above{z.x + a, z.y}, below{1.0 + a * z.x, a * z.y};
  const Vec2d w = turned(above, {below.x, -below.y});
  const Vec2d direction = w * (1.0 / size(w));
  return turned(direction, p * (1.0 / r)) * radius;
}

bool FlakeGrower::settle(Landing landing, Place& place) const {
  place.p = landing.p;
  if (m_arms == 1) return true;
  fold(landing);
  const Vec2d better = aligned(landing);
  place.p = m_map.overlaps(better) ? landing.p : better;
  if (!besideTwin(landing.parent, {0.0, 1.0}, place)) return false;
  if (!besideTwin(landing.parent, {m_wall.y, -m_wall.x}, place)) return false;
  // Nearer to the middle than the seed's ring it would overlap its own turned images.
  const double ring = 0.5 / (m_arms == 8 ? kWallEight.y : kWallSix.y);
  if (dot2(place.p, place.p) < ring * ring * (1.0 - 1e-9)) return false;
  return place.p.y == 0.0 || place.p.y > 0.5 - 1e-9;
}

/// Brings a place and the particle it touches into the sector 0 <= angle <= half an arm.
void FlakeGrower::fold(Landing& landing) const {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < static_cast<std::size_t>(m_arms); ++k)
    if (dot2(landing.p, m_turns[k]) > dot2(landing.p, m_turns[nearest])) nearest = k;
  const Vec2d back{m_turns[nearest].x, -m_turns[nearest].y};
  landing = {turned(landing.p, back), turned(landing.parent, back)};
  if (landing.p.y < 0.0) landing.p.y = -landing.p.y, landing.parent.y = -landing.parent.y;
}

/// Ice branches at 60 degrees, so the directions are those of six arms even where there are eight: they are
/// taken in the sector, from the arm that bounds it. Close to the axis and abreast of its tip nothing grows
/// along the arm: such a row and its mirror image would starve the tip and outrun it, and the arm would be
/// split in two with a gap along its middle.
Vec2d FlakeGrower::aligned(Landing landing) const {
  static const std::array<Vec2d, 8> kDirections = armsOf(6);
  const Vec2d side = landing.p - landing.parent;
  const bool besideAxis =
      landing.parent.y > 0.0 && (landing.parent.y < kArmsOwn || landing.parent.x > m_tip - kArmsOwn);
  Vec2d nearest = kDirections[besideAxis ? 1 : 0];
  for (std::size_t k = 1; k < 6; ++k)
    if ((k != 3 || !besideAxis) && dot2(side, kDirections[k]) > dot2(side, nearest)) nearest = kDirections[k];
  const Vec2d blend = side * (1.0 - m_settings.alignment) + nearest * m_settings.alignment;
  return landing.parent + blend * (1.0 / size(blend));
}

/// A particle nearer to a wall than half its size would overlap its mirror image. It rolls round its parent
/// on to the wall, where it is its own image, or until both images touch, whichever is nearer.
bool FlakeGrower::besideTwin(Vec2d parent, Vec2d inward, Place& place) const {
  const double distance = dot2(place.p, inward);
  if (distance >= 0.5) return true;
  const double wanted = distance < 0.25 ? 0.0 : 0.5;
  const Vec2d along{inward.y, -inward.x};
  const double across = wanted - dot2(parent, inward);
  if (std::abs(across) > 1.0) return false;
  const double step = std::sqrt(1.0 - across * across), middle = dot2(parent, along);
  const double t = dot2(place.p, along) > middle ? middle + step : middle - step;
  place = {inward * wanted + along * t, wanted == 0.0};
  return !m_map.overlaps(place.p);
}

/// Counts a landing; true when there were enough. A place beside a wall has twice the images of one on it, so
/// walkers come to it twice as often: it needs twice the landings. Places nearer than a quarter are one.
bool FlakeGrower::landedOften(const Place& place) {
  if (m_arms == 1) return true;
  const auto key = [](double x) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(x * 4.0 + 0.37));
  };
  const std::uint64_t where = key(place.p.x) << 32 | key(place.p.y);
  const double share = place.p.y == 0.0 ? kTipShare : place.onWall ? 1.0 : 2.0;
  if (++m_landings[where] < share * m_settings.landings) return false;
  m_landings.erase(where);
  return true;
}

void FlakeGrower::addImages(const Place& place) {
  if (place.p.y == 0.0) m_tip = std::max(m_tip, place.p.x);
  for (std::size_t k = 0; k < static_cast<std::size_t>(m_arms); ++k) add(turned(place.p, m_turns[k]));
  if (m_arms == 1 || place.onWall) return;
  const Vec2d mirrored{place.p.x, -place.p.y};
  for (std::size_t k = 0; k < static_cast<std::size_t>(m_arms); ++k) add(turned(mirrored, m_turns[k]));
}

void FlakeGrower::add(Vec2d p) {
  m_map.add(p);
  m_reach = std::max(m_reach, size(p));
}

}  // namespace spin
