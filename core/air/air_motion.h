// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/air/air_fields.h"
#include "core/air/pressure_solve.h"

namespace spin {

/// The velocities' part of a step: weight, carrying, diffusion, projection.
template <class Backend>
class AirMotion {
 public:
  using Fields = AirFields<Backend>;
  using Field = PaddedArray<Backend>;
  using Passes = AirPasses<Backend>;

  void rebuild(Backend& backend, const Fields& fields) {
    m_pressure.rebuild(backend, fields.window(), fields.solids());
    m_ready = false;
  }
  std::size_t bytes() const { return m_pressure.bytes(); }

  double fastest(Backend& backend, Passes& passes, const Fields& f) const {
    const std::vector<double>& values =
        passes.results(backend, "step", f.strides(), f.faces,
                       FastestPass{{f.u[0].data(), f.u[1].data(), f.u[2].data()},
                                   {f.area[0].data(), f.area[1].data(), f.area[2].data()}});
    return largest(values);
  }

  /// Density over that round the cloud, less 1; returns the largest, not a number where a cell cannot be.
  double weigh(Backend& backend, Passes& passes, Fields& f, const AirConfig& config,
               const AirAmbient& ambient) const {
    const std::vector<double>& values =
        passes.results(backend, "weight", f.strides(), f.active,
                       LoadPass{{f.q[0].data(), f.q[1].data(), f.q[2].data(), f.q[3].data()},
                                ambient,
                                config.buoyancy == AirBuoyancy::FogDensity ? 1 : 0,
                                f.load.data()});
    return largest(values);
  }

  /// Returns the stage in which a number was not finite, or null.
  template <class Book>
  const char* step(Backend& backend, Passes& passes, Fields& f, const AirConfig& config,
                   const AirAmbient& ambient, double seconds, const Book& book) {
    const double most = weigh(backend, passes, f, config, ambient);
    if (!std::isfinite(most)) return "weight";
    // Boussinesq's approximation while nothing is a tenth heavier than the air round it.
    const bool heavy = most > 0.1;
    if (heavy || m_heavy || !m_ready) {
      const float* area[3] = {f.area[0].data(), f.area[1].data(), f.area[2].data()};
      m_pressure.coefficients(backend, passes, area, f.open.data(), heavy ? f.load.data() : nullptr);
      m_heavy = heavy;
      m_ready = true;
    }
    const bool carries = config.stages.advectVelocity;
    if (config.stages.diffuse) mixEddies(backend, passes, f, config, seconds);
    if (config.reflection && carries && config.stages.project)
      return reflected(backend, passes, f, config, seconds, book);
    if (carries) {
      carry(backend, passes, f, config, f.u, f.u, f.next, seconds);
      std::swap(f.u, f.next);
    }
    push(backend, passes, f, config, f.u, seconds);
    if (config.stages.diffuse) diffuse(backend, passes, f, config, f.u, seconds);
    if (config.stages.project && !book(project(backend, passes, f, config, f.u, 0))) return kPressure;
    return nullptr;
  }

 private:
  static constexpr const char* kPressure = "pressure";

  /// Two half steps; what the first projection took is taken once more before the second (Zehnder et al.
  /// 2018), so that it does not cost energy.
  template <class Book>
  const char* reflected(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, double seconds,
                        const Book& book) {
    const double half = 0.5 * seconds;
    carry(backend, passes, f, config, f.u, f.u, f.next, half);
    push(backend, passes, f, config, f.next, half);
    if (config.stages.diffuse) diffuse(backend, passes, f, config, f.next, half);
    passes.run(backend, "reflection", f.strides(), f.near,
               CopyPass{{f.next[0].data(), f.next[1].data(), f.next[2].data()},
                        {f.mid[0].data(), f.mid[1].data(), f.mid[2].data()}});
    if (!book(project(backend, passes, f, config, f.next, 0))) return kPressure;
    passes.run(backend, "reflection", f.strides(), f.faces,
               ReflectPass{{f.next[0].data(), f.next[1].data(), f.next[2].data()},
                           {f.mid[0].data(), f.mid[1].data(), f.mid[2].data()}});
    carry(backend, passes, f, config, f.next, f.mid, f.u, half);
    push(backend, passes, f, config, f.u, half);
    if (config.stages.diffuse) diffuse(backend, passes, f, config, f.u, half);
    return book(project(backend, passes, f, config, f.u, 1)) ? nullptr : kPressure;
  }

