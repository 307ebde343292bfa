// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/nodes/settings_nodes.h"
#include "editor/render/gl_program.h"

namespace spin {

/// Which variant of the programs draws the snow cover.
enum class SnowLook : std::uint8_t { Physical, Published, Values };
inline constexpr std::size_t kSnowLooks = 3;
/// One program for each look.
using LookPrograms = std::array<GlProgram, kSnowLooks>;

inline SnowLook snowLook(const RenderNode& settings) {
  if (settings.snowDisplay != SnowDisplay::Natural) return SnowLook::Values;
  return settings.snowShading == SnowShading::BlinnPhong ? SnowLook::Published : SnowLook::Physical;
}

/// The lines that make a program's variant.
inline const char* definesOf(SnowLook look) {
  constexpr std::array<const char*, kSnowLooks> kDefines{"", "#define PUBLISHED 1\n", "#define VALUES 1\n"};
  return kDefines[static_cast<std::size_t>(look)];
}

}  // namespace spin
