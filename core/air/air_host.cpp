// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/air_host.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/air/scalar_passes.h"
#include "core/air/weight_passes.h"

namespace spin {
namespace {

constexpr std::array<int, 3> kAlong{kBrickX, kBrickY, kBrickZ};

/// Calls what(brick, cell, index) for all cells of the active bricks, in the order of frames.
template <class What>
void forCells(const AirWindow& window, const What& what) {
  const AirStrides s = window.strides();
  for (std::size_t b = 0; b < window.active().size(); ++b)
    for (int c = 0; c < static_cast<int>(kBrickCells); ++c)
      what(b, c,
           static_cast<std::size_t>(window.active()[b].first + c % kBrickX + c / kBrickX % kBrickY * s.y +
                                    c / (kBrickX * kBrickY) * s.z));
}

const BrickSolids& solidsOf(const AirWindow& window, const std::vector<BrickSolids>& solids,
                            std::size_t active) {
  return solids[static_cast<std::size_t>(window.nearPlace(window.keys()[active]))];
}

/// Indices of the upper faces along an axis of bricks that no brick lies beyond.
std::vector<std::uint32_t> upperFaces(const AirWindow& window, std::size_t axis) {
  std::vector<std::uint32_t> index;
  const std::int32_t steps[3] = {1, window.strides().y, window.strides().z};
  for (std::size_t b = 0; b < window.keys().size(); ++b) {
    BrickKey above = window.keys()[b];
    ++above[axis];
    if (window.activePlace(above) >= 0) continue;
    for (int c = 0; c < static_cast<int>(kBrickCells); ++c) {
      const std::array<int, 3> in{c % kBrickX, c / kBrickX % kBrickY, c / (kBrickX * kBrickY)};
      if (in[axis] != kAlong[axis] - 1) continue;
      const std::int32_t at =
          window.active()[b].first + in[0] + in[1] * steps[1] + in[2] * steps[2] + steps[axis];
      index.push_back(static_cast<std::uint32_t>(at));
    }
  }
  return index;
}

Vec3d cellMiddle(const AirConfig& config, const BrickKey& key, int c) {
  return config.origin + config.cell * Vec3d{key[0] * kBrickX + c % kBrickX + 0.5,
                                             key[1] * kBrickY + c / kBrickX % kBrickY + 0.5,
                                             key[2] * kBrickZ + c / (kBrickX * kBrickY) + 0.5};
}

/// kg/m3, with all that hangs in it.
double densityOf(const AirConfig& config, const HostFields& fields, std::size_t at) {
  const auto of = [&](std::size_t a) { return static_cast<double>(fields.q[a][at]); };
  double growth = 0.0;
  const double vapour = config.humidity * saturatedVapour(config.temperature, growth) + of(3);
  return moistDensity(config.temperature + of(2), vapour, config.pressure) + of(0) + of(1);
}

AirField emptyField(const char* name, const char* unit, int components, const AirWindow& window) {
  AirField field{name, unit, components, 1.0f, {}};
  field.halves.assign(window.keys().size() * kBrickCells * static_cast<std::size_t>(components), 0);
  return field;
}

/// Sets the largest magnitude to 2^15 by a power of two, so that small values keep their digits.
float scaleFor(float largest) {
  if (!(largest > 0.0f) || !std::isfinite(largest)) return 1.0f;
  return std::exp2(std::ceil(std::log2(largest)) - 15.0f);
}

AirField scalarField(const char* name, const char* unit, const AirWindow& window,
                     const std::vector<float>& values) {
  AirField field = emptyField(name, unit, 1, window);
  float largest = 0.0f;
  forCells(window,
           [&](std::size_t, int, std::size_t at) { largest = std::max(largest, std::abs(values[at])); });
  field.scale = scaleFor(largest);
  std::size_t k = 0;
  forCells(window, [&](std::size_t, int, std::size_t at) {
    field.halves[k++] = halfFromFloat(values[at] / field.scale);
  });
  return field;
}

AirField velocityField(const AirConfig& config, const AirWindow& window,
                       const std::vector<BrickSolids>& solids, const HostFields& fields) {
  AirField field = emptyField("velocity", "m/s", 3, window);
  const std::int32_t steps[3] = {1, window.strides().y, window.strides().z};
  forCells(window, [&](std::size_t b, int c, std::size_t at) {
    const BrickKey& key = window.keys()[b];
    CellFaces faces;
    for (std::size_t a = 0; a < 3; ++a) {
      faces.low[a] = fields.u[a][at];
      faces.high[a] = fields.u[a][at + static_cast<std::size_t>(steps[a])];
    }
    closeFaces(config, window, solids,
               {key[0] * kBrickX + c % kBrickX, key[1] * kBrickY + c / kBrickX % kBrickY,
                key[2] * kBrickZ + c / (kBrickX * kBrickY)},
               faces);
    for (std::size_t a = 0; a < 3; ++a)
      field.halves[(b * 3 + a) * kBrickCells + static_cast<std::size_t>(c)] =
          halfFromFloat(0.5f * (faces.low[a] + faces.high[a]));
  });
  return field;
}

/// Open shares of a cell's upper face: the lower one of the next cell.
float upperArea(const AirWindow& window, const std::vector<BrickSolids>& solids, std::size_t b, int c,
                std::size_t axis) {
  std::array<int, 3> in{c % kBrickX, c / kBrickX % kBrickY, c / (kBrickX * kBrickY)};
  BrickKey key = window.keys()[b];
  if (++in[axis] == kAlong[axis]) {
    in[axis] = 0;
    ++key[axis];
  }
  const BrickSolids& there = solids[static_cast<std::size_t>(window.nearPlace(key))];
  return there.area[axis][static_cast<std::size_t>((in[2] * kBrickY + in[1]) * kBrickX + in[0])];
}

AirField divergenceField(const AirConfig& config, const AirWindow& window,
                         const std::vector<BrickSolids>& solids, const HostFields& fields) {
  AirField field = emptyField("divergence", "1/s", 1, window);
  const std::int32_t steps[3] = {1, window.strides().y, window.strides().z};
  std::vector<float> values(field.halves.size());
  float largest = 0.0f;
  std::size_t k = 0;
  forCells(window, [&](std::size_t b, int c, std::size_t at) {
    const BrickSolids& own = solidsOf(window, solids, b);
    const auto cell = static_cast<std::size_t>(c);
    double sum = static_cast<double>(own.flux[cell]);
    for (std::size_t a = 0; a < 3; ++a) {
      const float high = std::max(upperArea(window, solids, b, c, a), 0.0f),
                  low = std::max(own.area[a][cell], 0.0f);
      sum += static_cast<double>(high * fields.u[a][at + static_cast<std::size_t>(steps[a])] -
                                 low * fields.u[a][at]);
    }
    values[k] = own.volume[cell] > 0.0f ? static_cast<float>(sum / config.cell) : 0.0f;
    largest = std::max(largest, std::abs(values[k++]));
  });
  field.scale = scaleFor(largest);
  for (std::size_t i = 0; i < values.size(); ++i) field.halves[i] = halfFromFloat(values[i] / field.scale);
  return field;
}

/// Bricks of a window that are no farther than kNear cells from those that hold something or were touched.
class CloudZone {
 public:
  CloudZone(const AirWindow& window, const std::vector<double>& activity,
            const std::vector<BrickKey>& touched)
      : m_window(window), m_in(slot(window.bricksAlong()) + 1, 0) {
    for (std::size_t b = 0; b < activity.size(); ++b)
      if (activity[b] >= ActivityPass::kHolds) mark(window.keys()[b]);
    for (const BrickKey& key : touched)
      if (window.activePlace(key) >= 0) mark(key);
  }
  bool holds(const BrickKey& key) const { return m_in[slot(inWindow(key))] != 0; }

