// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flake/flake_settings.h"

#include <fmt/format.h>

namespace spin {
namespace {

Status within(const char* name, double value, double low, double high) {
  // Written so that a NaN fails.
  if (value >= low && value <= high) return {};
  return badInput("The flake cannot be grown", name,
                  fmt::format("{:g} is not between {:g} and {:g}", value, low, high));
}

}  // namespace

Status checkFlakeSettings(const FlakeSettings& settings) {
  const int arms = static_cast<int>(settings.symmetry);
  if (arms != 1 && arms != 6 && arms != 8)
    return badInput("The flake cannot be grown", "symmetry", fmt::format("{} arms are not 1, 6 or 8", arms));
  if (Status s = within("particle_diameter", settings.particleDiameter, 1e-7, 1e-3); !s) return s;
  if (Status s = within("radius", settings.radius, kSmallestFlake, kLargestFlake); !s) return s;
  if (settings.radius > kLargestReach * settings.particleDiameter * (1.0 + 1e-9))
    return badInput("The flake cannot be grown", "particle_diameter",
                    fmt::format("the radius is more than {:g} particle diameters", kLargestReach),
                    "Take larger particles");
  if (Status s = within("alignment", settings.alignment, 0.0, 1.0); !s) return s;
  if (Status s = within("landings", settings.landings, 1, kMostLandings); !s) return s;
  return within("particles", settings.particles, 1, kMostFlakeParticles);
}

}  // namespace spin
