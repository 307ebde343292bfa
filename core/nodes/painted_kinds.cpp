// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/painted_kinds.h"

#include <array>
#include <limits>

#include "core/nodes/flow_nodes.h"
#include "core/nodes/ground_nodes.h"

namespace spin {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

constexpr std::array<PaintedKind, 5> kKinds{{
    {&kGroundTypeLayerType, true, float{kUnpaintedGround}, 0, kGroundTypeCount - 1, 0, kGroundTypeCount - 1,
     Unit::None, SPIN_TR("Ground type"), "ground type", ""},
    {&kGroundTemperatureLayerType, false, kNan, 100, 400, 253.15, 293.15, Unit::Kelvin,
     SPIN_TR("Ground temperature"), "ground temperature", "K"},
    {&kSnowDepthLayerType, false, kNan, 0, 100, 0, 2, Unit::Metre, SPIN_TR("Snow depth"), "snow depth", "m"},
    {&kKeepClearLayerType, false, 0.0f, 0, 1, 0, 1, Unit::Factor, SPIN_TR("Keep clear"), "share kept clear",
     ""},
    {&kAvalancheReleaseType, true, float{kReleaseUnpainted}, kReleasePainted, kReleasePainted,
     kReleasePainted, kReleasePainted, Unit::None, SPIN_TR("Avalanche release"), "release area", ""},
}};

}  // namespace

std::span<const PaintedKind> paintedKinds() {
  return kKinds;
}

const PaintedKind* paintedKind(const NodeType& type) {
  for (const PaintedKind& kind : kKinds)
    if (kind.type == &type) return &kind;
  return nullptr;
}

}  // namespace spin
