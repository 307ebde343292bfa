// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/air/air_fields.h"
#include "core/air/air_passes.h"

namespace spin {

/// What the air carries: by fluxes, so that mass is kept to rounding.
template <class Backend>
class AirTransport {
 public:
  using Fields = AirFields<Backend>;
  using Field = PaddedArray<Backend>;
  using Passes = AirPasses<Backend>;

  /// Content per brick, in cells' volumes.
  const std::vector<double>& contents(Backend& backend, Passes& passes, const Fields& f,
                                      std::size_t scalar) const {
    return passes.results(backend, "budget", f.strides(), f.active,
                          ContentPass{f.q[scalar].data(), f.volume.data()});
  }
  double content(Backend& backend, Passes& passes, const Fields& f, std::size_t scalar) const {
    return f.window().keys().empty() ? 0.0 : total(contents(backend, passes, f, scalar));
  }

  /// Per brick: below 1 it is as good as empty.
  std::vector<double> activity(Backend& backend, Passes& passes, const Fields& f,
                               const AirConfig& config) const {
    ActivityPass pass{};
    pass.strides = f.strides();
    for (std::size_t a = 0; a < kAirScalars; ++a) {
      pass.q[a] = f.q[a].data();
      pass.least[a] = static_cast<float>(config.least[a]);
    }
    for (std::size_t a = 0; a < 3; ++a) {
      pass.u[a] = f.u[a].data();
      pass.area[a] = f.area[a].data();
      pass.wind[a] = f.windAt(a);
    }
    pass.open = f.open.data();
    pass.leastSpeed = static_cast<float>(config.leastSpeed);
    return passes.results(backend, "bricks", f.strides(), f.active, pass);
  }

  /// False where a speed is too high for steps to be counted, or none.
  bool step(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, double seconds,
            AirBudget& budget) {
    constexpr double kMostParts = 1e6;
    const std::array<double, kAirScalars> settling{config.settling[0], config.settling[1], 0.0, 0.0};
    for (std::size_t a = 0; a < kAirScalars; ++a) {
      // What is nowhere need not be carried.
      if (!holdsAny(backend, passes, f, a)) continue;
      const double out = mostOutflow(backend, passes, f, seconds / config.cell, settling[a]);
      if (!(out < kMostParts)) return false;
      const int parts = std::max(1, static_cast<int>(std::ceil(out)));
      for (int k = 0; k < parts; ++k) {
        m_forward = !m_forward;
        carry(backend, passes, f, config, a, seconds / parts, settling[a], budget);
        if (a < 2 && settling[a] > 0.0)
          settle(backend, passes, f, config, a, seconds / parts, settling[a], budget);
      }
    }
    return true;
  }

  /// Order of the axes in the latest carrying; it turns each time.
  bool forward() const { return m_forward; }
  void setForward(bool forward) { m_forward = forward; }

  /// False where a cell's state is none afterwards.
  bool condense(Backend& backend, Passes& passes, Fields& f, const AirConfig& config,
                const AirAmbient& ambient, AirBudget& budget) {
    const double condensed =
        volumeOf(config) * total(passes.results(backend, "phase change", f.strides(), f.active,
                                                CondensePass{f.volume.data(), f.open.data(), f.q[0].data(),
                                                             f.q[2].data(), f.q[3].data(), ambient}));
    if (!std::isfinite(condensed)) return false;
    budget.condensed[0] += condensed;
    budget.condensed[3] -= condensed;
    budget.condensed[2] += condensed * kEvaporationHeat / kDryAirHeat / static_cast<double>(ambient.density);
    return true;
  }

 private:
  static double total(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum;
  }
  static double volumeOf(const AirConfig& config) { return config.cell * config.cell * config.cell; }

  bool holdsAny(Backend& backend, Passes& passes, const Fields& f, std::size_t scalar) const {
    const std::vector<double>& values =
        passes.results(backend, "budget", f.strides(), f.active, LargestPass{f.q[scalar].data()});
    return std::any_of(values.begin(), values.end(), [](double v) { return v > 0.0; });
  }

  double mostOutflow(Backend& backend, Passes& passes, const Fields& f, double cells, double settling) const {
    const std::vector<double>& values =
        passes.results(backend, "carry scalars", f.strides(), f.active,
                       OutflowPass{f.strides(),
                                   {f.u[0].data(), f.u[1].data(), f.u[2].data()},
                                   {f.area[0].data(), f.area[1].data(), f.area[2].data()},
                                   f.open.data(),
                                   f.volume.data(),
                                   static_cast<float>(cells),
                                   static_cast<float>(settling)});
    double most = 0.0;
    for (const double v : values) most = v > most || std::isnan(v) ? v : most;
    return most;
  }

  template <int axis>
  void sweep(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, const float* q,
             const float* volume, float* to, float* volumeTo, double seconds, double settling,
             std::size_t scalar, AirBudget& budget) {
    const std::vector<double>& left =
        passes.results(backend, "carry scalars", f.strides(), f.active,
                       SweepPass<axis>{f.strides(), q, volume, f.u[axis].data(), f.area[axis].data(),
                                       f.open.data(), volumeTo ? nullptr : f.volume.data(), to, volumeTo,
                                       static_cast<float>(seconds / config.cell),
                                       static_cast<float>(axis == 2 ? settling : 0.0)});
    const double cell = volumeOf(config);
    for (std::size_t b = 0; b < left.size(); ++b) {
      if (left[b] == 0.0) continue;
      const BrickKey& key = f.window().keys()[b];
      const bool side = key[axis] == config.lowBrick[axis] || key[axis] == config.highBrick[axis] - 1;
      (side ? budget.leftSides : budget.givenUp)[scalar] += cell * left[b];
    }
  }

  /// x, y, z, or the other way round, in turn.
  void carry(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, std::size_t a,
             double seconds, double settling, AirBudget& budget) {
    float *q = f.q[a].data(), *one = f.sweepA.data(), *two = f.sweepB.data();
    float *volumeOne = f.volumeA.data(), *volumeTwo = f.volumeB.data();
    if (m_forward) {
      sweep<0>(backend, passes, f, config, q, f.volume.data(), one, volumeOne, seconds, settling, a, budget);
      sweep<1>(backend, passes, f, config, one, volumeOne, two, volumeTwo, seconds, settling, a, budget);
      sweep<2>(backend, passes, f, config, two, volumeTwo, q, nullptr, seconds, settling, a, budget);
    } else {
      sweep<2>(backend, passes, f, config, q, f.volume.data(), one, volumeOne, seconds, settling, a, budget);
      sweep<1>(backend, passes, f, config, one, volumeOne, two, volumeTwo, seconds, settling, a, budget);
      sweep<0>(backend, passes, f, config, two, volumeTwo, q, nullptr, seconds, settling, a, budget);
    }
  }

  void settle(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, std::size_t a,
              double seconds, double speed, AirBudget& budget) {
    budget.deposited[a] +=
        volumeOf(config) *
        total(passes.results(
            backend, "settling", f.strides(), f.active,
            DepositPass{f.strides(), f.area[2].data(), f.volume.data(), f.open.data(), f.q[a].data(),
                        f.down[a].data(), static_cast<float>(speed * seconds / config.cell)}));
  }

  bool m_forward = false;
};

}  // namespace spin
