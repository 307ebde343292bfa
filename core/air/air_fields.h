// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "core/air/air_loop.h"
#include "core/air/air_recut.h"
#include "core/air/padded_array.h"

namespace spin {

/// Copies whole bricks from one lattice to another.
struct MoveBricksKernel {
  const std::int32_t *from, *to;  ///< first cells
  const float* source;
  float* target;
  AirStrides sourceStrides, targetStrides;
  SPIN_HD void operator()(std::size_t i) const {
    const std::size_t brick = i / 256;
    const int c = static_cast<int>(i % 256), x = c % 16, y = c / 16 % 4, z = c / 64;
    target[to[brick] + x + y * targetStrides.y + z * targetStrides.z] =
        source[from[brick] + x + y * sourceStrides.y + z * sourceStrides.z];
  }
};

/// Writes the cells of bricks, given brick by brick.
struct FillBricksKernel {
  const std::int32_t* first;
  const float* values;
  float* target;
  AirStrides strides;
  SPIN_HD void operator()(std::size_t i) const {
    const int c = static_cast<int>(i % 256), x = c % 16, y = c / 16 % 4, z = c / 64;
    target[first[i / 256] + x + y * strides.y + z * strides.z] = values[i];
  }
};

/// Sets bricks that are not computed to the wind, but for lower faces that belong to computed ones below.
struct CalmBricksKernel {
  const std::int32_t* first;
  const std::int32_t* below;  ///< bit a: the brick below along axis a is computed
  const float* wind[3];       ///< null: calm
  float* to[3];
  AirStrides strides;
  SPIN_HD void operator()(std::size_t i) const {
    const int c = static_cast<int>(i % 256), in[3] = {c % 16, c / 16 % 4, c / 64};
    const int at = first[i / 256] + in[0] + in[1] * strides.y + in[2] * strides.z;
    for (int a = 0; a < 3; ++a)
      if (in[a] > 0 || !(below[i / 256] >> a & 1)) to[a][at] = wind[a] ? wind[a][at] : 0.0f;
  }
};

/// open = 1 where there is room.
struct OpenKernel {
  const AirBrick* bricks;
  const float* volume;
  float* open;
  AirStrides strides;
  SPIN_HD void operator()(std::size_t i) const {
    const int c = static_cast<int>(i % 256), x = c % 16, y = c / 16 % 4, z = c / 64;
    const int at = bricks[i / 256].first + x + y * strides.y + z * strides.z;
    open[at] = volume[at] > 0.0f ? 1.0f : 0.0f;
  }
};

/// All arrays of the air on a backend, over one window; moving to another window keeps what both hold.
template <class Backend>
class AirFields {
 public:
  using Field = PaddedArray<Backend>;
  template <class T>
  using Array = typename Backend::template Array<T>;

  std::array<Field, 3> u, next, mid;  ///< velocities; the next ones, those between two half steps
  std::array<Field, kAirScalars> q;
  std::array<Field, 2> pressure;
  std::array<Field, 3> area;
  Field volume, open, flux, load;
  std::array<Field, 3>
      wall;  ///< speed of solids that hold the air, beside `sticks`; only where there are any
  Field sticks;
  Field hat, least, most;                  ///< of carrying and diffusing
  Field sweepA, sweepB, volumeA, volumeB;  ///< of carrying scalars
  std::array<Field, 2> down;               ///< what mist and snow came down since it was asked
  std::array<Field, 3> wind;               ///< of the air round the cloud; only where there is any
  Array<AirBrick> active, faces, near;
  Array<AirBrick> walled;  ///< those of near that are not all open

  const AirWindow& window() const { return m_window; }
  const std::vector<BrickSolids>& solids() const { return m_solids; }
  bool sticky() const { return m_sticky; }
  bool moving() const { return m_moving; }
  /// Null where it is calm.
  const float* windAt(std::size_t axis) const { return m_windy ? wind[axis].data() : nullptr; }
  AirStrides strides() const { return m_window.strides(); }

