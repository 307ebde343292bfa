// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/air_nodes.h"

namespace spin {
namespace {

constexpr Choice kSchemes[] = {
    {"semi_lagrangian", SPIN_TR("Semi-Lagrangian")},
    {"maccormack", SPIN_TR("MacCormack")},
    {"cubic", SPIN_TR("Cubic")},
};
constexpr Choice kSolvers[] = {
    {"multigrid", SPIN_TR("Conjugate gradients with multigrid")},
    {"jacobi", SPIN_TR("Jacobi sweeps")},
    {"gauss_seidel", SPIN_TR("Gauss-Seidel sweeps")},
};
constexpr Choice kLifts[] = {
    {"humid_air", SPIN_TR("Density of humid air and its load")},
    {"stacked_cells", SPIN_TR("Difference of stacked cells")},
    {"fog_density", SPIN_TR("Fog density")},
};

constexpr PropertyRow kAirRows[] = {
    property<&AirNode::cell>("cell_m", SPIN_TR("Cell size"),
                             SPIN_TR("Edge of the air's cells; 0 takes four spacings of the flow. Half of it "
                                     "takes eight times the cells."))
        .in(Unit::Metre)
        .range(0, 100, 0.1),
    property<&AirNode::coupling>(
        "coupling_s", SPIN_TR("Exchange every"),
        SPIN_TR(
            "Longest film time from one exchange between flow and air to the next; longer frames are cut."))
        .in(Unit::Second)
        .range(0.001, 1, 0.01),
    property<&AirNode::advection>("advection", SPIN_TR("Advection"),
                                  SPIN_TR("How the wind of the cloud is carried along: semi-Lagrangian as "
                                          "published, or one of two sharper schemes."))
        .oneOf(kSchemes),
    property<&AirNode::reflection>("reflection", SPIN_TR("Reflection"),
                                   SPIN_TR("Two projections a step keep eddies alive that one would damp.")),
    property<&AirNode::solver>(
        "pressure_solver", SPIN_TR("Pressure solver"),
        SPIN_TR("How the pressure is found: to the tolerance, or by a fixed number of sweeps as published."))
        .oneOf(kSolvers),
    property<&AirNode::tolerance>("tolerance", SPIN_TR("Tolerance"),
                                  SPIN_TR("Residual of the pressure over its right side, at most."))
        .in(Unit::None)
        .range(1e-6, 0.1, 1e-3),
    property<&AirNode::lift>("lift", SPIN_TR("Lift by"),
                             SPIN_TR("What makes the cloud rise or sink: the density of humid air with its "
                                     "load, or one of two published forms."))
        .oneOf(kLifts),
    property<&AirNode::margin>("margin_m", SPIN_TR("Margin"),
                               SPIN_TR("How far the air reaches beyond the sides of the flow's box."))
        .in(Unit::Metre)
        .range(0, 10000, 5),
    property<&AirNode::headroom>(
        "headroom_m", SPIN_TR("Headroom"),
        SPIN_TR("How far the air reaches above the flow's box; what rises higher leaves."))
        .in(Unit::Metre)
        .range(0, 10000, 5),
    property<&AirNode::smallEddies>(
        "small_eddies", SPIN_TR("Small eddies"),
        SPIN_TR("Mixing by eddies that are smaller than a cell, by how fast the air shears: Smagorinsky's "
                "constant, 0.1 to 0.2; 0 leaves it out."))
        .in(Unit::None)
        .range(0, 0.5, 0.01),
    property<&AirNode::eddyViscosity>("eddy_viscosity_m2_s", SPIN_TR("Eddy viscosity"),
                                      SPIN_TR("The same mixing everywhere, whatever the air does."))
        .in(Unit::SquareMetrePerSecond)
        .range(0, 100, 0.01),
    property<&AirNode::evaporates>(
        "evaporates", SPIN_TR("Mist evaporates"),
        SPIN_TR(
            "Mist and vapour seek saturation: mist thins out in dry air and forms where moist air cools.")),
    property<&AirNode::mistDiameter>(
        "mist_diameter_m", SPIN_TR("Mist droplets"),
        SPIN_TR("Diameter of the droplets of mist: they sink and scatter light by it."))
        .in(Unit::Millimetre)
        .range(1e-6, 1e-3, 1e-5),
    property<&AirNode::grainDiameter>("grain_diameter_m", SPIN_TR("Powder grains"),
                                      SPIN_TR("Diameter of the grains of powder snow."))
        .in(Unit::Millimetre)
        .range(1e-5, 5e-3, 1e-5),
    property<&AirNode::waterTemperature>("water_temperature_k", SPIN_TR("Water temperature"),
                                         SPIN_TR("Temperature of all water that flows: warmer than the air "
                                                 "its mist rises, colder it hugs the ground."))
        .in(Unit::Kelvin)
        .range(250, 373, 1),
    property<&AirNode::waterWarms>(
        "water_warms", SPIN_TR("Water warms air"),
        SPIN_TR(
            "The surface of water and its drops give heat and vapour to the air that passes, or take them.")),
    property<&AirNode::impactAcceleration>(
        "impact_acceleration_m_s2", SPIN_TR("Impact from"),
        SPIN_TR("Acceleration from which a particle counts as hitting something."))
        .in(Unit::None)
        .range(10, 100000, 10),
    property<&AirNode::impactWater>(
        "impact_share_water", SPIN_TR("Mist by impact"),
        SPIN_TR("Share of water that an impact turns to mist per metre a second of speed that it takes."))
        .in(Unit::None)
        .range(0, 0.1, 1e-6),
    property<&AirNode::impactSnow>(
        "impact_share_snow", SPIN_TR("Powder by impact"),
        SPIN_TR("Share of snow that an impact turns to powder per metre a second of speed that it takes."))
        .in(Unit::None)
        .range(0, 0.1, 1e-3),
    property<&AirNode::mistSpeed>("mist_speed_m_s", SPIN_TR("Mist from"),
                                  SPIN_TR("Speed against the air from which the surface of water frays and "
                                          "impacts throw up mist; all of it at three times that speed."))
        .in(Unit::MetrePerSecond)
        .range(0.1, 200, 1),
    property<&AirNode::mistRate>("mist_rate_1_s", SPIN_TR("Mist rate"),
                                 SPIN_TR("Share of the particles at the surface of water that turns to mist "
                                         "a second, at three times that speed."))
        .in(Unit::PerSecond)
        .range(0, 10, 1e-6),
    property<&AirNode::powderSpeed>(
        "powder_speed_m_s", SPIN_TR("Powder from"),
        SPIN_TR("Speed against the air from which the surface of snow is whirled up and impacts throw up "
                "powder; all of it at three times that speed."))
        .in(Unit::MetrePerSecond)
        .range(0.1, 200, 1),
    property<&AirNode::powderRate>("powder_rate_1_s", SPIN_TR("Powder rate"),
                                   SPIN_TR("Share of the particles at the surface of snow that turns to "
                                           "powder a second, at three times that speed."))
        .in(Unit::PerSecond)
        .range(0, 10, 0.01),
    property<&AirNode::mostGiven>(
        "most_given", SPIN_TR("Most given"),
        SPIN_TR("Share of its mass that a particle in the flow gives to the air at most."))
        .in(Unit::Factor)
        .range(0, 0.9, 0.05),
    property<&AirNode::spray>("spray", SPIN_TR("Spray"),
                              SPIN_TR("Particles that are alone leave the flow and fly on as drops.")),
    property<&AirNode::lumpDiameter>("lump_diameter_m", SPIN_TR("Lumps"),
                                     SPIN_TR("Diameter of the lumps of water that leave the flow, if that "
                                             "is less than its spacing; the air tears them to drops."))
        .in(Unit::Metre)
        .range(1e-3, 2, 0.05),
    property<&AirNode::dropDiameter>("drop_diameter_m", SPIN_TR("Drops"),
                                     SPIN_TR("Diameter of the largest drops of spray; the air tears them to "
                                             "smaller ones where they are fast."))
        .in(Unit::Millimetre)
        .range(1e-4, 0.02, 1e-4),
    property<&AirNode::clumpDiameter>("clump_diameter_m", SPIN_TR("Snow clumps"),
                                      SPIN_TR("Diameter of the clumps of snow that fly on their own."))
        .in(Unit::Millimetre)
        .range(1e-4, 1, 1e-3),
    property<&AirNode::sprayLife>(
        "spray_life_s", SPIN_TR("Life of spray"),
        SPIN_TR("Time in which flying drops fray into mist, to 37 %; larger ones take longer."))
        .in(Unit::Second)
        .range(0.1, 100000, 10),
    property<&AirNode::clumpLife>("clump_life_s", SPIN_TR("Life of clumps"),
                                  SPIN_TR("Time in which flying clumps of snow fray into powder, to 37 %."))
        .in(Unit::Second)
        .range(0.1, 1000, 1),
    property<&AirNode::sprayRate>("spray_rate_1_s", SPIN_TR("Spray rate"),
                                  SPIN_TR("Share of a particle at the surface of water that is thrown up a "
                                          "second where air is trapped, a crest breaks and energy is high."))
        .in(Unit::PerSecond)
        .range(0, 100, 0.05),
    property<&AirNode::trappedLow>(
        "trapped_air_low_m_s", SPIN_TR("Trapped air from"),
        SPIN_TR("Mean speed at which neighbours come nearer from which air is trapped (Ihmsen et al. 2012)."))
        .in(Unit::MetrePerSecond)
        .range(0, 200, 0.5),
    property<&AirNode::trappedHigh>("trapped_air_high_m_s", SPIN_TR("Trapped air up to"),
                                    SPIN_TR("The same, beyond which no more is thrown up."))
        .in(Unit::MetrePerSecond)
        .range(0.1, 200, 0.5),
    property<&AirNode::crestLow>("crest_low", SPIN_TR("Crests from"),
                                 SPIN_TR("Bend of the surface from which a wave's crest breaks (Ihmsen et "
                                         "al. 2012): mean of 1 - cosine of the angle between normals."))
        .in(Unit::Factor)
        .range(0, 2, 0.01),
    property<&AirNode::crestHigh>("crest_high", SPIN_TR("Crests up to"),
                                  SPIN_TR("The same, beyond which no more is thrown up."))
        .in(Unit::Factor)
        .range(0.01, 2, 0.01),
    property<&AirNode::energyLow>(
        "energy_low_j_kg", SPIN_TR("Energy from"),
        SPIN_TR("Kinetic energy per kilogram from which water is thrown up (Ihmsen et al. 2012)."))
        .in(Unit::None)
        .range(0, 100000, 5),
    property<&AirNode::energyHigh>("energy_high_j_kg", SPIN_TR("Energy up to"),
                                   SPIN_TR("The same, beyond which no more is thrown up."))
        .in(Unit::None)
        .range(0.1, 100000, 5),
    property<&AirNode::mostDrops>(
        "most_drops", SPIN_TR("Most spray"),
        SPIN_TR(
            "Parcels of spray at most; beyond, what is alone stays in the flow and nothing is thrown up."))
        .range(0, 10000000, 10000),
};

}  // namespace

constinit const NodeType kAirType = nodeType<AirNode>(
    "air", SPIN_TR("Mist and powder"),
    SPIN_TR("What hangs in the air over water and avalanches, and how it is computed."), true, kAirRows);

}  // namespace spin
