// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/air/air_passes.h"
#include "core/air/air_pockets.h"
#include "core/air/air_solver.h"
#include "core/air/padded_array.h"

namespace spin {

/// How a projection went.
struct AirSolve {
  int iterations = 0;
  double residual = 0.0;  ///< over the right side, root mean squares; not finite: nothing was solved
  bool reached = true;
};

/// The pressure's equation: conjugate gradients whose preconditioner is one V-cycle of multigrid. Cells are
/// joined by eight, corrections are handed down as they are, and the coarse equation is the fine one's own at
/// twice the edge, which makes up for the constant interpolation (Braess 1995 doubles the correction; here
/// the factor is in the coefficients). Smoothing: two damped Jacobi sweeps before and two after, with the
/// damping of Chebyshev's polynomial.
template <class Backend>
class PressureSolve {
 public:
  template <class T>
  using Array = typename Backend::template Array<T>;

  /// Lists and arrays for a window; pressures themselves are the caller's.
  void rebuild(Backend& backend, const AirWindow& window, const std::vector<BrickSolids>& solids) {
    m_levels.clear();
    addLevel(backend, window.dims(), window.active(), window.faces());
    // A brick of its own is 16 cells long: two levels more leave four.
    for (int more = 2; m_levels.size() < kMostLevels && more > 0;) {
      if (extent(m_levels.back()->hostActive) == 1) --more;
      const Level& fine = *m_levels.back();
      const CoarseBricks coarse = coarserBricks(fine.dims, fine.hostActive);
      addLevel(backend, coarse.dims, coarse.active, coarse.faces);
    }
    for (PaddedArray<Backend>* a : {&m_direction, &m_product})
      a->reset(backend, window.cells(), window.strides());
    m_pockets.clear();
    for (const std::vector<std::uint32_t>& cells : findPockets(window, solids)) {
      m_pockets.emplace_back();
      backend.upload(cells, m_pockets.back());
    }
  }

  /// Coefficients of all levels; `load` null where the density is that round the cloud.
  void coefficients(Backend& backend, AirPasses<Backend>& passes, const float* const area[3],
                    const float* open, const float* load) {
    Level& finest = *m_levels.front();
    passes.run(backend, "pressure set-up", finest.strides(), finest.faces,
               CoefficientPass{finest.strides(),
                               {area[0], area[1], area[2]},
                               open,
                               load,
                               {finest.c[0].data(), finest.c[1].data(), finest.c[2].data()}});
    for (std::size_t l = 0; l < m_levels.size(); ++l) {
      Level& level = *m_levels[l];
      if (l > 0) {
        passes.run(backend, "pressure set-up", level.strides(), level.faces, coarsening(l));
      }
      passes.run(backend, "pressure set-up", level.strides(), level.active,
                 DiagonalPass{level.strides(), level.c[0].data(), level.c[1].data(), level.c[2].data(),
                              l > 0 ? level.lengths[0].data() : open, level.inverse.data()});
    }
  }

  /// Makes u free of divergence; `pressure` is where it begins and what it ends with.
  AirSolve project(Backend& backend, AirPasses<Backend>& passes, const AirConfig& config,
                   const float* const area[3], const float* solidFlux, float* const u[3], float* pressure) {
    Level& finest = *m_levels.front();
    const double right = total(passes.results(backend, "pressure", finest.strides(), finest.active,
                                              AirDivergencePass{finest.strides(),
                                                                {area[0], area[1], area[2]},
                                                                {u[0], u[1], u[2]},
                                                                solidFlux,
                                                                finest.inverse.data(),
                                                                finest.b.data()}));
    AirSolve solve;
    // Before the solution carries it everywhere.
    if (!std::isfinite(right)) return {0, right, false};
    emptyPockets(backend, finest.b.data());
    if (config.solver == AirPressure::Multigrid)
      solve = gradients(backend, passes, config, right, pressure);
    else
      solve = sweeps(backend, passes, config, right, pressure);
    passes.run(backend, "pressure", finest.strides(), finest.faces,
               CorrectPass{finest.strides(),
                           {area[0], area[1], area[2]},
                           {finest.c[0].data(), finest.c[1].data(), finest.c[2].data()},
                           pressure,
                           {u[0], u[1], u[2]}});
    return solve;
  }

