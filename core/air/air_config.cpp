// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/air_config.h"

#include <cmath>
#include <string>

namespace spin {
namespace {

struct Range {
  const char* name;
  double value, least, most;
};

}  // namespace

Status checkAirConfig(const AirConfig& c) {
  const Range ranges[] = {{"cell size", c.cell, 1e-4, 1e4},
                          {"temperature", c.temperature, 150.0, 400.0},
                          {"pressure", c.pressure, 1e3, 2e5},
                          {"humidity", c.humidity, 0.0, 1.0},
                          {"viscosity", c.viscosity, 0.0, 1e6},
                          {"share of small eddies", c.smagorinsky, 0.0, 0.5},
                          {"settling speed of mist", c.settling[0], 0.0, 100.0},
                          {"settling speed of snow", c.settling[1], 0.0, 100.0},
                          {"tolerance", c.tolerance, 1e-9, 1.0},
                          {"diffusion's tolerance", c.diffusionTolerance, 1e-9, 1.0},
                          {"Courant number", c.mostCourant, 0.1, 100.0},
                          {"number of iterations", static_cast<double>(c.mostIterations), 1.0, 1e4},
                          {"number of sweeps", static_cast<double>(c.sweeps), 1.0, 1e4},
                          {"least speed", c.leastSpeed, 1e-9, 1e9}};
  const auto bad = [](const std::string& why) {
    return Error{ErrorKind::BadInput, "The air cannot be computed", "air", why, "Set it within its range"};
  };
  for (const Range& r : ranges)
    if (!(r.value >= r.least && r.value <= r.most))
      return bad(std::string("its ") + r.name + " is " + std::to_string(r.value));
  for (const double least : c.least)
    if (!(least > 0.0 && least < 1e9)) return bad("a least amount is not positive");
  if (!isFinite(c.origin) || !isFinite(c.gravity)) return bad("its origin or gravity is not finite");
  for (std::size_t a = 0; a < 3; ++a)
    if (c.lowBrick[a] >= c.highBrick[a] || c.lowBrick[a] < -10'000'000 || c.highBrick[a] > 10'000'000)
      return bad("its domain holds no brick, or too many");
  for (const AirSolid& solid : c.solids)
    if (!solid.distance) return bad("a solid has no distance");
  return {};
}

}  // namespace spin
