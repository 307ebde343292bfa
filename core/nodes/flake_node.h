// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/property/property_table.h"

namespace spin {

/// How flakes grow: by aggregation with no, six or eight arms, or as crystals of a lattice automaton.
enum class FlakeGrowth : std::uint8_t { Free, SixArms, EightArms, Crystal };
/// Habits of crystals, in the order of CrystalHabit (core/flake/crystal_grower.h).
enum class CrystalForm : std::uint8_t { Fern, Stellar, Broad, Plate };
/// Pixels of an atlas' frames.
enum class FlakeDetail : std::uint8_t { Coarse, Medium, Fine, Finest };

/// What the falling flakes look like: shapes that are grown once and drawn as sprites.
struct FlakeNode : NodeData {
  FlakeGrowth growth = FlakeGrowth::SixArms;
  int shapes = 8;
  std::int64_t seed = 1;
  double smallest = 0.3e-3, largest = 2.5e-3;  ///< radii, m
  FlakeDetail detail = FlakeDetail::Medium;
  double particleDiameter = 15e-6;  ///< m, of what aggregates
  int particles = 20000;            ///< at most in a flake
  double alignment = 1.0;           ///< to the crystal's own directions, 0..1
  int landings = 20;                ///< before a particle stays
  CrystalForm form = CrystalForm::Stellar;
  int cells = 120;       ///< of a crystal's radius
  double variety = 0.3;  ///< of the air on the crystal's way, 0..1
};
extern const NodeType kFlakeType;

}  // namespace spin