  AirSolve project(Backend& backend, Passes& passes, Fields& f, const AirConfig& config,
                   std::array<Field, 3>& u, std::size_t which) {
    const float* area[3] = {f.area[0].data(), f.area[1].data(), f.area[2].data()};
    float* velocity[3] = {u[0].data(), u[1].data(), u[2].data()};
    return m_pressure.project(backend, passes, config, area, f.moving() ? f.flux.data() : nullptr, velocity,
                              f.pressure[which].data());
  }

  template <int axis>
  void ghosts(Backend& backend, Passes& passes, Fields& f, Field& u) {
    if (f.walled.size() == 0) return;
    passes.run(backend, "walls", f.strides(), f.walled,
               GhostPass<axis>{f.strides(), f.area[axis].data(), f.sticky() ? f.sticks.data() : nullptr,
                               f.sticky() ? f.wall[axis].data() : nullptr, u.data()});
  }

  template <int axis>
  void carryAxis(Backend& backend, Passes& passes, Fields& f, const AirConfig& config,
                 const VelocityView& view, const Field& from, Field& to, float cells) {
    const float *area = f.area[axis].data(), *open = f.open.data();
    if (config.advection == AirAdvection::Cubic) {
      passes.run(backend, "carry velocity", f.strides(), f.faces,
                 CarryCubicPass<axis>{view, from.data(), area, open, to.data(), cells});
      return;
    }
    const bool twice = config.advection == AirAdvection::MacCormack;
    if (twice)
      passes.run(backend, "carry velocity", f.strides(), f.near, CopyOnePass{from.data(), f.hat.data()});
    Field& first = twice ? f.hat : to;
    passes.run(backend, "carry velocity", f.strides(), f.faces,
               CarryPass<axis>{view, from.data(), area, open, first.data(), twice ? f.least.data() : nullptr,
                               twice ? f.most.data() : nullptr, cells});
    if (!twice) return;
    ghosts<axis>(backend, passes, f, f.hat);
    passes.run(backend, "carry velocity", f.strides(), f.faces,
               CarryBackPass<axis>{view, from.data(), f.hat.data(), area, open, f.least.data(), f.most.data(),
                                   to.data(), cells});
  }

  /// `from` carried by `by` into `to`.
  void carry(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, std::array<Field, 3>& by,
             std::array<Field, 3>& from, std::array<Field, 3>& to, double seconds) {
    for (std::array<Field, 3>* set : {&by, &from}) {
      ghosts<0>(backend, passes, f, (*set)[0]);
      ghosts<1>(backend, passes, f, (*set)[1]);
      ghosts<2>(backend, passes, f, (*set)[2]);
      if (&by == &from) break;
    }
    const VelocityView view{f.strides(), f.window().dims(), {by[0].data(), by[1].data(), by[2].data()}};
    const auto cells = static_cast<float>(seconds / config.cell);
    carryAxis<0>(backend, passes, f, config, view, from[0], to[0], cells);
    carryAxis<1>(backend, passes, f, config, view, from[1], to[1], cells);
    carryAxis<2>(backend, passes, f, config, view, from[2], to[2], cells);
  }

  void push(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, std::array<Field, 3>& u,
            double seconds) {
    if (!config.stages.forces || config.gravity.z == 0.0) return;
    passes.run(backend, "weight", f.strides(), f.faces,
               BuoyancyPass{f.strides(), f.load.data(), f.area[2].data(), f.open.data(), u[2].data(),
                            static_cast<float>(config.gravity.z * seconds),
                            config.buoyancy == AirBuoyancy::StackedCells ? 1 : 0});
  }