 private:
  static constexpr int kNear = 16;

  BrickKey inWindow(const BrickKey& key) const {
    const BrickKey& low = m_window.low();
    return {key[0] - low[0], key[1] - low[1], key[2] - low[2]};
  }
  std::size_t slot(const BrickKey& k) const {
    const BrickKey count = m_window.bricksAlong();
    return (static_cast<std::size_t>(k[2]) * static_cast<std::size_t>(count[1]) +
            static_cast<std::size_t>(k[1])) *
               static_cast<std::size_t>(count[0]) +
           static_cast<std::size_t>(k[0]);
  }
  void mark(const BrickKey& key) {
    const BrickKey middle = inWindow(key), count = m_window.bricksAlong();
    BrickKey low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int32_t far = (kNear + kAlong[a] - 1) / kAlong[a];
      low[a] = std::max(middle[a] - far, 0);
      high[a] = std::min(middle[a] + far, count[a] - 1);
    }
    for (std::int32_t z = low[2]; z <= high[2]; ++z)
      for (std::int32_t y = low[1]; y <= high[1]; ++y)
        for (std::int32_t x = low[0]; x <= high[0]; ++x) m_in[slot({x, y, z})] = 1;
  }

  const AirWindow& m_window;
  std::vector<std::uint8_t> m_in;  ///< by brick of the window
};

}  // namespace

