// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/sph/flow_kernels.h"

namespace spin {

struct KeptVelocity {
  float x, y, z;  ///< m/s
};

struct KeepVelocityKernel {
  FlowView v;
  KeptVelocity* kept;
  SPIN_HD void operator()(std::size_t i) const {
    const PairRecord& r = v.record[i];
    kept[i] = {r.vx, r.vy, r.vz};
  }
};

/// The acceleration by all that acted, in the place of that by neighbours.
struct WholeAccelerationKernel {
  FlowView v;
  const KeptVelocity* before;
  float kick;  ///< s
  SPIN_HD void operator()(std::size_t i) const {
    const PairRecord& r = v.record[i];
    v.ax[i] = (r.vx - before[i].x) / kick;
    v.ay[i] = (r.vy - before[i].y) / kick;
    v.az[i] = (r.vz - before[i].z) / kick;
  }
};

/// What a step keeps for samples() where it is asked to: neighbours and the whole acceleration. Other steps
/// pay nothing.
template <class Backend>
class FlowSampler {
 public:
  /// Before the forces of a step, with the particles sorted.
  void begin(Backend& backend, FlowView& view, bool on) {
    m_sampled = on;
    if (!on) return;
    if (m_neighbours.size() < view.count) {
      m_neighbours.resize(view.count);
      m_before.resize(view.count);
    }
    view.neighbours = m_neighbours.data();
    backend.forEach("neighbours", view.count, NeighbourKernel{view});
    backend.forEach("neighbours", view.count, KeepVelocityKernel{view, m_before.data()});
  }
  /// After the step, which advanced velocities by `kick` seconds.
  void end(Backend& backend, const FlowView& view, double kick) {
    if (m_sampled)
      backend.forEach("neighbours", view.count,
                      WholeAccelerationKernel{view, m_before.data(), static_cast<float>(kick)});
  }
  /// The particles are others now.
  void forget() { m_sampled = false; }
  /// Neighbours per particle; nothing where the latest step was not sampled.
  void download(Backend& backend, std::vector<std::uint32_t>& neighbours) const {
    if (m_sampled) backend.download(m_neighbours, neighbours);
  }
  std::size_t bytes() const {
    return m_neighbours.size() * sizeof(std::uint32_t) + m_before.size() * sizeof(KeptVelocity);
  }

 private:
  typename Backend::template Array<std::uint32_t> m_neighbours;
  typename Backend::template Array<KeptVelocity> m_before;
  bool m_sampled = false;
};

}  // namespace spin
