// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/flow_nodes.h"

namespace spin {
namespace {

constexpr Choice kLaws[] = {
    {"newtonian", SPIN_TR("Newtonian")}, {"power_law", SPIN_TR("Power law")},
    {"bingham", SPIN_TR("Bingham")},     {"herschel_bulkley", SPIN_TR("Herschel-Bulkley")},
    {"cross", SPIN_TR("Cross")},         {"frictional", SPIN_TR("Frictional (Mohr-Coulomb)")},
};

constexpr PropertyRow kMaterialRows[] = {
    property<&FlowMaterialNode::law>(
        "law", SPIN_TR("Law"),
        SPIN_TR("How the viscosity follows from the shear rate. Snow is frictional: it piles up and stops."))
        .oneOf(kLaws),
    property<&FlowMaterialNode::density>("density_kg_m3", SPIN_TR("Density"), SPIN_TR("Density at rest."))
        .in(Unit::KilogramPerCubicMetre)
        .range(1, 5000, 10),
    property<&FlowMaterialNode::viscosity>(
        "viscosity_pa_s", SPIN_TR("Viscosity"),
        SPIN_TR("Newtonian viscosity, consistency in Pa s^n, or that of a Cross fluid at rest."))
        .in(Unit::PascalSecond)
        .range(0, 1e6, 0.5),
    property<&FlowMaterialNode::exponent>(
        "exponent", SPIN_TR("Exponent"),
        SPIN_TR("Exponent n of the power law, Herschel-Bulkley and Cross: below 1 the first two thin."))
        .in(Unit::Factor)
        .range(0.05, 5, 0.05),
    property<&FlowMaterialNode::cohesion>(
        "cohesion_pa", SPIN_TR("Cohesion"),
        SPIN_TR("Stress below which it does not flow without pressure: cohesion, or the yield stress."))
        .in(Unit::Pascal)
        .range(0, 1e6, 10),
    property<&FlowMaterialNode::frictionAngleDegrees>(
        "friction_angle_deg", SPIN_TR("Friction angle"),
        SPIN_TR("Angle of internal friction; its tangent times the pressure adds to the cohesion."))
        .in(Unit::Degree)
        .range(0, 60, 1),
    property<&FlowMaterialNode::tensileStrength>("tensile_strength_pa", SPIN_TR("Tensile strength"),
                                                 SPIN_TR("Tension that it bears before it tears: what makes "
                                                         "wet snow hang together and roll in lumps. Acts "
                                                         "with the equation of state."))
        .in(Unit::Pascal)
        .range(0, 1e5, 10),
    property<&FlowMaterialNode::viscosityAtSpeed>("viscosity_at_speed_pa_s", SPIN_TR("Viscosity at speed"),
                                                  SPIN_TR("That of a Cross fluid in fast shear."))
        .in(Unit::PascalSecond)
        .range(0, 1e6, 0.5),
    property<&FlowMaterialNode::crossFactor>("cross_factor", SPIN_TR("Cross factor"),
                                             SPIN_TR("Cross' K in s^n: how early it changes."))
        .in(Unit::Factor)
        .range(0, 1e6, 1),
    property<&FlowMaterialNode::least>("least_viscosity_pa_s", SPIN_TR("Least viscosity"),
                                       SPIN_TR("The viscosity is held above this."))
        .in(Unit::PascalSecond)
        .range(0, 1e6, 1),
    property<&FlowMaterialNode::most>(
        "most_viscosity_pa_s", SPIN_TR("Largest viscosity"),
        SPIN_TR("The viscosity is held below this: larger values creep less at rest and ask for more steps."))
        .in(Unit::PascalSecond)
        .range(0, 1e9, 100),
};

constexpr Choice kAccuracies[] = {
    {"fast", SPIN_TR("Fast")},
    {"accurate", SPIN_TR("Accurate")},
};
constexpr Choice kDensities[] = {
    {"summation", SPIN_TR("Summation")},
    {"continuity", SPIN_TR("Continuity")},
};
constexpr Choice kPressures[] = {
    {"state_equation", SPIN_TR("State equation")},
    {"implicit", SPIN_TR("Solved for (DFSPH)")},
};
constexpr Choice kGrips[] = {
    {"coulomb", SPIN_TR("Friction by coefficient")},
    {"no_slip", SPIN_TR("Sticks")},
    {"free_slip", SPIN_TR("Slides freely")},
};

constexpr const char* kFrictionDoc = SPIN_TR(
    "Friction coefficient of flow on this type of ground. Swiss guidelines give 0.155 to 0.35 for "
    "flowing snow (Salm, Burkard and Gubler 1990).");

template <double FlowSettingsNode::*Member>
constexpr PropertyRow friction(const char* id, const char* label) {
  return property<Member>(id, label, kFrictionDoc).in(Unit::Factor).range(0, 2, 0.05);
}

constexpr PropertyRow kSettingsRows[] = {
    property<&FlowSettingsNode::spacing>(
        "spacing_m", SPIN_TR("Spacing"),
        SPIN_TR("Distance of particles at rest. Half of it takes eight times the particles and sixteen times "
                "the work."))
        .in(Unit::Metre)
        .range(0.005, 10, 0.05),
    property<&FlowSettingsNode::accuracy>(
        "accuracy", SPIN_TR("Accuracy"),
        SPIN_TR("Particles act on others within 2 spacings (fast) or 3 (accurate, about three times the "
                "work)."))
        .oneOf(kAccuracies),
    property<&FlowSettingsNode::density>(
        "density", SPIN_TR("Density by"),
        SPIN_TR("Summation over neighbours, or continuity with diffusion: quieter pressure, cheaper steps."))
        .oneOf(kDensities),
    property<&FlowSettingsNode::pressure>(
        "pressure", SPIN_TR("Pressure by"),
        SPIN_TR("The state equation (small, cheap steps, slightly compressible), or solved for so that the "
                "density stays: larger steps, each of many iterations."))
        .oneOf(kPressures),
    property<&FlowSettingsNode::soundSpeed>(
        "sound_speed_m_s", SPIN_TR("Sound speed"),
        SPIN_TR("Stiffness of the flow: larger is less compressible and takes more steps; 0 finds it."))
        .in(Unit::MetrePerSecond)
        .range(0, 2000, 5),
    property<&FlowSettingsNode::longestStep>("longest_step_s", SPIN_TR("Longest step"),
                                             SPIN_TR("Time steps are never longer than this."))
        .in(Unit::Second)
        .range(1e-6, 1, 0.001),
    property<&FlowSettingsNode::smoothing>(
        "smoothing", SPIN_TR("Smoothing"),
        SPIN_TR("Share of the neighbours' velocity that a particle takes on (XSPH)."))
        .in(Unit::Factor)
        .range(0, 1, 0.05),
    property<&FlowSettingsNode::viscosityCap>(
        "viscosity_cap_pa_s", SPIN_TR("Viscosity cap"),
        SPIN_TR("No viscosity is larger: less creep at rest asks for more steps; 0 finds one that leaves the "
                "step alone."))
        .in(Unit::PascalSecond)
        .range(0, 1e9, 100),
    property<&FlowSettingsNode::windDrag>(
        "wind_drag_1_m", SPIN_TR("Wind drag"),
        SPIN_TR("Acceleration by the wind per square of the speed against it."))
        .in(Unit::PerMetre)
        .range(0, 10, 0.01)
        .animated(),
    property<&FlowSettingsNode::margin>(
        "margin_m", SPIN_TR("Margin"), SPIN_TR("How far beyond the found reach of the flow the domain goes."))
        .in(Unit::Metre)
        .range(0, 10000, 5),
    property<&FlowSettingsNode::headroom>(
        "headroom_m", SPIN_TR("Headroom"),
        SPIN_TR("How far the domain goes above ground and sources; what flies higher leaves."))
        .in(Unit::Metre)
        .range(0.1, 10000, 5),
    property<&FlowSettingsNode::domainMin>(
        "domain_min_m", SPIN_TR("Domain from"),
        SPIN_TR("Lowest corner of the box that flow stays in; equal corners find the box from the terrain."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 1),
    property<&FlowSettingsNode::domainMax>("domain_max_m", SPIN_TR("Domain to"),
                                           SPIN_TR("Highest corner of the box that flow stays in."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 1),
    property<&FlowSettingsNode::closed>(
        "closed_domain", SPIN_TR("Closed domain"),
        SPIN_TR("The sides of the domain are smooth walls; otherwise flow leaves there.")),
    property<&FlowSettingsNode::grip>("ground_grip", SPIN_TR("Ground holds by"),
                                      SPIN_TR("How the ground holds what flows over it."))
        .oneOf(kGrips),
    property<&FlowSettingsNode::turbulence>(
        "turbulent_friction_m_s2", SPIN_TR("Turbulent friction"),
        SPIN_TR("Voellmy's xi: the ground also holds by density times gravity times speed squared over xi; 0 "
                "is none. Published values are 400 to 4000 (Salm, Burkard and Gubler 1990)."))
        .in(Unit::None)
        .range(0, 100000, 100),
    friction<&FlowSettingsNode::quartz>("friction_quartz", SPIN_TR("Friction on quartz")),
    friction<&FlowSettingsNode::sand>("friction_sand", SPIN_TR("Friction on sand")),
    friction<&FlowSettingsNode::soil>("friction_soil", SPIN_TR("Friction on soil")),
    friction<&FlowSettingsNode::vegetation>("friction_vegetation", SPIN_TR("Friction on vegetation")),
    friction<&FlowSettingsNode::rock>("friction_rock", SPIN_TR("Friction on rock")),
    friction<&FlowSettingsNode::ice>("friction_ice", SPIN_TR("Friction on ice")),
    friction<&FlowSettingsNode::asphalt>("friction_asphalt", SPIN_TR("Friction on asphalt")),
    friction<&FlowSettingsNode::water>("friction_water", SPIN_TR("Friction on water")),
};

}  // namespace

constinit const NodeType kFlowMaterialType =
    nodeType<FlowMaterialNode>("flow_material", SPIN_TR("Flow material"),
                               SPIN_TR("Numbers of a custom material that flows."), false, kMaterialRows);
constinit const NodeType kFlowSettingsType =
    nodeType<FlowSettingsNode>("flow_settings", SPIN_TR("Flow settings"),
                               SPIN_TR("How avalanches and water are computed."), true, kSettingsRows);

}  // namespace spin