  /// To the window of other bricks.
  void move(Backend& backend, const AirConfig& config, AirWindow window) {
    const AirWindow old = std::exchange(m_window, std::move(window));
    m_sticky = config.sticky;
    for (const bool side : config.stickySides) m_sticky = m_sticky || side;
    cutSolids(config, old);
    const Moves around = movesOf(old, old.nearKeys(), m_window.nearKeys());
    const Moves kept = movesOf(old, old.keys(), m_window.keys());
    for (std::array<Field, 3>* set : {&u, &next, &mid})
      for (Field& f : *set) carry(backend, old, around, f);
    for (Field& f : q) carry(backend, old, kept, f);
    for (Field& f : pressure) carry(backend, old, kept, f);
    for (Field& f : down) carry(backend, old, kept, f);
    m_windy = static_cast<bool>(config.wind);
    fillWind(backend, config, old, around);
    calmRim(backend);
    for (Field* f : {&volume, &open, &flux, &load, &hat, &least, &most, &sweepA, &sweepB, &volumeA, &volumeB})
      f->reset(backend, m_window.cells(), strides());
    for (Field& f : area) f.reset(backend, m_window.cells(), strides());
    backend.upload(m_window.active(), active);
    backend.upload(m_window.faces(), faces);
    backend.upload(m_window.near(), near);
    writeSolids(backend, config);
  }

  /// Cuts the bricks anew that moving solids touch or touched; gives back what has changed as it was before.
  BricksBefore recutMoving(const AirConfig& config) {
    BricksBefore before;
    for (std::size_t k = 0; k < m_solids.size(); ++k) {
      if (!m_solids[k].moves && !touchesMoving(config, m_window.nearKeys()[k])) continue;
      const BrickSolids cut = cutBrick(config, m_window.nearKeys()[k]);
      if (cut == m_solids[k]) continue;
      before.emplace(k, m_solids[k]);
      m_solids[k] = cut;
    }
    return before;
  }

  /// Volumes of the active bricks, brick by brick, as they were when solids that move were elsewhere than the
  /// configuration says: what has changed since is found when they are moved.
  void takeVolumes(Backend& backend, const AirConfig& config, const float* volumes) {
    if (std::none_of(config.solids.begin(), config.solids.end(),
                     [](const AirSolid& s) { return s.velocity; }))
      return;
    for (const BrickKey& key : m_window.keys()) {
      BrickSolids& solids = m_solids[static_cast<std::size_t>(m_window.nearPlace(key))];
      for (float& own : solids.volume) {
        const float given = *volumes++;
        if (given == own || !(given == 0.0f || (given >= kLeastVolume && given <= 1.0f))) continue;
        own = given;
        solids.moves = true;
        solids.open = false;
      }
    }
    writeSolids(backend, config);
  }

  /// Brings the solids into the arrays.
  void writeSolids(Backend& backend, const AirConfig& config) {
    std::vector<std::int32_t> first;
    std::array<std::vector<float>, 5> values;
    std::vector<AirBrick> cutBricks;
    m_moving = false;
    for (std::size_t k = 0; k < m_solids.size(); ++k) {
      const BrickSolids& s = m_solids[k];
      first.push_back(m_window.near()[k].first);
      if (!s.open) cutBricks.push_back(m_window.near()[k]);
      for (std::size_t a = 0; a < 3; ++a)
        values[a].insert(values[a].end(), s.area[a].begin(), s.area[a].end());
      values[3].insert(values[3].end(), s.volume.begin(), s.volume.end());
      values[4].insert(values[4].end(), s.flux.begin(), s.flux.end());
      m_moving = m_moving || s.moves;
    }
    for (std::size_t a = 0; a < 3; ++a) fill(backend, area[a], first, values[a]);
    fill(backend, volume, first, values[3]);
    fill(backend, flux, first, values[4]);
    open.reset(backend, m_window.cells(), strides());
    backend.forEach("bricks", m_window.keys().size() * kBrickCells,
                    OpenKernel{active.data(), volume.data(), open.data(), strides()});
    backend.upload(cutBricks, walled);
    if (m_sticky) writeSticking(backend, config, first);
  }

