// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/air_exchange.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace spin {
namespace {

constexpr std::array<std::int32_t, 3> kBrick{kBrickX, kBrickY, kBrickZ};

std::int32_t floorDivide(std::int32_t a, std::int32_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

const BrickSolids* solidsAt(const AirWindow& window, const std::vector<BrickSolids>& solids,
                            const BrickKey& key) {
  const std::int32_t place = window.nearPlace(key);
  return place < 0 ? nullptr : &solids[static_cast<std::size_t>(place)];
}

float roomOf(const AirWindow& window, const std::vector<BrickSolids>& solids, const CellKey& cell) {
  const BrickKey key = brickOf(cell);
  const BrickSolids* there = window.activePlace(key) < 0 ? nullptr : solidsAt(window, solids, key);
  return there ? there->volume[cellInBrick(cell, key)] : 0.0f;
}

/// Order by key, in the order of entering where keys are alike.
std::vector<std::size_t> orderOf(const std::vector<std::uint32_t>& keys) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return order;
}

std::vector<float> sumsOfAlike(const std::vector<std::uint32_t>& keys, const std::vector<std::size_t>& order,
                               const std::vector<float>& values) {
  std::vector<double> sums;
  for (std::size_t n = 0; n < order.size(); ++n) {
    if (n == 0 || keys[order[n]] != keys[order[n - 1]]) sums.push_back(0.0);
    sums.back() += static_cast<double>(values[order[n]]);
  }
  std::vector<float> rounded(sums.size());
  std::transform(sums.begin(), sums.end(), rounded.begin(), [](double v) { return static_cast<float>(v); });
  return rounded;
}

/// Sources that found a cell, by cell.
struct PlacedSources {
  std::vector<std::uint32_t> index;
  std::vector<float> volume;
  std::vector<std::size_t> source;
};

/// Whether a cell's lower face along an axis is; walls of the domain are not meant.
bool closed(const BrickSolids& brick, const CellKey& cell, std::size_t axis) {
  return !brick.open && brick.area[axis][cellInBrick(cell, brickOf(cell))] == 0.0f;
}

/// m/s along the axis, of what closes that face.
float solidSpeed(const AirConfig& config, const BrickSolids& brick, const CellKey& cell, std::size_t axis) {
  if (!brick.moves) return 0.0f;
  Vec3d middle{cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5};
  (axis == 0 ? middle.x : axis == 1 ? middle.y : middle.z) -= 0.5;
  const Vec3d v = nearestSolidVelocity(config, config.origin + config.cell * middle);
  return static_cast<float>(axis == 0 ? v.x : axis == 1 ? v.y : v.z);
}

}  // namespace

CellKey cellOf(const AirConfig& config, Vec3d place) {
  // Far outside is outside whatever the number.
  const auto along = [&](double x) {
    return static_cast<std::int32_t>(std::floor(std::clamp(x, -1e9, 1e9)));
  };
  const Vec3d in = (place - config.origin) * (1.0 / config.cell);
  return {along(in.x), along(in.y), along(in.z)};
}

BrickKey brickOf(const CellKey& cell) {
  return {floorDivide(cell[0], kBrickX), floorDivide(cell[1], kBrickY), floorDivide(cell[2], kBrickZ)};
}

std::size_t cellInBrick(const CellKey& cell, const BrickKey& key) {
  const std::int32_t x = cell[0] - key[0] * kBrickX, y = cell[1] - key[1] * kBrickY,
                     z = cell[2] - key[2] * kBrickZ;
  return static_cast<std::size_t>((z * kBrickY + y) * kBrickX + x);
}

bool inDomain(const AirConfig& config, const BrickKey& key) {
  for (std::size_t a = 0; a < 3; ++a)
    if (key[a] < config.lowBrick[a] || key[a] >= config.highBrick[a]) return false;
  return true;
}

