// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "core/air/air_exchange.h"
#include "core/air/air_fields.h"
#include "core/air/air_host.h"
#include "core/air/air_motion.h"
#include "core/air/air_recut.h"
#include "core/air/air_transport.h"

namespace spin {

/// The solver's one text, over a backend's concept (core/base/parallel.h) and its way to go over bricks.
template <class Backend>
class AirSolverOn final : public AirSolver {
 public:
  AirSolverOn(const AirConfig& config, Backend backend, AirPasses<Backend> passes)
      : m_config(config), m_backend(std::move(backend)), m_passes(std::move(passes)) {
    const double vapour = config.humidity * saturatedVapourOf(config.temperature);
    m_ambient = {static_cast<float>(config.temperature), static_cast<float>(config.pressure),
                 static_cast<float>(vapour),
                 static_cast<float>(moistDensity(config.temperature, vapour, config.pressure))};
  }

  /// First bricks; fails where they are too many.
  Status start() {
    std::vector<BrickKey> keys;
    if (m_config.everywhere)
      for (std::int32_t z = m_config.lowBrick[2]; z < m_config.highBrick[2]; ++z)
        for (std::int32_t y = m_config.lowBrick[1]; y < m_config.highBrick[1]; ++y)
          for (std::int32_t x = m_config.lowBrick[0]; x < m_config.highBrick[0]; ++x)
            keys.push_back({x, y, z});
    return useBricks(std::move(keys));
  }

  Status add(const std::vector<AirSource>& sources) override {
    std::vector<Vec3d> places;
    for (const AirSource& s : sources) {
      const double sum = std::accumulate(s.amounts.begin(), s.amounts.end(), 0.0);
      if (!isFinite(s.impulse) || !std::isfinite(sum)) return foreignNumber("a source");
      places.push_back(s.position);
    }
    if (Status ok = reach(places); !ok) return ok;
    const SourceLists lists = listSources(m_config, m_fields.window(), m_fields.solids(), sources, m_budget);
    for (std::size_t a = 0; a < kAirScalars; ++a) addAmounts(lists.cells, lists.amounts[a], m_fields.q[a]);
    if (m_fields.window().keys().empty()) return {};
    if (!weigh()) return broken("exchange");
    pushFaces(lists);
    return {};
  }

  Status drag(std::vector<AirDrag>& particles, double seconds) override {
    std::vector<Vec3d> places;
    for (const AirDrag& p : particles) {
      if (!isFinite(p.velocity)) return foreignNumber("something in it");
      places.push_back(p.position);
    }
    if (Status ok = reach(places); !ok) return ok;
    DragCells cells = binDrag(m_config, m_fields.window(), m_fields.solids(), particles);
    if (cells.index.empty()) return {};
    if (!weigh()) return broken("exchange");
    const std::vector<Vec3d> impulses =
        exchangeDrag(cells, facesOf(cells.cell, cells.index), gather(cells.index, m_fields.load, 0),
                     static_cast<double>(m_ambient.density), m_config.cell, seconds, particles);
    SourceLists lists;
    for (std::size_t c = 0; c < cells.index.size(); ++c)
      addImpulse(m_fields.window(), m_fields.solids(), cells.cell[c], impulses[c], 0.0, lists, m_budget);
    mergeFaces(lists);
    pushFaces(lists);
    return {};
  }

  std::vector<Vec3d> velocities(const std::vector<Vec3d>& places) const override {
    std::vector<CellKey> cells;
    std::vector<std::uint32_t> index;
    for (const Vec3d& p : places) {
      cells.push_back(cellOf(m_config, p));
      index.push_back(activeIndex(m_fields.window(), cells.back()));
    }
    const std::vector<CellFaces> faces = facesOf(cells, index);
    std::vector<Vec3d> found;
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (index[k] == kNoCell) {
        found.push_back(m_config.wind ? m_config.wind(places[k]) : Vec3d{});
        continue;
      }
      // Linear between a cell's two faces along each axis, as the divergence is.
      const Vec3d in = (places[k] - m_config.origin) * (1.0 / m_config.cell);
      const auto between = [&](std::size_t a, double x) {
        const double f = x - std::floor(x);
        return (1.0 - f) * static_cast<double>(faces[k].low[a]) + f * static_cast<double>(faces[k].high[a]);
      };
      found.push_back({between(0, in.x), between(1, in.y), between(2, in.z)});
    }
    return found;
  }