  /// Sets bricks of a field; values brick by brick.
  void fill(Backend& backend, Field& field, const std::vector<std::int32_t>& first,
            const std::vector<float>& values) {
    if (first.empty()) return;
    backend.upload(first, m_to);
    backend.upload(values, m_values);
    backend.forEach("bricks", values.size(),
                    FillBricksKernel{m_to.data(), m_values.data(), field.data(), strides()});
  }

  std::size_t bytes() const {
    std::size_t sum = 0;
    const auto add = [&](const auto& set) {
      for (const Field& f : set) sum += f.bytes();
    };
    add(u), add(next), add(mid), add(q), add(pressure), add(area), add(wall), add(wind), add(down);
    for (const Field* f :
         {&volume, &open, &flux, &load, &sticks, &hat, &least, &most, &sweepA, &sweepB, &volumeA, &volumeB})
      sum += f->bytes();
    return sum;
  }

 private:
  struct Moves {
    std::vector<std::int32_t> from, to;
  };

  static std::int32_t firstOf(const AirWindow& window, const BrickKey& key) {
    const std::int32_t place = window.nearPlace(key);
    return place < 0 ? -1 : window.near()[static_cast<std::size_t>(place)].first;
  }

  /// Bricks of a list that are in another one too, both in order.
  Moves movesOf(const AirWindow& old, const std::vector<BrickKey>& before,
                const std::vector<BrickKey>& now) const {
    Moves moves;
    std::size_t b = 0;
    for (const BrickKey& key : now) {
      while (b < before.size() && brickBefore(before[b], key)) ++b;
      if (b == before.size() || before[b] != key) continue;
      moves.from.push_back(firstOf(old, key));
      moves.to.push_back(firstOf(m_window, key));
    }
    return moves;
  }

  void carry(Backend& backend, const AirWindow& old, const Moves& moves, Field& field) {
    Field moved;
    moved.reset(backend, m_window.cells(), strides());
    if (!moves.from.empty()) {
      backend.upload(moves.from, m_from);
      backend.upload(moves.to, m_to);
      backend.forEach(
          "bricks", moves.from.size() * kBrickCells,
          MoveBricksKernel{m_from.data(), m_to.data(), field.data(), moved.data(), old.strides(), strides()});
    }
    field = std::move(moved);
  }

  static Vec3d brickMiddle(const AirConfig& config, const BrickKey& key) {
    return config.origin +
           config.cell * Vec3d{(key[0] + 0.5) * kBrickX, (key[1] + 0.5) * kBrickY, (key[2] + 0.5) * kBrickZ};
  }

  /// Bricks that were not near before get the wind.
  void fillWind(Backend& backend, const AirConfig& config, const AirWindow& old, const Moves& around) {
    std::vector<std::int32_t> first;
    std::array<std::vector<float>, 3> values;
    for (std::size_t k = 0; m_windy && k < m_window.nearKeys().size(); ++k) {
      if (old.nearPlace(m_window.nearKeys()[k]) >= 0) continue;
      first.push_back(m_window.near()[k].first);
      appendWind(config, m_window.nearKeys()[k], values);
    }
    for (std::size_t a = 0; m_windy && a < 3; ++a) {
      carry(backend, old, around, wind[a]);
      for (Field* f : {&wind[a], &u[a], &next[a], &mid[a]}) fill(backend, *f, first, values[a]);
    }
  }

  /// What is not computed is the wind, whatever was there: it follows from the bricks alone.
  void calmRim(Backend& backend) {
    std::vector<std::int32_t> first, below;
    for (std::size_t k = 0; k < m_window.nearKeys().size(); ++k) {
      const BrickKey& key = m_window.nearKeys()[k];
      if (m_window.activePlace(key) >= 0) continue;
      first.push_back(m_window.near()[k].first);
      below.push_back(0);
      for (std::size_t a = 0; a < 3; ++a) {
        BrickKey lower = key;
        --lower[a];
        if (m_window.activePlace(lower) >= 0) below.back() |= 1 << a;
      }
    }
    if (first.empty()) return;
    backend.upload(first, m_from);
    backend.upload(below, m_to);
    for (std::array<Field, 3>* set : {&u, &next, &mid})
      backend.forEach("bricks", first.size() * kBrickCells,
                      CalmBricksKernel{m_from.data(),
                                       m_to.data(),
                                       {windAt(0), windAt(1), windAt(2)},
                                       {(*set)[0].data(), (*set)[1].data(), (*set)[2].data()},
                                       strides()});
  }