  void mixEddies(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, double seconds) {
    if (config.smagorinsky <= 0.0) return;
    ghosts<0>(backend, passes, f, f.u[0]);
    ghosts<1>(backend, passes, f, f.u[1]);
    ghosts<2>(backend, passes, f, f.u[2]);
    const double share = config.smagorinsky * config.smagorinsky * seconds / config.cell;
    passes.run(backend, "eddies", f.strides(), f.near,
               StrainPass{f.strides(),
                          {f.u[0].data(), f.u[1].data(), f.u[2].data()},
                          f.hat.data(),
                          static_cast<float>(share)});
    mixAxis<0>(backend, passes, f);
    mixAxis<1>(backend, passes, f);
    mixAxis<2>(backend, passes, f);
    std::swap(f.u, f.next);
  }

  template <int axis>
  void mixAxis(Backend& backend, Passes& passes, Fields& f) {
    passes.run(backend, "eddies", f.strides(), f.faces,
               EddyMixPass<axis>{f.strides(), f.area[axis].data(), f.open.data(), f.hat.data(),
                                 f.u[axis].data(), f.next[axis].data()});
  }

  void diffuse(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, std::array<Field, 3>& u,
               double seconds) {
    if (config.viscosity <= 0.0) return;
    const auto share = static_cast<float>(config.viscosity * seconds / (config.cell * config.cell));
    diffuseAxis<0>(backend, passes, f, config, u[0], share);
    diffuseAxis<1>(backend, passes, f, config, u[1], share);
    diffuseAxis<2>(backend, passes, f, config, u[2], share);
  }

  /// What is not a number stays.
  static double largest(const std::vector<double>& values) {
    double most = 0.0;
    for (const double v : values) most = v > most || std::isnan(v) ? v : most;
    return most;
  }
  static double total(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum;
  }

  /// Backward Euler by conjugate gradients, which need few steps: the identity rules the matrix.
  template <int axis>
  void diffuseAxis(Backend& backend, Passes& passes, Fields& f, const AirConfig& config, Field& u,
                   float share) {
    constexpr int kMost = 2000;
    const char* name = "diffusion";
    const float *area = f.area[axis].data(), *open = f.open.data(),
                *sticks = f.sticky() ? f.sticks.data() : nullptr;
    const float* wall = f.sticky() ? f.wall[axis].data() : nullptr;
    Field &r = f.hat, &s = f.least, &q = f.most;
    s.reset(backend, f.window().cells(), f.strides());
    const double norm = total(passes.results(backend, name, f.strides(), f.faces,
                                             NormPass<axis>{f.strides(), area, open, u.data()}));
    double left = total(passes.results(backend, name, f.strides(), f.faces,
                                       DiffuseResidualPass<axis>{f.strides(), area, open, sticks, wall,
                                                                 u.data(), u.data(), r.data(), share}));
    const double enough = config.diffusionTolerance * config.diffusionTolerance * std::max(norm, left);
    double factor = 0.0;
    for (int k = 0; k < kMost && left > enough; ++k) {
      passes.run(backend, name, f.strides(), f.faces,
                 DirectionPass{r.data(), s.data(), static_cast<float>(factor)});
      const double product = total(passes.results(
          backend, name, f.strides(), f.faces,
          DiffuseProductPass<axis>{f.strides(), area, open, sticks, s.data(), q.data(), share}));
      if (!(product > 0.0)) break;
      const double next = total(passes.results(
          backend, name, f.strides(), f.faces,
          AdvancePass{s.data(), q.data(), u.data(), r.data(), static_cast<float>(left / product)}));
      factor = next / left;
      left = next;
    }
  }

  PressureSolve<Backend> m_pressure;
  bool m_ready = false, m_heavy = false;
};

}  // namespace spin
