// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/sim/frame.h"
#include "plugins/sdk/exporter.h"

/// What the particle exporters share.
namespace spin {

inline bool hasParticles(const Frame& frame) {
  for (const auto& [name, part] : frame.parts)
    if (dynamic_cast<const ParticlePart*>(part.get())) return true;
  return false;
}

/// The flakes have the job's plain name, every other set adds its own, so that names do not depend on which
/// sets a frame happens to hold.
inline std::string particleBaseName(const ExportContext& context, const std::string& partName) {
  return partName == "flakes" ? context.baseName : context.baseName + "_" + partName;
}

inline std::string frameFileName(const std::string& baseName, int frame, const char* extension) {
  return fmt::format("{}.{:04d}.{}", baseName, frame, extension);
}

/// Sets whose arrays do not fit each other are our own bug, but must not become a broken file.
inline Status checkParticles(const ParticleSet& particles, const std::string& where) {
  const std::size_t n = particles.size();
  bool sound = particles.ids.empty() || particles.ids.size() == n;
  for (const ParticleAttribute& a : particles.attributes)
    sound = sound && a.components >= 1 && a.values.size() == n * static_cast<std::size_t>(a.components);
  if (sound) return {};
  return Error{ErrorKind::Failed, "The particles could not be written", where,
               "their attributes differ in number", "Report this to the makers of the program"};
}

}  // namespace spin
