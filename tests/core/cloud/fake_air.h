// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <map>
#include <utility>

#include "core/air/air_solver.h"

namespace spin::test {

/// Air that stays where it is: cells of a map take what they are given, are dragged, and let mist and snow
/// settle; nothing is carried along. It keeps the interface's promises on mass and momentum.
class FakeAir final : public AirSolver {
 public:
  explicit FakeAir(const AirConfig& config) : m_config(config) {}

  Status add(const std::vector<AirSource>& sources) override {
    for (const AirSource& s : sources) {
      m_budget.addedImpulse += s.impulse;
      for (std::size_t k = 0; k < kAirScalars; ++k) m_budget.added[k] += s.amounts[k];
      Cell& c = cellAt(s.position);
      for (std::size_t k = 0; k < kAirScalars; ++k) c.amounts[k] += static_cast<float>(s.amounts[k]);
      push(c, s.impulse, s.amounts[0] + s.amounts[1] + s.amounts[3]);
    }
    return {};
  }
  Status drag(std::vector<AirDrag>& particles, double seconds) override {
    for (AirDrag& p : particles) {
      Cell& c = cellAt(p.position);
      const Vec3d air = velocityOf(c);
      const double share = p.rate * seconds / (1.0 + p.rate * seconds * (1.0 + p.mass / airMass()));
      const Vec3d change = (air - p.velocity) * share;
      p.velocity += change;
      push(c, change * -p.mass, 0.0);
      m_budget.addedImpulse += change * -p.mass;
    }
    return {};
  }
  std::vector<Vec3d> velocities(const std::vector<Vec3d>& places) const override {
    std::vector<Vec3d> found;
    for (const Vec3d& p : places) {
      const auto it = m_cells.find(keyOf(p));
      found.push_back(it == m_cells.end() ? wind(p) : velocityOf(it->second));
    }
    return found;
  }
  Result<std::vector<AirCellNow>> cellsAt(const std::vector<Vec3d>& places) override {
    for (const Vec3d& p : places) cellAt(p);
    std::vector<AirCellNow> found;
    for (const Vec3d& p : places) {
      const auto it = m_cells.find(keyOf(p));
      AirCellNow now;
      now.cell = static_cast<std::uint32_t>(std::distance(m_cells.begin(), it));
      now.volume = m_config.cell * m_config.cell * m_config.cell;
      for (std::size_t k = 0; k < kAirScalars; ++k)
        now.densities[k] = static_cast<double>(it->second.amounts[k]) / now.volume;
      found.push_back(now);
    }
    return found;
  }
  Result<AirStep> step(double seconds) override {
    for (auto& [key, c] : m_cells)
      for (std::size_t k = 0; k < 2; ++k) {
        const float falls = c.amounts[k] * static_cast<float>(-std::expm1(-m_settle * seconds));
        c.amounts[k] -= falls;
        AirDeposit d{centreOf(key), 0.0, 0.0};
        (k == 0 ? d.mist : d.snow) = static_cast<double>(falls);
        if (falls > 0.0f) m_deposits.push_back(d);
        m_budget.deposited[k] += static_cast<double>(falls);
      }
    AirStep done;
    done.seconds = seconds, done.subSteps = 1, done.cells = m_cells.size();
    return done;
  }
  Status moveSolids(const std::vector<AirSolid>& solids) override {
    ++moves;
    m_config.solids = solids;
    return {};
  }
  std::vector<AirDeposit> takeDeposits() override { return std::exchange(m_deposits, {}); }
  AirBudget budget() const override {
    AirBudget now = m_budget;
    now.present = {};
    for (const auto& [key, c] : m_cells)
      for (std::size_t k = 0; k < kAirScalars; ++k) now.present[k] += static_cast<double>(c.amounts[k]);
    return now;
  }
  void publish(bool, AirPart& part) const override {
    part.origin = m_config.origin, part.cell = m_config.cell;
    part.temperature = m_config.temperature;
    std::map<std::array<std::int32_t, 3>, std::vector<std::pair<std::size_t, const Cell*>>> bricks;
    for (const auto& [k, c] : m_cells) {
      const auto down = [](int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); };
      const int x = down(k[2], kBrickX), y = down(k[1], kBrickY), z = down(k[0], kBrickZ);
      bricks[{z, y, x}].push_back(
          {static_cast<std::size_t>(k[2] - x * kBrickX +
                                    kBrickX * (k[1] - y * kBrickY + kBrickY * (k[0] - z * kBrickZ))),
           &c});
    }
    part.fields = {
        {"mist", "kg/m3", 1, 1.0f, {}}, {"temperature", "K", 1, 1.0f, {}}, {"vapour", "kg/m3", 1, 1.0f, {}}};
    for (const auto& [key, cells] : bricks) {
      part.bricks.push_back({key[2], key[1], key[0]});
      for (AirField& f : part.fields) f.halves.resize(part.bricks.size() * kBrickCells, 0);
      for (const auto& [at, c] : cells) {
        const float volume = static_cast<float>(m_config.cell * m_config.cell * m_config.cell);
        const std::size_t place = (part.bricks.size() - 1) * kBrickCells + at;
        part.fields[0].halves[place] = halfFromFloat(c->amounts[0] / volume);
        part.fields[1].halves[place] = halfFromFloat(c->amounts[2] / volume);
        part.fields[2].halves[place] = halfFromFloat(c->amounts[3] / volume);
      }
    }
  }
  AirState state() const override {
    AirState s;
    s.budget = m_budget;
    for (const auto& [key, c] : m_cells) {
      s.bricks.push_back(key);
      s.values.insert(s.values.end(), c.velocity.begin(), c.velocity.end());
      s.values.insert(s.values.end(), c.amounts.begin(), c.amounts.end());
    }
    return s;
  }
  Status restore(const AirState& s) override {
    if (s.values.size() != 7 * s.bricks.size()) return badInput("The state does not fit", "air", "lengths");
    m_cells.clear();
    for (std::size_t b = 0; b < s.bricks.size(); ++b) {
      Cell& c = m_cells[s.bricks[b]];
      for (std::size_t k = 0; k < 7; ++k) (k < 3 ? c.velocity[k] : c.amounts[k - 3]) = s.values[7 * b + k];
    }
    m_budget = s.budget;
    return {};
  }
  std::size_t cells() const override { return m_cells.size(); }
  std::size_t bytes() const override { return m_cells.size() * sizeof(Cell); }
  StageTimings& timings() override { return m_timings; }
  const char* device() const override { return "fake"; }