  Result<std::vector<AirCellNow>> cellsAt(const std::vector<Vec3d>& places) override {
    if (Status ok = reach(places); !ok) return ok.error();
    std::vector<AirCellNow> found(places.size());
    std::vector<std::uint32_t> index(places.size(), kNoCell);
    for (std::size_t k = 0; k < places.size(); ++k) {
      CellKey cell = cellOf(m_config, places[k]);
      const float room = takingCell(m_fields.window(), m_fields.solids(), cell);
      if (room > 0.0f) index[k] = activeIndex(m_fields.window(), cell);
      found[k].cell = index[k];
      found[k].volume = static_cast<double>(room) * m_config.cell * m_config.cell * m_config.cell;
    }
    for (std::size_t a = 0; a < kAirScalars; ++a) {
      const std::vector<float> values = gather(index, m_fields.q[a], 0);
      for (std::size_t k = 0; k < places.size(); ++k)
        found[k].densities[a] = index[k] == kNoCell ? 0.0 : static_cast<double>(values[k]);
    }
    return found;
  }

  Result<AirStep> step(double seconds) override {
    AirStep done;
    done.seconds = seconds;
    for (double left = seconds; left > 1e-9 * seconds;) {
      if (stopped()) return cancelledStep();
      if (Status ok = followCloud(); !ok) return ok.error();
      if (m_fields.window().keys().empty()) break;
      const double fastest = m_motion.fastest(m_backend, m_passes, m_fields);
      if (!(fastest < kMostSpeed)) return broken("step");
      done.fastest = std::max(done.fastest, fastest);
      const double most = m_config.mostCourant * m_config.cell / std::max(fastest, 1e-6);
      const double part = left / std::ceil(std::max(1.0, left / most * (1.0 - 1e-9)));
      if (Status ok = subStep(part, done); !ok) return ok.error();
      left -= part;
      ++done.subSteps;
      done.cells += m_fields.window().keys().size() * kBrickCells;
    }
    m_touched.clear();
    // Else the phase change has seen to that.
    if (!changesPhase() && !m_fields.window().keys().empty() && !weigh()) return broken("step");
    return done;
  }

  Status moveSolids(const std::vector<AirSolid>& solids) override {
    if (solids.size() != m_config.solids.size())
      return Error{ErrorKind::BadInput, "The air stopped", "air", "the number of solids changed",
                   "Report this"};
    m_config.solids = solids;
    const BricksBefore before = m_fields.recutMoving(m_config);
    if (before.empty()) return {};
    keepContents(planRecut(m_fields.window(), m_fields.solids(), before));
    m_fields.writeSolids(m_backend, m_config);
    m_motion.rebuild(m_backend, m_fields);
    return {};
  }

  std::vector<AirDeposit> takeDeposits() override {
    std::vector<float> mist, snow;
    const std::size_t cells = m_fields.window().cells();
    std::vector<AirDeposit> found = std::move(m_deposits);
    m_deposits.clear();
    if (m_fields.window().keys().empty()) return found;
    m_fields.down[0].download(m_backend, cells, mist);
    m_fields.down[1].download(m_backend, cells, snow);
    appendDeposits(m_config, m_fields.window(), mist, snow, found);
    for (auto& field : m_fields.down) field.reset(m_backend, cells, m_fields.strides());
    return found;
  }