  std::size_t bytes() const {
    std::size_t sum = m_direction.bytes() + m_product.bytes();
    for (const auto& level : m_levels)
      for (const PaddedArray<Backend>* a : {&level->c[0], &level->c[1], &level->c[2], &level->inverse,
                                            &level->b, &level->x, &level->next, &level->r})
        sum += a->bytes();
    return sum;
  }

 private:
  static constexpr std::size_t kMostLevels = 12;
  /// Chebyshev's two dampings for eigenvalues of D^-1 A from a quarter of the largest, 2, up.
  static constexpr float kFirst = 0.5617f, kSecond = 1.3896f;

  struct Level {
    AirDims dims;
    std::vector<AirBrick> hostActive;
    Array<AirBrick> active, faces;
    PaddedArray<Backend> c[3], inverse, b, x, next, r;
    PaddedArray<Backend> lengths[3];  ///< on coarser levels
    AirStrides strides() const { return {dims.x, dims.x * dims.y}; }
    PressureView view() const { return {strides(), c[0].data(), c[1].data(), c[2].data(), inverse.data()}; }
  };

  CoarsenPass coarsening(std::size_t l) {
    Level &level = *m_levels[l], &fine = *m_levels[l - 1];
    CoarsenPass pass{};
    pass.map.fine = fine.strides();
    pass.inverse = fine.inverse.data();
    for (std::size_t a = 0; a < 3; ++a) {
      pass.c[a] = fine.c[a].data();
      pass.lengths[a] = l > 1 ? fine.lengths[a].data() : nullptr;
      pass.to[a] = level.c[a].data();
      pass.toLengths[a] = level.lengths[a].data();
    }
    return pass;
  }

  /// Cells along the longest side of what is active, in the coarsest sense: 1 = nothing left to join.
  static int extent(const std::vector<AirBrick>& bricks) {
    if (bricks.empty()) return 1;
    AirBrick low = bricks.front(), high = bricks.front();
    for (const AirBrick& b : bricks) {
      low.x = std::min(low.x, b.x), low.y = std::min(low.y, b.y), low.z = std::min(low.z, b.z);
      high.x = std::max(high.x, b.x), high.y = std::max(high.y, b.y), high.z = std::max(high.z, b.z);
    }
    return std::max({(high.x - low.x) / kBrickX, (high.y - low.y) / kBrickY, (high.z - low.z) / kBrickZ}) + 1;
  }

  void addLevel(Backend& backend, AirDims dims, const std::vector<AirBrick>& active,
                const std::vector<AirBrick>& faces) {
    auto level = std::make_unique<Level>();
    level->dims = dims;
    level->hostActive = active;
    backend.upload(active, level->active);
    backend.upload(faces, level->faces);
    const AirStrides strides = level->strides();
    const std::size_t cells = static_cast<std::size_t>(strides.z) * static_cast<std::size_t>(dims.z);
    for (PaddedArray<Backend>* a : {&level->c[0], &level->c[1], &level->c[2], &level->inverse, &level->b,
                                    &level->x, &level->next, &level->r})
      a->reset(backend, cells, strides);
    for (PaddedArray<Backend>& a : level->lengths)
      if (!m_levels.empty()) a.reset(backend, cells, strides);
    m_levels.push_back(std::move(level));
  }

  static double total(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum;
  }

  void emptyPockets(Backend& backend, float* b) {
    for (const Array<std::uint32_t>& cells : m_pockets) {
      const std::uint32_t* index = cells.data();
      const double sum = backend.reduce("pressure", cells.size(), 0.0, ListedValue{b, index}, AddDouble{});
      const auto mean = static_cast<float>(sum / static_cast<double>(cells.size()));
      backend.forEach("pressure", cells.size(), ListedSubtract{b, index, mean});
    }
  }

  AirSolve gradients(Backend& backend, AirPasses<Backend>& passes, const AirConfig& config, double right,
                     float* p) {
    Level& f = *m_levels.front();
    double left = total(passes.results(backend, "pressure", f.strides(), f.active,
                                       ResidualPass{f.view(), p, f.b.data(), f.r.data()}));
    const double enough = config.tolerance * config.tolerance * right;
    AirSolve solve;
    double before = 1.0;
    while (left > enough && left > 1e-30 && solve.iterations < config.mostIterations) {
      const double now = cycle(backend, passes, 0, f.r.data());
      const auto factor = static_cast<float>(solve.iterations == 0 ? 0.0 : now / before);
      passes.run(backend, "pressure", f.strides(), f.active,
                 DirectionPass{f.x.data(), m_direction.data(), factor});
      before = now;
      const double product =
          total(passes.results(backend, "pressure", f.strides(), f.active,
                               ProductPass{f.view(), m_direction.data(), m_product.data()}));
      if (!(product > 0.0)) break;
      left = total(passes.results(backend, "pressure", f.strides(), f.active,
                                  AdvancePass{m_direction.data(), m_product.data(), p, f.r.data(),
                                              static_cast<float>(now / product)}));
      ++solve.iterations;
    }
    solve.residual = residualOf(left, right);
    solve.reached = left <= enough || left <= 1e-30;
    return solve;
  }