  static void appendWind(const AirConfig& config, const BrickKey& key,
                         std::array<std::vector<float>, 3>& values) {
    for (int z = 0; z < kBrickZ; ++z)
      for (int y = 0; y < kBrickY; ++y)
        for (int x = 0; x < kBrickX; ++x) {
          const Vec3d low{key[0] * kBrickX + x + 0.0, key[1] * kBrickY + y + 0.0, key[2] * kBrickZ + z + 0.0};
          const auto at = [&](Vec3d offset) {
            return config.wind(config.origin + config.cell * (low + offset));
          };
          values[0].push_back(static_cast<float>(at({0.0, 0.5, 0.5}).x));
          values[1].push_back(static_cast<float>(at({0.5, 0.0, 0.5}).y));
          values[2].push_back(static_cast<float>(at({0.5, 0.5, 0.0}).z));
        }
  }

  void cutSolids(const AirConfig& config, const AirWindow& old) {
    std::vector<BrickSolids> solids;
    solids.reserve(m_window.nearKeys().size());
    for (const BrickKey& key : m_window.nearKeys()) {
      const std::int32_t before = old.nearPlace(key);
      solids.push_back(before >= 0 ? m_solids[static_cast<std::size_t>(before)] : cutBrick(config, key));
    }
    m_solids = std::move(solids);
  }

  bool touchesMoving(const AirConfig& config, const BrickKey& key) const {
    const Vec3d half = 0.5 * config.cell * Vec3d{kBrickX + 2.0, kBrickY + 2.0, kBrickZ + 2.0};
    const Vec3d middle = brickMiddle(config, key);
    for (const AirSolid& solid : config.solids) {
      if (!solid.velocity) continue;
      if (solid.low.x <= middle.x + half.x && solid.high.x >= middle.x - half.x &&
          solid.low.y <= middle.y + half.y && solid.high.y >= middle.y - half.y &&
          solid.low.z <= middle.z + half.z && solid.high.z >= middle.z - half.z)
        return true;
    }
    return false;
  }

  /// Which closed faces hold the air, and how fast they move.
  void writeSticking(Backend& backend, const AirConfig& config, const std::vector<std::int32_t>& first) {
    std::array<std::vector<float>, 4> values;
    constexpr std::array<int, 3> kAlong{kBrickX, kBrickY, kBrickZ};
    for (const BrickKey& key : m_window.nearKeys())
      for (int cell = 0; cell < static_cast<int>(kBrickCells); ++cell) {
        const std::array<int, 3> in{cell % kBrickX, cell / kBrickX % kBrickY, cell / (kBrickX * kBrickY)};
        float holds = config.sticky ? 1.0f : 0.0f;
        Vec3d speed{};
        for (std::size_t a = 0; a < 3; ++a)
          for (std::size_t side = 0; side < 2; ++side) {
            const int at = key[a] * kAlong[a] + in[a];
            const bool beyond =
                side == 0 ? at < config.lowBrick[a] * kAlong[a] : at >= config.highBrick[a] * kAlong[a];
            if (!beyond || !config.closed[2 * a + side]) continue;
            holds = config.stickySides[2 * a + side] ? 1.0f : 0.0f;
            speed = config.wallVelocity[2 * a + side];
          }
        values[0].push_back(static_cast<float>(speed.x));
        values[1].push_back(static_cast<float>(speed.y));
        values[2].push_back(static_cast<float>(speed.z));
        values[3].push_back(holds);
      }
    for (std::size_t a = 0; a < 3; ++a) {
      wall[a].reset(backend, m_window.cells(), strides());
      fill(backend, wall[a], first, values[a]);
    }
    sticks.reset(backend, m_window.cells(), strides());
    fill(backend, sticks, first, values[3]);
  }

  AirWindow m_window;
  std::vector<BrickSolids> m_solids;  ///< by nearKeys()
  bool m_sticky = false, m_moving = false, m_windy = false;
  Array<std::int32_t> m_from, m_to;
  Array<float> m_values;
};

}  // namespace spin
