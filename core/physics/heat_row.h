// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/bounded_math.h"

/// Implicit conduction through a row of layers, from the top: one sweep up that turns all below into one
/// conductance to one temperature, and one sweep down with the flux that the top lets in.
namespace spin {

/// What is below a face as seen from it: heat goes down at conductance (t - temperature), W/m2.
template <class V>
struct BelowFace {
  V conductance;  ///< W/(m2 K)
  V temperature;  ///< K above 273.15 K
};

template <class V, int kLayers>
struct HeatRow {
  V storage[kLayers];     ///< heat capacity over the step, W/(m2 K); 0 for an empty layer
  V resistance[kLayers];  ///< of half the layer, m2 K/W; 0 for an empty layer
  V temperature[kLayers];
  BelowFace<V> below[kLayers + 1];  ///< upper face of each layer, and the lower face of the last
  V flux[kLayers + 1];              ///< W/m2 down through those faces, by sweepDown()

  /// W/m2 that a layer keeps.
  SPIN_HD_INLINE V gain(int layer) const { return flux[layer] - flux[layer + 1]; }
};

/// Fills `below` from below[kLayers], which the caller has set. An empty layer hands on what it sees.
template <class V, int kLayers>
SPIN_HD_INLINE void sweepUp(HeatRow<V, kLayers>& h) {
  const V one = lit<V>(1.0), tiny = lit<V>(1e-20);
  for (int i = kLayers - 1; i >= 0; --i) {
    const BelowFace<V>& b = h.below[i + 1];
    const V through = b.conductance / (one + h.resistance[i] * b.conductance);
    const V sum = h.storage[i] + through;
    h.below[i].temperature = (h.storage[i] * h.temperature[i] + through * b.temperature) / maximum(sum, tiny);
    h.below[i].conductance = sum / (one + h.resistance[i] * sum);
  }
}

/// Lets `down` (W/m2) in through an upper face at the temperature `face`. Temperatures come from the sweep
/// up, which keeps rounding from growing downwards; what a layer keeps is the difference of its fluxes.
template <class V, int kLayers>
SPIN_HD_INLINE void sweepDown(HeatRow<V, kLayers>& h, V down, V face) {
  const V one = lit<V>(1.0);
  h.flux[0] = down;
  for (int i = 0; i < kLayers; ++i) {
    const BelowFace<V>& b = h.below[i + 1];
    const V attached = one / (one + h.resistance[i] * b.conductance);
    const V sum = h.storage[i] + b.conductance * attached;
    const V held = h.below[i].temperature;
    const V inside = held + (face - held) / (one + h.resistance[i] * sum);
    h.flux[i + 1] = b.conductance * attached * (inside - b.temperature);
    face = b.temperature + (inside - b.temperature) * attached;
  }
}

}  // namespace spin
