// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/snow/wind_columns.h"

namespace spin {

std::size_t xFace(const WindColumns& g, int i, int j, int k) {
  return (static_cast<std::size_t>(j) * static_cast<std::size_t>(g.width + 1) + static_cast<std::size_t>(i)) *
             static_cast<std::size_t>(g.layers) +
         static_cast<std::size_t>(k);
}

std::size_t yFace(const WindColumns& g, int i, int j, int k) {
  return (static_cast<std::size_t>(j) * static_cast<std::size_t>(g.width) + static_cast<std::size_t>(i)) *
             static_cast<std::size_t>(g.layers) +
         static_cast<std::size_t>(k);
}

std::size_t zFace(const WindColumns& g, std::size_t column, int k) {
  return column * static_cast<std::size_t>(g.layers + 1) + static_cast<std::size_t>(k);
}

namespace {

/// Net flow out of every box.
class NetFlow {
 public:
  NetFlow(const WindColumns& g, const WindFaces& faces) : m_g(&g), m_faces(&faces) {}
  double operator()(std::size_t c, int k) const {
    const int i = static_cast<int>(c) % m_g->width, j = static_cast<int>(c) / m_g->width;
    const WindFaces& f = *m_faces;
    return f.x[xFace(*m_g, i + 1, j, k)] - f.x[xFace(*m_g, i, j, k)] + f.y[yFace(*m_g, i, j + 1, k)] -
           f.y[yFace(*m_g, i, j, k)] + f.z[zFace(*m_g, c, k + 1)] - f.z[zFace(*m_g, c, k)];
  }

 private:
  const WindColumns* m_g;
  const WindFaces* m_faces;
};

/// The system A p = b: A p is the net flow out of a box that the potential p drives, outside p = 0.
class ColumnSystem {
 public:
  ColumnSystem(const WindColumns& g, const WindFaces& conductance, CpuBackend& backend)
      : m_g(&g), m_c(&conductance), m_backend(&backend), m_diagonal(g.boxes()), m_pivot(g.boxes()) {
    m_backend->forEach(
        "wind", g.columns(), [&](std::size_t c) { factor(c); }, kColumns);
  }

  void apply(const std::vector<double>& p, std::vector<double>& out) const {
    const auto n = static_cast<std::size_t>(m_g->layers);
    m_backend->forEach(
        "wind", m_g->columns(),
        [&](std::size_t c) {
          const int i = static_cast<int>(c) % m_g->width, j = static_cast<int>(c) / m_g->width;
          const double* own = &p[c * n];
          const double* west = i > 0 ? own - n : nullptr;
          const double* east = i + 1 < m_g->width ? own + n : nullptr;
          const double* south = j > 0 ? own - n * static_cast<std::size_t>(m_g->width) : nullptr;
          const double* north =
              j + 1 < m_g->height ? own + n * static_cast<std::size_t>(m_g->width) : nullptr;
          const double* cw = &m_c->x[xFace(*m_g, i, j, 0)];
          const double* ce = &m_c->x[xFace(*m_g, i + 1, j, 0)];
          const double* cs = &m_c->y[yFace(*m_g, i, j, 0)];
          const double* cn = &m_c->y[yFace(*m_g, i, j + 1, 0)];
          const double* cz = &m_c->z[zFace(*m_g, c, 0)];
          for (std::size_t k = 0; k < n; ++k) {
            double sum = m_diagonal[c * n + k] * own[k];
            if (west) sum -= cw[k] * west[k];
            if (east) sum -= ce[k] * east[k];
            if (south) sum -= cs[k] * south[k];
            if (north) sum -= cn[k] * north[k];
            if (k > 0) sum -= cz[k] * own[k - 1];
            if (k + 1 < n) sum -= cz[k + 1] * own[k + 1];
            out[c * n + k] = sum;
          }
        },
        kColumns);
  }

  /// Every column alone, by elimination.
  void precondition(const std::vector<double>& r, std::vector<double>& z) const {
    const auto n = static_cast<std::size_t>(m_g->layers);
    m_backend->forEach(
        "wind", m_g->columns(),
        [&](std::size_t c) {
          const double* cz = &m_c->z[zFace(*m_g, c, 0)];
          const double* pivot = &m_pivot[c * n];
          double* out = &z[c * n];
          out[0] = r[c * n] * pivot[0];
          for (std::size_t k = 1; k < n; ++k) out[k] = (r[c * n + k] + cz[k] * out[k - 1]) * pivot[k];
          for (std::size_t k = n - 1; k-- > 0;) out[k] += cz[k + 1] * pivot[k] * out[k + 1];
        },
        kColumns);
  }

  double dot(const std::vector<double>& a, const std::vector<double>& b) const {
    return m_backend->reduce(
        "wind", a.size(), 0.0, [&](std::size_t i) { return a[i] * b[i]; },
        [](double x, double y) { return x + y; });
  }