std::uint32_t activeIndex(const AirWindow& window, const CellKey& cell) {
  const BrickKey key = brickOf(cell);
  const std::int32_t place = window.activePlace(key);
  if (place < 0) return kNoCell;
  const AirBrick& brick = window.active()[static_cast<std::size_t>(place)];
  return static_cast<std::uint32_t>(brick.first + (cell[0] - key[0] * kBrickX) +
                                    (cell[1] - key[1] * kBrickY) * window.strides().y +
                                    (cell[2] - key[2] * kBrickZ) * window.strides().z);
}

float takingCell(const AirWindow& window, const std::vector<BrickSolids>& solids, CellKey& cell) {
  for (int up = 0; up < 3; ++up, ++cell[2])
    if (const float room = roomOf(window, solids, cell); room > 0.0f) return room;
  return 0.0f;
}

void closeFaces(const AirConfig& config, const AirWindow& window, const std::vector<BrickSolids>& solids,
                const CellKey& cell, CellFaces& faces) {
  const BrickKey key = brickOf(cell);
  const BrickSolids& own = *solidsAt(window, solids, key);
  for (std::size_t a = 0; a < 3; ++a) {
    CellKey above = cell;
    ++above[a];
    const BrickKey keyAbove = brickOf(above);
    const BrickSolids& next = keyAbove == key ? own : *solidsAt(window, solids, keyAbove);
    if (closed(own, cell, a)) faces.low[a] = solidSpeed(config, own, cell, a);
    if (closed(next, above, a)) faces.high[a] = solidSpeed(config, next, above, a);
  }
}

SourceLists listSources(const AirConfig& config, const AirWindow& window,
                        const std::vector<BrickSolids>& solids, const std::vector<AirSource>& sources,
                        AirBudget& budget) {
  SourceLists lists;
  PlacedSources placed;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const AirSource& source = sources[k];
    for (std::size_t a = 0; a < kAirScalars; ++a) budget.added[a] += source.amounts[a];
    CellKey cell = cellOf(config, source.position);
    const float room = takingCell(window, solids, cell);
    if (!(room > 0.0f)) {
      for (std::size_t a = 0; a < kAirScalars; ++a) budget.leftSides[a] += source.amounts[a];
      budget.solidImpulse += source.impulse;
      continue;
    }
    placed.index.push_back(activeIndex(window, cell));
    placed.volume.push_back(room);
    placed.source.push_back(k);
    const double mass = source.amounts[static_cast<std::size_t>(AirScalar::Mist)] +
                        source.amounts[static_cast<std::size_t>(AirScalar::Snow)] +
                        source.amounts[static_cast<std::size_t>(AirScalar::Vapour)];
    addImpulse(window, solids, cell, source.impulse, mass, lists, budget);
  }
  const double unit = 1.0 / (config.cell * config.cell * config.cell);
  AirAmounts sum{};
  std::uint32_t last = kNoCell;
  double share = 1.0;
  const auto close = [&] {
    for (std::size_t a = 0; a < kAirScalars && last != kNoCell; ++a)
      lists.amounts[a].push_back(static_cast<float>(sum[a] * unit / share));
    sum = {};
  };
  for (const std::size_t k : orderOf(placed.index)) {
    if (placed.index[k] != last) {
      close();
      last = placed.index[k];
      share = static_cast<double>(placed.volume[k]);
      lists.cells.push_back(last);
    }
    for (std::size_t a = 0; a < kAirScalars; ++a) sum[a] += sources[placed.source[k]].amounts[a];
  }
  close();
  mergeFaces(lists);
  return lists;
}