  AirBudget budget() const override {
    AirBudget b = m_budget;
    const double volume = m_config.cell * m_config.cell * m_config.cell;
    for (std::size_t a = 0; a < kAirScalars; ++a)
      b.present[a] = volume * m_transport.content(m_backend, m_passes, m_fields, a);
    return b;
  }

  void publish(bool divergence, AirPart& part) const override {
    publishAir(m_config, m_fields.window(), m_fields.solids(), hostFields(), divergence, part);
  }

  AirState state() const override {
    AirState state = packState(m_fields.window(), m_fields.solids(), hostFields());
    state.forward = m_transport.forward();
    state.budget = budget();
    return state;
  }

  Status restore(const AirState& state) override {
    if (Status ok = checkAirState(m_config, state); !ok) return ok;
    // From nothing, so that what stays outside the bricks is the wind again.
    if (Status ok = useBricks({}, true); !ok) return ok;
    m_deposits.clear();
    m_touched.clear();
    if (Status ok = useBricks(state.bricks, true); !ok) return ok;
    unpack(state);
    m_transport.setForward(state.forward);
    m_budget = state.budget;
    return {};
  }

  std::size_t cells() const override { return m_fields.window().keys().size() * kBrickCells; }
  std::size_t bytes() const override { return m_fields.bytes() + m_motion.bytes(); }
  StageTimings& timings() override { return m_backend.timings(); }
  const char* device() const override { return Backend::kDevice; }

 private:
  using Field = PaddedArray<Backend>;
  template <class T>
  using Array = typename Backend::template Array<T>;

  static double saturatedVapourOf(double temperature) {
    double growth = 0.0;
    return saturatedVapour(temperature, growth);
  }

  /// What is wrong, where, and the stage that found it.
  Error broken(const char* stage) const {
    return Error{ErrorKind::Failed, "The air stopped", "air",
                 firstBroken(m_config, m_fields.window(), m_fields.solids(), hostFields()) +
                     ", found in stage '" + stage + "'",
                 "Use shorter frames or smaller cells"};
  }

  bool changesPhase() const { return m_config.evaporates && m_config.stages.forces; }
  /// False where a cell's state is none.
  bool weigh() { return std::isfinite(m_motion.weigh(m_backend, m_passes, m_fields, m_config, m_ambient)); }

  static Error foreignNumber(const char* what) {
    return {ErrorKind::BadInput, "The air stopped", "air", std::string(what) + " is not finite",
            "Report this"};
  }

  bool stopped() const { return m_config.stop && m_config.stop(); }
  static Error cancelledStep() {
    return {ErrorKind::Cancelled, "The simulation stopped", "air", "it was cancelled", ""};
  }

  /// Bricks come to be at places.
  Status reach(const std::vector<Vec3d>& places) {
    std::vector<BrickKey> keys = m_fields.window().keys();
    for (const Vec3d& p : places) {
      if (!isFinite(p)) return foreignNumber("a place");
      const BrickKey key = brickOf(cellOf(m_config, p));
      if (inDomain(m_config, key)) keys.push_back(key);
    }
    m_touched.insert(m_touched.end(),
                     keys.begin() + static_cast<std::ptrdiff_t>(m_fields.window().keys().size()), keys.end());
    sortBricks(m_touched);
    return useBricks(std::move(keys));
  }

  Status useBricks(std::vector<BrickKey> keys, bool always = false) {
    sortBricks(keys);
    if (keys == m_fields.window().keys() && m_fields.window().cells() > 0 && !always) return {};
    Result<AirWindow> window = AirWindow::make(std::move(keys));
    if (!window) return window.error();
    if (!m_fields.window().keys().empty() && !always) giveUp(*window);
    m_fields.move(m_backend, m_config, std::move(*window));
    m_motion.rebuild(m_backend, m_fields);
    return {};
  }