std::vector<std::int32_t> firstCells(const AirWindow& window) {
  std::vector<std::int32_t> first;
  for (const AirBrick& brick : window.active()) first.push_back(brick.first);
  return first;
}

std::vector<BrickKey> bricksRound(const AirConfig& config, const AirWindow& window,
                                  const std::vector<double>& activity, const std::vector<BrickKey>& touched) {
  // A sub-step carries by mostCourant cells; a brick that grows empty is kept a little longer.
  constexpr double kEmpty = 0.5;
  BrickKey reach{};
  for (std::size_t a = 0; a < 3; ++a)
    reach[a] = std::max(1, static_cast<int>(std::ceil(config.mostCourant / kAlong[a])));
  const CloudZone zone(window, activity, touched);
  std::vector<BrickKey> keys;
  for (std::size_t b = 0; b < activity.size(); ++b) {
    const BrickKey& key = window.keys()[b];
    if (activity[b] > kEmpty) keys.push_back(key);
    if (activity[b] <= 1.0 || !zone.holds(key)) continue;
    for (std::int32_t z = -reach[2]; z <= reach[2]; ++z)
      for (std::int32_t y = -reach[1]; y <= reach[1]; ++y)
        for (std::int32_t x = -reach[0]; x <= reach[0]; ++x) {
          const BrickKey there{key[0] + x, key[1] + y, key[2] + z};
          if (inDomain(config, there)) keys.push_back(there);
        }
  }
  return keys;
}

void appendDeposits(const AirConfig& config, const AirWindow& window, const std::vector<float>& mist,
                    const std::vector<float>& snow, std::vector<AirDeposit>& to) {
  const double volume = config.cell * config.cell * config.cell;
  forCells(window, [&](std::size_t b, int c, std::size_t at) {
    if (mist[at] <= 0.0f && snow[at] <= 0.0f) return;
    to.push_back({cellMiddle(config, window.keys()[b], c), volume * static_cast<double>(mist[at]),
                  volume * static_cast<double>(snow[at])});
  });
}

void publishAir(const AirConfig& config, const AirWindow& window, const std::vector<BrickSolids>& solids,
                const HostFields& fields, bool divergence, AirPart& part) {
  part.origin = config.origin;
  part.cell = config.cell;
  part.temperature = config.temperature;
  part.bricks = window.keys();
  part.fields.clear();
  part.fields.push_back(scalarField("mist", "kg/m3", window, fields.q[0]));
  part.fields.push_back(scalarField("snow", "kg/m3", window, fields.q[1]));
  part.fields.push_back(scalarField("temperature", "K", window, fields.q[2]));
  part.fields.push_back(scalarField("vapour", "kg/m3", window, fields.q[3]));
  part.fields.push_back(velocityField(config, window, solids, fields));
  if (divergence) part.fields.push_back(divergenceField(config, window, solids, fields));
}

