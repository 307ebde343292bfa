// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/cover_nodes.h"

namespace spin {
namespace {

constexpr Choice kLaws[] = {
    {"energy_balance", SPIN_TR("Energy balance")},
    {"degree_day", SPIN_TR("Degree-day")},
    {"published", SPIN_TR("Tang and Zhang, as published")},
    {"lies", SPIN_TR("Lies as it fell")},
};

constexpr PropertyRow kCoverRows[] = {
    property<&SnowCoverNode::law>(
        "melt_law", SPIN_TR("Melt"),
        SPIN_TR("Energy balance: sun, sky, air, rain and ground, settling and refreezing. Degree-day: by "
                "the air's temperature alone. As published: the law of Tang and Zhang, for comparison; it "
                "knows no heat of melting. Lies as it fell: snow neither settles nor melts."))
        .oneOf(kLaws),
    property<&SnowCoverNode::degreeDayFactor>(
        "degree_day_factor", SPIN_TR("Degree-day factor"),
        SPIN_TR("Water that melts per day and degree above the threshold; 2 to 6 are usual."))
        .in(Unit::KilogramPerSquareMetreDayKelvin)
        .range(0, 20.0 / 86400.0, 0.5 / 86400.0),
    property<&SnowCoverNode::degreeDayThreshold>("degree_day_threshold_k", SPIN_TR("Degree-day threshold"),
                                                 SPIN_TR("Air temperature above which snow melts."))
        .in(Unit::Kelvin)
        .range(263.15, 283.15, 0.5),
    property<&SnowCoverNode::freshAlbedo>("fresh_albedo", SPIN_TR("Albedo of new snow"),
                                          SPIN_TR("Share of the sun's light that new snow sends back."))
        .in(Unit::Factor)
        .range(0.3, 0.98, 0.01),
    property<&SnowCoverNode::oldAlbedo>("old_albedo", SPIN_TR("Albedo of old snow"),
                                        SPIN_TR("What the albedo of ageing snow falls to."))
        .in(Unit::Factor)
        .range(0.2, 0.98, 0.01),
    property<&SnowCoverNode::windHeight>("wind_height_m", SPIN_TR("Height of the wind"),
                                         SPIN_TR("Above ground, at which the wind is measured."))
        .in(Unit::Metre)
        .range(1, 100, 1),
    property<&SnowCoverNode::airHeight>("air_height_m", SPIN_TR("Height of the temperature"),
                                        SPIN_TR("Above ground, at which temperature and humidity are."))
        .in(Unit::Metre)
        .range(1, 100, 0.5),
    property<&SnowCoverNode::slopesAndShadow>(
        "slopes_and_shadow", SPIN_TR("Slopes and shadow"),
        SPIN_TR("Where a sun melts, it and the sky count by slope, aspect and horizon; off: everything lies "
                "level and open.")),
    property<&SnowCoverNode::horizonReach>("horizon_reach_m", SPIN_TR("Horizon reach"),
                                           SPIN_TR("How far away mountains cast shadow."))
        .in(Unit::Metre)
        .range(10, 100000, 500),
};

constexpr PropertyRow kHeatRows[] = {
    property<&HeatSourceNode::position>("position_m", SPIN_TR("Position"),
                                        SPIN_TR("Place in local metres: east, north; it lies on the ground."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 0.5)
        .animated(),
    property<&HeatSourceNode::radius>("radius_m", SPIN_TR("Radius"),
                                      SPIN_TR("How far it warms; the heat fades towards the edge."))
        .in(Unit::Metre)
        .range(0.1, 10000, 0.5)
        .animated(),
    property<&HeatSourceNode::power>(
        "power_w_m2", SPIN_TR("Power"),
        SPIN_TR("Heat that goes into the ground at the centre; 100 W/m\u00b2 melts 26 mm of water a day."))
        .in(Unit::WattPerSquareMetre)
        .range(-1000, 10000, 10)
        .animated(),
};

}  // namespace

constinit const NodeType kSnowCoverType =
    nodeType<SnowCoverNode>("snow_cover", SPIN_TR("Snow cover"),
                            SPIN_TR("How lying snow settles, ages and melts."), true, kCoverRows);
constinit const NodeType kHeatSourceType =
    nodeType<HeatSourceNode>("heat_source", SPIN_TR("Heat source"),
                             SPIN_TR("Warm ground on which less snow stays."), false, kHeatRows);

}  // namespace spin