void addImpulse(const AirWindow& window, const std::vector<BrickSolids>& solids, const CellKey& cell,
                Vec3d impulse, double mass, SourceLists& lists, AirBudget& budget) {
  const double parts[3] = {impulse.x, impulse.y, impulse.z};
  Vec3d given{}, lost{};
  double* const givenParts[3] = {&given.x, &given.y, &given.z};
  double* const lostParts[3] = {&lost.x, &lost.y, &lost.z};
  const std::uint32_t own = activeIndex(window, cell);
  const std::int32_t steps[3] = {1, window.strides().y, window.strides().z};
  for (std::size_t a = 0; a < 3; ++a) {
    if (parts[a] == 0.0 && mass == 0.0) continue;
    CellKey above = cell;
    ++above[a];
    bool open[2] = {false, false};
    for (int side = 0; side < 2; ++side) {
      const CellKey& at = side == 0 ? cell : above;
      const BrickKey key = brickOf(at);
      const BrickSolids* there = solidsAt(window, solids, key);
      open[side] = own != kNoCell && there && there->area[a][cellInBrick(at, key)] > 0.0f;
    }
    const int count = static_cast<int>(open[0]) + static_cast<int>(open[1]);
    *(count > 0 ? givenParts : lostParts)[a] += parts[a];
    for (int side = 0; side < 2; ++side) {
      if (!open[side]) continue;
      lists.faces[a].push_back(own + static_cast<std::uint32_t>(side * steps[a]));
      lists.impulses[a].push_back(static_cast<float>(parts[a] / count));
      lists.masses[a].push_back(static_cast<float>(mass / count));
    }
  }
  budget.addedImpulse += given;
  budget.solidImpulse += lost;
}

void mergeFaces(SourceLists& lists) {
  for (std::size_t a = 0; a < 3; ++a) {
    std::vector<std::uint32_t>& faces = lists.faces[a];
    const std::vector<std::size_t> order = orderOf(faces);
    lists.impulses[a] = sumsOfAlike(faces, order, lists.impulses[a]);
    lists.masses[a] = sumsOfAlike(faces, order, lists.masses[a]);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  }
}

DragCells binDrag(const AirConfig& config, const AirWindow& window, const std::vector<BrickSolids>& solids,
                  const std::vector<AirDrag>& particles) {
  DragCells cells;
  std::vector<std::uint32_t> index, particle;
  std::vector<CellKey> keys;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    CellKey cell = cellOf(config, particles[k].position);
    if (!(takingCell(window, solids, cell) > 0.0f)) continue;
    index.push_back(activeIndex(window, cell));
    particle.push_back(static_cast<std::uint32_t>(k));
    keys.push_back(cell);
  }
  for (const std::size_t k : orderOf(index)) {
    if (cells.index.empty() || cells.index.back() != index[k]) {
      cells.index.push_back(index[k]);
      cells.cell.push_back(keys[k]);
      cells.who.emplace_back();
    }
    cells.who.back().push_back(particle[k]);
  }
  return cells;
}

std::vector<Vec3d> exchangeDrag(const DragCells& cells, const std::vector<CellFaces>& faces,
                                const std::vector<float>& load, double density, double cellSize,
                                double seconds, std::vector<AirDrag>& particles) {
  std::vector<Vec3d> impulses(cells.index.size());
  const auto share = [&](const AirDrag& p) { return p.rate * seconds / (1.0 + p.rate * seconds); };
  for (std::size_t c = 0; c < cells.index.size(); ++c) {
    const double mass = density * (1.0 + static_cast<double>(load[c])) * cellSize * cellSize * cellSize;
    const auto middle = [&](std::size_t a) {
      return 0.5 * (static_cast<double>(faces[c].low[a]) + static_cast<double>(faces[c].high[a]));
    };
    Vec3d momentum = mass * Vec3d{middle(0), middle(1), middle(2)};
    double weight = mass;
    for (const std::uint32_t k : cells.who[c]) {
      const double w = particles[k].mass * share(particles[k]);
      momentum += w * particles[k].velocity;
      weight += w;
    }
    const Vec3d end = momentum * (1.0 / weight);
    for (const std::uint32_t k : cells.who[c]) {
      AirDrag& p = particles[k];
      const Vec3d change = share(p) * (end - p.velocity);
      p.velocity += change;
      impulses[c] += -p.mass * change;
    }
  }
  return impulses;
}

}  // namespace spin