 private:
  static constexpr std::size_t kColumns = 64;

  void factor(std::size_t c) {
    const auto n = static_cast<std::size_t>(m_g->layers);
    const int i = static_cast<int>(c) % m_g->width, j = static_cast<int>(c) / m_g->width;
    const double* cz = &m_c->z[zFace(*m_g, c, 0)];
    for (std::size_t k = 0; k < n; ++k) {
      const int layer = static_cast<int>(k);
      double sum = m_c->x[xFace(*m_g, i, j, layer)] + m_c->x[xFace(*m_g, i + 1, j, layer)] +
                   m_c->y[yFace(*m_g, i, j, layer)] + m_c->y[yFace(*m_g, i, j + 1, layer)] + cz[k] +
                   cz[k + 1];
      if (!(sum > 0.0)) sum = 1.0;  // a box within a model
      m_diagonal[c * n + k] = sum;
      const double below = k > 0 ? cz[k] * cz[k] * m_pivot[c * n + k - 1] : 0.0;
      m_pivot[c * n + k] = 1.0 / (sum - below);
    }
  }

  const WindColumns* m_g;
  const WindFaces* m_c;
  CpuBackend* m_backend;
  std::vector<double> m_diagonal, m_pivot;
};

/// Adds what the potential drives through the faces.
void drive(const WindColumns& g, const WindFaces& c, const std::vector<double>& p, WindFaces& flow) {
  const auto n = static_cast<std::size_t>(g.layers);
  const auto at = [&](int i, int j, int k) {
    if (i < 0 || j < 0 || i >= g.width || j >= g.height || k >= g.layers) return 0.0;
    return p[g.column(i, j) * n + static_cast<std::size_t>(k)];
  };
  for (int j = 0; j <= g.height; ++j)
    for (int i = 0; i <= g.width; ++i)
      for (int k = 0; k <= g.layers; ++k) {
        const double own = at(i, j, k);
        if (j < g.height && k < g.layers)
          flow.x[xFace(g, i, j, k)] += c.x[xFace(g, i, j, k)] * (at(i - 1, j, k) - own);
        if (i < g.width && k < g.layers)
          flow.y[yFace(g, i, j, k)] += c.y[yFace(g, i, j, k)] * (at(i, j - 1, k) - own);
        if (i < g.width && j < g.height && k > 0)
          flow.z[zFace(g, g.column(i, j), k)] += c.z[zFace(g, g.column(i, j), k)] * (at(i, j, k - 1) - own);
      }
}

double rootMeanSquare(const WindColumns& g, const WindFaces& flow) {
  const NetFlow net(g, flow);
  double sum = 0.0;
  for (std::size_t c = 0; c < g.columns(); ++c)
    for (int k = 0; k < g.layers; ++k) {
      const double n = net(c, k);
      sum += n * n;
    }
  return std::sqrt(sum / static_cast<double>(g.boxes()));
}

}  // namespace

WindBalance balanceWind(const WindColumns& g, const WindFaces& conductance, double tolerance,
                        int mostIterations, CpuBackend& backend, WindFaces& flow, const CancelToken* cancel) {
  const ColumnSystem system(g, conductance, backend);
  const NetFlow net(g, flow);
  const auto n = static_cast<std::size_t>(g.layers);
  std::vector<double> p(g.boxes(), 0.0), r(g.boxes()), z(g.boxes()), d(g.boxes()), q(g.boxes());
  for (std::size_t c = 0; c < g.columns(); ++c)
    for (std::size_t k = 0; k < n; ++k) r[c * n + k] = -net(c, static_cast<int>(k));
  // As a share of what a unit wind drives through the side of a mean box.
  const double side = g.cell * g.depth(g.columns() / 2) / g.layers;
  const double goal = tolerance * side * std::sqrt(static_cast<double>(g.boxes()));
  system.precondition(r, z);
  d = z;
  double rz = system.dot(r, z);
  WindBalance balance;
  while (balance.iterations < mostIterations && std::sqrt(system.dot(r, r)) > goal && rz > 0.0) {
    if (cancel && cancel->cancelled()) break;
    system.apply(d, q);
    const double alpha = rz / system.dot(d, q);
    backend.forEach("wind", p.size(), [&](std::size_t i) { p[i] += alpha * d[i], r[i] -= alpha * q[i]; });
    system.precondition(r, z);
    const double next = system.dot(r, z), beta = next / rz;
    rz = next;
    backend.forEach("wind", p.size(), [&](std::size_t i) { d[i] = z[i] + beta * d[i]; });
    ++balance.iterations;
  }
  drive(g, conductance, p, flow);
  balance.divergence = rootMeanSquare(g, flow) / side;
  return balance;
}

}  // namespace spin
