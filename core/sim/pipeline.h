// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/sim/process.h"

namespace spin {

/// All kinds of processes that are built in. Defined in core/processes, which alone knows them:
/// a later process adds one line there.
const std::vector<ProcessType>& processTypes();

/// The processes one scene needs, in order, with their exchange.
class Pipeline {
 public:
  /// Only what the scene needs; an empty pipeline is valid (nothing moves).
  static Pipeline compile(const SceneSnapshot& scene, const std::vector<ProcessType>& types = processTypes());

  const std::vector<std::unique_ptr<Process>>& processes() const { return m_processes; }
  Exchange& exchange() { return *m_exchange; }

 private:
  std::vector<std::unique_ptr<Process>> m_processes;
  std::unique_ptr<Exchange> m_exchange = std::make_unique<Exchange>();
};

/// Whether the scene's settings hold a process still in the step that ends at a film time: its state stays as
/// it is, and nothing that it depends on makes its frames stale.
bool isPaused(const SceneSnapshot& scene, const Process& process, double filmTime);

/// Key of frame 0 and the chain: key(n) = H(key(n-1), inputs of the step to n, solver version, backend,
/// seed).
std::vector<Hash128> frameKeys(const SceneSnapshot& scene, const Pipeline& pipeline,
                               const std::string& backendName, int lastFrame);

}  // namespace spin