std::string firstBroken(const AirConfig& config, const AirWindow& window,
                        const std::vector<BrickSolids>& solids, const HostFields& fields) {
  constexpr std::array<const char*, 9> kNames{
      "velocity along x", "velocity along y", "velocity along z", "mist",           "snow",
      "warmth",           "vapour",           "pressure",         "second pressure"};
  const std::vector<float>* const lists[9] = {&fields.u[0], &fields.u[1],        &fields.u[2],
                                              &fields.q[0], &fields.q[1],        &fields.q[2],
                                              &fields.q[3], &fields.pressure[0], &fields.pressure[1]};
  std::string found;
  forCells(window, [&](std::size_t b, int c, std::size_t at) {
    if (!found.empty()) return;
    const BrickKey& key = window.keys()[b];
    const auto place = [&] {
      const Vec3d p = cellMiddle(config, key, c);
      return fmt::format(" at ({:.5g}, {:.5g}, {:.5g}) m", p.x, p.y, p.z);
    };
    for (std::size_t k = 0; k < 9 && found.empty(); ++k)
      if (!std::isfinite((*lists[k])[at])) found = fmt::format("its {} is not finite", kNames[k]) + place();
    for (std::size_t k = 0; k < 3 && found.empty(); ++k)
      if (std::abs(static_cast<double>(fields.u[k][at])) >= kMostSpeed)
        found = fmt::format("its {} is {:.3g} m/s", kNames[k], fields.u[k][at]) + place();
    const double temperature = config.temperature + static_cast<double>(fields.q[2][at]);
    if (!found.empty() || solidsOf(window, solids, b).volume[static_cast<std::size_t>(c)] <= 0.0f) return;
    if (temperature < kLeastTemperature)
      found = fmt::format("the air is at {:.4g} K", temperature) + place();
    else if (densityOf(config, fields, at) <= 0.0)
      found = "the air weighs nothing" + place();
  });
  return found.empty() ? "a number is not finite" : found;
}

AirState packState(const AirWindow& window, const std::vector<BrickSolids>& solids,
                   const HostFields& fields) {
  AirState state;
  state.bricks = window.keys();
  state.values.reserve(kAirFields * window.keys().size() * kBrickCells);
  const auto add = [&](const std::vector<float>& values) {
    forCells(window, [&](std::size_t, int, std::size_t at) { state.values.push_back(values[at]); });
  };
  for (const auto& values : fields.u) add(values);
  for (const auto& values : fields.q) add(values);
  for (const auto& values : fields.pressure) add(values);
  for (std::size_t b = 0; b < window.keys().size(); ++b) {
    const auto& volume = solidsOf(window, solids, b).volume;
    state.values.insert(state.values.end(), volume.begin(), volume.end());
  }
  for (std::size_t a = 0; a < 3; ++a)
    for (const std::uint32_t at : upperFaces(window, a)) state.upper[a].push_back(fields.u[a][at]);
  return state;
}

Status checkAirState(const AirConfig& config, const AirState& state) {
  const auto bad = [](const char* why) {
    return Error{ErrorKind::BadInput, "The air's state could not be used", "air", why,
                 "Simulate from the start"};
  };
  if (state.values.size() != kAirFields * state.bricks.size() * kBrickCells)
    return bad("its arrays do not fit its bricks");
  for (std::size_t k = 0; k < state.bricks.size(); ++k) {
    if (!inDomain(config, state.bricks[k])) return bad("a brick lies outside the domain");
    if (k > 0 && !brickBefore(state.bricks[k - 1], state.bricks[k]))
      return bad("its bricks are not in order");
  }
  const auto finite = [](float v) { return std::isfinite(v); };
  bool whole = std::all_of(state.values.begin(), state.values.end(), finite);
  for (const auto& upper : state.upper) whole = whole && std::all_of(upper.begin(), upper.end(), finite);
  return whole ? Status{} : bad("a value is not finite");
}

void listUpperFaces(const AirWindow& window, const AirState& state, std::size_t axis,
                    std::vector<std::uint32_t>& index, std::vector<float>& values) {
  const std::vector<std::uint32_t> all = upperFaces(window, axis);
  if (all.size() != state.upper[axis].size()) return;
  index = all;
  values = state.upper[axis];
}

}  // namespace spin