  /// Books what is in bricks that are not computed any more, and keeps what came down there.
  void giveUp(const AirWindow& next) {
    const std::vector<BrickKey>& keys = m_fields.window().keys();
    std::vector<std::size_t> gone;
    for (std::size_t b = 0; b < keys.size(); ++b)
      if (next.activePlace(keys[b]) < 0) gone.push_back(b);
    if (gone.empty()) return;
    const double volume = m_config.cell * m_config.cell * m_config.cell;
    for (std::size_t a = 0; a < kAirScalars; ++a) {
      const std::vector<double>& contents = m_transport.contents(m_backend, m_passes, m_fields, a);
      for (const std::size_t b : gone) m_budget.givenUp[a] += volume * contents[b];
    }
    m_deposits = takeDeposits();
  }

  /// Bricks with something in them and those round them stay or come to be; the rest goes.
  Status followCloud() {
    if (m_config.everywhere || m_fields.window().keys().empty()) return {};
    const std::vector<double> activity = m_transport.activity(m_backend, m_passes, m_fields, m_config);
    for (const double a : activity)
      if (!std::isfinite(a)) return broken("bricks");
    return useBricks(bricksRound(m_config, m_fields.window(), activity, m_touched));
  }

  Status subStep(double seconds, AirStep& done) {
    const auto book = [&](const AirSolve& solve) {
      ++done.solves;
      done.iterations += solve.iterations;
      done.residual = std::max(done.residual, solve.residual);
      done.reached = done.reached && solve.reached;
      return std::isfinite(solve.residual);
    };
    const char* stage = m_motion.step(m_backend, m_passes, m_fields, m_config, m_ambient, seconds, book);
    if (stage) return broken(stage);
    if (stopped()) return cancelledStep();
    if (m_config.stages.advectScalars &&
        !m_transport.step(m_backend, m_passes, m_fields, m_config, seconds, m_budget))
      return broken("carry scalars");
    if (changesPhase() && !m_transport.condense(m_backend, m_passes, m_fields, m_config, m_ambient, m_budget))
      return broken("phase change");
    return {};
  }

  void addAmounts(const std::vector<std::uint32_t>& index, const std::vector<float>& values, Field& field) {
    if (index.empty()) return;
    m_backend.upload(index, m_index);
    m_backend.upload(values, m_values);
    m_backend.forEach("exchange", index.size(), ListedAdd{field.data(), m_index.data(), m_values.data()});
  }

  /// After weigh().
  void pushFaces(const SourceLists& lists) {
    const float unit =
        1.0f / (m_ambient.density * static_cast<float>(m_config.cell * m_config.cell * m_config.cell));
    for (std::size_t a = 0; a < 3; ++a) {
      if (lists.faces[a].empty()) continue;
      m_backend.upload(lists.faces[a], m_index);
      m_backend.upload(lists.impulses[a], m_values);
      m_backend.upload(lists.masses[a], m_masses);
      m_backend.forEach("exchange", lists.faces[a].size(),
                        ListedPush{m_fields.u[a].data(), m_fields.load.data(), m_index.data(),
                                   m_values.data(), m_masses.data(), stepAlong(a), unit});
    }
  }

  /// What the cells hold when their volumes change; what has no cell to go to is booked.
  void keepContents(const RecutPlan& plan) {
    if (plan.index.empty()) return;
    const double volume = m_config.cell * m_config.cell * m_config.cell;
    for (std::size_t a = 0; a < kAirScalars; ++a) {
      std::vector<float> values = gather(plan.index, m_fields.q[a], 0);
      m_budget.givenUp[a] += volume * applyRecut(plan, a == std::size_t{2}, values);
      m_backend.upload(values, m_values);
      m_backend.forEach("exchange", values.size(),
                        ListedWrite{m_fields.q[a].data(), m_index.data(), m_values.data()});
    }
  }

