// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/flow_nodes.h"

namespace spin {
namespace {

constexpr Choice kMaterials[] = {
    {"dry_snow", SPIN_TR("Dry snow")},
    {"wet_snow", SPIN_TR("Wet snow")},
    {"slush", SPIN_TR("Slush")},
    {"water", SPIN_TR("Water")},
    {"cross_thinning", SPIN_TR("Cross fluid, thinning")},
    {"cross_thickening", SPIN_TR("Cross fluid, thickening")},
    {"custom", SPIN_TR("Custom")},
};
static_assert(std::size(kMaterials) == kFlowMaterialKinds);

constexpr const char* kMaterialDoc = SPIN_TR(
    "What flows: a preset, or custom for the numbers of a flow material node. The presets' numbers and "
    "sources stand in the documentation of flow materials.");
constexpr const char* kCustomDoc =
    SPIN_TR("Flow material node that a custom material takes its numbers from.");

constexpr PropertyRow kReleaseRows[] = {
    property<&AvalancheReleaseNode::outline>(
        "outline_m", SPIN_TR("Outline"),
        SPIN_TR(
            "Corners of the release area in plan, local metres east and north. It must not cross itself."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 1),
    property<&AvalancheReleaseNode::source>(
        "source", SPIN_TR("Painted file"),
        SPIN_TR("8-bit PNG of the terrain's size, 1 where the slab is released and 255 elsewhere; it adds to "
                "the outline and is written when the scene is saved."))
        .path(),
    property<&AvalancheReleaseNode::depth>("depth_m", SPIN_TR("Slab depth"),
                                           SPIN_TR("Depth of the slab that breaks loose."))
        .in(Unit::Metre)
        .range(0.01, 50, 0.1),
    property<&AvalancheReleaseNode::depthIsVertical>(
        "depth_vertical", SPIN_TR("Vertical depth"),
        SPIN_TR("The depth is measured vertically; otherwise along the slope's normal, as release depths are "
                "given.")),
    property<&AvalancheReleaseNode::density>("density_kg_m3", SPIN_TR("Density"),
                                             SPIN_TR("Density of the slab; 0 takes the material's."))
        .in(Unit::KilogramPerCubicMetre)
        .range(0, 2000, 10),
    property<&AvalancheReleaseNode::material>("material", SPIN_TR("Material"), kMaterialDoc)
        .oneOf(kMaterials),
    property<&AvalancheReleaseNode::customMaterial>("custom_material", SPIN_TR("Custom material"), kCustomDoc)
        .naming("flow_material"),
    property<&AvalancheReleaseNode::releaseTime>(
        "release_time_s", SPIN_TR("Release time"),
        SPIN_TR("Film time at which the slab breaks loose; it is not there before."))
        .in(Unit::Second)
        .range(0, 1e6, 0.5),
};

constexpr Choice kSourceShapes[] = {
    {"line", SPIN_TR("Line")},
    {"disc", SPIN_TR("Disc")},
};

constexpr PropertyRow kSourceRows[] = {
    property<&WaterSourceNode::shape>("shape", SPIN_TR("Shape"),
                                      SPIN_TR("A line such as a crest, or a disc such as a pipe's mouth."))
        .oneOf(kSourceShapes),
    property<&WaterSourceNode::position>("position_m", SPIN_TR("Position"),
                                         SPIN_TR("One end of the line, or the centre of the disc."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 0.5),
    property<&WaterSourceNode::end>("end_m", SPIN_TR("Line's end"), SPIN_TR("The other end of the line."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 0.5),
    property<&WaterSourceNode::onGround>("on_ground", SPIN_TR("Stand on ground"),
                                         SPIN_TR("Heights count from the terrain under each point.")),
    property<&WaterSourceNode::radius>("radius_m", SPIN_TR("Radius"), SPIN_TR("Radius of the disc."))
        .in(Unit::Metre)
        .range(0.01, 100, 0.1),
    property<&WaterSourceNode::velocity>(
        "velocity_m_s", SPIN_TR("Velocity"),
        SPIN_TR("Direction and speed at which fluid enters. Of a disc only the direction counts: its speed "
                "follows from flow and radius."))
        .in(Unit::MetrePerSecond)
        .range(-100, 100, 0.5)
        .animated(),
    property<&WaterSourceNode::flowPerMetre>("flow_m2_s", SPIN_TR("Flow per metre"),
                                             SPIN_TR("Volume a second and metre of the line."))
        .in(Unit::SquareMetrePerSecond)
        .range(0, 1000, 0.1)
        .animated(),
    property<&WaterSourceNode::flow>("flow_m3_s", SPIN_TR("Flow"), SPIN_TR("Volume a second of the disc."))
        .in(Unit::CubicMetrePerSecond)
        .range(0, 100000, 0.1)
        .animated(),
    property<&WaterSourceNode::material>("material", SPIN_TR("Material"), kMaterialDoc).oneOf(kMaterials),
    property<&WaterSourceNode::customMaterial>("custom_material", SPIN_TR("Custom material"), kCustomDoc)
        .naming("flow_material"),
    property<&WaterSourceNode::start>("start_s", SPIN_TR("Start"), SPIN_TR("Film time of the first inflow."))
        .in(Unit::Second)
        .range(0, 1e6, 0.5),
    property<&WaterSourceNode::stop>("stop_s", SPIN_TR("Stop"), SPIN_TR("Film time at which inflow ends."))
        .in(Unit::Second)
        .range(0, 1e6, 0.5),
};

constexpr Choice kSinkShapes[] = {
    {"plane", SPIN_TR("Plane")},
    {"box", SPIN_TR("Box")},
};

constexpr PropertyRow kSinkRows[] = {
    property<&FlowSinkNode::shape>("shape", SPIN_TR("Shape"),
                                   SPIN_TR("All behind a plane, or all within a box, is taken out."))
        .oneOf(kSinkShapes),
    property<&FlowSinkNode::position>("position_m", SPIN_TR("Position"),
                                      SPIN_TR("A point of the plane, or the centre of the box."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 0.5)
        .animated(),
    property<&FlowSinkNode::normal>("normal", SPIN_TR("Normal"),
                                    SPIN_TR("Direction from the plane to the side that stays."))
        .in(Unit::Factor)
        .range(-1, 1, 0.1),
    property<&FlowSinkNode::size>("size_m", SPIN_TR("Size"), SPIN_TR("Edges of the box along x, y and z."))
        .in(Unit::Metre)
        .range(0.01, 1e6, 0.5),
};

constexpr Choice kMotions[] = {
    {"static", SPIN_TR("Stands still")},
    {"kinematic", SPIN_TR("Moves by its keys")},
    {"dynamic", SPIN_TR("Moved by what hits it")},
};

constexpr PropertyRow kBodyRows[] = {
    property<&RigidBodyNode::model>("model", SPIN_TR("Model"), SPIN_TR("Model that is solid for the flow."))
        .naming("model"),
    property<&RigidBodyNode::motion>("motion", SPIN_TR("Motion"),
                                     SPIN_TR("Whether the body stands, follows the keys of its model, or is "
                                             "moved by flow, gravity and collisions."))
        .oneOf(kMotions),
    property<&RigidBodyNode::density>("density_kg_m3", SPIN_TR("Density"),
                                      SPIN_TR("Density of a moved body."))
        .in(Unit::KilogramPerCubicMetre)
        .range(1, 25000, 50),
    property<&RigidBodyNode::friction>(
        "friction", SPIN_TR("Friction"),
        SPIN_TR("Coulomb's coefficient against flow, ground and other bodies."))
        .in(Unit::Factor)
        .range(0, 2, 0.05),
    property<&RigidBodyNode::restitution>("restitution", SPIN_TR("Restitution"),
                                          SPIN_TR("Share of the speed that a collision gives back."))
        .in(Unit::Factor)
        .range(0, 1, 0.05),
    property<&RigidBodyNode::velocity>("velocity_m_s", SPIN_TR("Start velocity"),
                                       SPIN_TR("Velocity of a moved body at the start."))
        .in(Unit::MetrePerSecond)
        .range(-200, 200, 0.5),
    property<&RigidBodyNode::spin>("spin_rad_s", SPIN_TR("Start spin"),
                                   SPIN_TR("Angular velocity of a moved body at the start, rad/s."))
        .in(Unit::PerSecond)
        .range(-200, 200, 0.5),
};

}  // namespace

constinit const NodeType kAvalancheReleaseType =
    nodeType<AvalancheReleaseNode>("avalanche_release", SPIN_TR("Avalanche release"),
                                   SPIN_TR("A slab of snow that breaks loose."), false, kReleaseRows);
constinit const NodeType kWaterSourceType =
    nodeType<WaterSourceNode>("water_source", SPIN_TR("Water source"),
                              SPIN_TR("A crest or a mouth where water enters."), false, kSourceRows);
constinit const NodeType kFlowSinkType = nodeType<FlowSinkNode>(
    "flow_sink", SPIN_TR("Flow sink"), SPIN_TR("A plane or a box that takes flow out."), false, kSinkRows);
constinit const NodeType kRigidBodyType = nodeType<RigidBodyNode>(
    "rigid_body", SPIN_TR("Rigid body"), SPIN_TR("Makes a model solid for the flow."), false, kBodyRows);

}  // namespace spin
