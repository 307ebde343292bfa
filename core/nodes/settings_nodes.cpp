// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/settings_nodes.h"

namespace spin {

constinit const std::array<Choice, 10> kFlowDisplayChoices{{
    {"material", SPIN_TR("Material")},
    {"speed", SPIN_TR("Speed")},
    {"density", SPIN_TR("Density")},
    {"pressure", SPIN_TR("Pressure")},
    {"acceleration", SPIN_TR("Acceleration")},
    {"shear_rate", SPIN_TR("Shear rate")},
    {"viscosity", SPIN_TR("Viscosity")},
    {"class", SPIN_TR("Particle class")},
    {"age", SPIN_TR("Age")},
    {"neighbours", SPIN_TR("Neighbours")},
}};

constinit const std::array<const char*, 3> kFlowClassLabels{
    {SPIN_TR("Within the flow"), SPIN_TR("Isolated"), SPIN_TR("At the surface")}};

constinit const std::array<Choice, 7> kSnowDisplayChoices{{
    {"natural", SPIN_TR("Natural colours")},
    {"depth", SPIN_TR("Snow depth")},
    {"swe", SPIN_TR("Snow water equivalent")},
    {"density", SPIN_TR("Snow density")},
    {"temperature", SPIN_TR("Surface temperature")},
    {"liquid_water", SPIN_TR("Liquid water in the snow")},
    {"exposure", SPIN_TR("Exposure to snowfall")},
}};

constinit const std::array<Choice, 5> kAirDisplayChoices{{
    {"natural", SPIN_TR("Natural colours")},
    {"density", SPIN_TR("Mist density")},
    {"velocity", SPIN_TR("Mist velocity")},
    {"temperature", SPIN_TR("Excess temperature")},
    {"divergence", SPIN_TR("Divergence")},
}};

constinit const std::array<Choice, 4> kAirSliceChoices{{
    {"off", SPIN_TR("Off")},
    {"across_x", SPIN_TR("Across x")},
    {"across_y", SPIN_TR("Across y")},
    {"across_z", SPIN_TR("Across z")},
}};

namespace {

constexpr Choice kSnowShadings[] = {
    {"physical", SPIN_TR("Physically based")},
    {"blinn_phong", SPIN_TR("Blinn-Phong, as published")},
};

constexpr PropertyRow kRenderRows[] = {
    property<&RenderNode::width>("width_px", SPIN_TR("Width"), SPIN_TR("Width of pictures."))
        .in(Unit::Pixel)
        .range(16, 16384, 16)
        .affecting(Affects::Picture),
    property<&RenderNode::height>("height_px", SPIN_TR("Height"), SPIN_TR("Height of pictures."))
        .in(Unit::Pixel)
        .range(16, 16384, 16)
        .affecting(Affects::Picture),
    property<&RenderNode::samples>("samples", SPIN_TR("Samples"),
                                   SPIN_TR("Samples per pixel against jagged edges: 1, 2, 4 or 8."))
        .range(1, 8, 1)
        .affecting(Affects::Picture),
    property<&RenderNode::exposure>("exposure_stops", SPIN_TR("Exposure"),
                                    SPIN_TR("Brightness in stops: +1 is twice as bright."))
        .range(-10, 10, 0.25)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::snowfallHaze>(
        "snowfall_haze", SPIN_TR("Snowfall haze"),
        SPIN_TR("How much of its real extinction falling snow shows in the distance: 1 is what the eye would "
                "see, less keeps the view open."))
        .in(Unit::Factor)
        .range(0, 1, 0.05)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::showFlakes>("show_flakes", SPIN_TR("Show flakes"),
                                      SPIN_TR("Draw the falling flakes."))
        .affecting(Affects::Picture),
    property<&RenderNode::showCaption>("show_caption", SPIN_TR("Show caption"),
                                       SPIN_TR("Print the caption and the credit line on pictures."))
        .affecting(Affects::Picture),
    property<&RenderNode::caption>("caption", SPIN_TR("Caption"), SPIN_TR("Text printed on pictures."))
        .affecting(Affects::Picture),
    property<&RenderNode::flowDisplay>(
        "flow_display", SPIN_TR("Flow shows"),
        SPIN_TR(
            "What the colours of flowing particles tell. Material draws snow as snow and water as water."))
        .oneOf(kFlowDisplayChoices)
        .affecting(Affects::Picture),
    property<&RenderNode::flowRangeAuto>(
        "flow_range_auto", SPIN_TR("Range of the frame"),
        SPIN_TR("Spread the colours over what the frame's particles have; off takes the range below."))
        .affecting(Affects::Picture),
    property<&RenderNode::flowRangeLow>(
        "flow_range_low", SPIN_TR("Range from"),
        SPIN_TR("Value of the darkest colour, in the unit that the legend shows."))
        .range(-1e9, 1e9, 1)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::flowRangeHigh>(
        "flow_range_high", SPIN_TR("Range to"),
        SPIN_TR("Value of the brightest colour, in the unit that the legend shows."))
        .range(-1e9, 1e9, 1)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::flowLogarithmic>(
        "flow_logarithmic", SPIN_TR("Logarithmic colours"),
        SPIN_TR(
            "Each step of colour multiplies the value: for viscosity and shear rate. Needs values above 0."))
        .affecting(Affects::Picture),
    property<&RenderNode::flowLegend>(
        "flow_legend", SPIN_TR("Show legend"),
        SPIN_TR("Print what the colours of flow, snow and air mean where they stand for values."))
        .affecting(Affects::Picture),
    property<&RenderNode::showFlowBoundary>("show_flow_boundary", SPIN_TR("Show boundary particles"),
                                            SPIN_TR("Draw the particles that stand for moving bodies."))
        .affecting(Affects::Picture),
    property<&RenderNode::snowDisplay>(
        "snow_display", SPIN_TR("Snow shows"),
        SPIN_TR(
            "What the colours of the snow cover tell, on the ground and on models. Natural colours draw it "
            "as snow; ground that has no value is grey."))
        .oneOf(kSnowDisplayChoices)
        .affecting(Affects::Picture),
    property<&RenderNode::snowRangeAuto>(
        "snow_range_auto", SPIN_TR("Range of the frame's snow"),
        SPIN_TR("Spread the colours over what the frame's cover has; off takes the range below, the same for "
                "all frames."))
        .affecting(Affects::Picture),
    property<&RenderNode::snowRangeLow>(
        "snow_range_low", SPIN_TR("Snow range from"),
        SPIN_TR("Value of the darkest colour, in the unit that the legend shows."))
        .range(-1e6, 1e6, 0.5)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::snowRangeHigh>(
        "snow_range_high", SPIN_TR("Snow range to"),
        SPIN_TR("Value of the brightest colour, in the unit that the legend shows."))
        .range(-1e6, 1e6, 0.5)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::airDisplay>(
        "air_display", SPIN_TR("Air shows"),
        SPIN_TR(
            "What the colours of mist and powder in the air tell: mass per volume, speed, how much warmer "
            "than the air around, or what the pressure solver left of the divergence. Natural colours draw "
            "them as they look."))
        .oneOf(kAirDisplayChoices)
        .affecting(Affects::Picture),
    property<&RenderNode::airSlice>(
        "air_slice", SPIN_TR("Air slice"),
        SPIN_TR("Show the values of the air on a plane across this axis instead of in the whole cloud. Needs "
                "a value to show."))
        .oneOf(kAirSliceChoices)
        .affecting(Affects::Picture),
    property<&RenderNode::airSlicePosition>("air_slice_position_m", SPIN_TR("Slice at"),
                                            SPIN_TR("Where the plane stands on its axis."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 1)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::airRangeAuto>(
        "air_range_auto", SPIN_TR("Range of the frame's air"),
        SPIN_TR("Spread the colours over what the frame's air has; off takes the range below, the same for "
                "all frames."))
        .affecting(Affects::Picture),
    property<&RenderNode::airRangeLow>(
        "air_range_low", SPIN_TR("Air range from"),
        SPIN_TR("Value of the darkest colour, in the unit that the legend shows."))
        .range(-1e6, 1e6, 0.1)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::airRangeHigh>(
        "air_range_high", SPIN_TR("Air range to"),
        SPIN_TR("Value of the brightest colour, in the unit that the legend shows."))
        .range(-1e6, 1e6, 0.1)
        .animated()
        .affecting(Affects::Picture),
    property<&RenderNode::snowShading>(
        "snow_shading", SPIN_TR("Snow shading"),
        SPIN_TR(
            "Physically based snow scatters light below its surface and is bluish in the shade. The "
            "published model adds ambient, diffuse and mirrored light, and mixes snow with what lies below "
            "by the exposure."))
        .oneOf(kSnowShadings)
        .affecting(Affects::Picture),
    property<&RenderNode::snowAmbient>(
        "snow_ambient", SPIN_TR("Ambient reflection"),
        SPIN_TR("K_a of the published shading: share of the sky's light that snow reflects."))
        .in(Unit::Factor)
        .range(0, 2, 0.05)
        .affecting(Affects::Picture),
    property<&RenderNode::snowDiffuse>(
        "snow_diffuse", SPIN_TR("Diffuse reflection"),
        SPIN_TR("K_d of the published shading: share of the sun's light that snow reflects to all sides."))
        .in(Unit::Factor)
        .range(0, 2, 0.05)
        .affecting(Affects::Picture),
    property<&RenderNode::snowSpecular>(
        "snow_specular", SPIN_TR("Mirror reflection"),
        SPIN_TR("K_s of the published shading: share of the sun's light in the highlight."))
        .in(Unit::Factor)
        .range(0, 2, 0.05)
        .affecting(Affects::Picture),
    property<&RenderNode::snowShininess>(
        "snow_shininess", SPIN_TR("Shininess"),
        SPIN_TR("n of the published shading: the higher, the smaller the highlight."))
        .range(1, 1000, 1)
        .affecting(Affects::Picture),
};

constexpr Choice kExposureMethods[] = {
    {"rays", SPIN_TR("Rays")},
    {"maps", SPIN_TR("Occlusion maps")},
};

constexpr PropertyRow kSimulationRows[] = {
    property<&SimulationNode::frameRate>("frame_rate", SPIN_TR("Frame rate"),
                                         SPIN_TR("Pictures per second of film."))
        .in(Unit::PerSecond)
        .range(1, 240, 1),
    property<&SimulationNode::timeScale>("time_scale", SPIN_TR("Time scale"),
                                         SPIN_TR("Seconds of weather per second of film. Cover and mass use "
                                                 "weather time, flakes on screen film time."))
        .in(Unit::Factor)
        .range(0, 1e6, 1),
    property<&SimulationNode::firstFrame>(
        "first_frame", SPIN_TR("First frame"),
        SPIN_TR("First frame shown and exported; the simulation itself starts at 0."))
        .range(0, 1000000, 1)
        .affecting(Affects::Nothing),
    property<&SimulationNode::lastFrame>("last_frame", SPIN_TR("Last frame"),
                                         SPIN_TR("Last frame shown and exported."))
        .range(0, 1000000, 1)
        .affecting(Affects::Nothing),
    property<&SimulationNode::seed>(
        "seed", SPIN_TR("Seed"), SPIN_TR("Start of the random numbers: same scene, same seed, same result."))
        .range(0, 2147483647, 1),
    property<&SimulationNode::exposureRays>(
        "exposure_rays", SPIN_TR("Exposure rays"),
        SPIN_TR("Rays per cover cell that measure how open it lies; the error falls with the square root."))
        .range(1, 65536, 16),
    property<&SimulationNode::exposureMethod>(
        "exposure_method", SPIN_TR("Shelter by"),
        SPIN_TR(
            "Rays: exact but for the number of rays. Maps: pictures of the scene along a few directions of "
            "fall, quicker with many triangles and moving things, and a little coarse at edges."))
        .oneOf(kExposureMethods),
    property<&SimulationNode::exposureDirections>(
        "exposure_directions", SPIN_TR("Map directions"),
        SPIN_TR("Directions of fall that maps are drawn for; few give stepped edges of shelter."))
        .range(1, 256, 1),
    property<&SimulationNode::exposureMapSize>(
        "exposure_map_size", SPIN_TR("Map size"),
        SPIN_TR("Texels along a map at most; small ground takes as many as half a cell asks for."))
        .in(Unit::Pixel)
        .range(64, 8192, 64),
    property<&SimulationNode::newSnowDensity>("new_snow_density_kg_m3", SPIN_TR("New snow density"),
                                              SPIN_TR("0 takes it from the air temperature."))
        .in(Unit::KilogramPerCubicMetre)
        .range(0, 900, 10),
    property<&SimulationNode::holdsBelowDegrees>(
        "holds_below_deg", SPIN_TR("Holds below"),
        SPIN_TR("Slopes flatter than this keep all the snow that reaches them."))
        .in(Unit::Degree)
        .range(0, 90, 1),
    property<&SimulationNode::shedsAboveDegrees>("sheds_above_deg", SPIN_TR("Sheds above"),
                                                 SPIN_TR("Slopes steeper than this keep none."))
        .in(Unit::Degree)
        .range(0, 90, 1),
    property<&SimulationNode::exposureNoise>("exposure_noise", SPIN_TR("Cover noise"),
                                             SPIN_TR("Unevenness of the cover; its mean is zero."))
        .in(Unit::Factor)
        .range(0, 0.5, 0.01),
    property<&SimulationNode::snowSlides>(
        "snow_slides", SPIN_TR("Snow slides"),
        SPIN_TR("Snow that lies steeper than its angle of repose moves down, off roofs too.")),
    property<&SimulationNode::reposeDryDegrees>("repose_dry_deg", SPIN_TR("Repose of dry snow"),
                                                SPIN_TR("Steepest slope that loose dry snow keeps."))
        .in(Unit::Degree)
        .range(5, 80, 1)
        .animated(),
    property<&SimulationNode::reposeWetDegrees>(
        "repose_wet_deg", SPIN_TR("Repose of slush"),
        SPIN_TR(
            "Steepest slope that snow with 15 % of liquid water by volume keeps; moist snow with less than "
            "3 % keeps what dry snow does."))
        .in(Unit::Degree)
        .range(1, 80, 1)
        .animated(),
    property<&SimulationNode::smoothingWidth>(
        "snow_smoothing_m", SPIN_TR("Smoothing"),
        SPIN_TR("Width of hollows in the snow's surface that fill within a day; 0 keeps them."))
        .in(Unit::Metre)
        .range(0, 10, 0.05),
    property<&SimulationNode::snowDrifts>(
        "snow_drift", SPIN_TR("Snow drifts"),
        SPIN_TR(
            "The wind carries snow along the ground: it takes it up where it speeds up and lays it down in "
            "the lee."))
        .animated(),
    property<&SimulationNode::driftThresholdWind>(
        "drift_threshold_m_s", SPIN_TR("Drifts from"),
        SPIN_TR("Wind 10 m above ground from which snow drifts. 0 takes it from air temperature, wetness and "
                "density."))
        .in(Unit::MetrePerSecond)
        .range(0, 60, 0.5)
        .animated(),
    property<&SimulationNode::driftInflow>(
        "drift_inflow", SPIN_TR("Drift over the border"),
        SPIN_TR(
            "Share of what the wind can carry that blows in over the scene's windward border: 1 where the "
            "snow goes on beyond it, 0 where nothing comes."))
        .in(Unit::Factor)
        .range(0, 1, 0.1),
    property<&SimulationNode::checkpointInterval>(
        "checkpoint_interval", SPIN_TR("Checkpoint every"),
        SPIN_TR("Frames between full saves of the state, from which an edit restarts."))
        .range(1, 10000, 1)
        .affecting(Affects::Nothing),
    // frameKeys() hashes these for the processes that they hold still.
    property<&SimulationNode::pauseSnow>(
        "pause_snow", SPIN_TR("Pause snow"),
        SPIN_TR("While it is on, falling snow and cover stand still and everything else goes on."))
        .animated(),
    property<&SimulationNode::pauseFlow>(
        "pause_flow", SPIN_TR("Pause flow"),
        SPIN_TR("While it is on, avalanches, water and bodies stand still and everything else goes on."))
        .animated(),
    property<&SimulationNode::pauseAir>(
        "pause_air", SPIN_TR("Pause mist and powder"),
        SPIN_TR("While it is on, mist, powder and spray stand still and everything else goes on."))
        .animated(),
};

}  // namespace

constinit const NodeType kRenderType = nodeType<RenderNode>(
    "render", SPIN_TR("Pictures"), SPIN_TR("Size and look of pictures."), true, kRenderRows);
constinit const NodeType kSimulationType =
    nodeType<SimulationNode>("simulation", SPIN_TR("Simulation"),
                             SPIN_TR("Time, range and accuracy of the simulation."), true, kSimulationRows);

}  // namespace spin
