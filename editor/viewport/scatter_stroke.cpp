// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/scatter_stroke.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "editor/viewport/node_shape.h"

namespace spin {
namespace {

constexpr std::uint32_t kStream = 0x73636174u;
constexpr std::uint32_t kAttempts = 8;

double squared(Vec2d d) {
  return d.x * d.x + d.y * d.y;
}

/// Share of the way from a to b at which a disc that moves along it first covers p; nothing if it never does.
std::optional<double> coveredAt(Vec2d p, Vec2d a, Vec2d b, double radius) {
  const Vec2d ap = p - a;
  const double rest = squared(ap) - radius * radius;
  if (rest <= 0.0) return 0.0;
  const Vec2d ab = b - a;
  const double way = squared(ab), along = ab.x * ap.x + ab.y * ap.y;
  const double root = along * along - way * rest;
  if (way <= 0.0 || along <= 0.0 || root < 0.0) return std::nullopt;
  const double when = (along - std::sqrt(root)) / way;
  return when <= 1.0 ? std::optional(when) : std::nullopt;
}

}  // namespace

std::uint64_t PlanGrid::keyOf(std::int64_t i, std::int64_t j) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32 | static_cast<std::uint32_t>(j);
}

std::uint64_t PlanGrid::keyAt(Vec2d p) const {
  return keyOf(std::llround(std::floor(p.x / m_cellSize)), std::llround(std::floor(p.y / m_cellSize)));
}

bool PlanGrid::anyNearer(Vec2d p, double distance) const {
  const std::int64_t i = std::llround(std::floor(p.x / m_cellSize));
  const std::int64_t j = std::llround(std::floor(p.y / m_cellSize));
  for (std::int64_t b = j - 1; b <= j + 1; ++b)
    for (std::int64_t a = i - 1; a <= i + 1; ++a) {
      const auto cell = m_cells.find(keyOf(a, b));
      if (cell == m_cells.end()) continue;
      for (const Vec2d& other : cell->second)
        if (squared(other - p) < distance * distance) return true;
    }
  return false;
}

ScatterStroke::ScatterStroke(PlanPoints copies, ScatterTask task)
    : m_copies(std::move(copies)),
      m_task(std::move(task)),
      m_before(static_cast<int>(m_copies.size())),
      m_side(1.0 / std::sqrt(m_task.density)),
      m_squares(m_side),
      m_near(std::max(m_task.distance, m_side)) {
  if (m_task.erase) return;
  for (const Vec2d& p : m_copies) {
    m_squares.add(p);
    m_near.add(p);
  }
  m_near.add(m_task.own);
}

bool ScatterStroke::moveTo(Vec2d position) {
  const bool first = !m_last;
  const Vec2d from = m_last.value_or(position);
  m_last = position;
  if (m_task.erase) return eraseAlong(from, position);
  std::vector<Square> squares = squaresAlong(from, position);
  std::sort(squares.begin(), squares.end(), [](const Square& a, const Square& b) {
    return a.when != b.when ? a.when < b.when : a.i != b.i ? a.i < b.i : a.j < b.j;
  });
  bool changed = false;
  for (const Square& square : squares) changed |= fill(square, from, position);
  const auto inTip = [&](Vec2d p) { return squared(p - position) <= m_task.radius * m_task.radius; };
  if (first && !changed && std::none_of(m_copies.begin(), m_copies.end(), inTip)) changed = place(position);
  return changed;
}

/// A copy's turn and size follow from its number, so the others keep theirs but for the last ones, which move
/// up into the gaps.
bool ScatterStroke::eraseAlong(Vec2d from, Vec2d to) {
  const std::size_t before = m_copies.size();
  for (std::size_t k = before; k-- > 0;) {
    if (!coveredAt(m_copies[k], from, to, m_task.radius)) continue;
    m_copies[k] = m_copies.back();
    m_copies.pop_back();
  }
  return m_copies.size() < before;
}

std::vector<ScatterStroke::Square> ScatterStroke::squaresAlong(Vec2d from, Vec2d to) {
  std::vector<Square> squares;
  const auto first = [&](double a, double b) {
    return static_cast<std::int64_t>(std::floor((std::min(a, b) - m_task.radius) / m_side));
  };
  const auto last = [&](double a, double b) {
    return static_cast<std::int64_t>(std::floor((std::max(a, b) + m_task.radius) / m_side));
  };
  for (std::int64_t j = first(from.y, to.y); j <= last(from.y, to.y); ++j)
    for (std::int64_t i = first(from.x, to.x); i <= last(from.x, to.x); ++i) {
      const auto when = coveredAt(placeIn(i, j, 0), from, to, m_task.radius);
      if (when && m_passed.insert(PlanGrid::keyOf(i, j)).second) squares.push_back({*when, i, j});
    }
  return squares;
}

bool ScatterStroke::fill(const Square& square, Vec2d from, Vec2d to) {
  const Vec2d tip = from + (to - from) * square.when;
  const Vec2d middle{(static_cast<double>(square.i) + 0.5) * m_side,
                     (static_cast<double>(square.j) + 0.5) * m_side};
  if (m_squares.anyInCell(middle)) return false;
  for (std::uint32_t attempt = 0; attempt < kAttempts; ++attempt) {
    const Vec2d p = placeIn(square.i, square.j, attempt);
    if (attempt > 0 && squared(p - tip) > m_task.radius * m_task.radius) continue;
    if (place(p)) return true;
  }
  return false;
}

bool ScatterStroke::place(Vec2d p) {
  if (full() || m_near.anyNearer(p, m_task.distance)) return false;
  if (m_task.isGround && !m_task.isGround(p)) return false;
  m_copies.push_back(toCentimetres(p));
  m_squares.add(p);
  m_near.add(p);
  return true;
}

Vec2d ScatterStroke::placeIn(std::int64_t i, std::int64_t j, std::uint32_t attempt) const {
  const UInt4 words = CounterRandom{m_task.seed, kStream}.words(PlanGrid::keyOf(i, j), attempt);
  return {(static_cast<double>(i) + toUnitDouble(words.x, words.y)) * m_side,
          (static_cast<double>(j) + toUnitDouble(words.z, words.w)) * m_side};
}

}  // namespace spin
