// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/sim/air_part.h"

namespace spin {

/// How particles scatter light by angle: a narrow peak (diffraction) of Henyey and Greenstein 1941 with mean
/// cosine `peak`, and a broad share after Draine 2003, with `alpha` 0 that of Henyey and Greenstein too.
struct AirPhase {
  double peak = 0.0, broad = 0.0, alpha = 0.0;
  double broadShare = 1.0;

  /// Per sr, of the cosine of the angle between the ways before and after; over all directions 1.
  double at(double cosine) const;
  double meanCosine() const;
};

/// Droplets of a diameter in m: the fit of Mie's theory by J. Jendersie and E. d'Eon 2023, which holds for 5
/// to 50 um; beyond, the nearer end.
AirPhase dropPhase(double diameter);
/// Ice grains of irregular shape, much larger than the wavelength: half of what they take from the beam is
/// diffraction; over all a mean cosine of 0.75 (A. Kokhanovsky, E. Zege 2004).
AirPhase grainPhase();

/// Cross-section of particles of a diameter in m per mass, m2/kg: 1.5 Q / (rho d) with Q = 2, as of all that
/// is larger than the wavelength. Requires a diameter > 0.
double extinctionPerMass(double density, double diameter);

/// What light meets in the air.
struct AirOptics {
  std::vector<float> extinction;  ///< 1/m by cell, in the order of the fields; empty where nothing hangs
  AirPhase phase;                 ///< of mist and snow, by what each takes from the beam
};
AirOptics airOptics(const AirPart& air);

}  // namespace spin
