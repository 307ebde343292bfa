// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/flake_node.h"

namespace spin {
namespace {

constexpr Choice kGrowths[] = {
    {"free", SPIN_TR("Free cluster")},
    {"six_arms", SPIN_TR("Six arms")},
    {"eight_arms", SPIN_TR("Eight arms")},
    {"crystal", SPIN_TR("Crystal")},
};
constexpr Choice kForms[] = {
    {"fern", SPIN_TR("Fern-like star")},
    {"stellar", SPIN_TR("Plain star")},
    {"broad", SPIN_TR("Star with broad branches")},
    {"plate", SPIN_TR("Plate with corners")},
};
constexpr Choice kDetails[] = {
    {"coarse", SPIN_TR("32 pixels")},
    {"medium", SPIN_TR("64 pixels")},
    {"fine", SPIN_TR("128 pixels")},
    {"finest", SPIN_TR("256 pixels")},
};

constexpr PropertyRow kFlakeRows[] = {
    property<&FlakeNode::growth>("growth", SPIN_TR("Growth"),
                                 SPIN_TR("Free cluster, six and eight arms grow by diffusion-limited "
                                         "aggregation, crystals by a lattice automaton."))
        .oneOf(kGrowths)
        .affecting(Affects::Picture),
    property<&FlakeNode::shapes>("shapes", SPIN_TR("Shapes"),
                                 SPIN_TR("Number of different flakes that are grown."))
        .range(1, 32, 1)
        .affecting(Affects::Picture),
    property<&FlakeNode::seed>("seed", SPIN_TR("Seed"),
                               SPIN_TR("Another number grows other flakes of the same kind."))
        .range(0, 1000000, 1)
        .affecting(Affects::Picture),
    property<&FlakeNode::smallest>("smallest_radius_m", SPIN_TR("Smallest radius"),
                                   SPIN_TR("Radius to which the smallest flake grows."))
        .in(Unit::Millimetre)
        .range(0.05e-3, 4.6e-3, 0.05e-3)
        .affecting(Affects::Picture),
    property<&FlakeNode::largest>("largest_radius_m", SPIN_TR("Largest radius"),
                                  SPIN_TR("Radius to which the largest flake grows."))
        .in(Unit::Millimetre)
        .range(0.05e-3, 4.6e-3, 0.05e-3)
        .affecting(Affects::Picture),
    property<&FlakeNode::detail>("detail", SPIN_TR("Detail"),
                                 SPIN_TR("Size of a flake's pictures; close-ups want fine ones."))
        .oneOf(kDetails)
        .affecting(Affects::Picture),
    property<&FlakeNode::particleDiameter>(
        "particle_diameter_m", SPIN_TR("Particle"),
        SPIN_TR("Diameter of the particles that aggregate; the finer, the more branches. Not for crystals."))
        .in(Unit::Millimetre)
        .range(0.003e-3, 0.1e-3, 0.001e-3)
        .affecting(Affects::Picture),
    property<&FlakeNode::particles>("particles", SPIN_TR("Most particles"),
                                    SPIN_TR("A flake that has as many stops growing. Not for crystals."))
        .range(100, 1000000, 1000)
        .affecting(Affects::Picture),
    property<&FlakeNode::alignment>(
        "alignment", SPIN_TR("Alignment"),
        SPIN_TR("How far particles turn to the crystal's own directions: 0 gives corals, 1 branches at 60 "
                "degrees. For six and eight arms."))
        .in(Unit::Factor)
        .range(0, 1, 0.05)
        .affecting(Affects::Picture),
    property<&FlakeNode::landings>(
        "landings", SPIN_TR("Landings"),
        SPIN_TR(
            "Particles that must land at a place before one stays: more give straighter arms. For six and "
            "eight arms."))
        .range(1, 200, 1)
        .affecting(Affects::Picture),
    property<&FlakeNode::form>("crystal_form", SPIN_TR("Form of crystals"),
                               SPIN_TR("Habit of the crystals that the automaton grows."))
        .oneOf(kForms)
        .affecting(Affects::Picture),
    property<&FlakeNode::cells>(
        "crystal_cells", SPIN_TR("Cells of crystals"),
        SPIN_TR("Lattice cells from the middle to the tips: more give finer branches, and "
                "take longer."))
        .range(20, 400, 10)
        .affecting(Affects::Picture),
    property<&FlakeNode::variety>(
        "crystal_variety", SPIN_TR("Variety of crystals"),
        SPIN_TR("How much the air changes while a crystal grows; it makes each one its own."))
        .in(Unit::Factor)
        .range(0, 1, 0.05)
        .affecting(Affects::Picture),
};

}  // namespace

constinit const NodeType kFlakeType =
    nodeType<FlakeNode>("flake", SPIN_TR("Flake shapes"),
                        SPIN_TR("Shapes of the falling flakes: what grows is what falls."), true, kFlakeRows);

}  // namespace spin