  std::vector<CellFaces> facesOf(const std::vector<CellKey>& cells,
                                 const std::vector<std::uint32_t>& index) const {
    std::vector<CellFaces> faces(cells.size());
    for (std::size_t a = 0; a < 3; ++a) {
      const std::vector<float> low = gather(index, m_fields.u[a], 0),
                               high = gather(index, m_fields.u[a], stepAlong(a));
      for (std::size_t k = 0; k < cells.size(); ++k) faces[k].low[a] = low[k], faces[k].high[a] = high[k];
    }
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (index[k] != kNoCell) closeFaces(m_config, m_fields.window(), m_fields.solids(), cells[k], faces[k]);
    return faces;
  }
  int stepAlong(std::size_t axis) const {
    const AirStrides s = m_fields.strides();
    return axis == 0 ? 1 : axis == 1 ? s.y : s.z;
  }

  /// Values at cells plus an offset; those of kNoCell are those of cell 0.
  std::vector<float> gather(const std::vector<std::uint32_t>& index, const Field& field, int offset) const {
    std::vector<float> values(index.size());
    if (index.empty() || m_fields.window().cells() == 0) return values;
    m_backend.upload(index, m_index);
    m_gathered.resize(index.size());
    m_backend.forEach("exchange", index.size(),
                      ListedRead{field.data() + offset, m_index.data(), m_gathered.data()});
    m_backend.download(m_gathered, values);
    return values;
  }

  HostFields hostFields() const {
    HostFields host;
    const std::size_t cells = m_fields.window().cells();
    for (std::size_t a = 0; a < 3; ++a) m_fields.u[a].download(m_backend, cells, host.u[a]);
    for (std::size_t a = 0; a < kAirScalars; ++a) m_fields.q[a].download(m_backend, cells, host.q[a]);
    for (std::size_t a = 0; a < 2; ++a) m_fields.pressure[a].download(m_backend, cells, host.pressure[a]);
    return host;
  }

  void unpack(const AirState& state) {
    const std::vector<std::int32_t> first = firstCells(m_fields.window());
    const std::size_t size = first.size() * kBrickCells;
    const auto field = [&](std::size_t k, Field& to) {
      const auto begin = state.values.begin() + static_cast<std::ptrdiff_t>(k * size);
      m_fields.fill(m_backend, to, first,
                    std::vector<float>(begin, begin + static_cast<std::ptrdiff_t>(size)));
    };
    for (std::size_t a = 0; a < 3; ++a) {
      field(a, m_fields.u[a]);
      field(a, m_fields.next[a]);
      field(a, m_fields.mid[a]);
    }
    for (std::size_t a = 0; a < kAirScalars; ++a) field(3 + a, m_fields.q[a]);
    for (std::size_t a = 0; a < 2; ++a) field(3 + kAirScalars + a, m_fields.pressure[a]);
    m_fields.takeVolumes(m_backend, m_config, state.values.data() + (kAirFields - 1) * size);
    unpackUpper(state);
  }

  /// Upper faces of the bricks' upper sides lie in bricks that are not computed.
  void unpackUpper(const AirState& state) {
    for (std::size_t a = 0; a < 3; ++a) {
      std::vector<std::uint32_t> index;
      std::vector<float> values;
      listUpperFaces(m_fields.window(), state, a, index, values);
      if (index.empty()) continue;
      m_backend.upload(index, m_index);
      m_backend.upload(values, m_values);
      for (Field* f : {&m_fields.u[a], &m_fields.next[a], &m_fields.mid[a]})
        m_backend.forEach("bricks", index.size(), ListedWrite{f->data(), m_index.data(), m_values.data()});
    }
  }

  AirConfig m_config;
  AirAmbient m_ambient{};
  mutable Backend m_backend;
  mutable AirPasses<Backend> m_passes;
  AirFields<Backend> m_fields;
  AirMotion<Backend> m_motion;
  mutable AirTransport<Backend> m_transport;
  AirBudget m_budget;
  std::vector<BrickKey> m_touched;     ///< where something was brought since the latest step
  std::vector<AirDeposit> m_deposits;  ///< of bricks that were given up
  mutable Array<std::uint32_t> m_index;
  mutable Array<float> m_values, m_masses, m_gathered;
};

}  // namespace spin