  /// One V-cycle for the right side b from zero; the result is in the level's x. Returns the sum of x b.
  double cycle(Backend& backend, AirPasses<Backend>& passes, std::size_t l, const float* b) {
    Level& level = *m_levels[l];
    const PressureView v = level.view();
    const auto smooth = [&](const float* from, float* to, float damping) {
      passes.run(backend, "pressure", v.strides, level.active, SmoothPass{v, b, from, to, damping},
                 scratch(level));
    };
    passes.run(backend, "pressure", v.strides, level.active,
               FirstSmoothPass{v, b, level.x.data(), kFirst, kSecond});
    if (l + 1 == m_levels.size()) {
      for (int k = 0; k < 8; ++k) {
        smooth(level.x.data(), level.next.data(), kSecond);
        smooth(level.next.data(), level.x.data(), kFirst);
      }
    } else {
      Level& coarse = *m_levels[l + 1];
      // The finest level's r is the right side itself: its residual goes where the next sweep writes.
      float* r = level.next.data();
      passes.run(backend, "pressure", v.strides, level.active, ResidualPass{v, level.x.data(), b, r},
                 scratch(level));
      passes.run(backend, "pressure", coarse.strides(), coarse.active,
                 RestrictPass{{v.strides}, r, coarse.b.data()});
      cycle(backend, passes, l + 1, coarse.b.data());
      passes.run(backend, "pressure", v.strides, level.active,
                 ProlongPass{coarse.strides(), coarse.x.data(), level.inverse.data(), level.x.data()});
    }
    smooth(level.x.data(), level.next.data(), kSecond);
    const std::vector<double>& products =
        passes.results(backend, "pressure", v.strides, level.active,
                       SmoothPass{v, b, level.next.data(), level.x.data(), kFirst});
    return l == 0 ? total(products) : 0.0;
  }

  AirSolve sweeps(Backend& backend, AirPasses<Backend>& passes, const AirConfig& config, double right,
                  float* p) {
    Level& f = *m_levels.front();
    AirSolve solve;
    const PressureView v = f.view();
    for (; solve.iterations < config.sweeps; ++solve.iterations) {
      if (config.solver == AirPressure::Jacobi) {
        passes.run(backend, "pressure", v.strides, f.active,
                   SmoothPass{v, f.b.data(), p, f.next.data(), 1.0f}, scratch(f));
        copy(backend, passes, f, f.next.data(), p);
      } else {
        passes.run(backend, "pressure", v.strides, f.active, ColourPass{v, f.b.data(), p, f.next.data(), 0});
        copy(backend, passes, f, f.next.data(), f.x.data());
        passes.run(backend, "pressure", v.strides, f.active, ColourPass{v, f.b.data(), f.x.data(), p, 1});
      }
    }
    const double left = total(
        passes.results(backend, "pressure", v.strides, f.active, ResidualPass{v, p, f.b.data(), f.r.data()}));
    solve.residual = residualOf(left, right);
    solve.reached = solve.residual <= config.tolerance;
    return solve;
  }

  /// Not finite where what is left is not.
  static double residualOf(double left, double right) {
    return std::isfinite(left) ? (right > 0.0 ? std::sqrt(left / right) : 0.0) : left;
  }

  void copy(Backend& backend, AirPasses<Backend>& passes, Level& level, const float* from, float* to) {
    passes.run(backend, "pressure", level.strides(), level.active, CopyOnePass{from, to});
  }
  /// Room for results that nobody reads.
  double* scratch(const Level& level) {
    m_scratch.resize(std::max(m_scratch.size(), level.hostActive.size()));
    return m_scratch.data();
  }

  std::vector<std::unique_ptr<Level>> m_levels;
  PaddedArray<Backend> m_direction, m_product;
  std::vector<Array<std::uint32_t>> m_pockets;
  Array<double> m_scratch;
};

}  // namespace spin