  const AirConfig& config() const { return m_config; }
  void setSettling(double rate) { m_settle = rate; }
  int moves = 0;

 private:
  struct Cell {
    std::array<float, 3> velocity{};
    std::array<float, kAirScalars> amounts{};
  };
  using Key = std::array<std::int32_t, 3>;  ///< z, y, x

  Key keyOf(Vec3d p) const {
    const auto at = [&](double a, double low) {
      return static_cast<std::int32_t>(std::floor((a - low) / m_config.cell));
    };
    return {at(p.z, m_config.origin.z), at(p.y, m_config.origin.y), at(p.x, m_config.origin.x)};
  }
  Vec3d centreOf(const Key& k) const {
    return m_config.origin + Vec3d{k[2] + 0.5, k[1] + 0.5, k[0] + 0.5} * m_config.cell;
  }
  Vec3d wind(Vec3d p) const { return m_config.wind ? m_config.wind(p) : Vec3d{}; }
  Cell& cellAt(Vec3d p) {
    const auto [it, fresh] = m_cells.try_emplace(keyOf(p));
    if (fresh)
      for (int axis = 0; axis < 3; ++axis)
        it->second.velocity[static_cast<std::size_t>(axis)] = static_cast<float>(wind(p)[axis]);
    return it->second;
  }
  static Vec3d velocityOf(const Cell& c) {
    return Vec3f{c.velocity[0], c.velocity[1], c.velocity[2]}.to<double>();
  }
  double airMass() const { return 1.3 * m_config.cell * m_config.cell * m_config.cell; }
  /// After the mass that came with it.
  void push(Cell& c, Vec3d impulse, double mass) {
    const Vec3d change = (impulse - velocityOf(c) * mass) *
                         (1.0 / (airMass() + static_cast<double>(c.amounts[0] + c.amounts[1])));
    for (int axis = 0; axis < 3; ++axis)
      c.velocity[static_cast<std::size_t>(axis)] += static_cast<float>(change[axis]);
  }

  AirConfig m_config;
  std::map<Key, Cell> m_cells;
  AirBudget m_budget;
  std::vector<AirDeposit> m_deposits;
  StageTimings m_timings;
  double m_settle = 0.2;  ///< 1/s
};

}  // namespace spin::test
