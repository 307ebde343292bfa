// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/base/random.h"
#include "core/bench/bench_case.h"
#include "core/bench/worst.h"
#include "core/math/vec.h"
#include "core/physics/kernels.h"

namespace spin {
namespace {

/// A kernel of support 1 in the precision that pairs are summed in.
struct Form {
  const char* id;
  bool forDensity;  ///< its lattice sum has a bar
  double norm;
  float (*shape)(float q);
  float (*slope)(float q);      ///< d shape / dq
  float (*laplacian)(float q);  ///< null where only the pairwise form is in use
};

const std::array<Form, 4>& forms() {
  static const std::array<Form, 4> list = {{
      {"cubic", true, CubicSpline::kNorm, [](float q) { return CubicSpline::shape(q); },
       [](float q) { return q * CubicSpline::slopeOverQ(q); }, nullptr},
      {"poly6", true, Poly6::kNorm, [](float q) { return Poly6::shapeOfSquare(q * q); },
       [](float q) { return q * Poly6::slopeOverQOfSquare(q * q); }, nullptr},
      {"spiky", false, Spiky::kNorm, [](float q) { return Spiky::shape(q); },
       [](float q) { return Spiky::slope(q); }, nullptr},
      {"viscosity", false, ViscosityKernel::kNorm, [](float q) { return ViscosityKernel::shape(q); },
       [](float q) { return ViscosityKernel::slope(q); },
       [](float q) { return ViscosityKernel::laplacian(q); }},
  }};
  return list;
}

/// What sums over a lattice give at one point of it. Lengths in supports.
struct Sums {
  double unity = 0.0;      ///< sum W V
  Vec3d gradient{};        ///< sum grad W V
  double pairwise = 0.0;   ///< Laplacian of x^2 by 2 (f_i - f_j) grad W . x / r^2, over its value 2
  double laplacian = 0.0;  ///< the same by lap W (f_j - f_i)
};

/// Point `index` of a lattice with `perSupport` spacings to the support, jittered by up to `jitter` spacings.
Sums sumsAt(const Form& form, int perSupport, double jitter, std::uint64_t index) {
  const CounterRandom random{3, 17};
  const double spacing = 1.0 / perSupport, volume = spacing * spacing * spacing * form.norm;
  const int reach = perSupport + 1, across = 2 * reach + 1;
  const auto point = [&](int i, int j, int k) {
    const auto id = static_cast<std::uint64_t>(((i + reach) * across + j + reach) * across + k + reach) +
                    index * static_cast<std::uint64_t>(across * across * across);
    const auto shift = [&](std::uint32_t d) { return jitter * (2.0 * random.uniformDouble(id, d) - 1.0); };
    return Vec3d{i + shift(0), j + shift(1), k + shift(2)} * spacing;
  };
  const Vec3d own = point(0, 0, 0);
  Sums sums;
  // The pole of the viscosity kernel: a particle does not act on itself.
  if (form.forDensity || form.laplacian == nullptr)
    sums.unity = volume * static_cast<double>(form.shape(0.0f));
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      for (int k = -reach; k <= reach; ++k) {
        if (i == 0 && j == 0 && k == 0) continue;
        const Vec3d d = own - point(i, j, k);
        const double r = length(d);
        const auto q = static_cast<float>(r);
        const double slope = volume * static_cast<double>(form.slope(q));
        sums.unity += volume * static_cast<double>(form.shape(q));
        sums.gradient += d * (slope / r);
        // f = (x - x_i)^2
        sums.pairwise -= d.x * d.x * slope / r;
        if (form.laplacian)
          sums.laplacian += 0.5 * d.x * d.x * volume * static_cast<double>(form.laplacian(q));
      }
  return sums;
}

double integral(const Form& form) {
  constexpr int kCells = 20000;
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i) {
    const double q = (i + 0.5) / kCells;
    sum += 4.0 * kPi * q * q * static_cast<double>(form.shape(static_cast<float>(q)));
  }
  return form.norm * sum / kCells;
}

void addJittered(const Form& form, int perSupport, BenchRow& row) {
  constexpr std::uint64_t kPoints = 200;
  double unity = 0.0, gradient = 0.0, factor = 0.0;
  for (std::uint64_t p = 0; p < kPoints; ++p) {
    const Sums sums = sumsAt(form, perSupport, 0.2, p);
    unity += (sums.unity - 1.0) * (sums.unity - 1.0);
    gradient += dot(sums.gradient, sums.gradient);
    factor += form.laplacian ? sums.laplacian : sums.pairwise;
  }
  row.addFigure("jittered_sum_rms", std::sqrt(unity / kPoints), "1");
  row.addFigure("jittered_gradient_rms", std::sqrt(gradient / kPoints) / perSupport, "1/spacing");
  row.addFigure("jittered_laplacian_factor", factor / kPoints, "1");
}

Result<std::vector<BenchRow>> run(const BenchOptions&) {
  std::vector<BenchRow> rows;
  for (const int perSupport : {2, 3})
    for (const Form& form : forms()) {
      BenchRow row;
      row.caseId = "kernel-sums";
      row.settings = {{"kernel", form.id}, {"support", fmt::format("{} spacings", perSupport)}};
      const Sums sums = sumsAt(form, perSupport, 0.0, 0);
      row.addError("integral_error", std::abs(integral(form) - 1.0), "1", 1e-5);
      const double unity = std::abs(sums.unity - 1.0);
      if (form.forDensity)
        row.addError("lattice_sum_error", unity, "1", 0.01);
      else
        row.addFigure("lattice_sum_error", unity, "1");
      row.addError("lattice_gradient", length(sums.gradient) / perSupport, "1/spacing", 1e-6);
      row.addFigure("pairwise_laplacian_factor", sums.pairwise, "1");
      if (form.laplacian) row.addFigure("laplacian_factor", sums.laplacian, "1");
      addJittered(form, perSupport, row);
      rows.push_back(std::move(row));
    }
  return rows;
}

}  // namespace

BenchCase kernelSumsCase() {
  return {"kernel-sums", "sums of kernels, gradients and Laplacians over lattices; their integrals",
          "unit sum and integral, zero gradient, Laplacian of x^2", run};
}

}  // namespace spin
