// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/air_flows.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace spin {

void setVortices(AirBox& box, double speed) {
  const double wave = 2.0 * kPi / box.cells()[0];
  box.setCurl([&](int axis, int i, int, int k) {
    return axis == 1 ? speed / wave * std::sin(wave * i) * std::sin(wave * k) : 0.0;
  });
}

void setTurning(AirBox& box, int across) {
  const auto node = [across](int i) { return static_cast<double>(i) / across - 0.5; };
  box.setCurl([&](int axis, int i, int, int k) {
    if (axis != 1) return 0.0;
    const double r2 = node(i) * node(i) + node(k) * node(k);
    return kPi * std::min(r2, 0.47 * 0.47) * across;
  });
}

void setDeformation(AirBox& box, double speed) {
  const int n = box.cells()[0];
  const auto a = [n](int i) {
    const double s = std::sin(kPi * i / n);
    return s * s;
  };
  // The potential (0, -a(x) a'(y) a(z), a(x) a(y) a'(z)) / pi^2 with a = sin^2 and a' = pi sin 2x, integrated
  // over edges.
  const double scale = speed * n * n / (kPi * kPi);
  box.setCurl([&](int axis, int i, int j, int k) {
    if (axis == 1) return -scale * a(i) * (a(j + 1) - a(j)) * a(k);
    return axis == 2 ? scale * a(i) * a(j) * (a(k + 1) - a(k)) : 0.0;
  });
}

void setDiffusionMode(AirBox& box, int waves) {
  const double wave = kPi * waves / box.cells()[0];
  box.setCurl([&](int axis, int i, int, int k) {
    return axis == 1 ? std::sin(wave * i) * std::sin(wave * k) / wave : 0.0;
  });
}

}  // namespace spin
